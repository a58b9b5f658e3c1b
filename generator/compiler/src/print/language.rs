//! The description of a language for the printer: data and small functions. A program is not traversed here.

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
    /// whether a word is reserved by the language, or by the fixed text of a block
    pub(super) is_reserved: fn(&str) -> bool,
    /// the number of characters in which names of one scope must differ; a longer name loses parts of its path if that is
    /// sufficient. `None` if all characters are significant
    pub(super) significant: Option<usize>,
    /// names that are used unchanged although they are reserved: signals that a legalising pass adds
    pub(super) kept: &'static [&'static str],
    /// the names of BOOL, DINT, UDINT, LREAL and REAL
    pub(super) types: [&'static str; 5],
    /// the text of a value in a declaration
    pub literal: fn(Literal) -> String,
    /// the text of a value in a statement, and how tightly it binds
    pub operand: fn(Literal) -> (String, Level),
    /// the operators between two operands, in the order of [`portable::Binary`]
    pub(super) symbols: [&'static str; 13],
    /// minimum binding of the operands of an `and` and of an `or` without parentheses
    pub(super) logic: [Level; 2],
    /// the notation of an operation whose first operand has this type; `None` for its symbol
    pub(super) form: fn(&Expr, Type, RealKind) -> Option<Form>,
    /// whether the values of signals are enumerations that the caller can use
    pub(super) has_enumerations: bool,
    /// the appearance of each named number of a program; named numbers of signals are given if they are enumerations
    pub(super) appearances: fn(&Program, &[Signal]) -> Vec<Appearance>,
    /// the prefixes of an input, an output, a state, a constant and a local in a statement
    pub(super) before: [&'static str; 5],
    /// between the name of a parameter set and that of its part
    pub(super) inside: &'static str,
    /// whether inputs, outputs and state are three structs with separate names, instead of one scope
    pub(super) has_structs: bool,
    /// whether the names of constants are in capitals
    pub(super) has_capitals: bool,
    /// the declaration of a local with a name and a type among the statements: before its value, and without a value. `None`
    /// if locals are declared elsewhere
    pub(super) locals: Option<[Declaration; 2]>,
    /// between a target and its value
    pub(super) assign: &'static str,
    /// the texts of an `if`: before the first condition, before each further one, after a condition, before the statements
    /// if no condition holds, at the end
    pub(super) choice: [&'static str; 5],
    /// the comment in the `else` at the end of a chain of questions without further statements; `None` if a chain needs no
    /// such end
    pub(super) nothing_else: Option<&'static str>,
    /// the notation of a choice by a number
    pub(super) cases: Cases,
    /// before and after the index of an element of an array
    pub(super) index: [&'static str; 2],
    /// the statement that calls the separate function; `{block}` is the beginning of the block's names
    pub(super) call: &'static str,
    /// the beginning of a comment, the beginning of its next line, and its end
    pub(super) comment: [&'static str; 3],
}

/// The declaration of a name with a type.
pub(super) type Declaration = fn(&str, &str) -> String;

/// The notation of a choice by a number.
#[derive(Clone, Copy, Debug)]
pub(super) struct Cases {
    /// before and after the selecting expression
    pub asks: [&'static str; 2],
    /// before the first label of a list, between two labels, after the last one
    pub label: [&'static str; 3],
    /// whether labels are names, else digits with the names in a comment
    pub by_name: bool,
    /// before the list for every other number
    pub others: &'static str,
    /// for every other number, if there is nothing to do
    pub nothing: &'static str,
    /// at the end of each list, inside it and after it; without them, assignments are in the line of their labels, if they fit
    pub ends: [&'static str; 2],
    pub end: &'static str,
}

impl Language {
    /// The marks at the beginning and at the end of a comment; without the latter, a comment ends with its line.
    #[must_use]
    pub fn comment_marks(&self) -> [&'static str; 2] {
        let [begin, _, end] = self.comment;
        [begin.trim(), end.trim()]
    }

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

/// The notation of an operation.
pub(super) struct Form {
    pub level: Level,
    /// its text: `{0}` and `{1}` are its operands, `{block}` is the beginning of the block's names, a line break is a blank
    /// or, if a line is too long, a new line
    pub text: &'static str,
    /// minimum binding of its operands without parentheses
    pub least: [Level; 2],
}

/// The appearance of a named number in a block.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Appearance {
    /// its digits in the statements, followed by its name
    Inline,
    /// by its name, declared as a constant; if functions have their own constants, in the only function that reads it
    Declared,
    /// by its name with the block's name as prefix, declared as a constant outside all functions
    Shared,
    /// by its name, a variable that is assigned again in each cycle
    Assigned,
    /// by its name with the block's name as prefix, in capital letters: an enumerator that the caller can use
    Enumerator,
}
