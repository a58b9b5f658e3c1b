//! The common lists of a block's files in every language: its signals with their meanings, and its numbers in groups. The
//! notation of types, numbers and comments depends on the language.

use super::{BlockIdentity, TargetBlock, unit};
use compiler::legalise::{NOTICE, NOTICES, ONLY_NOTICES, RENAMED};
use compiler::print::{Appearance, Language, Printer, comment, identifier};
use compiler::program::{Constant, Local, Origin, Program, Row, Type, Variable};
use portable::Literal;
use std::borrow::Cow;

/// Characters in a line of a comment, without the marks around it.
pub(super) const COMMENT_WIDTH: usize = 110;
/// A declaration that is longer has its comment above it.
const LONGEST: usize = 140;
/// Characters of a declaration in addition to its parts, at most: blanks, comment marks, a word before the value.
const BETWEEN: usize = 34;

/// A variable with its first value, or a named number.
#[derive(Clone, Debug)]
pub(super) struct Member {
    pub(super) ty: Cow<'static, str>,
    pub(super) name: String,
    pub(super) doc: String,
    pub(super) value: String,
}

impl Member {
    /// The wrapped comment if it does not fit after the declaration; otherwise `None`.
    pub(super) fn above(&self, next_line: &str) -> Option<String> {
        let length = self.ty.len() + self.name.len() + self.value.len() + self.doc.len() + BETWEEN;
        (length > LONGEST).then(|| self.lines(next_line))
    }

    /// The comment in lines.
    pub(super) fn lines(&self, next_line: &str) -> String {
        comment::wrapped(&[&self.doc], COMMENT_WIDTH, next_line)
    }
}

/// A group of constants.
#[derive(Clone, Debug)]
pub(super) struct Group {
    /// its common meaning; empty if already explained
    pub(super) note: String,
    pub(super) constants: Vec<Member>,
}

/// The lists of a block in a language.
pub(super) struct Outline<'l> {
    pub(super) axis: &'l BlockIdentity,
    pub(super) block: &'l TargetBlock<'l>,
    pub(super) language: &'static Language,
    pub(super) printer: &'l Printer<'l>,
    /// the text between two lines of a comment
    pub(super) next_line: &'static str,
}

impl Outline<'_> {
    /// The inputs without the parameter set, which is the last one.
    pub(super) fn inputs(&self) -> Vec<Member> {
        self.inputs_where(&|input| self.block.program.in_set(input).is_none())
    }

    /// The parts of the parameter set; empty if the block takes no sets.
    pub(super) fn set(&self) -> Vec<Member> {
        self.inputs_where(&|input| self.block.program.in_set(input).is_some())
    }

    fn inputs_where(&self, is_wanted: &dyn Fn(&Variable) -> bool) -> Vec<Member> {
        let inputs = self.block.program.inputs.iter().zip(&self.printer.names().inputs);
        inputs.filter(|(input, _)| is_wanted(input)).map(|(input, name)| self.member(input, name)).collect()
    }

    /// The outputs; the comment of the error id lists the ids that can occur. A parameter set is one output of the type `made`, with
    /// its start value, and comes last.
    pub(super) fn outputs(&self, made: [String; 2]) -> Vec<Member> {
        let program = &*self.block.program;
        let mut members = self.members(&program.outputs, &self.printer.names().outputs);
        for (member, output) in members.iter_mut().zip(&program.outputs) {
            let ids = match output.path.as_str() {
                "error_id" => error_ids(program, &|_| true),
                path if path == RENAMED[1].1 => error_ids(program, &|name| !ONLY_NOTICES.contains(&name)),
                NOTICE => error_ids(program, &|name| NOTICES.contains(&name)),
                _ => continue,
            };
            member.doc.push_str(&ids);
        }
        let is_part = |output: &Variable| program.in_made(output).is_some();
        let mut outputs = program.outputs.iter();
        members.retain(|_| !outputs.next().is_some_and(is_part));
        members.extend(program.made.filter(|_| program.outputs.iter().any(is_part)).map(|name| {
            let [ty, value] = made;
            let doc = "the parameter set; all of it is 0 unless designed is TRUE".to_owned();
            Member { ty: ty.into(), name: name.to_owned(), doc, value }
        }));
        members
    }

    /// The parts of the state, each element of an array on its own.
    pub(super) fn parts_of_state(&self) -> Vec<Member> {
        self.members(&self.block.program.state, &self.printer.names().state)
    }

    /// The declarations of these parts of the state. `array` makes that of an array of this length from its first element.
    pub(super) fn state(&self, parts: Vec<Member>, array: impl Fn(Member, usize) -> Member) -> Vec<Member> {
        let program = &*self.block.program;
        let declared = |(index, member): (usize, Member)| match program.row_of(index) {
            None => Some(member),
            Some(row) if row.first == index => {
                let name = self.printer.array(row).to_owned();
                let doc = self.contents(row);
                Some(array(Member { name, doc, ..member }, row.length))
            }
            Some(_) => None,
        };
        parts.into_iter().enumerate().filter_map(declared).collect()
    }

    /// The names of the elements of an array, in their order, unless an array before it has the same.
    fn contents(&self, row: Row) -> String {
        let program = &*self.block.program;
        let names = |row: Row| -> Vec<String> {
            let common = program.path_of_row(row).map_or(0, str::len);
            let name = |part| identifier(program.path(part)[common..].trim_start_matches('.'));
            row.elements().map(name).collect()
        };
        let mut before = program.rows.iter().filter(|other| other.first < row.first);
        match before.find(|other| names(**other) == names(row)) {
            None => names(row).join(", "),
            Some(same) => format!("the same elements as {}", self.printer.array(*same)),
        }
    }

    /// The intermediate values; their meaning is explained where they are computed.
    pub(super) fn locals(&self) -> Vec<Member> {
        let (program, names) = (&*self.block.program, &self.printer.names().locals);
        let member = |(local, name): (&Local, &String)| Member {
            ty: self.ty(local.ty.expect("outline: the typing pass has typed every local")).into(),
            name: name.clone(),
            doc: String::new(),
            value: String::new(),
        };
        program.locals.iter().zip(names).map(member).collect()
    }

    fn members(&self, variables: &[Variable], names: &[String]) -> Vec<Member> {
        variables.iter().zip(names).map(|(variable, name)| self.member(variable, name)).collect()
    }

    fn member(&self, variable: &Variable, name: &str) -> Member {
        Member {
            ty: self.ty(variable.ty).into(),
            name: name.to_owned(),
            doc: self.doc(variable.doc),
            value: (self.language.literal)(variable.start),
        }
    }

    /// A doc comment of the reference, with the unit of the axis.
    pub(super) fn doc(&self, doc: &str) -> String {
        comment::harmless(&unit::of_axis(doc, self.axis.is_rotary)).into_owned()
    }

    fn ty(&self, ty: Type) -> &'static str {
        self.language.ty(ty, self.block.program.real)
    }

    /// The constants with each of these appearances.
    pub(super) fn groups<const N: usize>(&self, wanted: [Appearance; N]) -> [Vec<Group>; N] {
        let list = |_, appearance| wanted.iter().position(|wanted| *wanted == appearance);
        self.groups_in(list, [self.next_line; N])
    }

    /// The constants in lists, in their order; a new group begins with another note of the block. `list` returns the list of
    /// a constant, `next_lines` is the text between two lines of a comment in each list.
    pub(super) fn groups_in<const N: usize>(
        &self,
        list: impl Fn(usize, Appearance) -> Option<usize>,
        next_lines: [&str; N],
    ) -> [Vec<Group>; N] {
        let mut lists = [const { Vec::new() }; N];
        // The number of groups that have begun, and the group of each list.
        let (mut begun, mut at) = (0, [0; N]);
        let (mut said, mut notes): (Vec<&str>, Vec<&str>) = (Vec::new(), Vec::new());
        let (constants, names) = (&self.block.program.constants, &self.printer.names().constants);
        for (index, (constant, appearance)) in constants.iter().zip(self.printer.appearances()).enumerate() {
            // A value that the runtime provides is written in the statements under its own name.
            let Some(mut fresh) = self.notes(constant) else { continue };
            fresh.retain(|note| !said.contains(note));
            if begun == 0 || !fresh.is_empty() {
                begun += 1;
                said.extend(&fresh);
                notes = fresh;
            }
            let Some(list) = list(index, *appearance) else { continue };
            if std::mem::replace(&mut at[list], begun) != begun {
                let note = comment::wrapped(&notes, COMMENT_WIDTH, next_lines[list]);
                lists[list].push(Group { note, constants: Vec::new() });
            }
            if let Some(Group { constants, .. }) = lists[list].last_mut() {
                constants.push(self.number(constant, &names[index], *appearance));
            }
        }
        lists
    }

    /// The meanings of a constant and its neighbours; `None` if it does not belong to the block.
    fn notes(&self, constant: &Constant) -> Option<Vec<&str>> {
        let notes = &self.block.block.notes;
        match constant.origin {
            Origin::Coefficient(_) => {
                Some(notes_of(&constant.path).filter_map(|path| notes.get(path)).map(String::as_str).collect())
            }
            Origin::Function => Some(vec!["constants that do not depend on the axis"]),
            Origin::Runtime(_) => None,
            Origin::Variant(variant) => Some(vec![variant.of.doc]),
        }
    }

    fn number(&self, constant: &Constant, name: &str, appearance: Appearance) -> Member {
        let value = match appearance {
            Appearance::Assigned => (self.language.operand)(constant.value).0,
            Appearance::Inline | Appearance::Declared | Appearance::Shared | Appearance::Enumerator => {
                (self.language.literal)(constant.value)
            }
        };
        Member { ty: self.ty_of(constant).into(), name: name.to_owned(), doc: self.doc(constant.doc), value }
    }

    pub(super) fn ty_of(&self, constant: &Constant) -> &'static str {
        self.ty(Type::of_literal(constant.value).expect("outline: the passes leave what exists at run time"))
    }
}

/// The ids that a program can report, filtered, each with the thing that it is named after.
fn error_ids(program: &Program, is_wanted: &dyn Fn(&str) -> bool) -> String {
    let id = |value| if let Literal::U32(id) = value { Some(id) } else { None };
    let named = program.constants.iter().filter_map(|constant| {
        let name = constant.path.rsplit('.').next().filter(|name| is_wanted(name))?.strip_prefix("error_")?;
        Some((id(constant.value)?, name))
    });
    let mut ids: Vec<(u32, &str)> = named.filter(|(id, _)| *id > 0).collect();
    ids.sort_unstable();
    ids.iter().map(|(id, name)| format!(", {id} {name}")).collect()
}

/// A path and those that contain it, outermost first.
fn notes_of(path: &str) -> impl Iterator<Item = &str> {
    let ends = path.char_indices().filter(|(_, character)| *character == '.').map(|(end, _)| end);
    ends.chain([path.len()]).map(|end| &path[..end])
}
