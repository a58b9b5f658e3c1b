//! The target languages: each turns verified programs into files. A target never looks at a parameter.

pub mod c;
pub mod comment;
pub mod number;

use crate::axis::Axis;
use crate::block::Block;

/// A target language.
#[derive(Clone, Copy, Debug)]
pub struct Target {
    /// the name on the command line and in a set
    pub name: &'static str,
    /// the files of an axis
    pub files: fn(&Axis, &[Block]) -> Vec<File>,
}

/// All targets.
pub const TARGETS: [Target; 1] = [Target { name: "c", files: c::files }];

/// The target of that name.
#[must_use]
pub fn named(name: &str) -> Option<Target> {
    TARGETS.into_iter().find(|target| target.name == name)
}

/// A file that was made, with its name below the output folder.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct File {
    /// the name
    pub name: String,
    /// the content
    pub text: String,
}
