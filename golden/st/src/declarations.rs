//! The variables of a block: declarations -> slots.

use super::constant;
use super::kind::{Kind, Value};
use super::machine::Slots;
use super::mistake::Mistakes;
use super::syntax::{children, said, shown};
use super::{Dialect, names};
use portable::RealKind;
use std::collections::HashMap;
use tree_sitter::Node;

/// Who writes a variable.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Role {
    /// the caller
    Input,
    /// the block, for the caller
    Output,
    /// the block
    Local,
    /// the block; the value does not outlive the cycle
    Temporary,
    /// nobody
    Constant,
}

/// A variable.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Variable {
    /// its type
    pub(crate) kind: Kind,
    /// who writes it
    pub(crate) role: Role,
    /// its slot, among those of its type
    pub(crate) slot: u32,
    /// whether its type is one of ours; if not, its uses are no further mistakes by themselves
    pub(crate) known: bool,
}

/// The variables of a block.
#[derive(Clone, Debug)]
pub(crate) struct Variables {
    /// what a real is
    pub(crate) real: RealKind,
    /// by their names in lower case
    by_name: HashMap<String, Variable>,
    /// what the slots hold at the start
    pub(crate) slots: Slots<f64>,
}

impl Variables {
    /// None yet.
    pub(crate) fn new(real: RealKind) -> Self {
        Self { real, by_name: HashMap::new(), slots: Slots::default() }
    }

    /// A variable by its name.
    pub(crate) fn find(&self, name: &str) -> Option<Variable> {
        self.by_name.get(&name.to_ascii_lowercase()).copied()
    }

    /// Another slot.
    pub(crate) fn slot(&mut self, kind: Kind, value: Option<Value>) -> u32 {
        let slots = &mut self.slots;
        let slot = match kind {
            Kind::Real => {
                slots.reals.push(if let Some(Value::Real(value)) = value { value } else { 0.0 });
                slots.reals.len() - 1
            }
            Kind::Bool => {
                slots.bools.push(matches!(value, Some(Value::Bool(true))));
                slots.bools.len() - 1
            }
            Kind::Dint | Kind::Udint => {
                slots.words.push(if let Some(Value::Word(value)) = value { value } else { 0 });
                slots.words.len() - 1
            }
        };
        u32::try_from(slot).expect("engine: a text is shorter than 2^32 bytes")
    }
}

/// Declares what a `VAR` block holds.
pub(crate) fn declare(node: Node<'_>, text: &str, dialect: Dialect, all: &mut Variables, mistakes: &mut Mistakes<'_>) {
    let parts = children(node);
    let Some(role) = role(node, text, dialect, mistakes) else { return };
    let declarations = parts.iter().filter(|(part, _)| part.kind() == "variable_declaration");
    if declarations.clone().count() == 0 && !node.has_error() {
        mistakes.push(node.start_byte(), "a `VAR` block that declares nothing", "no such block");
    }
    for (declaration, _) in declarations {
        variable(*declaration, text, (dialect, role), all, mistakes);
    }
}

fn role(node: Node<'_>, text: &str, dialect: Dialect, mistakes: &mut Mistakes<'_>) -> Option<Role> {
    let at = node.start_byte();
    let qualifiers = children(node).into_iter().find(|(part, _)| part.kind() == "var_qualifier_list");
    let qualifier = qualifiers.map(|(list, _)| (list, said(list, text).to_ascii_uppercase()));
    let role = match node.kind() {
        "var_input" => Role::Input,
        "var_output" => Role::Output,
        "var_block" if qualifier.as_ref().is_some_and(|(_, words)| words == "CONSTANT") => {
            if dialect != Dialect::Plain {
                return Some(Role::Constant);
            }
            mistakes.push(at, "`VAR CONSTANT`", "the number where it is used");
            return None;
        }
        "var_block" => Role::Local,
        "var_temp" if dialect == Dialect::Scl => Role::Temporary,
        other => {
            let name = other.to_ascii_uppercase();
            mistakes.push(at, format!("`{name}`"), "`VAR_INPUT`, `VAR_OUTPUT` or `VAR`");
            return None;
        }
    };
    if let Some((list, words)) = qualifier {
        mistakes.push(list.start_byte(), format!("`{words}`"), "the block without it");
    }
    Some(role)
}

fn variable(
    node: Node<'_>,
    text: &str,
    (dialect, role): (Dialect, Role),
    all: &mut Variables,
    mistakes: &mut Mistakes<'_>,
) {
    if node.has_error() {
        return;
    }
    let parts = children(node);
    let names: Vec<_> = parts.iter().filter(|(part, _)| part.kind() == "identifier").map(|(part, _)| *part).collect();
    // A type of one's own is an identifier too, in the field `type`.
    let names: Vec<_> =
        names.into_iter().filter(|name| node.child_by_field_name("type").is_none_or(|ty| ty != *name)).collect();
    if let [_, second, ..] = names[..] {
        mistakes.push(second.start_byte(), "a second name in a declaration", "one declaration for each name");
    }
    if let Some(address) = node.child_by_field_name("address") {
        mistakes.push(address.start_byte(), "`AT`", "a variable without an address");
    }
    let Some(ty) = node.child_by_field_name("type") else { return };
    let kind = Kind::of(said(ty, text), all.real);
    if kind.is_none() {
        let real = Kind::Real.name(all.real);
        mistakes.push(
            ty.start_byte(),
            format!("the type {}", shown(ty, text)),
            format!("`{real}`, `BOOL`, `DINT` or `UDINT`"),
        );
    }
    let start = node.child_by_field_name("initial_value");
    match (start, role, dialect) {
        (Some(start), Role::Output | Role::Local, Dialect::Plain) => {
            let found = "an initial value, which some compiler drops";
            mistakes.push(start.start_byte(), found, "an assignment in the first cycle");
        }
        (Some(start), Role::Temporary, _) => {
            mistakes.push(start.start_byte(), "an initial value of a temporary", "an assignment in each cycle");
        }
        (None, Role::Constant, _) => {
            mistakes.push(node.start_byte(), "a constant without a value", "`:=` and its value");
        }
        _ => {}
    }
    let value =
        start.zip(kind).and_then(|(start, kind)| constant::initial((dialect, all.real), start, text, kind, mistakes));
    let value = value.filter(|_| dialect != Dialect::Plain);
    for name in names {
        if let Some((found, instead)) = names::mistake(dialect, said(name, text)) {
            mistakes.push(name.start_byte(), found, instead);
        }
        add(name, text, kind, role, value, all, mistakes);
    }
}

fn add(
    node: Node<'_>,
    text: &str,
    kind: Option<Kind>,
    role: Role,
    value: Option<Value>,
    all: &mut Variables,
    mistakes: &mut Mistakes<'_>,
) {
    let name = said(node, text);
    let lower = name.to_ascii_lowercase();
    if all.by_name.contains_key(&lower) {
        mistakes.push(node.start_byte(), format!("`{name}`, which is declared already"), "another name");
        return;
    }
    let known = kind.is_some();
    let kind = kind.unwrap_or(Kind::Real);
    let slot = all.slot(kind, value);
    all.by_name.insert(lower, Variable { kind, role, slot, known });
}
