//! Passes on programs that are small enough to be read; the random programs find what these do not think of.

mod legalised;
mod small;

use compiler::program::{Expr, Statement, Type, Var, Variable};
use portable::{Binary, Literal};

/// Inputs, an output and a part of the state that all programs have.
const X: Expr = Expr::Var(Var::Input(0));
const ON: Expr = Expr::Var(Var::Input(1));
const Y: Var = Var::Output(0);
const S: Var = Var::State(0);

fn variable(path: &str, ty: Type, start: Literal) -> Variable {
    Variable { path: path.to_owned(), doc: "", ty, start }
}

fn real(value: f64) -> Expr {
    Expr::Literal(Literal::F64(value))
}

fn binary(operator: Binary, left: Expr, right: Expr) -> Expr {
    Expr::Binary(operator, Box::new(left), Box::new(right))
}

fn assign(target: Var, value: Expr) -> Statement {
    Statement::Assign { target, value }
}
