//! Declarations in other files that a file may use, and the part of them that no grammar accepts: addresses of process data.
//! No file is read here.

use super::block::Block;
use super::structure::Structure;
use super::variables::{Role, Variables};

/// The declarations of other files.
#[derive(Clone, Copy, Default)]
pub(crate) struct Known<'a> {
    /// the blocks that may have instances
    pub(crate) blocks: &'a [Block],
    /// the structures that may have variables
    pub(crate) structures: &'a [Structure],
    /// the variables that are visible in every file of a program; only the program itself uses them
    pub(crate) globals: Option<&'a Variables>,
    /// whether it is a program with its blocks; files emitted for every compiler have no process data, and structures as
    /// inputs only
    pub(crate) is_program: bool,
}

/// `AT %I*` or `AT %Q*`
#[derive(Clone, Copy, Debug)]
pub(crate) struct Address {
    /// its first byte
    pub(crate) at: usize,
    /// the writer of the variable: the bus of the inputs for `%I*`, the program for `%Q*`
    pub(crate) role: Role,
}

/// Removes the addresses from a text and replaces them by blanks, so that every other position stays the same.
pub(crate) fn addresses(text: &mut String) -> Vec<Address> {
    let mut found = Vec::new();
    for (word, role) in [("AT %I*", Role::Input), ("AT %Q*", Role::Output)] {
        while let Some(at) = text.find(word) {
            text.replace_range(at..at + word.len(), &" ".repeat(word.len()));
            found.push(Address { at, role });
        }
    }
    found
}
