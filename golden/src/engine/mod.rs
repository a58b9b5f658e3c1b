//! Ways to run a block. All of them must give the same bits.

#[cfg(feature = "compilers")]
mod c;
#[cfg(feature = "compilers")]
mod compiler;
pub mod emitted;
#[cfg(feature = "compilers")]
mod process;
mod program;
mod reference;
#[cfg(feature = "compilers")]
pub mod rust;

#[cfg(feature = "compilers")]
pub use c::Harness;
#[cfg(feature = "compilers")]
pub use compiler::Compiler;
pub use reference::{Cycle, start};

use crate::samples::{Samples, Shape};
use generator::blocks::{Block, Designed};
use generator::generate::identity;
use generator::target::{self, File, Target};
use portable::Literal;
use st::Dialect;
use std::fmt;

/// A way to run a block.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Engine {
    /// the Rust source itself
    Reference,
    /// the specialised program, interpreted
    Program,
    /// the emitted C, compiled
    C,
    /// the emitted Rust, compiled
    Rust,
    /// the emitted Structured Text of the target `st`
    St,
    /// the Structured Text in the files of the target `twincat`
    TwinCat,
    /// the Structured Text in the files of the target `codesys`
    Codesys,
    /// the SCL of the target `scl`
    Scl,
}

/// All engines; the first one is the correct one.
pub const ENGINES: [Engine; 8] = [
    Engine::Reference,
    Engine::Program,
    Engine::C,
    Engine::Rust,
    Engine::St,
    Engine::TwinCat,
    Engine::Codesys,
    Engine::Scl,
];

impl Engine {
    /// Whether it runs compiled code: on a computer with a compiler, and with the feature `compilers`.
    #[must_use]
    pub fn is_compiled(self) -> bool {
        matches!(self, Self::C | Self::Rust)
    }
}

impl fmt::Display for Engine {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(match self {
            Self::Reference => "reference",
            Self::Program => "program",
            Self::C => "c",
            Self::Rust => "rust",
            Self::St => "st",
            Self::TwinCat => "twincat",
            Self::Codesys => "codesys",
            Self::Scl => "scl",
        })
    }
}

/// The reason why an engine could not run a block.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Failure {
    /// a program that the engine needs is missing; the text says what to install
    Environment(String),
    /// the compiler rejected the emitted file, as the file itself demands
    Refused(String),
    /// the self-test of the compiled block found other bits
    SelfTest(u32),
    /// a defect of axgen: the emitted file does not compile, or the engine aborted
    Broken(String),
}

impl fmt::Display for Failure {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Environment(text) | Self::Refused(text) | Self::Broken(text) => f.write_str(text),
            Self::SelfTest(sample) => {
                write!(f, "the self-test found other bits than the reference's, at sample {sample}")
            }
        }
    }
}

impl std::error::Error for Failure {}

/// Runs a block of an axis from its start.
///
/// # Errors
/// The engines `c` and `rust` need a compiler; the engines of Structured Text reject a text that implementations may
/// interpret differently.
pub fn run(engine: Engine, designed: &Designed, block: &Block, inputs: &Samples) -> Result<Samples, Failure> {
    match engine {
        Engine::Reference => Ok(reference::run(designed, block, inputs)),
        Engine::Program => Ok(program::run(block, inputs)),
        #[cfg(feature = "compilers")]
        Engine::C => run_c(designed, block, inputs, &Compiler::host()),
        #[cfg(feature = "compilers")]
        Engine::Rust => rust::run(designed, block, inputs),
        #[cfg(not(feature = "compilers"))]
        Engine::C | Engine::Rust => Err(Failure::Environment(format!("there is no compiler here for engine {engine}"))),
        Engine::St => emitted::run(Dialect::Plain, designed, block, inputs),
        Engine::TwinCat => emitted::run(Dialect::TwinCat, designed, block, inputs),
        Engine::Codesys => emitted::run(Dialect::Codesys, designed, block, inputs),
        Engine::Scl => emitted::run(Dialect::Scl, designed, block, inputs),
    }
}

/// The outputs of a block after each sample of its inputs.
fn answers(block: &Block, inputs: &Samples, mut cycle: impl FnMut(&[Literal], &mut Vec<Literal>)) -> Samples {
    let mut samples = Samples::with_capacity(Shape::of(&block.program.outputs, block.program.real), inputs.len());
    let (mut values, mut outputs) = (Vec::new(), Vec::new());
    for sample in 0..inputs.len() {
        inputs.read(sample, &mut values);
        cycle(&values, &mut outputs);
        samples.push(&outputs);
    }
    samples
}

fn target(name: &str) -> Target {
    target::named(name).expect("engine: there is such a target")
}

/// The files of a block in a target.
fn files(target: Target, designed: &Designed, block: &Block) -> Result<Vec<File>, Failure> {
    target.files(&identity(&designed.axis, block), block).map_err(|defect| Failure::Broken(defect.to_string()))
}

/// The files of the block `ipc` if they declare the type of the parameter sets that a block takes or makes; else empty.
///
/// # Errors
/// A defect of the target.
pub fn of_set(target: Target, designed: &Designed, block: &Block) -> Result<Vec<File>, Failure> {
    if !block.shares_set() {
        return Ok(Vec::new());
    }
    files(target, designed, &taker(designed)?)
}

/// The header that the emitted C of a block includes: that of the block which declares the type of its parameter sets. Empty if
/// it has none.
///
/// # Errors
/// A defect of the target.
pub fn headers(designed: &Designed, block: &Block) -> Result<Vec<File>, Failure> {
    let mut files = of_set(target("c"), designed, block)?;
    files.retain(|file| file.name.ends_with(".h"));
    Ok(files)
}

/// The block that declares the type of the parameter sets.
fn taker(designed: &Designed) -> Result<Block, Failure> {
    let kind = generator::blocks::named("ipc").expect("engine: there is the block");
    kind.block(designed).map_err(|defect| Failure::Broken(defect.to_string()))
}

/// Runs a block through the emitted C and the given compiler.
///
/// # Errors
/// The compiler is missing or rejects the block, or the block fails its self-test.
#[cfg(feature = "compilers")]
pub fn run_c(designed: &Designed, block: &Block, inputs: &Samples, compiler: &Compiler) -> Result<Samples, Failure> {
    Harness::compile(designed, block, compiler)?.run(inputs, compiler)
}
