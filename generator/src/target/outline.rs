//! What the files of every language list of a block: its signals with their meaning, and its numbers in groups that belong
//! together. How a type, a number or a comment looks is the language's business.

use super::comment;
use crate::blocks::Block;
use crate::render::{ConstantText, Group, Member};
use compiler::program::{Expr, Origin, Program, Type, Var, Variable};
use portable::Literal;
use std::fmt::Write;

/// Characters in a line of a comment, without the marks around it.
pub const COMMENT_WIDTH: usize = 110;

/// How a language writes what is listed.
pub struct Language<'l> {
    /// the name of a type
    pub ty: &'l dyn Fn(Type) -> &'static str,
    /// the text of a value
    pub literal: &'l dyn Fn(Literal) -> String,
    /// between two lines of a comment
    pub next_line: &'static str,
}

impl Language<'_> {
    /// The inputs of a program; those that this axis does not need say so.
    #[must_use]
    pub fn inputs(&self, program: &Program, names: &[String]) -> Vec<Member> {
        let mut members = self.members(&program.inputs, names);
        for (member, _) in members.iter_mut().zip(is_read(program)).filter(|(_, is_read)| !is_read) {
            member.doc.push_str("; not read for this axis");
        }
        members
    }

    /// The outputs of a program; those that this axis does not have say so.
    #[must_use]
    pub fn outputs(&self, program: &Program, names: &[String]) -> Vec<Member> {
        let mut members = self.members(&program.outputs, names);
        for (member, _) in members.iter_mut().zip(is_constant(program)).filter(|(_, is_constant)| *is_constant) {
            let _ = write!(member.doc, "; always {} for this axis", member.start);
        }
        members
    }

    /// Inputs, outputs or state.
    #[must_use]
    pub fn members(&self, variables: &[Variable], names: &[String]) -> Vec<Member> {
        let member = |(variable, name): (&Variable, &String)| Member {
            ty: (self.ty)(variable.ty),
            name: name.clone(),
            doc: comment::harmless(variable.doc).into_owned(),
            start: (self.literal)(variable.start),
        };
        variables.iter().zip(names).map(member).collect()
    }

    /// The constants of a program in their order, a new group where another note of the block begins.
    #[must_use]
    pub fn groups(&self, block: &Block, program: &Program, names: &[String]) -> Vec<Group> {
        let mut groups: Vec<Group> = Vec::new();
        let mut said = Vec::new();
        for (constant, name) in program.constants.iter().zip(names) {
            let notes: Vec<&str> = match constant.origin {
                Origin::Coefficient(_) => {
                    notes_of(&constant.path).filter_map(|path| block.notes.get(path)).map(String::as_str).collect()
                }
                Origin::Function => vec!["the same for every axis"],
            };
            let fresh: Vec<&str> = notes.iter().copied().filter(|note| !said.contains(note)).collect();
            let text = ConstantText {
                ty: (self.ty)(Type::of(constant.value).expect("outline: the passes leave what exists at run time")),
                name: name.clone(),
                value: (self.literal)(constant.value),
                doc: comment::harmless(constant.doc).into_owned(),
            };
            match groups.last_mut() {
                Some(last) if fresh.is_empty() => last.constants.push(text),
                _ => groups.push(Group { note: self.note(&fresh), constants: vec![text] }),
            }
            said.extend(notes);
        }
        groups
    }

    /// Notes as the inside of one comment.
    fn note(&self, notes: &[&str]) -> String {
        comment::wrapped(notes, COMMENT_WIDTH, self.next_line)
    }
}

/// Which inputs a cycle reads.
#[must_use]
pub fn is_read(program: &Program) -> Vec<bool> {
    let mut read = vec![false; program.inputs.len()];
    for statement in &program.step {
        statement.expressions(&mut |expr| {
            expr.variables(&mut |var| {
                if let Var::Input(index) = var {
                    read[index] = true;
                }
            });
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
