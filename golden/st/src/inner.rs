//! Blocks inside a block: calls of instances, and their outputs.

use super::block::Block;
use super::kind::Kind;
use super::lowering::{Lowering, Operand};
use super::op::{Code, Op, moved};
use super::structure::Structure;
use super::syntax::{children, said, shown};
use super::variables::{self, Inner, Role, Whole, slot_of};
use super::whole::parts;
use std::collections::BTreeSet;
use tree_sitter::Node;

/// The slots of a part of a structure, in the block and in its instance.
struct Pair {
    kind: Kind,
    here: u32,
    there: u32,
}

impl Lowering<'_, '_> {
    /// Lowers a call: its arguments are assigned, then the instance executes a cycle; `None` after a reported error.
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
        let block = &self.known.blocks[inner.of];
        let mut before = BTreeSet::new();
        let arguments: Vec<Node<'_>> =
            children(arguments).into_iter().map(|(part, _)| part).filter(Node::is_named).collect();
        let is_shared = |argument: &Node<'_>| {
            let name = argument.child_by_field_name("name");
            let whole = name.and_then(|name| block.variables.whole.get(said(name, self.text)));
            whole.is_some_and(|whole| whole.role == Role::Shared)
        };
        let (given, others): (Vec<Node<'_>>, Vec<Node<'_>>) = arguments.into_iter().partition(is_shared);
        for argument in others {
            self.argument(argument, (inner, block), &mut before);
        }
        let shared = self.shared(function, &given, (inner, block));
        self.copy(&shared, false);
        let first = variables::number(self.ops.len());
        self.ops.extend(block.ops.iter().map(|op| moved(*op, inner.base, first)));
        self.copy(&shared, true);
        Some(())
    }

    /// The structures that a call passes to an instance: the slots of their parts in the block and in the instance. Each is
    /// passed only once: then a copy before the call and one after it are equivalent to a reference, because no part has a
    /// second name.
    fn shared(&mut self, function: Node<'_>, given: &[Node<'_>], (inner, block): (Inner, &Block)) -> Vec<Pair> {
        let (mut pairs, mut own) = (Vec::new(), BTreeSet::new());
        let mut missing: BTreeSet<String> = block.variables.shared().map(|(name, _)| name.to_owned()).collect();
        for &argument in given {
            let word =
                |field| argument.child_by_field_name(field).map(|node| said(node, self.text).to_ascii_lowercase());
            let (Some(name), Some(path)) = (word("name"), word("value")) else { continue };
            let Some(whole) = block.variables.whole.get(&name) else { continue };
            let wanted = &self.known.structures[whole.of];
            missing.remove(&name);
            let found = self.variables.whole.get(&path).filter(|whole| whole.role != Role::Input);
            if found.is_none_or(|whole| self.known.structures[whole.of].name != wanted.name) {
                let instead = format!("a variable of type `{}`", wanted.name);
                self.say(argument, shown(argument, self.text), instead);
                continue;
            }
            if !own.insert(name.clone()) || !own.insert(format!("={path}")) {
                self.say(argument, format!("{}, given a second time", shown(argument, self.text)), "each once");
            }
            pairs.extend(self.pairs([&path, &name], wanted, (inner, block)));
        }
        if let Some(name) = missing.first() {
            self.say(function, format!("a call without `{name}`"), format!("`{name} := variable`"));
        }
        pairs
    }

    /// The parts of two variables of a type: the first one in the block, the second one in an instance.
    fn pairs(&self, [here, there]: [&str; 2], ty: &Structure, (inner, block): (Inner, &Block)) -> Vec<Pair> {
        let pair = |path: &str| {
            let here = self.variables.single.get(&format!("{here}.{path}"))?;
            let there = slot_of(inner, block.variables.single.get(&format!("{there}.{path}"))?);
            Some(Pair { kind: here.kind, here: here.slot, there })
        };
        ty.parts.iter().filter_map(|part| pair(&part.path)).collect()
    }

    /// Copies shared structures to an instance, or back.
    fn copy(&mut self, shared: &[Pair], back: bool) {
        for &Pair { kind, here, there } in shared {
            let (to, from) = if back { (here, there) } else { (there, here) };
            self.ops.push(Op::new(Code::moving(kind), to, [from, 0]));
        }
    }

    /// Lowers an argument; `before` has the inputs of the previous arguments.
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
            self.say(node, shown(node, self.text), "`input := value`, and an output after the call");
            return None;
        }
        let word = said(name, self.text).to_ascii_lowercase();
        if let Some(whole) = block.variables.whole.get(&word) {
            return self.whole_argument(node, (inner, block, whole), before);
        }
        let input = block.variables.single.get(&word).filter(|variable| variable.role == Role::Input);
        if input.is_none() {
            let found = format!("{}, which is not an input of `{}`", shown(name, self.text), block.name);
            self.say(name, found, "one of its inputs");
        } else if !before.insert(word) {
            self.say(name, format!("{} a second time", shown(name, self.text)), "each input once");
        }
        let target = input.map(|variable| (variable.kind, slot_of(inner, variable)));
        self.assign(target, node.child_by_field_name("value")?)
    }

    /// Lowers a structure that is copied to an input part by part.
    fn whole_argument(
        &mut self,
        node: Node<'_>,
        (inner, block, whole): (Inner, &Block, Whole),
        before: &mut BTreeSet<String>,
    ) -> Option<()> {
        let name = said(node.child_by_field_name("name")?, self.text).to_ascii_lowercase();
        let value = node.child_by_field_name("value")?;
        let wanted = &block.structures[whole.of];
        let Some(found) = self.named(value).filter(|found| found.ty == wanted.name) else {
            let instead = format!("a variable of type `{}`", wanted.name);
            self.say(node, shown(node, self.text), instead);
            return None;
        };
        let to = parts(wanted, &block.variables, &name, |part| (part.kind, slot_of(inner, part)));
        if !before.insert(name) {
            self.say(node, format!("{} a second time", shown(node, self.text)), "each input once");
        }
        self.copy_parts(&to, &found.parts);
        Some(())
    }

    /// Lowers an output of an instance, or a part of one that is a structure; `None` after a reported error.
    pub(crate) fn output(&mut self, node: Node<'_>) -> Option<Operand> {
        let (mut object, member) = (node.child_by_field_name("object")?, node.child_by_field_name("member")?);
        while object.kind() == "member_access_expression" {
            object = object.child_by_field_name("object")?;
        }
        let after: &str = self.text.get(object.end_byte()..node.end_byte()).unwrap_or_default();
        let path = after.replace(char::is_whitespace, "");
        let path = path.trim_start_matches('.');
        let Some(inner) = self.instance(object) else {
            if !self.has_unknown_type(object) {
                self.say(node, shown(node, self.text), "a variable, a number or an operation on them");
            }
            return None;
        };
        let block = &self.known.blocks[inner.of];
        let output = block.variables.single.get(path).filter(|variable| variable.role == Role::Output);
        let Some(variable) = output else {
            let found = format!("{}, which is not an output of `{}`", shown(member, self.text), block.name);
            self.say(member, found, "one of its outputs");
            return None;
        };
        if after.len() != 1 + path.len() {
            self.say(node, "an output away from its instance", "the instance, `.` and the output without blanks");
            return None;
        }
        Some(Operand::Slot { kind: variable.kind, slot: slot_of(inner, variable), part: false })
    }

    /// The instance that a node names.
    fn instance(&self, node: Node<'_>) -> Option<Inner> {
        self.variables.inner.get(said(node, self.text)).filter(|_| node.kind() == "identifier")
    }

    /// Whether a node names a variable with a rejected type: it may have been meant as an instance.
    fn has_unknown_type(&self, node: Node<'_>) -> bool {
        self.variables.single.get(said(node, self.text)).is_some_and(|variable| !variable.known)
    }
}
