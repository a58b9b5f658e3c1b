//! Compares a real after its range check only: Structured Text evaluates both operands of AND, and a comparison with a NaN can
//! stop a runtime.
//!
//! ```text
//! if a && in_range(x, limit) && x < b { .. }      if in_range(x, limit) { x_ordered := x < b } else { x_ordered := false }
//!                                            ->   if a && x_ordered { .. }
//! ```

use crate::pass::Defect;
use crate::program::{Expr, Local, Program, Statement, Type, Var};
use portable::{Binary, Intrinsic};

pub(super) fn run(mut program: Program) -> Result<Program, Defect> {
    let mut step = std::mem::take(&mut program.step);
    in_list(&mut step, &mut program);
    program.step = step;
    Ok(program)
}

fn in_list(list: &mut Vec<Statement>, program: &mut Program) {
    for mut statement in std::mem::take(list) {
        statement.change_branches(|inner| in_list(inner, program));
        if let Statement::Assign { value: expr, .. } | Statement::If { condition: expr, .. } = &mut statement {
            expr.change(&mut |part| {
                while let Some(checked) = checked(part, program) {
                    list.push(checked);
                }
            });
        }
        list.push(statement);
    }
}

/// Takes the first range check with comparisons of the same variable out of a condition; `None` if there is none.
fn checked(part: &mut Expr, program: &mut Program) -> Option<Statement> {
    let mut terms = Vec::new();
    terms_of(part, &mut terms);
    let (at, var) = terms.iter().enumerate().find_map(|(at, term)| {
        let Expr::Intrinsic(Intrinsic::InRange, operands) = term else { return None };
        let Expr::Var(var) = operands[0] else { return None };
        terms.iter().any(|term| compares(term, var)).then_some((at, var))
    })?;
    let condition = terms[at].clone();
    let local = Var::Local(program.locals.len());
    let path = format!("{}_ordered", program.path(var));
    program.locals.push(Local { path, ty: Some(Type::Bool) });
    terms[at] = Expr::Var(local);
    let (compared, others): (Vec<Expr>, Vec<Expr>) = terms.into_iter().partition(|term| compares(term, var));
    let all = |terms: Vec<Expr>| terms.into_iter().reduce(|left, right| Expr::logic(Binary::And, left, right));
    *part = all(others)?;
    let assign = |value| vec![Statement::Assign { target: local, value }];
    Some(Statement::If { condition, then: assign(all(compared)?), otherwise: assign(Expr::bool(false)) })
}

/// The terms of a conjunction, in their order; an expression that is none is its own term.
fn terms_of(expr: &Expr, terms: &mut Vec<Expr>) {
    if let Expr::Binary(Binary::And, left, right) = expr {
        terms_of(left, terms);
        terms_of(right, terms);
    } else {
        terms.push(expr.clone());
    }
}

/// Whether a term compares the variable.
fn compares(term: &Expr, var: Var) -> bool {
    let is_order = |operator: &Binary| {
        matches!(operator, Binary::Less | Binary::LessEqual | Binary::Greater | Binary::GreaterEqual)
    };
    matches!(term, Expr::Binary(operator, ..) if is_order(operator)) && term.mentions(var)
}
