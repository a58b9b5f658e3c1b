//! A program as text, for people who look into the pipeline. Nothing reads it back.

use crate::program::{Expr, Program, Statement, Var, Variable};
use portable::{Binary, Intrinsic, Literal, Unary};
use std::fmt::Write;

/// The whole program: its variables, then its statements.
#[must_use]
pub fn text(program: &Program) -> String {
    let mut text = String::new();
    let variables = [("input", &program.inputs), ("output", &program.outputs), ("state", &program.state)];
    for (kind, list) in variables {
        list.iter().for_each(|variable| declare(kind, variable, &mut text));
    }
    for constant in &program.constants {
        let _ = writeln!(text, "constant {} = {}", constant.path, literal(constant.value));
    }
    for (index, local) in program.locals.iter().enumerate() {
        let ty = local.ty.map_or_else(|| "?".to_owned(), |ty| format!("{ty:?}"));
        let _ = writeln!(text, "local    {}: {ty}", local_name(program, index));
    }
    for (name, list) in [("init", &program.init), ("step", &program.step)] {
        let _ = writeln!(text, "{name}");
        statements(program, list, 1, &mut text);
    }
    text
}

fn declare(kind: &str, variable: &Variable, text: &mut String) {
    let Variable { path, ty, start, .. } = variable;
    let _ = writeln!(text, "{kind:<8} {path}: {ty:?} = {}", literal(*start));
}

fn statements(program: &Program, list: &[Statement], level: usize, text: &mut String) {
    let indent = "    ".repeat(level);
    for statement in list {
        match statement {
            Statement::Note(note) => {
                let _ = writeln!(text, "{indent}# {note}");
            }
            Statement::Assign { target, value } => {
                let _ = writeln!(text, "{indent}{} = {}", name(program, *target), expr(program, value));
            }
            Statement::If { condition, then, otherwise } => {
                let _ = writeln!(text, "{indent}if {}", expr(program, condition));
                statements(program, then, level + 1, text);
                if !otherwise.is_empty() {
                    let _ = writeln!(text, "{indent}else");
                    statements(program, otherwise, level + 1, text);
                }
            }
        }
    }
}

fn expr(program: &Program, value: &Expr) -> String {
    let inner = |part: &Expr| match part {
        Expr::Literal(_) | Expr::Var(_) | Expr::Intrinsic(..) => expr(program, part),
        _ => format!("({})", expr(program, part)),
    };
    match value {
        Expr::Literal(value) => literal(*value),
        Expr::Var(var) => name(program, *var),
        Expr::Unary(Unary::Negate, operand) => format!("-{}", inner(operand)),
        Expr::Unary(Unary::Not, operand) => format!("not {}", inner(operand)),
        Expr::Binary(operator, left, right) => format!("{} {} {}", inner(left), symbol(*operator), inner(right)),
        Expr::Intrinsic(intrinsic, operands) => {
            let name = match intrinsic {
                Intrinsic::InRange => "in_range",
                Intrinsic::Within => "within",
                Intrinsic::FromU32 | Intrinsic::FromI32 => "real",
                Intrinsic::Truncate => "truncate",
                Intrinsic::Nearest => "nearest",
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
        Var::Local(index) => local_name(program, index),
    }
}

/// Two locals may have one path: the number tells them apart.
fn local_name(program: &Program, index: usize) -> String {
    format!("{}%{index}", program.locals[index].path)
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

fn symbol(operator: Binary) -> &'static str {
    match operator {
        Binary::Add => "+",
        Binary::Subtract => "-",
        Binary::Multiply => "*",
        Binary::Divide => "/",
        Binary::Less => "<",
        Binary::LessEqual => "<=",
        Binary::Greater => ">",
        Binary::GreaterEqual => ">=",
        Binary::Equal => "==",
        Binary::NotEqual => "!=",
        Binary::And => "and",
        Binary::Or => "or",
    }
}
