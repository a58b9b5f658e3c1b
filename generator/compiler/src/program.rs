//! The second IR: one block of one axis, owned, typed and flat. No loops, no calls, no aggregates; plain data.
//!
//! Every scalar of the inputs, the outputs and the state is a variable of its own, named by its path in the reference
//! (`stage[0].filter[0].section[1].s1`). A local is assigned exactly once on each way through the program.

use portable::{Literal, RealKind};

/// A specialised block.
#[derive(Clone, Debug, PartialEq)]
pub struct Program {
    /// the block's name: `ipc`
    pub block: &'static str,
    /// the input that turns the block off: a mode at 0, a switch at FALSE
    pub enable: &'static str,
    /// what [`Type::Real`] is
    pub real: RealKind,
    /// written by the caller
    pub inputs: Vec<Variable>,
    /// written by `step`
    pub outputs: Vec<Variable>,
    /// kept from cycle to cycle
    pub state: Vec<Variable>,
    /// named numbers, in the order in which the reference declares them
    pub constants: Vec<Constant>,
    /// intermediate values
    pub locals: Vec<Local>,
    /// before the first cycle
    pub init: Vec<Statement>,
    /// one cycle
    pub step: Vec<Statement>,
}

/// An input, an output or a part of the state.
#[derive(Clone, Debug, PartialEq)]
pub struct Variable {
    /// the path in the reference's struct
    pub path: String,
    /// the doc comment of the field
    pub doc: &'static str,
    /// its type
    pub ty: Type,
    /// its value before anything was written
    pub start: Literal,
}

/// A named number.
#[derive(Clone, Debug, PartialEq)]
pub struct Constant {
    /// the path in the coefficients, or the name of the function that gives it
    pub path: String,
    /// the doc comment of the field or function
    pub doc: &'static str,
    /// its value
    pub value: Literal,
    /// where it comes from
    pub origin: Origin,
}

/// Where a named number comes from; in this order they are listed.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Origin {
    /// a coefficient, by its position among their leaves
    Coefficient(usize),
    /// a function without parameters, the same for every axis
    Function,
}

/// An intermediate value.
#[derive(Clone, Debug, PartialEq)]
pub struct Local {
    /// where in the state it is computed, and its name in the reference: `stage[0].filter[0].section[0].y`
    pub path: String,
    /// its type; the typing pass fills it in
    pub ty: Option<Type>,
}

/// The type of a scalar.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Type {
    /// BOOL
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
    #[must_use]
    pub fn of(value: Literal) -> Option<Self> {
        match value {
            Literal::Bool(_) => Some(Self::Bool),
            Literal::I32(_) => Some(Self::I32),
            Literal::U32(_) => Some(Self::U32),
            Literal::F64(_) | Literal::F32(_) => Some(Self::Real),
            Literal::Usize(_) | Literal::Variant(_) => None,
        }
    }
}

/// A variable or a constant, by its position in the program's list.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Var {
    /// of [`Program::inputs`]
    Input(usize),
    /// of [`Program::outputs`]
    Output(usize),
    /// of [`Program::state`]
    State(usize),
    /// of [`Program::constants`]
    Constant(usize),
    /// of [`Program::locals`]
    Local(usize),
}

/// A statement.
#[derive(Clone, Debug, PartialEq)]
pub enum Statement {
    /// what the next statements are
    Note(String),
    /// writes an output, a part of the state or a local
    Assign {
        /// what is written
        target: Var,
        /// with what
        value: Expr,
    },
    /// chooses
    If {
        /// decides
        condition: Expr,
        /// if it holds
        then: Vec<Statement>,
        /// if not
        otherwise: Vec<Statement>,
    },
}

/// An expression without effect.
#[derive(Clone, Debug, PartialEq)]
pub enum Expr {
    /// a value
    Literal(Literal),
    /// what a variable holds
    Var(Var),
    /// an operator with one operand
    Unary(portable::Unary, Box<Expr>),
    /// an operator with two operands
    Binary(portable::Binary, Box<Expr>, Box<Expr>),
    /// an operation that each target prints in its own way
    Intrinsic(portable::Intrinsic, Vec<Expr>),
}

impl Statement {
    /// Calls `visit` for every expression of this statement and of those inside it.
    pub fn expressions<'a>(&'a self, visit: &mut dyn FnMut(&'a Expr)) {
        match self {
            Self::Note(_) => {}
            Self::Assign { value, .. } => visit(value),
            Self::If { condition, then, otherwise } => {
                visit(condition);
                for statement in then.iter().chain(otherwise) {
                    statement.expressions(visit);
                }
            }
        }
    }

    /// Calls `visit` for every variable that this statement or one inside it writes, with what it writes.
    pub fn assignments(&self, visit: &mut dyn FnMut(Var, &Expr)) {
        match self {
            Self::Note(_) => {}
            Self::Assign { target, value } => visit(*target, value),
            Self::If { then, otherwise, .. } => {
                for statement in then.iter().chain(otherwise) {
                    statement.assignments(visit);
                }
            }
        }
    }

    /// Calls `visit` for every variable that this statement or one inside it writes.
    pub fn targets(&self, visit: &mut dyn FnMut(Var)) {
        self.assignments(&mut |target, _| visit(target));
    }

    /// Whether this statement or one inside it reads or writes the variable.
    #[must_use]
    pub fn mentions(&self, var: Var) -> bool {
        let mut found = false;
        self.targets(&mut |target| found |= target == var);
        self.expressions(&mut |expr| expr.variables(&mut |read| found |= read == var));
        found
    }
}

impl Expr {
    /// Calls `visit` for the expression and for every part of it.
    pub fn parts<'a>(&'a self, visit: &mut dyn FnMut(&'a Self)) {
        visit(self);
        match self {
            Self::Literal(_) | Self::Var(_) => {}
            Self::Unary(_, operand) => operand.parts(visit),
            Self::Binary(_, left, right) => {
                left.parts(visit);
                right.parts(visit);
            }
            Self::Intrinsic(_, operands) => operands.iter().for_each(|operand| operand.parts(visit)),
        }
    }

    /// Calls `visit` for every variable that the expression reads.
    pub fn variables(&self, visit: &mut dyn FnMut(Var)) {
        self.parts(&mut |part| {
            if let Self::Var(var) = part {
                visit(*var);
            }
        });
    }

    /// Replaces every part of the expression, inner parts first.
    #[must_use]
    pub fn map(self, change: &mut dyn FnMut(Self) -> Self) -> Self {
        let inner = match self {
            Self::Unary(operator, operand) => Self::Unary(operator, Box::new(operand.map(change))),
            Self::Binary(operator, left, right) => {
                Self::Binary(operator, Box::new(left.map(change)), Box::new(right.map(change)))
            }
            Self::Intrinsic(intrinsic, operands) => {
                Self::Intrinsic(intrinsic, operands.into_iter().map(|operand| operand.map(change)).collect())
            }
            leaf => leaf,
        };
        change(inner)
    }
}

/// Replaces every expression of the statements, each as a whole.
#[must_use]
pub fn map_expressions(statements: Vec<Statement>, change: &mut dyn FnMut(Expr) -> Expr) -> Vec<Statement> {
    statements
        .into_iter()
        .map(|statement| match statement {
            Statement::Note(text) => Statement::Note(text),
            Statement::Assign { target, value } => Statement::Assign { target, value: change(value) },
            Statement::If { condition, then, otherwise } => {
                let condition = change(condition);
                Statement::If {
                    condition,
                    then: map_expressions(then, change),
                    otherwise: map_expressions(otherwise, change),
                }
            }
        })
        .collect()
}

/// Gives every variable that the statements mention another name.
#[must_use]
pub fn rename(statements: Vec<Statement>, renamed: &dyn Fn(Var) -> Var) -> Vec<Statement> {
    let change = &mut |part| match part {
        Expr::Var(var) => Expr::Var(renamed(var)),
        other => other,
    };
    let in_list = |list| rename(list, renamed);
    statements
        .into_iter()
        .map(|statement| match statement {
            Statement::Note(text) => Statement::Note(text),
            Statement::Assign { target, value } => {
                Statement::Assign { target: renamed(target), value: value.map(change) }
            }
            Statement::If { condition, then, otherwise } => {
                Statement::If { condition: condition.map(change), then: in_list(then), otherwise: in_list(otherwise) }
            }
        })
        .collect()
}
