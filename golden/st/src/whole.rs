//! Structures and arrays as values: the slots of their parts, and assignments of one to another.

use super::kind::Kind;
use super::lowering::Lowering;
use super::op::{Code, Op};
use super::structure::Structure;
use super::syntax::{said, shown};
use super::variables::{Array, Role, Variable, Variables, slot_of};
use tree_sitter::Node;

/// A structure that an expression names.
pub(crate) struct Named {
    /// the name of its type
    pub(crate) ty: String,
    /// types and slots of its parts
    pub(crate) parts: Vec<(Kind, u32)>,
}

impl Lowering<'_, '_> {
    /// Whether a node names a structure of the block, which only programs around emitted blocks use as a value.
    pub(crate) fn is_whole(&self, node: Node<'_>) -> bool {
        self.known.is_program && self.variables.whole.get(said(node, self.text)).is_some()
    }

    /// The structure that a node names: a variable, or in a program an output of an instance.
    pub(crate) fn named(&self, node: Node<'_>) -> Option<Named> {
        let path = said(node, self.text);
        if let Some(whole) = self.variables.whole.get(path) {
            let of = &self.known.structures[whole.of];
            let part = |variable: Variable| (variable.kind, variable.slot);
            return Some(Named { ty: of.name.clone(), parts: parts(of, self.variables, path, part) });
        }
        let (object, member) = path.split_once('.').filter(|_| self.known.is_program)?;
        let inner = self.variables.inner.get(object)?;
        let block = &self.known.blocks[inner.of];
        let whole = block.variables.whole.get(member).filter(|whole| whole.role == Role::Output)?;
        let of = &block.structures[whole.of];
        let part = |variable: Variable| (variable.kind, slot_of(inner, variable));
        Some(Named { ty: of.name.clone(), parts: parts(of, &block.variables, member, part) })
    }

    /// Lowers an assignment of a structure to another one, part by part.
    pub(crate) fn whole_assignment(&mut self, left: Node<'_>, right: Node<'_>) -> Option<()> {
        let name = said(left, self.text);
        let target = self.named(left)?;
        if self.variables.whole.get(name)?.role == Role::Input {
            self.say(left, format!("the input `{name}` left of `:=`"), "a variable of its own");
            return None;
        }
        let Some(value) = self.named(right).filter(|value| value.ty == target.ty) else {
            self.say(right, shown(right, self.text), format!("a variable of type `{}`", target.ty));
            return None;
        };
        self.copy_parts(&target.parts, &value.parts);
        Some(())
    }

    /// Lowers an assignment of an array to another one of the same type and length, element by element.
    pub(crate) fn array_assignment(&mut self, target: Array, right: Node<'_>) -> Option<()> {
        let is_same = |value: &Array| (value.first.kind, value.length) == (target.first.kind, target.length);
        let Some(value) = self.variables.arrays.get(said(right, self.text)).filter(is_same) else {
            let (last, kind) = (target.length - 1, self.name(target.first.kind));
            self.say(right, shown(right, self.text), format!("an `ARRAY[0..{last}] OF {kind}`"));
            return None;
        };
        let elements =
            |array: Array| (0..array.length).map(|index| (array.first.kind, array.first.slot + index)).collect();
        let (to, from): (Vec<_>, Vec<_>) = (elements(target), elements(value));
        self.copy_parts(&to, &from);
        Some(())
    }

    /// Copies a structure or an array, part by part.
    pub(crate) fn copy_parts(&mut self, to: &[(Kind, u32)], from: &[(Kind, u32)]) {
        for (&(kind, to), &(_, from)) in to.iter().zip(from) {
            self.ops.push(Op::new(Code::moving(kind), to, [from, 0]));
        }
    }
}

/// Types and slots of the parts of the variable `path`.
pub(crate) fn parts(
    of: &Structure,
    variables: &Variables,
    path: &str,
    part: impl Fn(Variable) -> (Kind, u32),
) -> Vec<(Kind, u32)> {
    of.parts.iter().filter_map(|of| variables.single.get(&format!("{path}.{}", of.path)).map(&part)).collect()
}
