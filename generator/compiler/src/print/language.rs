//! What a language is to the printer: data and small functions. No walk over a program.

use crate::program::{Program, Type};
use portable::{Binary, Intrinsic, Literal, RealKind, Unary};

/// How tightly an expression binds, in the order of one language, loosest first.
pub type Level = u8;

/// The level of a name, a number and a call: they never need parentheses.
pub const PRIMARY: Level = Level::MAX;

/// Writes the declaration of a local from its type and its name.
pub type Declaration = fn(&str, &str) -> String;

/// A language, or a dialect of one.
#[derive(Clone, Copy, Debug)]
pub struct Language {
    /// whether the language, or a block's own text, keeps a word for itself
    pub is_reserved: fn(&str) -> bool,
    /// names that are given as they are, although they are reserved: signals that a legalising pass adds
    pub kept: &'static [&'static str],
    /// the name of a type
    pub ty: fn(Type, RealKind) -> &'static str,
    /// the text of a value in a declaration
    pub literal: fn(Literal) -> String,
    /// the text of a value in a statement, and how tightly it binds
    pub operand: fn(Literal) -> (String, Level),
    /// how an operation is written whose first operand has this type
    pub form: fn(Operation, Type, RealKind) -> Form,
    /// how each named number of a program appears
    pub appearances: fn(&Program) -> Vec<Appearance>,
    /// what stands before the name of an input, an output, a state, a constant and a local in a statement
    pub before: [&'static str; 5],
    /// whether inputs, outputs and state are three structs, each with names of its own, instead of one scope
    pub has_structs: bool,
    /// how a local is declared among the statements: with its value, and without; `None`: elsewhere
    pub declaration: Option<[Declaration; 2]>,
    /// between a target and its value
    pub assign: &'static str,
    /// what stands around conditions and lists
    pub question: Question,
    /// what begins a comment, begins its next line, and ends it
    pub comment: [&'static str; 3],
}

/// The words of a choice.
#[derive(Clone, Copy, Debug)]
pub struct Question {
    /// before the first condition
    pub first: &'static str,
    /// before each further condition
    pub next: &'static str,
    /// after a condition
    pub then: &'static str,
    /// before what happens where no condition holds
    pub otherwise: &'static str,
    /// the end
    pub end: &'static str,
}

/// What has operands.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Operation {
    /// an operator with one
    Unary(Unary),
    /// an operator with two
    Binary(Binary),
    /// an operation that each language writes in its own way
    Intrinsic(Intrinsic),
}

/// How an operation is written.
#[derive(Clone, Copy, Debug)]
pub enum Form {
    /// the symbol between two operands, which bind at least as tightly as said
    Infix(Level, &'static str, [Level; 2]),
    /// pieces in their order
    Pieces(Level, &'static [Piece]),
}

/// A piece of an operation's text.
#[derive(Clone, Copy, Debug)]
pub enum Piece {
    /// the text itself
    Text(&'static str),
    /// an operand by its position, which binds at least as tightly as said, or gets parentheses
    Operand(usize, Level),
    /// a blank, or a new line where the line is too long
    Blank,
}

/// How a named number appears in a block.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Appearance {
    /// its digits in the statements, its name behind them
    Inline,
    /// by its name, declared as a constant
    Declared,
    /// by its name, a variable that each cycle assigns anew
    Assigned,
}
