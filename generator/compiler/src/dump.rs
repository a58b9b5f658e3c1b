//! A program as text, for people who look into the pipeline. Nothing reads it back.

use crate::program::{Expr, Program, Statement, Var, Variable};
use portable::{Intrinsic, Literal, Unary};
use std::fmt::{Display, Formatter, Result};

/// The operators, in the order of [`portable::Binary`].
const SYMBOLS: [&str; 13] = ["+", "-", "*", "/", "%", "<", "<=", ">", ">=", "==", "!=", "and", "or"];

/// The whole program: its variables, then its statements.
impl Display for Program {
    fn fmt(&self, f: &mut Formatter<'_>) -> Result {
        for (kind, list) in [("input", &self.inputs), ("output", &self.outputs), ("state", &self.state)] {
            for Variable { path, ty, start, .. } in list {
                writeln!(f, "{kind:<8} {path}: {ty:?} = {}", literal(*start))?;
            }
        }
        for constant in &self.constants {
            writeln!(f, "constant {} = {}", constant.path, literal(constant.value))?;
        }
        for (index, local) in self.locals.iter().enumerate() {
            let ty = local.ty.map_or_else(|| "?".to_owned(), |ty| format!("{ty:?}"));
            writeln!(f, "local    {}: {ty}", name(self, Var::Local(index)))?;
        }
        writeln!(f, "init")?;
        statements(self, &self.init, 1, f)?;
        writeln!(f, "step")?;
        statements(self, &self.step, 1, f)
    }
}

/// What a statement does, without those inside it.
pub(crate) fn first_line(program: &Program, statement: &Statement) -> String {
    match statement {
        Statement::Assign { target, value } => format!("{} = {}", name(program, *target), expr(program, value)),
        Statement::If { condition, .. } => format!("if {}", expr(program, condition)),
        Statement::Choose { by, .. } => format!("choose by {}", expr(program, by)),
        Statement::Note(_) | Statement::Apart(_) => String::new(),
    }
}

fn statements(program: &Program, list: &[Statement], level: usize, f: &mut Formatter<'_>) -> Result {
    let indent = "    ".repeat(level);
    for statement in list {
        match statement {
            Statement::Note(note) => writeln!(f, "{indent}# {note}")?,
            Statement::Assign { .. } => writeln!(f, "{indent}{}", first_line(program, statement))?,
            Statement::If { then, otherwise, .. } => {
                writeln!(f, "{indent}{}", first_line(program, statement))?;
                statements(program, then, level + 1, f)?;
                if !otherwise.is_empty() {
                    writeln!(f, "{indent}else")?;
                    statements(program, otherwise, level + 1, f)?;
                }
            }
            Statement::Apart(body) => {
                writeln!(f, "{indent}apart")?;
                statements(program, body, level + 1, f)?;
            }
            Statement::Choose { arms, .. } => {
                writeln!(f, "{indent}{}", first_line(program, statement))?;
                for arm in arms {
                    let labels: Vec<String> = arm.labels.iter().map(|label| expr(program, label)).collect();
                    writeln!(f, "{indent}{}:", labels.join(", "))?;
                    statements(program, &arm.body, level + 1, f)?;
                }
            }
        }
    }
    Ok(())
}

pub(crate) fn expr(program: &Program, value: &Expr) -> String {
    let inner = |part: &Expr| match part {
        Expr::Literal(_) | Expr::Var(_) | Expr::Intrinsic(..) => expr(program, part),
        _ => format!("({})", expr(program, part)),
    };
    match value {
        Expr::Literal(value) => literal(*value),
        Expr::Var(var) => name(program, *var),
        Expr::Unary(Unary::Negate, operand) => format!("-{}", inner(operand)),
        Expr::Unary(Unary::Not, operand) => format!("not {}", inner(operand)),
        Expr::Binary(operator, left, right) => {
            format!("{} {} {}", inner(left), SYMBOLS[*operator as usize], inner(right))
        }
        Expr::Intrinsic(intrinsic, operands) => {
            let name = match intrinsic {
                Intrinsic::FromU32 | Intrinsic::FromI32 => "real".to_owned(),
                other => format!("{other:?}").to_lowercase(),
            };
            format!("{name}({})", operands.iter().map(|part| expr(program, part)).collect::<Vec<_>>().join(", "))
        }
    }
}

fn name(program: &Program, var: Var) -> String {
    match var {
        Var::Input(index) => format!("inputs.{}", program.inputs[index].path),
        Var::Output(index) => format!("outputs.{}", program.outputs[index].path),
        Var::State(index) => format!("state.{}", program.state[index].path),
        Var::Constant(index) => program.constants[index].path.clone(),
        // Two locals may have one path: the number tells them apart.
        Var::Local(index) => format!("{}%{index}", program.locals[index].path),
    }
}

fn literal(value: Literal) -> String {
    match value {
        Literal::Bool(value) => value.to_string(),
        Literal::I32(value) => value.to_string(),
        Literal::U32(value) => value.to_string(),
        Literal::F64(value) => format!("{value:?}"),
        Literal::F32(value) => format!("{value:?}"),
        other => format!("{other:?}"),
    }
}
