//! Statements as C text, one to one: no operation is added, removed or moved. Expressions are printed in `expression`.

use super::names::is_reserved;
use super::{scope, types};
use crate::target::names::{Names, identifier};
use crate::target::{comment, line};
use compiler::program::{Expr, Program, Statement, Var, Variable};
use std::fmt::Write;

/// What a long line is broken before.
const OPERATORS: [&str; 4] = [" && ", " || ", " + ", " - "];

/// Characters in a line of a comment inside a function.
const NOTE_WIDTH: usize = 100;

/// The names of a program's constants, behind a prefix where the file has other programs too.
pub fn constants(program: &Program, prefix: &str, names: &mut Names) -> Vec<String> {
    let path = |path: &str| if prefix.is_empty() { path.to_owned() } else { format!("{prefix}.{path}") };
    program.constants.iter().map(|constant| names.take(&path(&constant.path))).collect()
}

/// A program with the names that its variables have in C.
pub struct Printer<'p> {
    program: &'p Program,
    inputs: Vec<String>,
    outputs: Vec<String>,
    state: Vec<String>,
    locals: Vec<String>,
    constants: Vec<String>,
}

impl<'p> Printer<'p> {
    /// A program that has a file for itself.
    pub fn new(program: &'p Program) -> Self {
        let mut names = Names::without(is_reserved);
        let constants = constants(program, "", &mut names);
        Self::beside(program, constants, names)
    }

    /// A program whose constants have their names, in a file with those of others: its locals have none of them.
    pub fn beside(program: &'p Program, constants: Vec<String>, mut names: Names) -> Self {
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

    /// What is printed.
    pub(super) fn program(&self) -> &Program {
        self.program
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
                self.assignment(["const ", ty, " ", name], value, level, text);
                continue;
            }
            for local in locals {
                put(text, level, format_args!("{} {};", self.local_type(local), self.locals[local]));
            }
            self.statement(statement, declared, level, text);
        }
    }

    fn statement(&self, statement: &Statement, declared: &mut [bool], level: usize, text: &mut String) {
        match statement {
            Statement::Note(note) => {
                let lines = comment::lines(&comment::harmless(note), NOTE_WIDTH);
                let indent = "    ".repeat(level);
                put(text, level, format_args!("/* {} */", lines.join(&format!("\n{indent} * "))));
            }
            Statement::Assign { target, value } => {
                self.assignment(["", "", "", self.var(*target)], value, level, text);
            }
            Statement::If { condition, then, otherwise } => {
                self.question("if (", condition, level, text);
                self.list(then, declared, level + 1, text);
                let mut rest = otherwise;
                // A chain of questions reads as one.
                while let [Statement::If { condition, then, otherwise }] = rest.as_slice() {
                    self.question("} else if (", condition, level, text);
                    self.list(then, declared, level + 1, text);
                    rest = otherwise;
                }
                if !rest.is_empty() {
                    put(text, level, format_args!("}} else {{"));
                    self.list(rest, declared, level + 1, text);
                }
                put(text, level, format_args!("}}"));
            }
        }
    }

    /// An assignment, on more lines where one would be too long.
    fn assignment(&self, target: [&str; 4], value: &Expr, level: usize, text: &mut String) {
        let start = text.len();
        line::indent(level, text);
        text.extend(target);
        text.push_str(" =");
        let end_of_target = text.len();
        text.push(' ');
        self.expr(value, text);
        text.push(';');
        line::fold_assignment(text, start, end_of_target, level, &OPERATORS);
        text.push('\n');
    }

    fn question(&self, words: &str, condition: &Expr, level: usize, text: &mut String) {
        let start = text.len();
        line::indent(level, text);
        text.push_str(words);
        self.expr(condition, text);
        text.push_str(") {");
        line::fold(text, start, level + 2, &OPERATORS);
        text.push('\n');
    }

    fn local_type(&self, local: usize) -> &'static str {
        let ty = self.program.locals[local].ty.expect("c: the typing pass has typed every local");
        types::name(ty, self.program.real)
    }

    pub(super) fn var(&self, var: Var) -> &str {
        match var {
            Var::Input(index) => &self.inputs[index],
            Var::Output(index) => &self.outputs[index],
            Var::State(index) => &self.state[index],
            Var::Constant(index) => &self.constants[index],
            Var::Local(index) => &self.locals[index],
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

fn put(text: &mut String, level: usize, content: std::fmt::Arguments<'_>) {
    line::indent(level, text);
    text.write_fmt(content).expect("c: a string takes all text");
    text.push('\n');
}
