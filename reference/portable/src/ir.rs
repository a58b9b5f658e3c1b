//! Functions of portable Rust as data: what `#[portable]` writes and the specialiser reads. No behaviour here.
//!
//! Everything is `'static` and borrowed, so that a function's IR is one constant. Variants with a reference inside have
//! named fields: rustc extends the lifetime of what such a field borrows, but not of a constructor's argument.

use crate::{Literal, Ty};

/// A function.
#[derive(Debug)]
pub struct Fn {
    /// the Rust name
    pub name: &'static str,
    /// the Rust module that holds it, for messages
    pub module: &'static str,
    /// the doc comment
    pub doc: &'static str,
    /// the parameters
    pub params: &'static [Param],
    /// the type of the value, if there is one
    pub returns: Option<Ty>,
    /// what it does
    pub body: Body,
}

/// The body of a function: an operation that each target knows, or a block.
#[derive(Debug)]
pub struct Body {
    /// set where each target prints the function in its own way
    pub intrinsic: Option<Intrinsic>,
    /// the block, empty for an intrinsic
    pub block: CodeBlock,
}

/// An operation that each target prints in its own way.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Intrinsic {
    /// [`crate::in_range`]
    InRange,
    /// [`crate::within`]
    Within,
    /// [`crate::from_u32`]
    FromU32,
    /// [`crate::from_i32`]
    FromI32,
    /// [`crate::unsigned`]
    Unsigned,
    /// the number of double precision, which single precision represents, as one of it: only before an output of that type
    Narrow,
    /// [`crate::truncate`]
    Truncate,
    /// [`crate::nearest`]
    Nearest,
}

/// A parameter.
#[derive(Debug)]
pub struct Param {
    /// the Rust name
    pub name: &'static str,
    /// by value, or how it is borrowed
    pub mode: Mode,
    /// the type, without the borrow
    pub ty: Ty,
}

/// How a parameter is passed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Mode {
    /// a scalar
    Value,
    /// `&T`
    Shared,
    /// `&mut T`
    Mutable,
}

/// Statements, then perhaps a value.
#[derive(Debug)]
pub struct CodeBlock {
    /// in the order of their execution
    pub statements: &'static [Statement],
    /// the last expression
    pub value: Option<&'static Expr>,
}

/// A statement.
#[derive(Debug)]
pub enum Statement {
    /// `let name = value;`
    Let {
        /// the name; no other local of the function has it
        name: &'static str,
        /// the value
        value: &'static Expr,
    },
    /// `let name = Type::default();`: a struct of this function
    Default {
        /// the name; no other local of the function has it
        name: &'static str,
        /// its type
        ty: Ty,
        /// hands out its scalars in the order of the type
        leaves: fn(&mut dyn FnMut(Literal)),
    },
    /// `note("...");`
    Note {
        /// the text of the comment
        text: &'static str,
    },
    /// `place = value;`
    Assign {
        /// what is written
        place: Place,
        /// the value
        value: &'static Expr,
    },
    /// `for variable in from..to { body }`
    For {
        /// the loop variable, a `usize`
        variable: &'static str,
        /// the first value
        from: &'static Expr,
        /// one past the last value
        to: &'static Expr,
        /// what is repeated
        body: CodeBlock,
    },
    /// a call, an `if` or a `match` whose value is not used
    Expr {
        /// the expression
        value: &'static Expr,
    },
}

/// An expression. A call with a mutable argument, an `if` and a `match` occur only where a whole value is expected.
#[derive(Debug)]
pub enum Expr {
    /// a value that rustc evaluates
    Constant {
        /// evaluates it
        value: fn() -> Literal,
    },
    /// what a place holds
    Read {
        /// the place
        place: Place,
    },
    /// an operator with one operand
    Unary {
        /// the operator
        operator: Unary,
        /// the operand
        operand: &'static Expr,
    },
    /// an operator with two operands
    Binary {
        /// the operator
        operator: Binary,
        /// left operand
        left: &'static Expr,
        /// right operand
        right: &'static Expr,
    },
    /// a call
    Call {
        /// the called function
        function: &'static Fn,
        /// its arguments
        arguments: &'static [Argument],
    },
    /// `if condition { then } else { otherwise }`
    If {
        /// the condition
        condition: &'static Expr,
        /// the block if the condition holds
        then: CodeBlock,
        /// the block if it does not
        otherwise: CodeBlock,
    },
    /// `match scrutinee { arms }`
    Match {
        /// the value that is compared: an enum, an integer or a bool
        scrutinee: &'static Expr,
        /// the arms in order
        arms: &'static [Arm],
    },
    /// `[a, b, c]`
    Array {
        /// the elements
        elements: &'static [Expr],
    },
    /// `[value; len]`
    Repeat {
        /// each element
        value: &'static Expr,
        /// the number of elements
        len: usize,
    },
}

/// An arm of a `match`.
#[derive(Debug)]
pub struct Arm {
    /// the values that choose it; empty for the wildcard
    pub patterns: &'static [fn() -> Literal],
    /// its body
    pub body: CodeBlock,
}

/// An argument of a call.
#[derive(Debug)]
pub enum Argument {
    /// a scalar
    Value {
        /// its value
        value: Expr,
    },
    /// `&place` or `&mut place`
    Borrow {
        /// the place
        place: Place,
    },
    /// `&with_numbers(&part, &numbers)`: a struct whose scalars are replaced by those that another struct has at the same
    /// paths; `&Type { field: with_numbers(&place.field, &numbers), ..place }`: the same within a struct
    Numbers {
        /// the whole struct
        structure: Place,
        /// the struct within it that gets the scalars, or itself
        part: Place,
        /// some scalars of the part, at the same paths
        numbers: Place,
    },
}

/// A local or a parameter, or a part of one.
#[derive(Debug)]
pub struct Place {
    /// the local or the parameter
    pub root: &'static str,
    /// from there inwards
    pub projections: &'static [Projection],
}

/// One step from a value to a part of it.
#[derive(Debug)]
pub enum Projection {
    /// `.name`
    Field {
        /// the name
        name: &'static str,
    },
    /// `[index]`
    Index {
        /// known when the function is specialised
        index: &'static Expr,
    },
}

/// Operators with one operand.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Unary {
    /// `-` of a real or an `i32`
    Negate,
    /// `!` of a bool
    Not,
}

/// Operators with two operands. Integers wrap around.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Binary {
    /// `+`
    Add,
    /// `-`
    Subtract,
    /// `*`
    Multiply,
    /// `/`; of integers, rounded towards 0, with a divisor of at least 1
    Divide,
    /// `%` of integers with a divisor of at least 1; the result has the sign of the dividend
    Remainder,
    /// `<`
    Less,
    /// `<=`
    LessEqual,
    /// `>`
    Greater,
    /// `>=`
    GreaterEqual,
    /// `==`, not of reals
    Equal,
    /// `!=`, not of reals
    NotEqual,
    /// `&&`
    And,
    /// `||`
    Or,
}
