//! The templates of Structured Text: plain, CODESYS and SCL.

use super::{Group, Member};
use askama::Template;

/// The comment that names a file's origin.
#[derive(Template)]
#[template(path = "st/origin.st")]
pub(crate) struct Origin<'a> {
    pub(crate) file: &'a str,
    pub(crate) version: &'a str,
    pub(crate) axis: &'a str,
    pub(crate) real: &'a str,
    pub(crate) cycle_time_ns: u32,
    pub(crate) parameters_digest: &'a str,
    pub(crate) checksum: &'a str,
    /// what is certain of the blocks in the file, and their measured response; empty where there is no block
    pub(crate) certificate: &'a str,
}

/// One block.
pub(crate) struct StBlock {
    pub(crate) name: String,
    pub(crate) inputs: Vec<Member>,
    pub(crate) outputs: Vec<Member>,
    pub(crate) state: Vec<Member>,
    pub(crate) locals: Vec<Member>,
    /// numbers that stand in the statements
    pub(crate) inline: Vec<Group>,
    /// numbers that are declared
    pub(crate) declared: Vec<Group>,
    /// numbers that each cycle assigns anew
    pub(crate) assigned: Vec<Group>,
    pub(crate) body: String,
}

impl StBlock {
    /// The variables that [`Self::assigned`] needs.
    #[must_use]
    pub(crate) fn assigned_variables(&self) -> Vec<&super::ConstantText> {
        self.assigned.iter().flat_map(|group| &group.constants).collect()
    }
}

/// A file of the target `st`.
#[derive(Template)]
#[template(path = "st/file.st")]
pub(crate) struct PlainFile<'a> {
    pub(crate) origin: &'a str,
    pub(crate) blocks: &'a [StBlock],
}

/// A file of the target `scl`.
#[derive(Template)]
#[template(path = "scl/file.scl")]
pub(crate) struct SclFile<'a> {
    pub(crate) origin: &'a str,
    pub(crate) blocks: &'a [StBlock],
}

/// A file of the target `codesys`.
#[derive(Template)]
#[template(path = "codesys/file.xml")]
pub(crate) struct CodesysFile<'a> {
    pub(crate) origin: &'a str,
    pub(crate) version: &'a str,
    pub(crate) name: &'a str,
    pub(crate) blocks: &'a [StBlock],
}

/// The file of CODESYS that all axes share.
#[derive(Template)]
#[template(path = "codesys/in_range.xml")]
pub(crate) struct CodesysInRange<'a> {
    pub(crate) version: &'a str,
    pub(crate) name: &'a str,
    pub(crate) checksum: &'a str,
    /// one function for each real type
    pub(crate) functions: &'a [super::TcInRange<'a>],
}
