//! Makes sure that a program keeps its promises before anything is printed from it.

use super::{Defect, typing};
use crate::arithmetic;
use crate::program::{Expr, Program, Statement, Type, Var};

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
    let nothing = Written { locals: vec![false; program.locals.len()], outputs: vec![false; program.outputs.len()] };
    statements(&program.init, &mut nothing.clone(), &program)?;
    let mut written = nothing;
    statements(&program.step, &mut written, &program)?;
    match program.outputs.iter().zip(&written.outputs).find(|(_, written)| !**written) {
        Some((output, _)) => Err(defect(format!("the output {} is not written on every way", output.path))),
        None => Ok(program),
    }
}

/// What has a value on every way to the present point.
#[derive(Clone)]
struct Written {
    locals: Vec<bool>,
    outputs: Vec<bool>,
}

impl Written {
    /// What has a value on two ways.
    fn and(self, other: &Self) -> Self {
        let both =
            |one: Vec<bool>, other: &[bool]| one.into_iter().zip(other).map(|(one, other)| one && *other).collect();
        Self { locals: both(self.locals, &other.locals), outputs: both(self.outputs, &other.outputs) }
    }
}

/// Follows a list of statements.
fn statements(list: &[Statement], written: &mut Written, program: &Program) -> Result<(), Defect> {
    for statement in list {
        match statement {
            Statement::Note(_) => {}
            Statement::Assign { target, value } => {
                readable(value, written, program)?;
                let found = typing::type_of(value, program)?;
                if found != target_type(*target, program)? {
                    return Err(defect(format!("{target:?} is assigned a {found:?}")));
                }
                match *target {
                    Var::Local(local) if std::mem::replace(&mut written.locals[local], true) => {
                        return Err(defect(format!("{target:?} is assigned twice on one way")));
                    }
                    Var::Output(output) => written.outputs[output] = true,
                    _ => {}
                }
            }
            Statement::If { condition, then, otherwise } => {
                readable(condition, written, program)?;
                if typing::type_of(condition, program)? != Type::Bool {
                    return Err(defect(format!("a condition is no BOOL: {condition:?}")));
                }
                let mut yes = written.clone();
                statements(then, &mut yes, program)?;
                statements(otherwise, written, program)?;
                *written = yes.and(written);
            }
        }
    }
    Ok(())
}

fn readable(expr: &Expr, written: &Written, program: &Program) -> Result<(), Defect> {
    let mut unwritten = None;
    expr.variables(&mut |var| {
        if let Var::Local(index) = var
            && !written.locals[index]
        {
            unwritten = Some(&program.locals[index].path);
        }
    });
    match unwritten {
        Some(path) => Err(defect(format!("`{path}` is read where it may have no value"))),
        None => Ok(()),
    }
}

fn target_type(target: Var, program: &Program) -> Result<Type, Defect> {
    match target {
        Var::Input(_) | Var::Constant(_) => Err(defect(format!("{target:?} is written"))),
        _ => program.ty(target).ok_or_else(|| defect(format!("{target:?} has no type"))),
    }
}

fn defect(message: String) -> Defect {
    Defect { pass: "verify", message }
}
