//! What the files of every language list of a block: its signals with their meaning, and its numbers in groups that belong
//! together. How a type, a number or a comment looks is the language's business.

use super::Legal;
use compiler::print::{Appearance, Language, Printer, comment};
use compiler::program::{Expr, Local, Origin, Program, Type, Var, Variable};
use std::fmt::Write;

/// Characters in a line of a comment, without the marks around it.
pub(super) const COMMENT_WIDTH: usize = 110;

/// A variable with its first value, or a named number.
pub(super) struct Member {
    pub(super) ty: &'static str,
    pub(super) name: String,
    pub(super) doc: String,
    pub(super) value: String,
}

/// Constants that belong together.
pub(super) struct Group {
    /// what they belong to; empty: said already
    pub(super) note: String,
    pub(super) constants: Vec<Member>,
}

/// What is listed of a block, in a language.
pub(super) struct Outline<'l> {
    pub(super) block: &'l Legal<'l>,
    pub(super) language: &'static Language,
    pub(super) printer: &'l Printer<'l>,
    /// between two lines of a comment at the left
    pub(super) next_line: &'static str,
}

impl Outline<'_> {
    /// The inputs; those that this axis does not need say so.
    pub(super) fn inputs(&self) -> Vec<Member> {
        let program = &*self.block.program;
        let mut members = self.members(&program.inputs, &self.printer.names().inputs);
        for (member, _) in members.iter_mut().zip(is_read(program)).filter(|(_, is_read)| !is_read) {
            member.doc.push_str("; not read for this axis");
        }
        members
    }

    /// The outputs; those that this axis does not have say so.
    pub(super) fn outputs(&self) -> Vec<Member> {
        let program = &*self.block.program;
        let mut members = self.members(&program.outputs, &self.printer.names().outputs);
        for (member, _) in members.iter_mut().zip(is_constant(program)).filter(|(_, is_constant)| *is_constant) {
            let _ = write!(member.doc, "; always {} for this axis", member.value);
        }
        members
    }

    pub(super) fn state(&self) -> Vec<Member> {
        self.members(&self.block.program.state, &self.printer.names().state)
    }

    /// The intermediate values; what they mean is said where they are computed.
    pub(super) fn locals(&self) -> Vec<Member> {
        let (program, names) = (&*self.block.program, &self.printer.names().locals);
        let member = |(local, name): (&Local, &String)| Member {
            ty: self.ty(local.ty.expect("outline: the typing pass has typed every local")),
            name: name.clone(),
            doc: String::new(),
            value: String::new(),
        };
        program.locals.iter().zip(names).map(member).collect()
    }

    fn members(&self, variables: &[Variable], names: &[String]) -> Vec<Member> {
        let member = |(variable, name): (&Variable, &String)| Member {
            ty: self.ty(variable.ty),
            name: name.clone(),
            doc: comment::harmless(variable.doc).into_owned(),
            value: (self.language.literal)(variable.start),
        };
        variables.iter().zip(names).map(member).collect()
    }

    fn ty(&self, ty: Type) -> &'static str {
        self.language.ty(ty, self.block.program.real)
    }

    /// The constants that appear in this way, in their order, a new group where another note of the block begins.
    pub(super) fn groups(&self, wanted: Appearance) -> Vec<Group> {
        let mut groups: Vec<Group> = Vec::new();
        let mut said = Vec::new();
        let (constants, names) = (&self.block.program.constants, &self.printer.names().constants);
        for ((constant, name), appearance) in constants.iter().zip(names).zip(self.printer.appearances()) {
            let notes: Vec<&str> = match constant.origin {
                Origin::Coefficient(_) => {
                    let notes = &self.block.block.notes;
                    notes_of(&constant.path).filter_map(|path| notes.get(path)).map(String::as_str).collect()
                }
                Origin::Function => vec!["the same for every axis"],
            };
            let fresh: Vec<&str> = notes.iter().copied().filter(|note| !said.contains(note)).collect();
            if groups.is_empty() || !fresh.is_empty() {
                let note = comment::wrapped(&fresh, COMMENT_WIDTH, self.next_line);
                groups.push(Group { note, constants: Vec::new() });
            }
            if let (Some(group), true) = (groups.last_mut(), *appearance == wanted) {
                group.constants.push(Member {
                    ty: self
                        .ty(Type::of_literal(constant.value)
                            .expect("outline: the passes leave what exists at run time")),
                    name: name.clone(),
                    value: match wanted {
                        Appearance::Assigned => (self.language.operand)(constant.value).0,
                        Appearance::Inline | Appearance::Declared => (self.language.literal)(constant.value),
                    },
                    doc: comment::harmless(constant.doc).into_owned(),
                });
            }
            said.extend(fresh);
        }
        groups.retain(|group| !group.constants.is_empty());
        groups
    }
}

/// Which inputs a cycle reads.
pub fn is_read(program: &Program) -> Vec<bool> {
    let mut read = vec![false; program.inputs.len()];
    for statement in &program.step {
        statement.reads(&mut |var| {
            if let Var::Input(index) = var {
                read[index] = true;
            }
        });
    }
    read
}

/// Which outputs are never anything but what they are at the start.
fn is_constant(program: &Program) -> Vec<bool> {
    let mut constant = vec![true; program.outputs.len()];
    for statement in &program.step {
        statement.assignments(&mut |target, value| {
            if let Var::Output(index) = target {
                constant[index] &= *value == Expr::Literal(program.outputs[index].start);
            }
        });
    }
    constant
}

/// A path and those that contain it, outermost first.
fn notes_of(path: &str) -> impl Iterator<Item = &str> {
    let ends = path.char_indices().filter(|(_, character)| *character == '.').map(|(end, _)| end);
    ends.chain([path.len()]).map(|end| &path[..end])
}
