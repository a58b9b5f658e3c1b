//! Statements and expressions as C text, one to one: no operation is added, removed or moved.

use super::names::{Names, identifier, is_reserved};
use super::{scope, types};
use crate::program::{Expr, Program, Statement, Var, Variable};
use crate::target::comment;
use portable::{Binary, Intrinsic, Literal, RealKind, Unary};
use std::fmt::Write;

/// Characters in a line of code, where it can be broken.
const LINE_WIDTH: usize = 120;

/// Characters in a line of a comment inside a function.
const NOTE_WIDTH: usize = 100;

/// A program with the names that its variables have in C.
pub struct Printer<'p> {
    program: &'p Program,
    inputs: Vec<String>,
    outputs: Vec<String>,
    state: Vec<String>,
    locals: Vec<String>,
    constants: Vec<String>,
}

/// How tightly an operator binds, loosest first.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
enum Precedence {
    Or,
    And,
    Equality,
    Relation,
    Sum,
    Product,
    Unary,
    Primary,
}

impl<'p> Printer<'p> {
    /// Names the constants, then the locals.
    pub fn new(program: &'p Program) -> Self {
        let mut names = Names::default();
        let constants = program.constants.iter().map(|constant| names.take(&constant.path)).collect();
        let locals = program.locals.iter().map(|local| names.take(&local.path)).collect();
        let members = |of: &str, variables: &[Variable]| -> Vec<String> {
            variables.iter().map(|variable| format!("{of}->{}", member(&variable.path))).collect()
        };
        Self {
            program,
            inputs: members("inputs", &program.inputs),
            outputs: members("outputs", &program.outputs),
            state: members("state", &program.state),
            locals,
            constants,
        }
    }

    /// The names of the constants, in their order.
    pub fn constants(&self) -> &[String] {
        &self.constants
    }

    /// The body of a function, indented by one level.
    pub fn body(&self, statements: &[Statement]) -> String {
        let mut text = String::new();
        self.list(statements, &mut vec![false; self.program.locals.len()], 1, &mut text);
        text
    }

    fn list(&self, list: &[Statement], declared: &mut [bool], level: usize, text: &mut String) {
        for (statement, locals) in list.iter().zip(scope::declarations(list, declared)) {
            if let Statement::Assign { target: Var::Local(local), value } = statement
                && locals.contains(local)
            {
                let (ty, name) = (self.local_type(*local), &self.locals[*local]);
                assignment(text, level, &format!("const {ty} {name} ="), &self.expr(value));
                continue;
            }
            for local in locals {
                line(text, level, format_args!("{} {};", self.local_type(local), self.locals[local]));
            }
            self.statement(statement, declared, level, text);
        }
    }

    fn statement(&self, statement: &Statement, declared: &mut [bool], level: usize, text: &mut String) {
        match statement {
            Statement::Note(note) => {
                let lines = comment::lines(&comment::harmless(note), NOTE_WIDTH);
                let indent = "    ".repeat(level);
                line(text, level, format_args!("/* {} */", lines.join(&format!("\n{indent} * "))));
            }
            Statement::Assign { target, value } => {
                assignment(text, level, &format!("{} =", self.var(*target)), &self.expr(value));
            }
            Statement::If { condition, then, otherwise } => {
                line(text, level, format_args!("if ({}) {{", self.expr(condition)));
                self.list(then, declared, level + 1, text);
                let mut rest = otherwise;
                // A chain of questions reads as one.
                while let [Statement::If { condition, then, otherwise }] = rest.as_slice() {
                    line(text, level, format_args!("}} else if ({}) {{", self.expr(condition)));
                    self.list(then, declared, level + 1, text);
                    rest = otherwise;
                }
                if !rest.is_empty() {
                    line(text, level, format_args!("}} else {{"));
                    self.list(rest, declared, level + 1, text);
                }
                line(text, level, format_args!("}}"));
            }
        }
    }

    fn local_type(&self, local: usize) -> &'static str {
        let ty = self.program.locals[local].ty.expect("c: the typing pass has typed every local");
        types::name(ty, self.program.real)
    }

    fn var(&self, var: Var) -> &str {
        match var {
            Var::Input(index) => &self.inputs[index],
            Var::Output(index) => &self.outputs[index],
            Var::State(index) => &self.state[index],
            Var::Constant(index) => &self.constants[index],
            Var::Local(index) => &self.locals[index],
        }
    }

    /// An expression as text.
    pub fn expr(&self, expr: &Expr) -> String {
        self.bound(expr, Precedence::Or)
    }

    /// An expression as text that binds at least as tightly as asked.
    fn bound(&self, expr: &Expr, least: Precedence) -> String {
        let (text, precedence) = self.print(expr);
        if precedence < least { format!("({text})") } else { text }
    }

    fn print(&self, expr: &Expr) -> (String, Precedence) {
        match expr {
            Expr::Literal(literal) => {
                let text = types::literal(*literal);
                let precedence = if text.starts_with('-') { Precedence::Unary } else { Precedence::Primary };
                (text, precedence)
            }
            Expr::Var(var) => (self.var(*var).to_owned(), Precedence::Primary),
            Expr::Unary(operator, operand) => self.unary(*operator, operand),
            Expr::Binary(operator, left, right) => self.binary(*operator, left, right),
            Expr::Intrinsic(intrinsic, operands) => self.intrinsic(*intrinsic, operands),
        }
    }

    fn unary(&self, operator: Unary, operand: &Expr) -> (String, Precedence) {
        // `Primary`: no `--x`, and the reader sees what the sign belongs to.
        let inner = self.bound(operand, Precedence::Primary);
        match operator {
            Unary::Not => (format!("!{inner}"), Precedence::Unary),
            Unary::Negate if self.is_i32(operand) => (format!("(int32_t)(0u - (uint32_t){inner})"), Precedence::Unary),
            Unary::Negate => (format!("-{inner}"), Precedence::Unary),
        }
    }

    fn binary(&self, operator: Binary, left: &Expr, right: &Expr) -> (String, Precedence) {
        let (symbol, precedence, least) = match operator {
            Binary::Add => ("+", Precedence::Sum, Precedence::Sum),
            Binary::Subtract => ("-", Precedence::Sum, Precedence::Sum),
            Binary::Multiply => ("*", Precedence::Product, Precedence::Product),
            Binary::Divide => ("/", Precedence::Product, Precedence::Product),
            // Comparisons of comparisons and `&&` beside `||` are legal and misread: they get parentheses.
            Binary::Less => ("<", Precedence::Relation, Precedence::Sum),
            Binary::LessEqual => ("<=", Precedence::Relation, Precedence::Sum),
            Binary::Greater => (">", Precedence::Relation, Precedence::Sum),
            Binary::GreaterEqual => (">=", Precedence::Relation, Precedence::Sum),
            Binary::Equal => ("==", Precedence::Equality, Precedence::Sum),
            Binary::NotEqual => ("!=", Precedence::Equality, Precedence::Sum),
            Binary::And => ("&&", Precedence::And, Precedence::And),
            Binary::Or => return (self.any_of(left, right), Precedence::Or),
        };
        if precedence >= Precedence::Sum && self.is_i32(left) {
            // A signed overflow has no meaning in C: wrap around as unsigned numbers do.
            let (left, right) = (self.bound(left, Precedence::Primary), self.bound(right, Precedence::Primary));
            return (format!("(int32_t)((uint32_t){left} {symbol} (uint32_t){right})"), Precedence::Unary);
        }
        let tighter = match least {
            Precedence::Sum if precedence == Precedence::Sum => Precedence::Product,
            Precedence::Product => Precedence::Primary,
            other => other,
        };
        let right_text = match right {
            Expr::Literal(_) => self.bound(right, Precedence::Primary),
            _ => self.bound(right, tighter),
        };
        (format!("{} {symbol} {right_text}", self.bound(left, least)), precedence)
    }

    fn any_of(&self, left: &Expr, right: &Expr) -> String {
        let side = |expr: &Expr| {
            let (text, precedence) = self.print(expr);
            if precedence == Precedence::And { format!("({text})") } else { text }
        };
        let right_text =
            if matches!(right, Expr::Binary(Binary::Or, ..)) { format!("({})", self.expr(right)) } else { side(right) };
        format!("{} || {right_text}", side(left))
    }

    fn intrinsic(&self, intrinsic: Intrinsic, operands: &[Expr]) -> (String, Precedence) {
        match (intrinsic, operands) {
            (Intrinsic::Usable | Intrinsic::Within, [x, limit]) => {
                let (x, limit) = (self.expr(x), self.bound(limit, Precedence::Sum));
                (format!("magnitude({x}) <= {limit}"), Precedence::Relation)
            }
            (Intrinsic::FromU32, [value]) => {
                let ty = match self.program.real {
                    RealKind::F64 => "double",
                    RealKind::F32 => "float",
                };
                (format!("({ty}){}", self.bound(value, Precedence::Primary)), Precedence::Unary)
            }
            _ => panic!("c: {intrinsic:?} with {} operands", operands.len()),
        }
    }

    fn is_i32(&self, expr: &Expr) -> bool {
        match expr {
            Expr::Literal(literal) => matches!(literal, Literal::I32(_)),
            Expr::Unary(_, operand) => self.is_i32(operand),
            Expr::Binary(operator, left, _) => {
                matches!(operator, Binary::Add | Binary::Subtract | Binary::Multiply) && self.is_i32(left)
            }
            other => crate::pass::typing::type_of(other, self.program) == Ok(crate::program::Type::I32),
        }
    }
}

/// The member of a struct that a path names.
pub fn member(path: &str) -> String {
    match identifier(path) {
        name if is_reserved(&name) => format!("{name}_value"),
        name => name,
    }
}

/// An assignment, on two lines where one would be too long.
fn assignment(text: &mut String, level: usize, target: &str, value: &str) {
    if 4 * level + target.len() + value.len() < LINE_WIDTH {
        line(text, level, format_args!("{target} {value};"));
    } else {
        line(text, level, format_args!("{target}"));
        line(text, level + 1, format_args!("{value};"));
    }
}

fn line(text: &mut String, level: usize, content: std::fmt::Arguments<'_>) {
    for _ in 0..level {
        text.push_str("    ");
    }
    text.write_fmt(content).expect("c: a string takes all text");
    text.push('\n');
}
