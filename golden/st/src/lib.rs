//! Structured Text: read, checked against the portable subset, and run bit by bit as by a controller; the crate's parts and
//! its public interface. It knows no generator, no axis, and only the file that it reads.
//!
//! ```text
//! source         file -> text, and the origin of each part; twincat, plcopen, scl: the forms around it; xml: for two of
//! them
//! lexical        letters, comments, pragmas, numbers; number: the forms and values of numbers; names: those to avoid
//! syntax         text -> tree, with an independent grammar
//! declarations   VAR blocks -> variables; constant: values in the text
//! variables      the variables and their slots; kind: the types and their values
//! lower          statements -> operations on slots; choice: IF, CASE; inner: instances of other blocks; whole: structures
//!                as values; expression, binary, call: their parts; single: how much of them a statement of REAL may hold;
//!                lowering: their common data
//! known          declarations in other files; program: the files of a program with its blocks, read one after another
//! block          the data of a block; read: a file -> a block; changed: a block that differs from its text
//! op             the operations; machine: their execution; run: an instance of a block, cycle by cycle
//! mistake        errors with their places
//! ```
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
