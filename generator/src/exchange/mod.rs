//! An axis list to a TOML set and back, nothing lost. The lines of a list are split in `config/lines.rs`.
//!
//! ```text
//! import    list -> set: values to the tree, lines with holes      tree      parameters by their paths
//! export    set -> which lines, which values                       print     the tree as TOML, with the comments
//! fill      values -> the holes of the lines                       encoding  lines as a text of TOML, and back
//! slot      where the value stands in a line                       spelling  a value's text in a list <-> in TOML
//! ```
//! The set has each value once, where a reader of TOML looks for it. The lines of the list stay in the set too, with `=`
//! where a value was: they give order, blanks, comments and the parameters of other functions back.

mod encoding;
mod export;
mod fill;
mod import;
mod print;
mod slot;
mod spelling;
mod tree;

pub use export::{export, export_with};
pub use import::{import, import_with};
