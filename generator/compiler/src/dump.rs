//! A program as text, for people who look into the pipeline. Nothing reads it back.

use crate::program::{Expr, Origin, Program, Statement, Var, Variable};
use portable::{Intrinsic, Literal, Unary};
use std::fmt::{Display, Formatter, Result, Write};

/// The operators, in the order of [`portable::Binary`].
const SYMBOLS: [&str; 13] = ["+", "-", "*", "/", "%", "<", "<=", ">", ">=", "==", "!=", "and", "or"];

/// The whole program: its variables, then its statements.
impl Display for Program {
    fn fmt(&self, f: &mut Formatter<'_>) -> Result {
        f.write_str(&Dump::of(self).whole())
    }
}

/// What is written of a program.
pub(crate) struct Dump<'p> {
    program: &'p Program,
    text: String,
    /// what stands for a value that an axis decides: of a coefficient, or of a variable at the start
    decided: fn(Literal) -> Literal,
    with_notes: bool,
}

impl<'p> Dump<'p> {
    pub(crate) fn of(program: &'p Program) -> Self {
        Self { program, text: String::new(), decided: |value| value, with_notes: true }
    }

    /// Without notes, and with another value for each that an axis decides, behind a text.
    pub(crate) fn bare(program: &'p Program, decided: fn(Literal) -> Literal, text: String) -> Self {
        Self { program, text, decided, with_notes: false }
    }

    pub(crate) fn whole(mut self) -> String {
        let program = self.program;
        for (kind, list) in [("input ", &program.inputs), ("output", &program.outputs), ("state ", &program.state)] {
            for Variable { path, ty, start, .. } in list {
                let _ = write!(self.text, "{kind}   {path}: {ty:?} = ");
                self.literal((self.decided)(*start));
                self.text.push('\n');
            }
        }
        for constant in &program.constants {
            self.put(&["constant ", &constant.path, " = "]);
            let is_decided = matches!(constant.origin, Origin::Coefficient(_));
            self.literal(if is_decided { (self.decided)(constant.value) } else { constant.value });
            self.text.push('\n');
        }
        for (index, local) in program.locals.iter().enumerate() {
            self.text.push_str("local    ");
            self.name(Var::Local(index));
            match local.ty {
                Some(ty) => drop(writeln!(self.text, ": {ty:?}")),
                None => self.text.push_str(": ?\n"),
            }
        }
        for (name, list) in [("init\n", &program.init), ("step\n", &program.step)] {
            self.text.push_str(name);
            self.statements(list, 1);
        }
        self.text
    }

    /// What a statement does, without those inside it.
    pub(crate) fn first_line(mut self, statement: &Statement) -> String {
        self.head(statement);
        self.text
    }

    pub(crate) fn expression(mut self, value: &Expr) -> String {
        self.expr(value);
        self.text
    }

    fn head(&mut self, statement: &Statement) {
        match statement {
            Statement::Assign { target, .. } => {
                self.name(*target);
                self.text.push_str(" = ");
            }
            Statement::If { .. } => self.text.push_str("if "),
            Statement::Choose { .. } => self.text.push_str("choose by "),
            Statement::Note(_) | Statement::Apart(_) => {}
        }
        statement.expr().into_iter().for_each(|expr| self.expr(expr));
    }

    fn statements(&mut self, list: &[Statement], level: usize) {
        let indent = &"    ".repeat(level);
        for statement in list {
            match statement {
                Statement::Note(_) if !self.with_notes => continue,
                Statement::Note(note) => self.put(&[indent, "# ", note, "\n"]),
                Statement::Apart(_) => self.put(&[indent, "apart\n"]),
                Statement::Assign { .. } | Statement::If { .. } | Statement::Choose { .. } => {
                    self.text.push_str(indent);
                    self.head(statement);
                    self.text.push('\n');
                }
            }
            for (index, list) in statement.branches().enumerate() {
                match statement {
                    Statement::If { otherwise, .. } if index == 1 && !otherwise.is_empty() => {
                        self.put(&[indent, "else\n"]);
                    }
                    Statement::Choose { arms, .. } => {
                        self.text.push_str(indent);
                        self.listed(&arms[index].labels);
                        self.text.push_str(":\n");
                    }
                    _ => {}
                }
                self.statements(list, level + 1);
            }
        }
    }

    fn expr(&mut self, value: &Expr) {
        match value {
            Expr::Literal(value) => self.literal(*value),
            Expr::Var(var) => self.name(*var),
            Expr::Unary(operator, operand) => {
                self.text.push_str(if *operator == Unary::Negate { "-" } else { "not " });
                self.operand(operand);
            }
            Expr::Binary(operator, left, right) => {
                self.operand(left);
                self.put(&[" ", SYMBOLS[*operator as usize], " "]);
                self.operand(right);
            }
            Expr::Intrinsic(intrinsic, operands) => {
                match intrinsic {
                    Intrinsic::FromU32 | Intrinsic::FromI32 => self.text.push_str("real"),
                    other => self.text.push_str(&format!("{other:?}").to_lowercase()),
                }
                self.text.push('(');
                self.listed(operands);
                self.text.push(')');
            }
        }
    }

    fn operand(&mut self, part: &Expr) {
        let is_simple = matches!(part, Expr::Literal(_) | Expr::Var(_) | Expr::Intrinsic(..));
        self.text.push_str(if is_simple { "" } else { "(" });
        self.expr(part);
        self.text.push_str(if is_simple { "" } else { ")" });
    }

    fn listed(&mut self, parts: &[Expr]) {
        for (index, part) in parts.iter().enumerate() {
            self.text.push_str(if index == 0 { "" } else { ", " });
            self.expr(part);
        }
    }

    fn name(&mut self, var: Var) {
        let before = match var {
            Var::Input(_) => "inputs.",
            Var::Output(_) => "outputs.",
            Var::State(_) => "state.",
            Var::Constant(_) | Var::Local(_) => "",
        };
        self.put(&[before, self.program.path(var)]);
        if let Var::Local(index) = var {
            // Two locals may have one path: the number tells them apart.
            let _ = write!(self.text, "%{index}");
        }
    }

    fn literal(&mut self, value: Literal) {
        let _ = match value {
            Literal::Bool(value) => write!(self.text, "{value}"),
            Literal::I32(value) => write!(self.text, "{value}"),
            Literal::U32(value) => write!(self.text, "{value}"),
            Literal::F64(value) => write!(self.text, "{value:?}"),
            Literal::F32(value) => write!(self.text, "{value:?}"),
            other => write!(self.text, "{other:?}"),
        };
    }

    fn put(&mut self, texts: &[&str]) {
        texts.iter().for_each(|text| self.text.push_str(text));
    }
}
