//! Declarations -> the variables of a block.

use super::constant;
use super::kind::Kind;
use super::known::{Address, Known};
use super::mistake::Mistakes;
use super::structure::Part;
use super::syntax::{children, said, shown};
use super::variables::{Array, Role, Variable, Variables, Whole};
use super::{Dialect, names};
use tree_sitter::Node;

/// The declarations of a block while they are being read.
pub(crate) struct Declarations<'a, 't> {
    pub(crate) text: &'a str,
    /// the form of the file
    pub(crate) dialect: Dialect,
    /// declarations of other files
    pub(crate) known: Known<'a>,
    /// the prefix of each name: the name of a list of global variables, and a dot
    pub(crate) prefix: &'a str,
    /// process data of this file
    pub(crate) addresses: &'a [Address],
    /// the variables so far
    pub(crate) all: &'a mut Variables,
    /// the errors
    pub(crate) mistakes: &'a mut Mistakes<'t>,
}

impl Declarations<'_, '_> {
    /// Declares the variables of a `VAR` block.
    pub(crate) fn declare(&mut self, node: Node<'_>) {
        let parts = children(node);
        let Some(role) = self.role(node) else { return };
        let declarations = parts.iter().filter(|(part, _)| part.kind() == "variable_declaration");
        if declarations.clone().count() == 0 && !node.has_error() {
            self.say(node, "a `VAR` block that declares nothing", "no such block");
        }
        for (declaration, _) in declarations {
            if !declaration.has_error() {
                self.declaration(*declaration, role);
            }
        }
    }

    fn say(&mut self, node: Node<'_>, found: impl Into<String>, instead: impl Into<String>) {
        self.mistakes.push(node.start_byte(), found, instead);
    }

    fn role(&mut self, node: Node<'_>) -> Option<Role> {
        let qualifiers = children(node).into_iter().find(|(part, _)| part.kind() == "var_qualifier_list");
        let qualifier = qualifiers.map(|(list, _)| (list, said(list, self.text).to_ascii_uppercase()));
        let role = match node.kind() {
            "var_input" => Role::Input,
            "var_output" => Role::Output,
            "var_block" if qualifier.as_ref().is_some_and(|(_, words)| words == "CONSTANT") => {
                if self.dialect != Dialect::Plain {
                    return Some(Role::Constant);
                }
                self.say(node, "`VAR CONSTANT`", "the number where it is used");
                return None;
            }
            "var_block" => Role::Local,
            "var_global" if self.known.is_program => {
                let is_constant = qualifier.as_ref().is_some_and(|(_, words)| words == "CONSTANT");
                return Some(if is_constant { Role::Constant } else { Role::Local });
            }
            "var_in_out" if self.known.is_program => Role::Shared,
            "var_temp" if self.dialect == Dialect::Scl => Role::Temporary,
            other => {
                let name = other.to_ascii_uppercase();
                self.say(node, format!("`{name}`"), "`VAR_INPUT`, `VAR_OUTPUT` or `VAR`");
                return None;
            }
        };
        if let Some((list, words)) = qualifier {
            self.say(list, format!("`{words}`"), "the block without it");
        }
        Some(role)
    }

    fn declaration(&mut self, node: Node<'_>, role: Role) {
        let Some(ty) = node.child_by_field_name("type") else { return };
        let address = self.addresses.iter().find(|address| node.byte_range().contains(&address.at));
        let role = address.map_or(role, |address| address.role);
        // The name of a user-defined type is an identifier too.
        let is_name = |part: &Node<'_>| part.kind() == "identifier" && *part != ty;
        let names: Vec<Node<'_>> = children(node).into_iter().map(|(part, _)| part).filter(is_name).collect();
        if let [_, second, ..] = names[..] {
            self.say(second, "a second name in a declaration", "one declaration for each name");
        }
        if let Some(address) = node.child_by_field_name("address") {
            self.say(address, "`AT`", "a variable without an address");
        }
        for name in &names {
            self.name(*name);
        }
        // A compiler of the plain form has none in an instance.
        if ty.kind() == "array_type" && self.dialect != Dialect::Plain {
            self.array(node, ty, &names, role);
            return;
        }
        let word = said(ty, self.text);
        let structure = self.known.structures.iter().position(|of| of.name.eq_ignore_ascii_case(word));
        if let Some(of) = structure {
            self.whole(node, of, &names, role);
            return;
        }
        if role == Role::Shared {
            self.say(ty, format!("`VAR_IN_OUT` of {}", shown(ty, self.text)), "a structure, or an input and an output");
        }
        let other = self.known.blocks.iter().position(|block| block.name.eq_ignore_ascii_case(word));
        match other.filter(|_| Kind::of(word, self.all.real).is_none()) {
            Some(of) => self.instance(node, ty, of, &names, role),
            None => self.variable(node, ty, &names, role),
        }
    }

    fn instance(&mut self, node: Node<'_>, ty: Node<'_>, of: usize, names: &[Node<'_>], role: Role) {
        let (block, real) = (&self.known.blocks[of], self.all.real);
        if role != Role::Local || !self.prefix.is_empty() {
            self.say(ty, "an instance that is not a variable of `VAR`", "the instance in `VAR`");
        }
        if block.variables.real != real {
            let [own, other] = [real, block.variables.real].map(|real| Kind::Real.name(real));
            self.say(ty, format!("`{}`, a block of {other}", block.name), format!("a block of {own}"));
        }
        if let Some(start) = node.child_by_field_name("initial_value") {
            self.say(start, "an initial value of an instance", "arguments of its call");
        }
        for &name in names {
            if self.is_new(name) {
                self.all.add_inner(said(name, self.text), of, &block.variables.slots);
            }
        }
    }

    fn variable(&mut self, node: Node<'_>, ty: Node<'_>, names: &[Node<'_>], role: Role) {
        let (dialect, real) = (self.dialect, self.all.real);
        let of = if self.known.is_program { Kind::of_program } else { Kind::of };
        let kind = of(said(ty, self.text), real);
        if kind.is_none() {
            let name = Kind::Real.name(real);
            self.say(ty, format!("the type {}", shown(ty, self.text)), format!("`{name}`, `BOOL`, `DINT` or `UDINT`"));
        }
        let start = node.child_by_field_name("initial_value");
        match (start, role, dialect) {
            (Some(start), Role::Output | Role::Local, Dialect::Plain) => {
                let found = "an initial value, which some compiler drops";
                self.say(start, found, "an assignment in the first cycle");
            }
            (Some(start), Role::Temporary, _) => {
                self.say(start, "an initial value of a temporary", "an assignment in each cycle");
            }
            (None, Role::Constant, _) => {
                self.say(node, "a constant without a value", "`:=` and its value");
            }
            _ => {}
        }
        let value = start.zip(kind);
        let value = value
            .and_then(|(start, kind)| constant::initial((dialect, real), start, self.text, kind, self.mistakes))
            .filter(|_| dialect != Dialect::Plain);
        let known = kind.is_some();
        let kind = kind.unwrap_or(Kind::Real);
        for &name in names {
            if self.is_new(name) {
                let slot = self.all.slot(kind, value);
                if role == Role::Constant && kind == Kind::Real {
                    self.all.numbers.push(slot);
                }
                self.all.single.add(&self.path(name), Variable { kind, role, slot, known });
            }
        }
    }

    /// An array from 0 on: each of its elements is a variable, `x[0]`.
    fn array(&mut self, node: Node<'_>, ty: Node<'_>, names: &[Node<'_>], role: Role) {
        let bound = |name: &str| {
            let range = ty.child_by_field_name("range")?.child_by_field_name(name)?;
            said(range, self.text).parse::<u32>().ok()
        };
        let of = ty.child_by_field_name("element_type").and_then(|of| Kind::of(said(of, self.text), self.all.real));
        let ranges = children(ty).into_iter().filter(|(part, _)| part.kind() == "subrange").count();
        let is_kept = role == Role::Local && node.child_by_field_name("initial_value").is_none();
        let (Some(0), Some(last @ 1..=65_535), Some(kind), 1, true) =
            (bound("lower"), bound("upper"), of, ranges, is_kept)
        else {
            let instead = "`ARRAY[0..n] OF` a type of variables, in `VAR` and without an initial value";
            self.say(ty, shown(ty, self.text), instead);
            for &name in names {
                if self.is_new(name) {
                    let slot = self.all.slot(Kind::Real, None);
                    self.all.single.add(&self.path(name), Variable { kind: Kind::Real, role, slot, known: false });
                }
            }
            return;
        };
        for &name in names {
            if self.is_new(name) {
                let path = self.path(name);
                let elements: Vec<Variable> =
                    (0..=last).map(|_| Variable { kind, role, slot: self.all.slot(kind, None), known: true }).collect();
                for (index, element) in elements.iter().enumerate() {
                    self.all.single.add(&format!("{path}[{index}]"), *element);
                }
                self.all.arrays.add(&path, Array { first: elements[0], length: last + 1 });
            }
        }
    }

    /// A structure: each of its parts is a variable with its path.
    fn whole(&mut self, node: Node<'_>, of: usize, names: &[Node<'_>], role: Role) {
        if matches!(role, Role::Constant | Role::Temporary) {
            self.say(node, "a structure that is not a variable", "the structure in `VAR` or `VAR_IN_OUT`");
        }
        if let Some(start) = node.child_by_field_name("initial_value") {
            self.say(start, "an initial value of a structure", "assignments to its parts");
        }
        for &name in names {
            if self.is_new(name) {
                let path = self.path(name);
                for &Part { path: ref part, kind, start } in &self.known.structures[of].parts {
                    let slot = self.all.slot(kind, start);
                    self.all.single.add(&format!("{path}.{part}"), Variable { kind, role, slot, known: true });
                }
                self.all.whole.add(&path, Whole { of, role });
            }
        }
    }

    /// The name of a variable in the text.
    fn path(&self, name: Node<'_>) -> String {
        format!("{}{}", self.prefix, said(name, self.text))
    }

    /// Reports errors in a name by itself.
    fn name(&mut self, node: Node<'_>) {
        let name = said(node, self.text);
        let allowed = self.known.is_program && names::of_library(name);
        if let Some((found, instead)) = names::mistake(self.dialect, name).filter(|_| !allowed) {
            self.say(node, found, instead);
        }
    }

    /// Whether a name is not declared yet; reports it if it is declared.
    fn is_new(&mut self, node: Node<'_>) -> bool {
        let (name, path) = (said(node, self.text), self.path(node));
        let all = &self.all;
        let is_group =
            all.inner.get(&path).is_some() || all.whole.get(&path).is_some() || all.arrays.get(&path).is_some();
        let declared = is_group || all.single.get(&path).is_some();
        if declared {
            self.say(node, format!("`{name}`, which is declared already"), "another name");
        }
        !declared
    }
}
