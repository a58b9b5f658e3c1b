//! A program as text, for readers who inspect the pipeline. Nothing reads it back.

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

/// The writer of a program.
pub(crate) struct Dump<'p> {
    program: &'p Program,
    text: String,
    /// the replacement of a value that depends on the axis: of a coefficient, or of a variable at the start
    decided: fn(Literal) -> Literal,
    with_notes: bool,
}

/// The next piece to write.
pub(crate) enum Piece<'a> {
    Text(&'a str),
    Value(Literal),
    Name(Var),
    Expr(&'a Expr),
    /// in parentheses, unless it is simple
    Operand(&'a Expr),
    Listed(&'a [Expr]),
    /// a statement without the statements inside it
    Head(&'a Statement),
}

use Piece::{Head, Listed, Name, Operand, Text, Value};

impl<'p> Dump<'p> {
    pub(crate) fn of(program: &'p Program) -> Self {
        Self { program, text: String::new(), decided: |value| value, with_notes: true }
    }

    /// A dump that continues a text, without notes; `decided` replaces the values that depend on the axis.
    pub(crate) fn bare(program: &'p Program, decided: fn(Literal) -> Literal, text: String) -> Self {
        Self { program, text, decided, with_notes: false }
    }

    /// One piece alone.
    pub(crate) fn alone(mut self, piece: Piece<'_>) -> String {
        self.put([piece]);
        self.text
    }

    pub(crate) fn whole(mut self) -> String {
        let program = self.program;
        for (kind, list) in [("input ", &program.inputs), ("output", &program.outputs), ("state ", &program.state)] {
            for Variable { path, ty, start, .. } in list {
                let _ = write!(self.text, "{kind}   {path}: {ty:?} = ");
                self.put([Value((self.decided)(*start)), Text("\n")]);
            }
        }
        for constant in &program.constants {
            let is_decided = matches!(constant.origin, Origin::Coefficient(_));
            let value = if is_decided { (self.decided)(constant.value) } else { constant.value };
            self.put([Text("constant "), Text(&constant.path), Text(" = "), Value(value), Text("\n")]);
        }
        for (index, local) in program.locals.iter().enumerate() {
            self.put([Text("local    "), Name(Var::Local(index))]);
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

    fn statements(&mut self, list: &[Statement], level: usize) {
        let indent = &"    ".repeat(level);
        for statement in list {
            match statement {
                Statement::Note(_) if !self.with_notes => continue,
                statement => self.put([Text(indent), Head(statement), Text("\n")]),
            }
            for (index, list) in statement.branches().enumerate() {
                match statement {
                    Statement::If { .. } if index == 1 && !list.is_empty() => self.put([Text(indent), Text("else\n")]),
                    Statement::Choose { arms, .. } => {
                        self.put([Text(indent), Listed(&arms[index].labels), Text(":\n")]);
                    }
                    _ => {}
                }
                self.statements(list, level + 1);
            }
        }
    }

    fn put<const N: usize>(&mut self, pieces: [Piece<'_>; N]) {
        for piece in pieces {
            match piece {
                Text(text) => self.text.push_str(text),
                Value(value) => self.literal(value),
                Name(var) => self.name(var),
                Piece::Expr(expr) => self.expr(expr),
                Operand(expr @ (Expr::Literal(_) | Expr::Var(_) | Expr::Intrinsic(..))) => self.expr(expr),
                Operand(expr) => self.put([Text("("), Piece::Expr(expr), Text(")")]),
                Listed(parts) => {
                    for (index, part) in parts.iter().enumerate() {
                        self.put([Text(if index == 0 { "" } else { ", " }), Piece::Expr(part)]);
                    }
                }
                Head(Statement::Note(note)) => self.put([Text("# "), Text(note)]),
                Head(Statement::Assign { target, value }) => {
                    self.put([Name(*target), Text(" = "), Piece::Expr(value)]);
                }
                Head(Statement::If { condition, .. }) => self.put([Text("if "), Piece::Expr(condition)]),
                Head(Statement::Choose { by, .. }) => self.put([Text("choose by "), Piece::Expr(by)]),
                Head(Statement::Apart(_)) => self.text.push_str("apart"),
            }
        }
    }

    fn expr(&mut self, value: &Expr) {
        match value {
            Expr::Literal(value) => self.literal(*value),
            Expr::Var(var) => self.name(*var),
            Expr::Unary(Unary::Negate, operand) => self.put([Text("-"), Operand(operand)]),
            Expr::Unary(Unary::Not, operand) => self.put([Text("not "), Operand(operand)]),
            Expr::Binary(operator, left, right) => {
                let symbol = SYMBOLS[*operator as usize];
                self.put([Operand(left), Text(" "), Text(symbol), Text(" "), Operand(right)]);
            }
            Expr::Intrinsic(intrinsic, operands) => {
                let name = match intrinsic {
                    Intrinsic::FromU32 | Intrinsic::FromI32 => "real",
                    Intrinsic::Unsigned => "unsigned",
                    Intrinsic::Narrow => "narrow",
                    other => &format!("{other:?}").to_lowercase(),
                };
                self.put([Text(name), Text("("), Listed(operands), Text(")")]);
            }
            Expr::Element(row, index) => {
                let path = self.program.path_of_row(*row).unwrap_or_default();
                self.put([Text("state."), Text(path), Text("["), Piece::Expr(index), Text("]")]);
            }
        }
    }

    fn name(&mut self, var: Var) {
        let path = Text(self.program.path(var));
        match var {
            Var::Input(_) => self.put([Text("inputs."), path]),
            Var::Output(_) => self.put([Text("outputs."), path]),
            Var::State(_) => self.put([Text("state."), path]),
            Var::Constant(_) => self.put([path]),
            Var::Local(index) => {
                self.put([path]);
                // Two locals may have the same path: the number distinguishes them.
                let _ = write!(self.text, "%{index}");
            }
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
}
