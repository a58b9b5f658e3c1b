//! The target languages: each turns a verified program into text. A target never looks at a parameter.

pub mod c;
pub mod number;

/// A file that was made, with its name below the output folder.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct File {
    /// the name
    pub name: String,
    /// the content
    pub text: String,
}
