//! The templates of TwinCAT.

use super::StBlock;
use askama::Template;

/// A function block.
#[derive(Template)]
#[template(path = "twincat/block.TcPOU")]
pub(crate) struct TcPou<'a> {
    pub(crate) origin: &'a str,
    pub(crate) id: &'a str,
    pub(crate) block: &'a StBlock,
}

/// The function that looks at a sample's exponent bits.
#[derive(Template)]
#[template(path = "twincat/in_range.TcPOU")]
pub(crate) struct TcInRange<'a> {
    pub(crate) version: &'a str,
    pub(crate) checksum: &'a str,
    pub(crate) id: String,
    pub(crate) name: &'a str,
    pub(crate) real: &'a str,
    /// the bit string of the same size
    pub(crate) word: &'a str,
    /// the exponent's bits
    pub(crate) exponent: &'a str,
}

/// The enumeration of the modes.
#[derive(Template)]
#[template(path = "twincat/mode.TcDUT")]
pub(crate) struct TcEnum<'a> {
    pub(crate) version: &'a str,
    pub(crate) checksum: &'a str,
    pub(crate) id: String,
    pub(crate) items: &'a [Item],
}

/// A value of an enumeration.
pub(crate) struct Item {
    pub(crate) name: &'static str,
    pub(crate) value: i32,
}

/// The union of a real and its bits.
#[derive(Template)]
#[template(path = "twincat/bits.TcDUT")]
pub(crate) struct TcUnion<'a> {
    pub(crate) version: &'a str,
    pub(crate) checksum: &'a str,
    pub(crate) id: String,
    pub(crate) real: &'a str,
    /// the bit string of the same size
    pub(crate) word: &'a str,
}

/// A recorded run of a block.
#[derive(Template)]
#[template(path = "twincat/vector.TcGVL")]
pub(crate) struct TcVector<'a> {
    pub(crate) origin: &'a str,
    pub(crate) id: &'a str,
    pub(crate) name: &'a str,
    pub(crate) last: usize,
    /// inputs and outputs
    pub(crate) tracks: &'a [Track],
}

/// A signal of a recorded run.
pub(crate) struct Track {
    pub(crate) name: String,
    /// the type of its values
    pub(crate) ty: &'static str,
    /// whether the values are the bits of reals
    pub(crate) is_bits: bool,
    pub(crate) values: String,
}

/// The suite that runs a block with its vector.
#[derive(Template)]
#[template(path = "twincat/suite.TcPOU")]
pub(crate) struct TcSuite<'a> {
    pub(crate) origin: &'a str,
    pub(crate) id: &'a str,
    pub(crate) method_id: &'a str,
    pub(crate) name: &'a str,
    pub(crate) block: &'a str,
    pub(crate) vector: &'a str,
    pub(crate) samples: usize,
    pub(crate) real: &'a str,
    /// what is read from the vector
    pub(crate) inputs: &'a [Track],
    /// what is compared with it
    pub(crate) outputs: &'a [Track],
}

/// The program that runs all suites.
#[derive(Template)]
#[template(path = "twincat/tests.TcPOU")]
pub(crate) struct TcProgram<'a> {
    pub(crate) version: &'a str,
    pub(crate) checksum: &'a str,
    pub(crate) id: String,
    pub(crate) suites: &'a [String],
}

/// What a project file has to name.
#[derive(Template)]
#[template(path = "twincat/axgen.plcproj")]
pub(crate) struct TcProject<'a> {
    pub(crate) version: &'a str,
    pub(crate) checksum: &'a str,
    /// what the machine runs
    pub(crate) objects: &'a [Compile],
    /// what only the tests need
    pub(crate) tests: &'a [Compile],
}

/// An entry of a project.
pub(crate) struct Compile {
    pub(crate) folder: &'static str,
    pub(crate) file: String,
}

/// The guide beside the files.
#[derive(Template)]
#[template(path = "twincat/IMPORT.md")]
pub(crate) struct TcGuide<'a> {
    pub(crate) version: &'a str,
    pub(crate) checksum: &'a str,
    /// a block `ipc`, for the example of a call; empty: there is none
    pub(crate) damping: &'a str,
    /// a block `axis`, for the example of a call; empty: there is none
    pub(crate) axis: &'a str,
    pub(crate) samples: usize,
}
