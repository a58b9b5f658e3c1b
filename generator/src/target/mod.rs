//! The target languages: each turns verified programs into files. A target never looks at a parameter.

mod c;
mod outline;
mod rust;
mod st;
mod structs;
mod unit;

pub(crate) use st::twincat::Cdata;

use crate::blocks::Block;
use crate::digest::with_checksum;
use askama::Template;
use compiler::legalise;
use compiler::pass::{Defect, Stage};
use compiler::program::Program;
use portable::RealKind;
use std::borrow::Cow;

/// The tool's version, which every generated file names.
pub(crate) const VERSION: &str = env!("CARGO_PKG_VERSION");

#[derive(Clone, Copy, Debug)]
pub struct Target {
    /// the name on the command line and in a set
    pub name: &'static str,
    /// the passes that make a program one that the language can say
    pub passes: &'static [Stage],
    /// the files of a block after these passes
    files: fn(&Header, &Legal<'_>) -> Vec<File>,
    /// the files that all axes of a set share
    pub shared: fn(&[Unit<'_>]) -> Vec<File>,
}

pub const TARGETS: [Target; 6] = [
    Target { name: "c", passes: legalise::WITH_OUTPUTS, files: c::files, shared: |_| Vec::new() },
    Target { name: "rust", passes: legalise::WITH_OUTPUTS, files: rust::files, shared: |_| Vec::new() },
    Target { name: "st", passes: legalise::WITH_DIGITS, files: st::plain, shared: |_| Vec::new() },
    Target { name: "twincat", passes: legalise::WITH_ENABLE, files: st::twincat::files, shared: st::twincat::shared },
    Target { name: "codesys", passes: legalise::WITH_ENABLE, files: st::codesys::files, shared: st::codesys::shared },
    Target { name: "scl", passes: legalise::WITH_ENABLE, files: st::scl, shared: st::scl_shared },
];

/// The targets of a set that names none.
pub const DEFAULT_TARGETS: [&str; 2] = ["c", "st"];

pub fn named(name: &str) -> Option<Target> {
    TARGETS.into_iter().find(|target| target.name == name)
}

impl Target {
    /// The program of a block as the language can say it.
    ///
    /// # Errors
    /// A defect of a legalising pass.
    pub fn program<'b>(&self, block: &'b Block) -> Result<Cow<'b, Program>, Defect> {
        legalise::run(&block.own.program, self.passes)
    }

    /// The files of a block.
    ///
    /// # Errors
    /// A defect of a legalising pass.
    pub fn files(&self, header: &Header, block: &Block) -> Result<Vec<File>, Defect> {
        Ok((self.files)(header, &Legal { program: self.program(block)?, block }))
    }
}

/// What the head of a file says of an axis and of a block.
#[derive(Clone, Debug)]
pub struct Header {
    pub name: String,
    pub real: RealKind,
    /// the cycle of its position controller
    pub cycle_time_ns: u32,
    /// whether it is a rotary axis or a spindle: its signals are in 0.001 deg, else in um
    pub is_rotary: bool,
    /// the digest of the effective parameters of the block
    pub parameters_digest: String,
}

/// A block with its program as the language of a target can say it.
#[derive(Clone, Debug)]
pub struct Legal<'b> {
    block: &'b Block,
    program: Cow<'b, Program>,
}

/// What a shared file may know of an axis: nothing that changes with a parameter other than the real type.
#[derive(Clone, Debug)]
pub struct Unit<'a> {
    pub axis: &'a str,
    pub real: RealKind,
    /// the names of its blocks
    pub blocks: Vec<&'static str>,
}

/// A file that was made, with its name below the output folder.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct File {
    /// the name; folders are separated by `/`
    pub name: String,
    pub text: String,
}

/// What the names of everything that an axis gets begin with.
pub fn stem(axis: &str) -> String {
    format!("axis_{}", axis.to_ascii_lowercase())
}

/// What the name of a block of an axis is in every target, but for a prefix.
pub fn block_name(axis: &str, block: &str) -> String {
    format!("{}_{block}", stem(axis))
}

/// A file from its template, behind a mark that some readers want at the very beginning.
fn rendered(name: &str, mark: &str, template: &impl Template) -> File {
    let mut text = template.render().expect("target: no input can keep a template from being filled");
    text.insert_str(0, mark);
    text.push('\n');
    File { name: name.to_owned(), text: with_checksum(text) }
}
