//! From files to their values, each with its place: a TOML set or one axis list. No rule is here.
//!
//! ```text
//! file         a file's bytes, bounded             encoding bytes <-> text
//! source       byte -> line, column                project  where a file has its axis lists
//! nc_axis      an axis of TwinCAT NC as a list
//! lines        a list's bytes <-> the parts of its lines
//! list, set    lines or tables -> (path, text)
//! toml_fault   errors of TOML's parser, in words
//! own_key      axgen's own keys in comments of a list
//! odd_line     lines without a parameter           other_kind files that are not lists
//! other_functions  used parameters of other functions
//! shape        a path -> its parts and indices      path     path -> parameter and indices
//! closest      the name that was meant
//! value        text -> value of the parameter's kind
//! toml_value   value of a set -> value of the parameter's kind
//! values       what was given, each with its place
//! given        all of it, for a set or for a list
//! stage_option stages of the command line as keys
//! ```

pub(crate) mod axis_name;
pub mod closest;
pub(crate) mod encoding;
pub(crate) mod file;
pub(crate) mod given;
pub(crate) mod lines;
pub(crate) mod list;
pub(crate) mod nc_axis;
pub(crate) mod odd_line;
pub(crate) mod other_functions;
pub(crate) mod other_kind;
pub(crate) mod own_key;
pub(crate) mod path;
pub(crate) mod project;
pub(crate) mod set;
mod shape;
pub(crate) mod source;
pub(crate) mod stage_option;
pub(crate) mod toml_fault;
pub(crate) mod toml_value;
pub(crate) mod value;
pub(crate) mod values;

pub(crate) use encoding::{Encoding, latin_1};
pub use file::{LARGEST, LARGEST_SAMPLES, Load, Unreadable, is_set, load, load_from, load_up_to};
pub use given::{ListOptions, OptionKey, axes_of_project};
pub(crate) use project::AxisList;
pub(crate) use set::AxisTable;
pub(crate) use source::Source;
pub use stage_option::stage_keys;
pub(crate) use toml_value::of_toml;
pub(crate) use value::{of_text, shown, spelled};
pub(crate) use values::{Key, Setting, Values, key};

/// The text of a file for messages, in any encoding.
pub fn text(bytes: Vec<u8>) -> Vec<u8> {
    encoding::decoded(bytes).0
}

/// The characters of a file in any encoding: if it is neither UTF-8 nor UTF-16, it is read as Latin-1.
pub fn characters(bytes: Vec<u8>) -> String {
    String::from_utf8(text(bytes)).unwrap_or_else(|error| latin_1(error.as_bytes()))
}
