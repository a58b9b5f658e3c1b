//! The templates of Structured Text: plain, CODESYS and SCL.

use super::{Group, Member};
use askama::Template;

/// The comment that names a file's origin.
#[derive(Template)]
#[template(path = "st/origin.st")]
pub struct Origin<'a> {
    /// the file's name
    pub file: &'a str,
    /// the tool's version
    pub version: &'a str,
    /// the axis
    pub axis: &'a str,
    /// name of the real type
    pub real: &'a str,
    /// position-controller cycle
    pub cycle_time_ns: u32,
    /// digest of the axis's effective parameters
    pub parameters_digest: &'a str,
    /// digest of the file
    pub body_digest: &'a str,
    /// what is certain of the blocks in the file, and their measured response; empty where there is no block
    pub certificate: &'a str,
}

/// One block.
pub struct StBlock {
    /// the function block's name
    pub name: String,
    /// inputs with their start
    pub inputs: Vec<Member>,
    /// outputs
    pub outputs: Vec<Member>,
    /// the state
    pub state: Vec<Member>,
    /// intermediate values
    pub locals: Vec<Member>,
    /// numbers that stand in the statements
    pub inline: Vec<Group>,
    /// numbers that are declared
    pub declared: Vec<Group>,
    /// numbers that each cycle assigns anew
    pub assigned: Vec<Group>,
    /// the statements
    pub body: String,
}

impl StBlock {
    /// The variables that [`Self::assigned`] needs.
    #[must_use]
    pub fn assigned_variables(&self) -> Vec<&super::ConstantText> {
        self.assigned.iter().flat_map(|group| &group.constants).collect()
    }
}

/// A file of the target `st`.
#[derive(Template)]
#[template(path = "st/file.st")]
pub struct PlainFile<'a> {
    /// the comment at the top
    pub origin: &'a str,
    /// the blocks of the axis
    pub blocks: &'a [StBlock],
}

/// A file of the target `scl`.
#[derive(Template)]
#[template(path = "scl/file.scl")]
pub struct SclFile<'a> {
    /// the comment at the top
    pub origin: &'a str,
    /// the blocks of the axis
    pub blocks: &'a [StBlock],
}

/// A file of the target `codesys`.
#[derive(Template)]
#[template(path = "codesys/file.xml")]
pub struct CodesysFile<'a> {
    /// the comment at the top
    pub origin: &'a str,
    /// the tool's version
    pub version: &'a str,
    /// the project's name
    pub name: &'a str,
    /// the blocks of the axis
    pub blocks: &'a [StBlock],
}

/// The file of CODESYS that all axes share.
#[derive(Template)]
#[template(path = "codesys/usable.xml")]
pub struct CodesysUsable<'a> {
    /// the tool's version
    pub version: &'a str,
    /// the project's name
    pub name: &'a str,
    /// digest of the file
    pub body_digest: &'a str,
    /// one function for each real type
    pub functions: &'a [super::TcUsable<'a>],
}
