//! What a file may refer to that stands in others, and what of it no grammar takes: addresses of process data. No file is read here.

use super::block::Block;
use super::structure::Structure;
use super::variables::{Role, Variables};

/// What other files declare.
#[derive(Clone, Copy, Default)]
pub(crate) struct Known<'a> {
    /// the blocks of which there may be instances
    pub(crate) blocks: &'a [Block],
    /// the structures of which there may be variables
    pub(crate) structures: &'a [Structure],
    /// the variables that every file of a program sees; only the program itself uses them
    pub(crate) globals: Option<&'a Variables>,
    /// whether it is a program with its blocks; what is emitted for every compiler has no process data, and structures as inputs only
    pub(crate) is_program: bool,
}

/// `AT %I*` or `AT %Q*`
#[derive(Clone, Copy, Debug)]
pub(crate) struct Address {
    /// its first byte
    pub(crate) at: usize,
    /// who writes the variable: of `%I*` the inputs' bus, of `%Q*` the program
    pub(crate) role: Role,
}

/// Takes the addresses out of a text: blanks stand in their place, so that every other place stays where it is.
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
