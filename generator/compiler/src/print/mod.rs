//! One printer for all languages: it traverses a program's statements, one to one. No operation is added, removed or moved,
//! and everything language-specific is in the description of the language.

pub mod c;
mod choice;
pub mod comment;
mod expression;
mod language;
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
use pretty::{Arena, DocAllocator, DocBuilder, RefDoc};

/// Characters in a line of code, where it can be broken.
const WIDTH: usize = 120;
/// Characters in a line of a comment among the statements.
const NOTE_WIDTH: usize = 100;
/// Blanks before inner statements.
const INDENTATION: isize = 4;

type Doc<'d> = DocBuilder<'d, Arena<'d>>;

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
        let mut names = Names::new(language);
        let signals = if language.has_enumerations { values::of_signals(program) } else { Vec::new() };
        let appearances = (language.appearances)(program, &signals);
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
            constants: program.constants.iter().zip(&appearances).map(|it| constant(it, &mut names)).collect(),
            locals: Vec::new(),
        };
        names.begin_locals();
        scope.locals = program.locals.iter().map(|local| names.take(&local.path)).collect();
        let names = scope;
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
                if let Origin::Runtime(text) = program.constants[index].origin {
                    text.clone_into(&mut texts.constants[index]);
                    continue;
                }
                let (digits, level) = (language.operand)(program.constants[index].value);
                let ([open, _, close], name) = (language.comment, &names.constants[index]);
                let text = format!("{digits} {open}{name}{close}");
                if level == Level::Primary {
                    negated[index] = Some(format!("{digits} {open}-{name}{close}"));
                    texts.constants[index] = text;
                } else {
                    texts.constants[index] = format!("({text})");
                }
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
    pub fn body(&self, statements: &[Statement], level: isize) -> String {
        let arena = Arena::new();
        let (line, hardline) = (arena.line().into_doc(), arena.hardline().into_doc());
        let layout = Layout { printer: self, arena: &arena, line, hardline };
        let doc = layout.list(statements, &mut vec![false; self.program.locals.len()]).nest(level * INDENTATION);
        let mut text = String::new();
        doc.render_fmt(WIDTH, &mut text).expect("print: a string takes all text");
        // Each line so far begins with its line break; now it ends with one.
        text.drain(..text.len().min(1));
        text.push_str(if text.is_empty() { "" } else { "\n" });
        text
    }
}

/// The layout of one body.
struct Layout<'d> {
    printer: &'d Printer<'d>,
    arena: &'d Arena<'d>,
    /// a blank, or a line break if the line is too long
    line: RefDoc<'d>,
    hardline: RefDoc<'d>,
}

impl<'d> Layout<'d> {
    /// Statements, each after a line break. `declared` contains the locals that an outer list declares.
    fn list(&self, list: &'d [Statement], declared: &mut [bool]) -> Doc<'d> {
        let Printer { program, language, names, .. } = self.printer;
        let mut doc = self.arena.nil();
        let Some([with_value, without]) = language.locals else {
            return list.iter().fold(doc, |doc, it| doc.append(self.hardline).append(self.statement(it, declared)));
        };
        let declared_as = |form: Declaration, local: usize| {
            let ty = program.locals[local].ty.expect("print: the typing pass has typed every local");
            self.arena.text(form(&names.locals[local], language.ty(ty, program.real)))
        };
        for (statement, locals) in list.iter().zip(scope::declarations(list, declared)) {
            doc = doc.append(self.hardline);
            if let Statement::Assign { target: Var::Local(local), value } = statement
                && locals.contains(local)
            {
                doc = doc.append(self.assignment(declared_as(with_value, *local), value));
                continue;
            }
            for local in locals {
                doc = doc.append(declared_as(without, local)).append(self.hardline);
            }
            doc = doc.append(self.statement(statement, declared));
        }
        doc
    }

    fn statement(&self, statement: &'d Statement, declared: &mut [bool]) -> Doc<'d> {
        match statement {
            Statement::Note(note) => {
                let [open, next, close] = self.printer.language.comment;
                let lines = comment::wrapped(&[note], NOTE_WIDTH, "\n");
                let between = self.arena.hardline().append(next);
                let lines = self.arena.intersperse(lines.split('\n').map(str::to_owned), between);
                self.arena.text(open).append(lines).append(close)
            }
            Statement::Assign { target, value } => {
                self.assignment(self.arena.text(&self.printer.texts[*target]), value)
            }
            Statement::Apart(_) => self.arena.text(self.printer.language.call.replace("{block}", self.printer.block)),
            Statement::Choose { by, arms } => self.choice(by, arms, declared),
            Statement::If { condition, then, otherwise } => {
                let [first, next, after, last, end] = self.printer.language.choice;
                let mut inner = |list| self.list(list, declared).nest(INDENTATION);
                let asked = |text: &'static str, condition| {
                    let condition = self.expr(condition).doc.group().nest(2 * INDENTATION);
                    self.arena.text(text).append(condition).append(after)
                };
                let mut doc = asked(first, condition).append(inner(then));
                let (mut rest, mut is_chain) = (otherwise, false);
                // A single `if` in the other branch continues the chain.
                while let [Statement::If { condition, then, otherwise }] = rest.as_slice() {
                    doc = doc.append(self.hardline).append(asked(next, condition)).append(inner(then));
                    (rest, is_chain) = (otherwise, true);
                }
                let nothing = self.printer.language.nothing_else.filter(|_| is_chain);
                if !rest.is_empty() {
                    doc = doc.append(self.hardline).append(last).append(inner(rest));
                } else if let Some(nothing) = nothing {
                    let comment = DocBuilder(self.arena, self.hardline.into()).append(nothing).nest(INDENTATION);
                    doc = doc.append(self.hardline).append(last).append(comment);
                }
                doc.append(self.hardline).append(end)
            }
        }
    }

    /// An assignment; if it is too long, it is broken after its target first.
    fn assignment(&self, target: Doc<'d>, value: &'d Expr) -> Doc<'d> {
        let value = self.expr(value).doc.nest(INDENTATION).append(";");
        let value = self.line_before(value).nest(INDENTATION);
        target.append(self.printer.language.assign).append(value)
    }

    /// A blank if the rest fits into the line, else a line break.
    fn line_before(&self, doc: Doc<'d>) -> Doc<'d> {
        DocBuilder(self.arena, self.line.into()).append(doc).group()
    }
}
