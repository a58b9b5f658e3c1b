//! Blocks inside a block: calls of instances, and their outputs.

use super::block::Block;
use super::lowering::{Lowering, Operand};
use super::op::moved;
use super::syntax::{children, said, shown};
use super::variables::{self, Inner, Role, slot_of};
use std::collections::BTreeSet;
use tree_sitter::Node;

impl Lowering<'_, '_> {
    /// Lowers a call: its arguments are assigned, then the instance has its cycle; `None`: a mistake was said.
    pub(crate) fn invocation(&mut self, node: Node<'_>) -> Option<()> {
        if node.has_error() {
            return None;
        }
        let (call, _) = children(node).into_iter().next()?;
        let (function, arguments) = (call.child_by_field_name("function")?, call.child_by_field_name("arguments")?);
        let Some(inner) = self.instance(function) else {
            if !self.has_unknown_type(function) {
                self.say(node, "a call as a statement", "what it does");
            }
            return None;
        };
        let block = &self.others[inner.of];
        let mut before = BTreeSet::new();
        for (argument, _) in children(arguments).into_iter().filter(|(part, _)| part.is_named()) {
            self.argument(argument, (inner, block), &mut before);
        }
        let first = variables::number(self.ops.len());
        self.ops.extend(block.ops.iter().map(|op| moved(*op, inner.base, first)));
        Some(())
    }

    /// Lowers an argument; `before` has the inputs of those before it.
    fn argument(
        &mut self,
        node: Node<'_>,
        (inner, block): (Inner, &Block),
        before: &mut BTreeSet<String>,
    ) -> Option<()> {
        let Some(name) = node.child_by_field_name("name") else {
            self.say(node, "an argument without a name", "`input := value`");
            return None;
        };
        if !children(node).iter().any(|(part, _)| part.kind() == ":=") {
            self.say(node, shown(node, self.text), "`input := value`, and an output behind the call");
            return None;
        }
        let word = said(name, self.text).to_ascii_lowercase();
        let input = block.variables.find(&word).filter(|variable| variable.role == Role::Input);
        if input.is_none() {
            let found = format!("{}, which is no input of `{}`", shown(name, self.text), block.name);
            self.say(name, found, "one of its inputs");
        } else if !before.insert(word) {
            self.say(name, format!("{} a second time", shown(name, self.text)), "each input once");
        }
        let target = input.map(|variable| (variable.kind, slot_of(inner, variable)));
        self.assign(target, node.child_by_field_name("value")?)
    }

    /// Lowers an output of an instance; `None`: a mistake was said.
    pub(crate) fn output(&mut self, node: Node<'_>) -> Option<Operand> {
        let (object, member) = (node.child_by_field_name("object")?, node.child_by_field_name("member")?);
        let Some(inner) = self.instance(object) else {
            if !self.has_unknown_type(object) {
                self.say(node, shown(node, self.text), "a variable, a number or an operation on them");
            }
            return None;
        };
        let block = &self.others[inner.of];
        let output = block.variables.find(said(member, self.text)).filter(|variable| variable.role == Role::Output);
        let Some(variable) = output else {
            let found = format!("{}, which is no output of `{}`", shown(member, self.text), block.name);
            self.say(member, found, "one of its outputs");
            return None;
        };
        if node.end_byte() - node.start_byte() != said(object, self.text).len() + 1 + said(member, self.text).len() {
            self.say(node, "an output away from its instance", "the instance, `.` and the output without blanks");
            return None;
        }
        Some(Operand::Slot { kind: variable.kind, slot: slot_of(inner, variable), part: false })
    }

    /// The instance that a node names.
    fn instance(&self, node: Node<'_>) -> Option<Inner> {
        self.variables.inner(said(node, self.text)).filter(|_| node.kind() == "identifier")
    }

    /// Whether a node names what was declared with a type that was refused: it may have been meant as an instance.
    fn has_unknown_type(&self, node: Node<'_>) -> bool {
        self.variables.find(said(node, self.text)).is_some_and(|variable| !variable.known)
    }
}
