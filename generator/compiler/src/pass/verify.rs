//! Makes sure that a program keeps its promises before anything is printed from it.

use super::{Defect, typing};
use crate::arithmetic;
use crate::program::{Program, Statement, Type, Var};
use std::collections::BTreeSet;

/// Runs the pass: types fit, every local is assigned once on each way before it is read, every output is written on each
/// way, inputs and constants are never written, and every number is finite.
///
/// # Errors
/// The first broken promise.
pub fn run(program: Program) -> Result<Program, Defect> {
    for constant in &program.constants {
        if !arithmetic::is_finite(constant.value) {
            return Err(defect(format!("the constant {} is {:?}", constant.path, constant.value)));
        }
    }
    statements(&program.init, &mut BTreeSet::new(), &program)?;
    let mut written = BTreeSet::new();
    statements(&program.step, &mut written, &program)?;
    for (index, output) in program.outputs.iter().enumerate() {
        if !written.contains(&Var::Output(index)) {
            return Err(defect(format!("the output {} is not written on every way", output.path)));
        }
    }
    Ok(program)
}

/// Follows a list of statements; `written` gathers what has a value on every way to the present point.
fn statements(list: &[Statement], written: &mut BTreeSet<Var>, program: &Program) -> Result<(), Defect> {
    for statement in list {
        match statement {
            Statement::Note(_) => {}
            Statement::Assign { target, value } => {
                readable(value, written, program)?;
                let found = typing::type_of(value, program)?;
                if found != target_type(*target, program)? {
                    return Err(defect(format!("{target:?} is assigned a {found:?}")));
                }
                let known = !written.insert(*target);
                if known && matches!(target, Var::Local(_)) {
                    return Err(defect(format!("{target:?} is assigned twice on one way")));
                }
            }
            Statement::If { condition, then, otherwise } => {
                readable(condition, written, program)?;
                if typing::type_of(condition, program)? != Type::Bool {
                    return Err(defect(format!("a condition is no BOOL: {condition:?}")));
                }
                let (mut yes, mut no) = (written.clone(), written.clone());
                statements(then, &mut yes, program)?;
                statements(otherwise, &mut no, program)?;
                *written = yes.intersection(&no).copied().collect();
            }
        }
    }
    Ok(())
}

fn readable(expr: &crate::program::Expr, written: &BTreeSet<Var>, program: &Program) -> Result<(), Defect> {
    let mut unwritten = None;
    expr.variables(&mut |var| {
        if let Var::Local(index) = var
            && !written.contains(&var)
        {
            unwritten = Some(program.locals[index].path.clone());
        }
    });
    match unwritten {
        Some(path) => Err(defect(format!("`{path}` is read where it may have no value"))),
        None => Ok(()),
    }
}

fn target_type(target: Var, program: &Program) -> Result<Type, Defect> {
    match target {
        Var::Output(index) => Ok(program.outputs[index].ty),
        Var::State(index) => Ok(program.state[index].ty),
        Var::Local(index) => program.locals[index].ty.ok_or_else(|| defect(format!("{target:?} has no type"))),
        Var::Input(_) | Var::Constant(_) => Err(defect(format!("{target:?} is written"))),
    }
}

fn defect(message: String) -> Defect {
    Defect { pass: "verify", message }
}
