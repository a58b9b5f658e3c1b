//! From files to the values that they give, each with its place: a TOML set or one axis list. No rule is here.
//!
//! ```text
//! file         a file's bytes, bounded             source   byte -> line, column
//! lines        a list's bytes <-> the parts of its lines
//! list, set    lines or tables -> (path, text)
//! path         path -> parameter and indices       closest  the name that was meant
//! value        text -> value of the parameter's kind
//! values       what was given, each with its place
//! given        all of it, for a set or for a list
//! ```

pub(crate) mod axis_name;
pub(crate) mod closest;
pub(crate) mod file;
pub(crate) mod given;
pub(crate) mod lines;
pub(crate) mod list;
pub(crate) mod path;
pub(crate) mod set;
pub(crate) mod source;
pub(crate) mod value;
pub(crate) mod values;

pub use file::{LARGEST_SAMPLES, Load, Unreadable, load, load_from, load_up_to};
pub use given::ListOptions;
pub(crate) use set::AxisTable;
pub(crate) use source::Source;
pub(crate) use value::{of_text, of_toml, shown};
pub(crate) use values::{Key, Setting, Values, key};
