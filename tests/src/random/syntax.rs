//! The syntax of portable Rust, as far as random programs use it. Plain data; every scalar expression knows its type.

use portable::{Binary, Intrinsic, Unary};

/// Positions of the structs that every program has.
pub const STATE: usize = 0;
/// See [`STATE`].
pub const COEFFS: usize = 1;
/// See [`STATE`].
pub const INPUTS: usize = 2;
/// See [`STATE`].
pub const OUTPUTS: usize = 3;

/// A program: the items of one Rust module.
#[derive(Clone, Debug, PartialEq)]
pub struct Program {
    /// the number of variants of each enum
    pub enums: Vec<usize>,
    /// the values of the named lengths
    pub lengths: Vec<usize>,
    /// first those of the block, then those that are part of others
    pub structs: Vec<Struct>,
    /// each after those that it calls; the last two are `init` and `step`
    pub functions: Vec<Function>,
    /// the value of the coefficients
    pub coefficients: Tree,
}

/// A struct.
#[derive(Clone, Debug, PartialEq)]
pub struct Struct {
    /// its name
    pub name: String,
    /// its fields
    pub fields: Vec<(String, Type)>,
}

/// A type.
#[derive(Clone, Debug, PartialEq)]
pub enum Type {
    /// a scalar
    Scalar(Scalar),
    /// a struct, by its position
    Struct(usize),
    /// an array
    Array(Box<Type>, Length),
}

/// The type of a scalar.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Scalar {
    /// the real type
    Real,
    /// `bool`
    Bool,
    /// `i32`
    I32,
    /// `u32`
    U32,
    /// `usize`, always known when the program is specialised
    Usize,
    /// an enum, by its position
    Enum(usize),
}

/// The length of an array.
#[derive(Clone, Copy, Debug)]
pub struct Length {
    /// how many elements
    pub count: usize,
    /// the constant that says so, if one does
    pub named: Option<usize>,
}

/// A length is what it counts, however it is written.
impl PartialEq for Length {
    fn eq(&self, other: &Self) -> bool {
        self.count == other.count
    }
}

/// The value of a scalar.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Value {
    /// `R::ZERO`
    Zero,
    /// `R::ONE`
    One,
    /// `R::lit(..)`
    Lit(f64),
    /// `R::per_kind(.., ..)`
    PerKind(f64, f32),
    /// `true` or `false`
    Bool(bool),
    /// an `i32`
    I32(i32),
    /// a `u32`
    U32(u32),
    /// a `usize`
    Usize(usize),
    /// a named length, by its position
    Length(usize),
    /// a variant of an enum
    Variant(usize, usize),
}

/// The value of the coefficients, or of a part of them.
#[derive(Clone, Debug, PartialEq)]
pub enum Tree {
    /// of a scalar
    Leaf(Value),
    /// of a struct, field by field
    Struct(usize, Vec<(String, Tree)>),
    /// of an array
    Array(Vec<Tree>),
}

/// A function.
#[derive(Clone, Debug, PartialEq)]
pub struct Function {
    /// its name
    pub name: String,
    /// whether it stands in the inner module
    pub inner: bool,
    /// its parameters
    pub params: Vec<Param>,
    /// the type of its value, if it has one
    pub returns: Option<Scalar>,
    /// what it does
    pub body: Block,
}

/// A parameter.
#[derive(Clone, Debug, PartialEq)]
pub struct Param {
    /// its name
    pub name: String,
    /// how it is passed
    pub mode: Mode,
    /// its type, without the borrow
    pub ty: Type,
}

/// How a parameter is passed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Mode {
    /// by value
    Value,
    /// `&`
    Shared,
    /// `&mut`
    Mutable,
}

/// Statements, then perhaps a value.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Block {
    /// the statements
    pub statements: Vec<Statement>,
    /// the value
    pub value: Option<Box<Expr>>,
}

/// A statement.
#[derive(Clone, Debug, PartialEq)]
pub enum Statement {
    /// `let name = value;`
    Let {
        /// the name
        name: String,
        /// whether it is assigned later
        mutable: bool,
        /// the value
        value: Expr,
    },
    /// `place = value;`
    Assign {
        /// what is written
        place: Place,
        /// the value
        value: Expr,
    },
    /// `place += value;` and its kind
    Compound {
        /// what is written
        place: Place,
        /// which
        operator: Binary,
        /// the value
        value: Expr,
    },
    /// `for variable in from..to { .. }`
    For {
        /// the loop variable
        variable: String,
        /// its first value
        from: Expr,
        /// one past its last value
        to: Expr,
        /// what is repeated
        body: Block,
    },
    /// `if`
    If(Choice),
    /// `match`
    Match(Selection),
    /// a call whose value, if any, is not used
    Call(Call),
}

/// An expression.
#[derive(Clone, Debug, PartialEq)]
pub enum Expr {
    /// a constant
    Literal(Value),
    /// what a place holds
    Read(Place, Scalar),
    /// an operator with one operand
    Unary(Unary, Box<Expr>),
    /// an operator with two operands
    Binary(Binary, Box<Expr>, Box<Expr>),
    /// a call
    Call(Call),
    /// `if` with a value; only as a whole value
    If(Box<Choice>),
    /// `match` with a value; only as a whole value
    Match(Box<Selection>),
    /// `[a, b, c]`; only right of `let`
    Array(Vec<Expr>),
    /// `[a; 3]`; only right of `let`
    Repeat(Box<Expr>, Length),
}

/// An `if`.
#[derive(Clone, Debug, PartialEq)]
pub struct Choice {
    /// decides
    pub condition: Expr,
    /// if it holds
    pub then: Block,
    /// if not
    pub otherwise: Option<Block>,
}

/// A `match`.
#[derive(Clone, Debug, PartialEq)]
pub struct Selection {
    /// decides
    pub scrutinee: Expr,
    /// in their order
    pub arms: Vec<Arm>,
}

/// An arm of a `match`.
#[derive(Clone, Debug, PartialEq)]
pub struct Arm {
    /// what chooses it; none: the wildcard
    pub patterns: Vec<Value>,
    /// what it does
    pub body: Block,
}

/// A call.
#[derive(Clone, Debug, PartialEq)]
pub struct Call {
    /// what is called
    pub callee: Callee,
    /// with what
    pub arguments: Vec<Argument>,
    /// the type of the value, if there is one
    pub returns: Option<Scalar>,
}

/// What is called.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Callee {
    /// a function of the program, by its position
    Function(usize),
    /// a function that every program has
    Intrinsic(Intrinsic),
}

/// An argument.
#[derive(Clone, Debug, PartialEq)]
pub enum Argument {
    /// a value
    Value(Expr),
    /// `&place`
    Shared(Place),
    /// `&mut place`
    Mutable(Place),
}

/// A local or a parameter, or a part of one.
#[derive(Clone, Debug, PartialEq)]
pub struct Place {
    /// the local or the parameter
    pub root: String,
    /// from there inwards
    pub steps: Vec<Step>,
}

/// One step from a value to a part of it.
#[derive(Clone, Debug, PartialEq)]
pub enum Step {
    /// `.name`
    Field(String),
    /// `[index]`
    Index(Expr),
}
