//! The target languages: each turns verified programs into files. A target never looks at a parameter.

pub mod c;
pub mod comment;
pub mod line;
pub mod names;
pub mod number;
pub mod outline;
pub mod st;

use crate::axis::Axis;
use crate::blocks::Block;
use crate::digest::seal;
use askama::Template;
use portable::RealKind;

/// The tool's version, which every generated file names.
const VERSION: &str = env!("CARGO_PKG_VERSION");

/// A target language.
#[derive(Clone, Copy, Debug)]
pub struct Target {
    /// the name on the command line and in a set
    pub name: &'static str,
    /// the files of an axis
    pub files: fn(&Axis, &[Block]) -> Vec<File>,
    /// the files that all axes of a set share
    pub shared: fn(&[Unit<'_>]) -> Vec<File>,
}

/// All targets.
pub const TARGETS: [Target; 5] = [
    Target { name: "c", files: c::files, shared: nothing },
    Target { name: "st", files: st::plain::files, shared: nothing },
    Target { name: "twincat", files: st::twincat::files, shared: st::twincat::shared },
    Target { name: "codesys", files: st::codesys::files, shared: st::codesys::shared },
    Target { name: "scl", files: st::scl::files, shared: nothing },
];

/// The targets of a set that names none.
pub const DEFAULT_TARGETS: [&str; 2] = ["c", "st"];

/// The target of that name.
#[must_use]
pub fn named(name: &str) -> Option<Target> {
    TARGETS.into_iter().find(|target| target.name == name)
}

/// What a shared file may know of an axis: nothing that changes with a parameter other than the real type.
#[derive(Clone, Debug)]
pub struct Unit<'a> {
    /// its name
    pub axis: &'a str,
    /// its real type
    pub real: RealKind,
    /// the names of its blocks
    pub blocks: Vec<&'static str>,
}

/// A file that was made, with its name below the output folder.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct File {
    /// the name; folders are separated by `/`
    pub name: String,
    /// the content
    pub text: String,
}

/// What the names of everything that an axis gets begin with.
#[must_use]
pub fn stem(axis: &str) -> String {
    format!("axis_{}", axis.to_ascii_lowercase())
}

/// What the name of a block of an axis is in every target, but for a prefix.
#[must_use]
pub fn block_name(axis: &str, block: &str) -> String {
    format!("{}_{block}", stem(axis))
}

/// A file from its template, behind a mark that some readers want at the very beginning.
fn sealed(name: String, mark: &str, template: &impl Template) -> File {
    let text = template.render().expect("target: no input can keep a template from being filled");
    File { name, text: seal(format!("{mark}{text}\n")) }
}

fn nothing(_: &[Unit<'_>]) -> Vec<File> {
    Vec::new()
}
