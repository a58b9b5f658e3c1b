//! C99: names, types, and statements as text. The skeletons of the files are templates.

mod expression;
mod file;
pub mod names;
pub mod print;
mod scope;
pub mod types;

pub use file::files;
