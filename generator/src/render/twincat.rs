//! The templates of TwinCAT.

use super::StBlock;
use askama::Template;

/// A function block.
#[derive(Template)]
#[template(path = "twincat/block.TcPOU")]
pub struct TcPou<'a> {
    /// the comment at the top
    pub origin: &'a str,
    /// the object's GUID
    pub id: &'a str,
    /// the block
    pub block: &'a StBlock,
}

/// The function that looks at a sample's exponent bits.
#[derive(Template)]
#[template(path = "twincat/usable.TcPOU")]
pub struct TcUsable<'a> {
    /// the tool's version
    pub version: &'a str,
    /// digest of the file
    pub body_digest: &'a str,
    /// the object's GUID
    pub id: String,
    /// the function's name
    pub name: &'a str,
    /// name of the real type
    pub real: &'a str,
    /// the bit string of the same size
    pub word: &'a str,
    /// the exponent's bits
    pub exponent: &'a str,
}

/// The enumeration of the modes.
#[derive(Template)]
#[template(path = "twincat/mode.TcDUT")]
pub struct TcEnum<'a> {
    /// the tool's version
    pub version: &'a str,
    /// digest of the file
    pub body_digest: &'a str,
    /// the object's GUID
    pub id: String,
    /// the modes
    pub items: &'a [Item],
}

/// A value of an enumeration.
pub struct Item {
    /// its name
    pub name: &'static str,
    /// its number
    pub value: i32,
}

/// The union of a real and its bits.
#[derive(Template)]
#[template(path = "twincat/bits.TcDUT")]
pub struct TcUnion<'a> {
    /// the tool's version
    pub version: &'a str,
    /// digest of the file
    pub body_digest: &'a str,
    /// the object's GUID
    pub id: String,
    /// name of the real type
    pub real: &'a str,
    /// the bit string of the same size
    pub word: &'a str,
}

/// A recorded run of a block.
#[derive(Template)]
#[template(path = "twincat/vector.TcGVL")]
pub struct TcVector<'a> {
    /// the comment at the top
    pub origin: &'a str,
    /// the object's GUID
    pub id: &'a str,
    /// the list's name
    pub name: &'a str,
    /// the last sample
    pub last: usize,
    /// inputs and outputs
    pub tracks: &'a [Track],
}

/// A signal of a recorded run.
pub struct Track {
    /// its name
    pub name: String,
    /// the type of its values
    pub ty: &'static str,
    /// whether the values are the bits of reals
    pub is_bits: bool,
    /// the values
    pub values: String,
}

/// The suite that runs a block with its vector.
#[derive(Template)]
#[template(path = "twincat/suite.TcPOU")]
pub struct TcSuite<'a> {
    /// the comment at the top
    pub origin: &'a str,
    /// the object's GUID
    pub id: &'a str,
    /// the method's GUID
    pub method_id: &'a str,
    /// the suite's name
    pub name: &'a str,
    /// the function block
    pub block: &'a str,
    /// the list with the vector
    pub vector: &'a str,
    /// how many samples
    pub samples: usize,
    /// name of the real type
    pub real: &'a str,
    /// what is read from the vector
    pub inputs: &'a [Track],
    /// what is compared with it
    pub outputs: &'a [Track],
}

/// The program that runs all suites.
#[derive(Template)]
#[template(path = "twincat/tests.TcPOU")]
pub struct TcProgram<'a> {
    /// the tool's version
    pub version: &'a str,
    /// digest of the file
    pub body_digest: &'a str,
    /// the object's GUID
    pub id: String,
    /// the suites
    pub suites: &'a [String],
}

/// What a project file has to name.
#[derive(Template)]
#[template(path = "twincat/axgen.plcproj")]
pub struct TcProject<'a> {
    /// the tool's version
    pub version: &'a str,
    /// digest of the file
    pub body_digest: &'a str,
    /// what the machine runs
    pub objects: &'a [Compile],
    /// what only the tests need
    pub tests: &'a [Compile],
}

/// An entry of a project.
pub struct Compile {
    /// the folder
    pub folder: &'static str,
    /// the file in it
    pub file: String,
}

/// The guide beside the files.
#[derive(Template)]
#[template(path = "twincat/IMPORT.md")]
pub struct TcGuide<'a> {
    /// the tool's version
    pub version: &'a str,
    /// digest of the file
    pub body_digest: &'a str,
    /// a block `ipc`, for the example of a call; empty: there is none
    pub damping: &'a str,
    /// a block `axis`, for the example of a call; empty: there is none
    pub axis: &'a str,
    /// of a recorded run
    pub samples: usize,
}
