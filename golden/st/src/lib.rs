//! Structured Text, read, held against the portable subset, and run bit by bit as a controller would: the crate's parts and what
//! other crates see of them. It knows no generator, no axis, and no file but the one that it reads.
//!
//! ```text
//! source         file -> text, and where each part of it comes from; twincat, plcopen, scl: the forms around it; xml: for two of them
//! lexical        letters, comments, pragmas, numbers; number: the forms and values of numbers; names: those to avoid
//! syntax         text -> tree, by a grammar that is not ours
//! declarations   VAR blocks -> variables; constant: values that the text has
//! variables      the variables and their slots; kind: the types and their values
//! lower          statements -> operations on slots; choice: IF, CASE; inner: instances of other blocks; expression, binary, call:
//!                their parts; single: how much of them a statement of REAL may hold; lowering: what they share
//! known          what stands in other files; program: the files of a program with its blocks, read one after another
//! block          what a block is; read: a file -> a block; changed: a block that differs from its text
//! op             the operations; machine: what they do; run: an instance of a block, cycle by cycle
//! mistake        what is wrong, and where
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
mod xml;

#[cfg(test)]
#[path = "../unit/evaluation.rs"]
mod evaluation;

pub use block::Block;
pub use mistake::Mistake;
pub use program::Program;
pub use run::{Instance, Signal};

/// Expressions and statements inside each other, at most: more would be no emitted text, but the end of the stack.
const DEPTH: usize = 500;

/// Which form a file has, and which compilers have to take it.
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
