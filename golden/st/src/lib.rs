//! Structured Text: read, checked against the portable subset, and run bit by bit as by a controller; the crate's parts and
//! its public interface. It knows no generator, no axis, and only the file that it reads.
#![forbid(unsafe_code)]

mod binary;
mod block;
mod call;
mod changed;
mod choice;
mod constant;
mod declarations;
mod expression;
mod inner;
mod kind;
mod known;
mod lexical;
mod lower;
mod lowering;
mod machine;
mod mistake;
mod names;
mod number;
mod op;
mod plcopen;
mod program;
mod read;
mod run;
mod scl;
mod single;
mod source;
mod structure;
mod syntax;
mod twincat;
mod types;
mod variables;
mod whole;
mod xml;

#[cfg(test)]
#[path = "../unit/evaluation.rs"]
mod evaluation;

pub use block::Block;
pub use mistake::Mistake;
pub use program::Program;
pub use run::{Instance, Signal};

/// Maximum nesting of expressions and statements: emitted text never reaches it, and deeper text would overflow the stack.
const DEPTH: usize = 500;

/// The form of a file, and the compilers that must accept it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Dialect {
    /// the text itself, for every compiler
    Plain,
    /// a `.TcPOU`
    TwinCat,
    /// PLCopen XML, `tc6_0200`
    Codesys,
    /// an external source of Siemens S7-1200 and S7-1500
    Scl,
}

impl Dialect {
    pub const ALL: [Self; 4] = [Self::Plain, Self::TwinCat, Self::Codesys, Self::Scl];
}
