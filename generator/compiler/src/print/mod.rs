//! One printer for all languages: it traverses a program's statements, one to one. No operation is added, removed or moved,
//! and everything language-specific is in the description of the language.

pub mod c;
mod choice;
pub mod comment;
mod expression;
mod language;
mod lines;
mod names;
mod number;
pub mod rust;
mod scope;
pub mod st;

pub use language::{Appearance, Language};
use names::Names;
pub use names::identifier;

use crate::program::values::{self, Signal};
use crate::program::{Constant, Expr, Origin, Program, Row, Statement, Table, Var, Variable, part_of};
use language::{Declaration, Level};
use lines::Lines;
use portable::{Literal, Real};
use std::borrow::Cow;

/// Characters in a line of a comment among the statements.
const NOTE_WIDTH: usize = 100;

/// A program with the names of its variables in a language.
pub struct Printer<'p> {
    program: &'p Program,
    language: &'p Language,
    /// the beginning of the block's names outside its functions
    block: &'p str,
    /// names as declared
    names: Scope,
    signals: Vec<Signal>,
    appearances: Vec<Appearance>,
    /// names as in a statement
    texts: Scope,
    /// the text of a constant after a sign, if that differs: the comment contains the sign too
    negated: Vec<Option<String>>,
}

/// A text for each variable of a program.
pub type Scope = Table<String>;

/// The texts that a caller writes for the inputs and for the outputs of a program.
pub fn signals(program: &Program, language: &Language) -> [Vec<String>; 2] {
    let mut names = Names::new(language);
    let mut inputs = grouped(&program.inputs, program.set, language, &mut names);
    put_inside(&mut inputs, &program.inputs, program.set, ".");
    let mut outputs = grouped(&program.outputs, program.made, language, &mut names);
    put_inside(&mut outputs, &program.outputs, program.made, ".");
    [inputs, outputs]
}

/// Puts the name of the parameter set before the names of its parts.
fn put_inside(names: &mut [String], variables: &[Variable], set: Option<&str>, inside: &str) {
    for (name, variable) in names.iter_mut().zip(variables) {
        if let Some(set) = set.filter(|set| part_of(Some(set), variable).is_some()) {
            name.insert_str(0, &format!("{set}{inside}"));
        }
    }
}

/// The names of inputs or outputs. A parameter set is one of them, with its own names inside.
fn grouped(variables: &[Variable], set: Option<&str>, language: &Language, names: &mut Names) -> Vec<String> {
    let in_set = |variable: &Variable| part_of(set, variable).map(str::to_owned);
    let is_outside = |variable: &&Variable| in_set(variable).is_none();
    let mut outside = members(variables.iter().filter(is_outside), language, names).into_iter();
    if variables.iter().any(|variable| in_set(variable).is_some()) && !language.has_structs {
        set.map(|set| names.take(set));
    }
    let mut inside = Names::new(language);
    let name = |variable| match in_set(variable) {
        Some(path) => inside.take(&path),
        None => outside.next().expect("print: each signal has its name"),
    };
    variables.iter().map(name).collect()
}

/// The names of variables that the caller sees: in one scope with all others, or in a struct.
fn members<'v>(
    variables: impl IntoIterator<Item = &'v Variable>,
    language: &Language,
    names: &mut Names,
) -> Vec<String> {
    let mut own = language.has_structs.then(|| Names::new(language));
    let names = own.as_mut().unwrap_or(names);
    let name = |variable: &Variable| match variable.path.as_str() {
        path if language.kept.contains(&path) => path.to_owned(),
        path => names.take(path),
    };
    variables.into_iter().map(name).collect()
}

/// The names of the parts of the state. An element of an array has the name of the array, and its index.
fn parts(program: &Program, language: &Language, names: &mut Names) -> Vec<String> {
    let mut own = language.has_structs.then(|| Names::new(language));
    let names = own.as_mut().unwrap_or(names);
    let mut array = String::new();
    let name = |(index, part): (usize, &Variable)| {
        let Some(row) = program.row_of(index) else { return names.take(&part.path) };
        if index == row.first {
            array = names.take(program.path_of_row(row).expect("print: an array has a path"));
        }
        format!("{array}[{}]", index - row.first)
    };
    program.state.iter().enumerate().map(name).collect()
}

/// The array of its first element.
fn without_index(first: &str) -> &str {
    first.strip_suffix("[0]").expect("print: the first element of an array")
}

impl<'p> Printer<'p> {
    /// Interface names are assigned first. `block` is the beginning of the block's names outside its functions.
    pub fn new(program: &'p Program, language: &'p Language, block: &'p str) -> Self {
        let signals = if language.has_enumerations { values::of_signals(program) } else { Vec::new() };
        let appearances = (language.appearances)(program, &signals);
        let names = declared(program, language, block, &appearances);
        let mut texts = names.clone();
        put_inside(&mut texts.inputs, &program.inputs, program.set, language.inside);
        put_inside(&mut texts.outputs, &program.outputs, program.made, ".");
        let Scope { inputs, outputs, state, constants, locals } = &mut texts;
        for (before, list) in language.before.into_iter().zip([inputs, outputs, state, constants, locals]) {
            list.iter_mut().for_each(|name| name.insert_str(0, before));
        }
        let mut negated = vec![None; program.constants.len()];
        for (index, appearance) in appearances.iter().enumerate() {
            if *appearance == Appearance::Inline {
                let (constant, name) = (&program.constants[index], &names.constants[index]);
                (texts.constants[index], negated[index]) = inline(constant, name, language);
            }
        }
        Self { program, language, block, names, signals, appearances, texts, negated }
    }

    /// The names of the variables, as they are declared.
    pub fn names(&self) -> &Scope {
        &self.names
    }

    /// The name of an array of the state, as it is declared.
    pub fn array(&self, row: Row) -> &str {
        without_index(&self.names.state[row.first])
    }

    /// The signals whose values are enumerations.
    pub fn signals(&self) -> &[Signal] {
        &self.signals
    }

    /// The appearance of each constant.
    pub fn appearances(&self) -> &[Appearance] {
        &self.appearances
    }

    /// Statements of the program, one per line, indented by some levels.
    ///
    /// # Panics
    /// If the program is not verified.
    pub fn body(&self, statements: &[Statement], level: usize) -> String {
        let mut layout = Layout { printer: self, lines: Lines::default() };
        layout.lines.level = level;
        layout.list(statements, &mut vec![false; self.program.locals.len()]);
        layout.lines.into_text()
    }
}

/// The names of the variables, as they are declared.
fn declared(program: &Program, language: &Language, block: &str, appearances: &[Appearance]) -> Scope {
    let mut names = Names::new(language);
    let constant = |(constant, appearance): (&Constant, &Appearance), names: &mut Names| {
        let name = match appearance {
            Appearance::Enumerator | Appearance::Shared if !block.is_empty() => {
                names.take(&format!("{block}.{}", constant.path))
            }
            _ => names.take(&constant.path),
        };
        let is_capital = language.has_capitals || *appearance == Appearance::Enumerator;
        if is_capital { name.to_ascii_uppercase() } else { name }
    };
    let mut scope = Scope {
        inputs: grouped(&program.inputs, program.set, language, &mut names),
        outputs: grouped(&program.outputs, program.made, language, &mut names),
        state: parts(program, language, &mut names),
        constants: program.constants.iter().zip(appearances).map(|it| constant(it, &mut names)).collect(),
        locals: Vec::new(),
    };
    names.begin_locals();
    scope.locals = program.locals.iter().map(|local| names.take(&local.path)).collect();
    scope
}

/// The digits of a constant with its name; then the text after a sign, if that differs.
fn inline(constant: &Constant, name: &str, language: &Language) -> (String, Option<String>) {
    if let Origin::Runtime(text) = constant.origin {
        return (text.to_owned(), None);
    }
    let (digits, level) = (language.operand)(constant.value);
    let [open, _, close] = language.comment;
    let text = format!("{digits} {open}{name}{close}");
    if level == Level::Primary {
        (text, Some(format!("{digits} {open}-{name}{close}")))
    } else {
        (format!("({text})"), None)
    }
}

/// The arrays, if the first statements of a list copy one to the other, element by element: the target, then the source.
fn copied(program: &Program, list: &[Statement]) -> Option<[Row; 2]> {
    let parts = |statement: &Statement| match statement {
        Statement::Assign { target: Var::State(to), value: Expr::Var(Var::State(from)) } => Some([*to, *from]),
        _ => None,
    };
    let [to, from] = parts(list.first()?)?.map(|part| program.row_of(part).filter(|row| row.first == part));
    let (to, from) = (to?, from?);
    let mut all = list.get(..to.length)?.iter().enumerate();
    let is_copied = |(index, statement)| parts(statement) == Some([to.first + index, from.first + index]);
    (to.length == from.length && all.all(is_copied)).then_some([to, from])
}

/// A value as it is assigned: a literal for an output of single precision in a program of double precision is one of single
/// precision.
fn of_target<'e>(program: &Program, target: Var, value: &'e Expr) -> Cow<'e, Expr> {
    match (target, value) {
        (Var::Output(output), Expr::Literal(Literal::F64(wide))) if program.is_single(&program.outputs[output]) => {
            Cow::Owned(Expr::Literal(Literal::F32(Real::lit(*wide))))
        }
        _ => Cow::Borrowed(value),
    }
}

/// The layout of one body.
struct Layout<'p> {
    printer: &'p Printer<'p>,
    lines: Lines,
}

impl Layout<'_> {
    /// Statements. `declared` contains the locals that an outer list declares.
    fn list(&mut self, list: &[Statement], declared: &mut [bool]) {
        let Printer { program, language, names, .. } = self.printer;
        let Some([with_value, without]) = language.locals else {
            return self.list_with_arrays(list, declared);
        };
        let declared_as = |form: Declaration, local: usize| {
            let ty = program.locals[local].ty.expect("print: the typing pass has typed every local");
            form(&names.locals[local], language.ty(ty, program.real))
        };
        for (statement, locals) in list.iter().zip(scope::declarations(list, declared)) {
            if let Statement::Assign { target: Var::Local(local), value } = statement
                && locals.contains(local)
            {
                self.assignment(&declared_as(with_value, *local), value);
                continue;
            }
            locals.into_iter().for_each(|local| self.line(&declared_as(without, local)));
            self.statement(statement, declared);
        }
    }

    /// Statements of a language that assigns an array as a whole, and declares locals elsewhere.
    fn list_with_arrays(&mut self, mut list: &[Statement], declared: &mut [bool]) {
        while let [statement, rest @ ..] = list {
            if let Some([to, from]) = copied(self.printer.program, list) {
                let [target, value] = [to, from].map(|row| without_index(&self.printer.texts.state[row.first]));
                self.line(&format!("{target}{} {value};", self.printer.language.assign));
                list = &list[to.length..];
            } else {
                self.statement(statement, declared);
                list = rest;
            }
        }
    }

    fn statement(&mut self, statement: &Statement, declared: &mut [bool]) {
        let Printer { language, texts, block, .. } = self.printer;
        match statement {
            Statement::Note(note) => self.note(note),
            Statement::Assign { target, value } => {
                self.assignment(&texts[*target], &of_target(self.printer.program, *target, value));
            }
            Statement::Apart(_) => self.line(&language.call.replace("{block}", block)),
            Statement::Choose { by, arms } => self.choice(by, arms, declared),
            Statement::If { condition, then, otherwise } => {
                let [first, next, _, last, end] = language.choice;
                self.asked(first, condition);
                self.inner(then, declared);
                let (mut rest, mut is_chain) = (otherwise, false);
                // A single `if` in the other branch continues the chain.
                while let [Statement::If { condition, then, otherwise }] = rest.as_slice() {
                    self.asked(next, condition);
                    self.inner(then, declared);
                    (rest, is_chain) = (otherwise, true);
                }
                if !rest.is_empty() {
                    self.line(last);
                    self.inner(rest, declared);
                } else if let Some(nothing) = language.nothing_else.filter(|_| is_chain) {
                    self.line(last);
                    self.indented(1, |layout| layout.line(nothing));
                }
                self.line(end);
            }
        }
    }

    fn note(&mut self, note: &str) {
        let [open, next, close] = self.printer.language.comment;
        self.lines.text(open);
        for (index, line) in comment::wrapped(&[note], NOTE_WIDTH, "\n").split('\n').enumerate() {
            if index > 0 {
                self.lines.end();
                self.lines.text(next);
            }
            self.lines.text(line);
        }
        self.line(close);
    }

    /// The line with a condition; if it is broken, it is indented more than the statements after it.
    fn asked(&mut self, before: &str, condition: &Expr) {
        self.lines.text(before);
        self.indented(2, |layout| _ = layout.expr(condition));
        self.line(self.printer.language.choice[2]);
    }

    /// An assignment; if it is too long, it is broken after its target first.
    fn assignment(&mut self, target: &str, value: &Expr) {
        self.lines.text(target);
        self.lines.text(self.printer.language.assign);
        self.indented(1, |layout| {
            layout.part(|layout| {
                layout.indented(1, |layout| _ = layout.expr(value));
                layout.lines.text(";");
            });
        });
        self.lines.end();
    }

    /// Statements inside another one.
    fn inner(&mut self, list: &[Statement], declared: &mut [bool]) {
        self.indented(1, |layout| layout.list(list, declared));
    }

    /// Writes with more levels before the lines that begin.
    fn indented(&mut self, levels: usize, write: impl FnOnce(&mut Self)) {
        self.lines.level += levels;
        write(self);
        self.lines.level -= levels;
    }

    /// Writes after a blank if all fits into the line, else into a new line.
    fn part(&mut self, write: impl FnOnce(&mut Self)) {
        let part = self.lines.begin_part();
        write(self);
        self.lines.end_part(part);
    }

    /// The end of a line.
    fn line(&mut self, text: &str) {
        self.lines.text(text);
        self.lines.end();
    }
}
