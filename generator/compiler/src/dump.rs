//! A program as text, for readers who inspect the pipeline. Nothing reads it back.

use crate::program::{Expr, Origin, Program, Statement, Type, Var, Variable, push_number};
use portable::{Intrinsic, Literal, Unary};
use std::fmt::{Display, Formatter, Result, Write};

/// The operators, in the order of [`portable::Binary`].
const SYMBOLS: [&str; 13] =
    [" + ", " - ", " * ", " / ", " % ", " < ", " <= ", " > ", " >= ", " == ", " != ", " and ", " or "];

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
    /// the text for a value that depends on the axis, of a coefficient or of a variable at the start, if it is not written
    decided: Option<fn(Literal) -> &'static str>,
    with_notes: bool,
}

impl<'p> Dump<'p> {
    pub(crate) fn of(program: &'p Program) -> Self {
        Self { program, text: String::new(), decided: None, with_notes: true }
    }

    /// A dump that continues a text, without notes; `decided` is the text for the values that depend on the axis.
    pub(crate) fn bare(program: &'p Program, decided: fn(Literal) -> &'static str, text: String) -> Self {
        Self { program, text, decided: Some(decided), with_notes: false }
    }

    /// An expression alone.
    pub(crate) fn expression(mut self, expr: &Expr) -> String {
        self.expr(expr);
        self.text
    }

    /// A statement alone, without the statements inside it.
    pub(crate) fn statement(mut self, statement: &Statement) -> String {
        self.head(statement);
        self.text
    }

    pub(crate) fn whole(mut self) -> String {
        let program = self.program;
        let lists = [("input    ", &program.inputs), ("output   ", &program.outputs), ("state    ", &program.state)];
        for (kind, list) in lists {
            for Variable { path, ty, start, .. } in list {
                self.put([kind, path, ": ", word(*ty), " = "]);
                self.number(*start, true);
            }
        }
        for constant in &program.constants {
            self.put(["constant ", &constant.path, " = "]);
            self.number(constant.value, matches!(constant.origin, Origin::Coefficient(_)));
        }
        for (index, local) in program.locals.iter().enumerate() {
            self.put(["local    "]);
            self.name(Var::Local(index));
            self.put([": ", local.ty.map_or("?", word), "\n"]);
        }
        for (name, list) in [("init\n", &program.init), ("step\n", &program.step)] {
            self.put([name]);
            self.statements(list, &mut "    ".to_owned());
        }
        self.text
    }

    /// The number of a declaration, and the end of its line.
    fn number(&mut self, value: Literal, is_of_axis: bool) {
        match self.decided.filter(|_| is_of_axis) {
            Some(decided) => self.put([decided(value), "\n"]),
            None => {
                self.literal(value);
                self.put(["\n"]);
            }
        }
    }

    fn statements(&mut self, list: &[Statement], indent: &mut String) {
        for statement in list {
            match statement {
                Statement::Note(_) if !self.with_notes => continue,
                statement => {
                    self.put([&*indent]);
                    self.head(statement);
                    self.put(["\n"]);
                }
            }
            for (index, list) in statement.branches().enumerate() {
                match statement {
                    Statement::If { .. } if index == 1 && !list.is_empty() => self.put([&*indent, "else\n"]),
                    Statement::Choose { arms, .. } => {
                        self.put([&*indent]);
                        self.listed(&arms[index].labels);
                        self.put([":\n"]);
                    }
                    _ => {}
                }
                indent.push_str("    ");
                self.statements(list, indent);
                indent.truncate(indent.len() - 4);
            }
        }
    }

    fn put<const N: usize>(&mut self, pieces: [&str; N]) {
        for piece in &pieces {
            self.text.push_str(piece);
        }
    }

    /// A statement without the statements inside it.
    fn head(&mut self, statement: &Statement) {
        match statement {
            Statement::Note(note) => self.put(["# ", note]),
            Statement::Assign { target, value } => {
                self.name(*target);
                self.put([" = "]);
                self.expr(value);
            }
            Statement::If { condition, .. } => {
                self.put(["if "]);
                self.expr(condition);
            }
            Statement::Choose { by, .. } => {
                self.put(["choose by "]);
                self.expr(by);
            }
            Statement::Apart(_) => self.put(["apart"]),
        }
    }

    fn listed(&mut self, parts: &[Expr]) {
        for (index, part) in parts.iter().enumerate() {
            self.put([if index == 0 { "" } else { ", " }]);
            self.expr(part);
        }
    }

    /// An expression, in parentheses unless it is simple.
    fn operand(&mut self, expr: &Expr) {
        if matches!(expr, Expr::Literal(_) | Expr::Var(_) | Expr::Intrinsic(..)) {
            self.expr(expr);
        } else {
            self.put(["("]);
            self.expr(expr);
            self.put([")"]);
        }
    }

    fn expr(&mut self, value: &Expr) {
        match value {
            Expr::Literal(value) => self.literal(*value),
            Expr::Var(var) => self.name(*var),
            Expr::Unary(operator, operand) => {
                self.put([if *operator == Unary::Negate { "-" } else { "not " }]);
                self.operand(operand);
            }
            Expr::Binary(operator, left, right) => {
                self.operand(left);
                self.put([SYMBOLS[*operator as usize]]);
                self.operand(right);
            }
            Expr::Intrinsic(intrinsic, operands) => {
                let name = match intrinsic {
                    Intrinsic::FromU32 | Intrinsic::FromI32 => "real",
                    other => &format!("{other:?}").to_lowercase(),
                };
                self.put([name, "("]);
                self.listed(operands);
                self.put([")"]);
            }
            Expr::Element(row, index) => {
                self.put(["state.", self.program.path_of_row(*row).unwrap_or_default(), "["]);
                self.expr(index);
                self.put(["]"]);
            }
        }
    }

    fn name(&mut self, var: Var) {
        let kind = match var {
            Var::Input(_) => "inputs.",
            Var::Output(_) => "outputs.",
            Var::State(_) => "state.",
            Var::Constant(_) | Var::Local(_) => "",
        };
        self.put([kind, self.program.path(var)]);
        if let Var::Local(index) = var {
            // Two locals may have the same path: the number distinguishes them.
            self.put(["%"]);
            push_number(&mut self.text, index);
        }
    }

    fn literal(&mut self, value: Literal) {
        let _ = match value {
            Literal::Bool(value) => return self.put([if value { "true" } else { "false" }]),
            Literal::I32(value) => write!(self.text, "{value}"),
            Literal::U32(value) => write!(self.text, "{value}"),
            Literal::F64(value) => write!(self.text, "{value:?}"),
            Literal::F32(value) => write!(self.text, "{value:?}"),
            other => write!(self.text, "{other:?}"),
        };
    }
}

fn word(ty: Type) -> &'static str {
    match ty {
        Type::Bool => "Bool",
        Type::I32 => "I32",
        Type::U32 => "U32",
        Type::Real => "Real",
    }
}
