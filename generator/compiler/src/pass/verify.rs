//! Checks the rules of a program before anything is printed from it.

use super::{Defect, typing};
use crate::arithmetic;
use crate::program::{Expr, Program, Statement, Var};

/// Checks that types fit, that every local is assigned once on each path before it is read, that every output is written on
/// each path, that inputs and constants are never written, and that every number is finite.
///
/// # Errors
/// The first violation.
pub fn run(program: Program) -> Result<Program, Defect> {
    check(program, false)
}

/// Checks a program after a legalising pass that permits a second assignment of a local on a path.
pub(crate) fn assigned_again(program: Program) -> Result<Program, Defect> {
    check(program, true)
}

fn check(program: Program, again: bool) -> Result<Program, Defect> {
    for constant in &program.constants {
        if !arithmetic::is_finite(constant.value) {
            return Err(defect(format!("the constant {} is {:?}", constant.path, constant.value)));
        }
    }
    let program = typing::run(program)?;
    let mut written =
        Written { locals: vec![false; program.locals.len()], outputs: vec![false; program.outputs.len()] };
    statements(&program.init, &mut written.clone(), &program, again)?;
    statements(&program.step, &mut written, &program, again)?;
    match program.outputs.iter().zip(&written.outputs).find(|(_, written)| !**written) {
        Some((output, _)) => Err(defect(format!("the output {} is not written on every way", output.path))),
        None => Ok(program),
    }
}

/// The variables with a value on every path to the present point.
#[derive(Clone)]
struct Written {
    locals: Vec<bool>,
    outputs: Vec<bool>,
}

/// Checks a list of statements.
fn statements(list: &[Statement], written: &mut Written, program: &Program, again: bool) -> Result<(), Defect> {
    for statement in list {
        match statement {
            Statement::Note(_) => {}
            Statement::Assign { target: target @ (Var::Input(_) | Var::Constant(_)), .. } => {
                return Err(defect(format!("{target:?} is written")));
            }
            Statement::Assign { target, value } => {
                readable(value, written, program)?;
                match *target {
                    Var::Local(local) if std::mem::replace(&mut written.locals[local], true) && !again => {
                        return Err(defect(format!("{target:?} is assigned twice on one way")));
                    }
                    Var::Output(output) => written.outputs[output] = true,
                    _ => {}
                }
            }
            Statement::Apart(body) => statements(body, written, program, again)?,
            Statement::If { condition: asked, .. } | Statement::Choose { by: asked, .. } => {
                readable(asked, written, program)?;
                let mut branches = statement.branches().map(|list| {
                    let mut written = written.clone();
                    statements(list, &mut written, program, again).map(|()| written)
                });
                let first = branches.next().unwrap_or_else(|| Ok(written.clone()))?;
                *written = branches.try_fold(first, |all, written| written.map(|written| both(all, &written)))?;
            }
        }
    }
    Ok(())
}

/// The variables that are written on both paths.
fn both(mut one: Written, other: &Written) -> Written {
    for (one, other) in [(&mut one.locals, &other.locals), (&mut one.outputs, &other.outputs)] {
        one.iter_mut().zip(other).for_each(|(one, other)| *one &= other);
    }
    one
}

fn readable(expr: &Expr, written: &Written, program: &Program) -> Result<(), Defect> {
    let mut result = Ok(());
    expr.variables(&mut |var| {
        if let Var::Local(index) = var
            && !written.locals[index]
        {
            let path = &program.locals[index].path;
            result = Err(defect(format!("`{path}` is read where it may have no value")));
        }
    });
    result
}

fn defect(message: String) -> Defect {
    Defect { pass: "verify", message }
}
