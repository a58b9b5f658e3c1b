//! The second IR: one block of one axis, owned, typed and flat. No loops, no calls, no aggregates; plain data.
//!
//! Every scalar of the inputs, the outputs and the state is a separate variable, named by its path in the reference
//! (`stage[0].filter[0].section[1].s1`). A local is assigned exactly once on each path through the program.

mod expr;
mod row;
mod table;
pub mod values;
mod visit;

pub use row::Row;
pub use table::Table;
pub use visit::map_expressions;
pub(crate) use visit::{close_up, rename, retain_mut};

use portable::{Binary, Brake, Intrinsic, Literal, RealKind, Unary, Variant};

/// A specialised block.
#[derive(Clone, Debug, PartialEq)]
pub struct Program {
    /// the block's name: `ipc`
    pub block: &'static str,
    /// what turns the block off from outside; `None` if nothing does
    pub switch: Option<Switch>,
    /// whether `step` begins with the fast path, and its last `else` is any other cycle
    pub usual_first: bool,
    /// the names of real inputs that are fractions from 0 to 1
    pub fractions: &'static [&'static str],
    /// the beginning of the paths of inputs that are a parameter set, which stays until another one is offered
    pub set: Option<&'static str>,
    /// the beginning of the paths of outputs that are a parameter set for another block, which checks it
    pub made: Option<&'static str>,
    /// whether its reals are of single precision, in a program of double precision
    pub is_made_single: bool,
    /// whether its real inputs are numbers that somebody types, not samples of a signal
    pub typed: bool,
    /// the type of [`Type::Real`]
    pub real: RealKind,
    /// written by the caller
    pub inputs: Vec<Variable>,
    /// written by `step`
    pub outputs: Vec<Variable>,
    /// kept from cycle to cycle
    pub state: Vec<Variable>,
    /// the arrays of the state; a legalising pass makes them
    pub rows: Vec<Row>,
    /// named numbers, in the order in which the reference declares them
    pub constants: Vec<Constant>,
    /// intermediate values
    pub locals: Vec<Local>,
    /// before the first cycle
    pub init: Vec<Statement>,
    /// one cycle
    pub step: Vec<Statement>,
}

/// The input that turns a block off.
#[derive(Clone, Debug, PartialEq)]
pub struct Switch {
    /// position in [`Program::inputs`]
    pub input: usize,
    /// the value that turns the block off
    pub off: Off,
}

/// The kind of an input that turns a block off.
#[derive(Clone, Debug, PartialEq)]
pub enum Off {
    /// a mode, and the part of the state that is TRUE until the block is at rest
    Mode(Constant, Option<Var>),
    /// FALSE, at once
    False,
    /// FALSE: nothing new begins; the part of the state that is TRUE until what began has ended
    Execute(Option<Var>),
    /// TRUE: the block brakes
    Brake(Brake),
}

impl Off {
    /// The value of the input.
    pub fn value(&self) -> Literal {
        match self {
            Self::Mode(off, _) => off.value,
            Self::False | Self::Execute(_) => Literal::Bool(false),
            Self::Brake(_) => Literal::Bool(true),
        }
    }
}

/// An input, an output or a part of the state.
#[derive(Clone, Debug, PartialEq)]
pub struct Variable {
    /// the path in the reference's struct
    pub path: String,
    /// the doc comment of the field
    pub doc: &'static str,
    pub ty: Type,
    /// its value before the first write
    pub start: Literal,
}

/// A named number.
#[derive(Clone, Debug, PartialEq)]
pub struct Constant {
    /// the path in the coefficients, or the name of the function that returns it
    pub path: String,
    /// the doc comment of the field or function
    pub doc: &'static str,
    pub value: Literal,
    pub origin: Origin,
}

/// The origin of a named number; numbers are listed in this order.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Origin {
    /// a coefficient, by its position among their leaves
    Coefficient(usize),
    /// a function without parameters, which does not depend on the axis
    Function,
    /// a variant of an enumeration
    Variant(Variant),
    /// a variable of the controller's runtime, as the language writes it: no block declares it
    Runtime(&'static str),
}

/// The name of the number of a variant: its enumeration's, then its own.
pub fn variant_name(variant: Variant) -> String {
    snake_case(variant.of.name.chars().chain(variant.def().name.chars()))
}

/// `SpindleState` as `spindle_state`.
pub fn snake_case(name: impl Iterator<Item = char>) -> String {
    let mut words = String::new();
    for letter in name {
        if letter.is_ascii_uppercase() && !words.is_empty() {
            words.push('_');
        }
        words.push(letter.to_ascii_lowercase());
    }
    words
}

/// Appends a number to a text, without the cost of a format.
pub(crate) fn push_number(text: &mut String, number: usize) {
    if number > 9 {
        push_number(text, number / 10);
    }
    text.push(char::from(b"0123456789"[number % 10]));
}

/// A field whose parts have the names of the struct's own fields.
const OWN: &str = "own";

/// Appends the name of a field to a path.
pub(crate) fn push_field(path: &mut String, name: &str) {
    if name != OWN {
        path.push_str(if path.is_empty() { "" } else { "." });
        path.push_str(name);
    }
}

/// Appends an index in brackets to a path.
pub(crate) fn push_index(path: &mut String, index: usize) {
    path.push('[');
    push_number(path, index);
    path.push(']');
}

/// An intermediate value.
#[derive(Clone, Debug, PartialEq)]
pub struct Local {
    /// where in the state it is computed, and its name in the reference: `stage[0].filter[0].section[0].y`
    pub path: String,
    /// its type; the typing pass fills it in
    pub ty: Option<Type>,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Type {
    Bool,
    /// DINT; an enum's variants are its numbers
    I32,
    /// UDINT
    U32,
    /// REAL or LREAL, as the program says
    Real,
}

impl Type {
    /// The type of a value that exists at run time.
    pub fn of_literal(value: Literal) -> Option<Self> {
        match value {
            Literal::Bool(_) => Some(Self::Bool),
            Literal::I32(_) => Some(Self::I32),
            Literal::U32(_) => Some(Self::U32),
            Literal::F64(_) | Literal::F32(_) => Some(Self::Real),
            Literal::Usize(_) | Literal::Variant(_) => None,
        }
    }

    pub(crate) fn of_intrinsic(intrinsic: Intrinsic) -> Self {
        match intrinsic {
            Intrinsic::InRange | Intrinsic::Within => Self::Bool,
            Intrinsic::FromU32 | Intrinsic::FromI32 | Intrinsic::Narrow => Self::Real,
            Intrinsic::Unsigned => Self::U32,
            Intrinsic::Truncate | Intrinsic::Nearest => Self::I32,
        }
    }
}

/// A variable or a constant, by its position in the program's list of its kind.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Var {
    Input(usize),
    Output(usize),
    State(usize),
    Constant(usize),
    Local(usize),
}

#[derive(Clone, Debug, PartialEq)]
pub enum Statement {
    /// a comment on the next statements
    Note(String),
    /// writes an output, a part of the state or a local
    Assign {
        target: Var,
        value: Expr,
    },
    If {
        condition: Expr,
        then: Vec<Statement>,
        otherwise: Vec<Statement>,
    },
    /// one of several lists, by the value of an enumeration or of an integer; a legalising pass makes it
    Choose {
        by: Expr,
        /// the last one is for every other number too
        arms: Vec<Arm>,
    },
    /// the rare path, at the end of `step`; a legalising pass separates it
    Apart(Vec<Statement>),
}

/// One list of a choice.
#[derive(Clone, Debug, PartialEq)]
pub struct Arm {
    /// the constants or literals that select it
    pub labels: Vec<Expr>,
    pub body: Vec<Statement>,
}

/// An expression without effect.
#[derive(Clone, Debug, PartialEq)]
pub enum Expr {
    Literal(Literal),
    Var(Var),
    Unary(Unary, Box<Expr>),
    Binary(Binary, Box<Expr>, Box<Expr>),
    /// an intrinsic operation
    Intrinsic(Intrinsic, Vec<Expr>),
    /// the element of an array at this index, which a condition around the statement has found to be below its length
    Element(Row, Box<Expr>),
}

/// The path of a signal within a parameter set; `None` if it is not part of one.
pub(crate) fn part_of<'v>(set: Option<&str>, signal: &'v Variable) -> Option<&'v str> {
    signal.path.strip_prefix(set?)?.strip_prefix('.')
}

impl Program {
    /// The type of a variable; `None` for a local before the typing pass.
    pub(crate) fn ty(&self, var: Var) -> Option<Type> {
        match var {
            Var::Input(index) => Some(self.inputs[index].ty),
            Var::Output(index) => Some(self.outputs[index].ty),
            Var::State(index) => Some(self.state[index].ty),
            Var::Constant(index) => Type::of_literal(self.constants[index].value),
            Var::Local(index) => self.locals[index].ty,
        }
    }

    /// The path of a variable in the reference.
    pub fn path(&self, var: Var) -> &str {
        match var {
            Var::Input(index) => &self.inputs[index].path,
            Var::Output(index) => &self.outputs[index].path,
            Var::State(index) => &self.state[index].path,
            Var::Constant(index) => &self.constants[index].path,
            Var::Local(index) => &self.locals[index].path,
        }
    }

    /// Whether an input is a fraction from 0 to 1.
    pub fn is_fraction(&self, input: &Variable) -> bool {
        let name = input.path.split('[').next();
        self.fractions.iter().any(|fraction| name == Some(fraction))
    }

    /// The path of an input within the parameter set; `None` if it is not part of one.
    pub fn in_set<'v>(&self, input: &'v Variable) -> Option<&'v str> {
        part_of(self.set, input)
    }

    /// The path of an output within the parameter set that it makes; `None` if it is not part of one.
    pub fn in_made<'v>(&self, output: &'v Variable) -> Option<&'v str> {
        part_of(self.made, output)
    }

    /// Whether an output is a real of single precision in a program of double precision.
    pub fn is_single(&self, output: &Variable) -> bool {
        self.is_made_single && output.ty == Type::Real && self.in_made(output).is_some()
    }

    /// Whether it has a parameter set.
    pub fn has_set(&self) -> bool {
        self.inputs.iter().any(|input| self.in_set(input).is_some())
    }

    /// Whether it contains one of these operations.
    pub fn asks_for(&self, wanted: &[Intrinsic]) -> bool {
        self.has(&|part| matches!(part, Expr::Intrinsic(intrinsic, _) if wanted.contains(intrinsic)))
    }

    /// Whether it contains such an expression, or a part of one.
    pub fn has(&self, is_wanted: &dyn Fn(&Expr) -> bool) -> bool {
        let mut found = false;
        for statement in self.statements() {
            statement.expressions(&mut |expr| expr.parts(&mut |part| found |= is_wanted(part)));
        }
        found
    }

    /// The statements of `step` that were separated as the rare path.
    pub fn apart(&self) -> &[Statement] {
        fn last(list: &[Statement]) -> &[Statement] {
            match list.last() {
                Some(Statement::Apart(body)) => body,
                Some(Statement::If { otherwise, .. }) => last(otherwise),
                Some(Statement::Note(_) | Statement::Assign { .. } | Statement::Choose { .. }) | None => &[],
            }
        }
        last(&self.step)
    }

    /// The statements of both bodies.
    pub fn statements(&self) -> impl DoubleEndedIterator<Item = &Statement> {
        self.step.iter().chain(&self.init)
    }
}
