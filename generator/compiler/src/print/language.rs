//! The description of a language for the printer: data and small functions. No walk over a program.

use crate::program::values::Signal;
use crate::program::{Expr, Program, Type};
use portable::{Literal, RealKind};

/// How tightly an expression binds, loosest first.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Level {
    /// gets parentheses next to every operator
    Any,
    Or,
    And,
    Comparison,
    /// a sum or a difference
    Sum,
    /// a product or a quotient
    Product,
    /// a sign, a negation, a cast
    Sign,
    /// a name, a number or a call: it never needs parentheses
    Primary,
}

/// A language, or a dialect of one.
#[derive(Clone, Copy, Debug)]
pub struct Language {
    /// whether the language, or a block's own text, keeps a word for itself
    pub(super) is_reserved: fn(&str) -> bool,
    /// the characters in which names of one scope must differ; a longer name loses parts of its path where that shortens it
    /// enough. `None`: all of them count
    pub(super) significant: Option<usize>,
    /// names that are given as they are, although they are reserved: signals that a legalising pass adds
    pub(super) kept: &'static [&'static str],
    /// the names of BOOL, DINT, UDINT, LREAL and REAL
    pub(super) types: [&'static str; 5],
    /// the text of a value in a declaration
    pub literal: fn(Literal) -> String,
    /// the text of a value in a statement, and how tightly it binds
    pub operand: fn(Literal) -> (String, Level),
    /// the operators between two operands, in the order of [`portable::Binary`]
    pub(super) symbols: [&'static str; 13],
    /// how tightly the operands of an `and` and of an `or` bind at least, or they get parentheses
    pub(super) logic: [Level; 2],
    /// how an operation is written whose first operand has this type; `None`: by its symbol
    pub(super) form: fn(&Expr, Type, RealKind) -> Option<Form>,
    /// whether the values of signals are enumerations that the caller sees
    pub(super) has_enumerations: bool,
    /// how each named number of a program appears; those of signals are known where they are enumerations
    pub(super) appearances: fn(&Program, &[Signal]) -> Vec<Appearance>,
    /// what stands before the name of an input, an output, a state, a constant and a local in a statement
    pub(super) before: [&'static str; 5],
    /// between the name of a parameter set and that of its part
    pub(super) inside: &'static str,
    /// whether inputs, outputs and state are three structs, each with names of its own, instead of one scope
    pub(super) has_structs: bool,
    /// whether the names of constants are in capitals
    pub(super) has_capitals: bool,
    /// how a local of a name and a type is declared among the statements: before its value, and without one. `None`: locals are
    /// declared elsewhere
    pub(super) locals: Option<[Declaration; 2]>,
    /// between a target and its value
    pub(super) assign: &'static str,
    /// the texts of an `if`: before the first condition, before each further one, after a condition, before the statements
    /// for which no condition holds, at the end
    pub(super) choice: [&'static str; 5],
    /// the comment in the `else` that ends a chain of questions in which nothing is left to do; `None`: a chain needs no such
    /// end
    pub(super) nothing_else: Option<&'static str>,
    /// how a choice by a number is written
    pub(super) cases: Cases,
    /// the statement that calls what stands apart; `{block}` is what the names of the block begin with
    pub(super) call: &'static str,
    /// what begins a comment, begins its next line, and ends it
    pub(super) comment: [&'static str; 3],
}

/// How a name of a type is declared.
pub(super) type Declaration = fn(&str, &str) -> String;

/// How a choice by a number is written.
#[derive(Clone, Copy, Debug)]
pub(super) struct Cases {
    /// before and after the selecting expression
    pub asks: [&'static str; 2],
    /// before the first label of a list, between two labels, after the last one
    pub label: [&'static str; 3],
    /// whether numbers stand there by their names, else as digits with the names in a comment
    pub by_name: bool,
    /// before the list for every other number
    pub others: &'static str,
    /// for every other number, where there is nothing to do
    pub nothing: &'static str,
    /// at the end of each list, inside it and after it
    pub ends: [&'static str; 2],
    /// at the end
    pub end: &'static str,
}

impl Language {
    pub fn ty(&self, ty: Type, real: RealKind) -> &'static str {
        self.types[match (ty, real) {
            (Type::Bool, _) => 0,
            (Type::I32, _) => 1,
            (Type::U32, _) => 2,
            (Type::Real, RealKind::F64) => 3,
            (Type::Real, RealKind::F32) => 4,
        }]
    }
}

/// How an operation is written.
pub(super) struct Form {
    pub level: Level,
    /// its text: `{0}` and `{1}` are its operands, `{block}` is what the names of the block begin with, a line break is a blank
    /// or, in a line that is too long, a new line
    pub text: &'static str,
    /// how tightly its operands bind at least, or they get parentheses
    pub least: [Level; 2],
}

/// How a named number appears in a block.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Appearance {
    /// its digits in the statements, followed by its name
    Inline,
    /// by its name, declared as a constant; where functions have constants of their own, in the only one that reads it
    Declared,
    /// by its name with the block's name as prefix, declared as a constant outside all functions
    Shared,
    /// by its name, a variable that each cycle assigns anew
    Assigned,
    /// by its name with the block's name as prefix, in capital letters: an enumerator that the caller sees
    Enumerator,
}
