//! Statements as Structured Text, one to one: no operation is added, removed or moved. Expressions are printed in
//! `expression`.

use super::dialect::{Dialect, Form};
use super::names::{is_reserved, signals};
use super::{forms, types};
use crate::target::names::Names;
use crate::target::{comment, line};
use compiler::program::{Constant, Expr, Program, Statement, Var};

/// What a long line is broken before.
const OPERATORS: [&str; 4] = [" AND ", " OR ", " + ", " - "];

/// Characters in a line of a comment among the statements.
const NOTE_WIDTH: usize = 100;

/// A program with the names that its variables have in a dialect.
pub struct Printer<'p> {
    program: &'p Program,
    dialect: Dialect,
    /// as declared
    pub names: Scope,
    /// how each constant appears
    pub forms: Vec<Form>,
    /// as in a statement
    in_statements: Scope,
}

/// A text for each variable of a program.
pub struct Scope {
    /// of the inputs
    pub inputs: Vec<String>,
    /// of the outputs
    pub outputs: Vec<String>,
    /// of the state
    pub state: Vec<String>,
    /// of the locals
    pub locals: Vec<String>,
    /// of the constants
    pub constants: Vec<String>,
}

impl<'p> Printer<'p> {
    /// Names everything, the interface first: all of it is one scope.
    #[must_use]
    pub fn new(program: &'p Program, dialect: Dialect) -> Self {
        let mut names = Names::without(is_reserved);
        let [inputs, outputs] = signals(program, &mut names);
        let names = Scope {
            inputs,
            outputs,
            state: program.state.iter().map(|variable| names.take(&variable.path)).collect(),
            constants: program.constants.iter().map(|constant| names.take(&constant.path)).collect(),
            locals: program.locals.iter().map(|local| names.take(&local.path)).collect(),
        };
        let with_sigil = |names: &[String]| names.iter().map(|name| format!("{}{name}", dialect.sigil)).collect();
        let forms = forms::of(program, &dialect);
        let constant = |((constant, name), form): ((&Constant, &String), &Form)| match form {
            Form::Inline => inline(&types::in_statement(constant.value), name),
            Form::Declared | Form::Assigned => format!("{}{name}", dialect.sigil),
        };
        let constants = program.constants.iter().zip(&names.constants).zip(&forms).map(constant).collect();
        let in_statements = Scope {
            inputs: with_sigil(&names.inputs),
            outputs: with_sigil(&names.outputs),
            state: with_sigil(&names.state),
            locals: with_sigil(&names.locals),
            constants,
        };
        Self { program, dialect, names, forms, in_statements }
    }

    pub(super) fn program(&self) -> &Program {
        self.program
    }

    pub(super) fn dialect(&self) -> &Dialect {
        &self.dialect
    }

    /// The statements of a cycle, indented by some levels.
    #[must_use]
    pub fn body(&self, level: usize) -> String {
        let mut text = String::new();
        self.list(&self.program.step, level, &mut text);
        text
    }

    fn list(&self, list: &[Statement], level: usize, text: &mut String) {
        for statement in list {
            self.statement(statement, level, text);
        }
    }

    fn statement(&self, statement: &Statement, level: usize, text: &mut String) {
        match statement {
            Statement::Note(note) => {
                let lines = comment::lines(&comment::harmless(note), NOTE_WIDTH);
                let mut next_line = "\n".to_owned();
                line::indent(level, &mut next_line);
                line::indent(level, text);
                text.push_str("(* ");
                text.push_str(&lines.join(&(next_line + "   ")));
                text.push_str(" *)\n");
            }
            Statement::Assign { target, value } => self.assignment(*target, value, level, text),
            Statement::If { condition, then, otherwise } => {
                self.question("IF ", condition, level, text);
                self.list(then, level + 1, text);
                let mut rest = otherwise;
                // A chain of questions reads as one.
                while let [Statement::If { condition, then, otherwise }] = rest.as_slice() {
                    self.question("ELSIF ", condition, level, text);
                    self.list(then, level + 1, text);
                    rest = otherwise;
                }
                if !rest.is_empty() {
                    line::indent(level, text);
                    text.push_str("ELSE\n");
                    self.list(rest, level + 1, text);
                }
                line::indent(level, text);
                text.push_str("END_IF;\n");
            }
        }
    }

    /// An assignment, on more lines where one would be too long.
    fn assignment(&self, target: Var, value: &Expr, level: usize, text: &mut String) {
        let start = text.len();
        line::indent(level, text);
        text.push_str(self.var(target));
        text.push_str(" :=");
        let end_of_target = text.len();
        text.push(' ');
        self.expr(value, text);
        text.push(';');
        line::fold_assignment(text, start, end_of_target, level, &OPERATORS);
        text.push('\n');
    }

    fn question(&self, word: &str, condition: &Expr, level: usize, text: &mut String) {
        let start = text.len();
        line::indent(level, text);
        text.push_str(word);
        self.expr(condition, text);
        text.push_str(" THEN");
        line::fold(text, start, level + 2, &OPERATORS);
        text.push('\n');
    }

    pub(super) fn var(&self, var: Var) -> &str {
        let Scope { inputs, outputs, state, locals, constants } = &self.in_statements;
        match var {
            Var::Input(index) => &inputs[index],
            Var::Output(index) => &outputs[index],
            Var::State(index) => &state[index],
            Var::Constant(index) => &constants[index],
            Var::Local(index) => &locals[index],
        }
    }
}

/// A number in a statement, with its name behind it.
fn inline(value: &str, name: &str) -> String {
    let is_bare = !value.starts_with(['-', '(']) && !value.contains(" * ");
    if is_bare { format!("{value} (* {name} *)") } else { format!("({value} (* {name} *))") }
}
