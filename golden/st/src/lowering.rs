//! What is known of a block while it is lowered, and where the values of its expressions are.

use super::declarations::Variables;
use super::kind::Kind;
use super::machine::Op;
use super::mistake::Mistakes;
use super::syntax::shown;
use super::{DEPTH, Dialect};
use portable::RealKind;
use std::collections::BTreeSet;
use tree_sitter::Node;

/// Where the value of an expression is.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Operand {
    /// in a slot
    Slot {
        /// its type
        kind: Kind,
        /// its number
        slot: u32,
        /// whether the slot is free again once the value was used
        passing: bool,
    },
    /// an integer literal, whose type is that of what it meets
    Integer(i64),
}

/// An operand of a known type: its type, its slot, and whether the slot is free again once the value was used.
pub(crate) type Typed = (Kind, u32, bool);

/// A block while it is lowered.
pub(crate) struct Lowering<'a, 't> {
    /// the text
    pub(crate) text: &'a str,
    /// which file form
    pub(crate) dialect: Dialect,
    /// the variables, and the slots of numbers and of parts of expressions
    pub(crate) variables: &'a mut Variables,
    /// what is wrong
    pub(crate) mistakes: &'a mut Mistakes<'t>,
    /// the operations so far
    pub(crate) ops: Vec<Op>,
    /// slots of parts of expressions that are free again, by their types
    pub(crate) free: [Vec<u32>; 4],
    /// the temporaries that have a value here on every way, by type and slot
    pub(crate) assigned: BTreeSet<(usize, u32)>,
    /// how many levels this place is inside others
    pub(crate) depth: usize,
    /// whether too many were said of
    pub(crate) too_deep: bool,
    /// whether all declarations can be read
    pub(crate) all_declared: bool,
}

impl Lowering<'_, '_> {
    /// A mistake at a node.
    pub(crate) fn say(&mut self, node: Node<'_>, found: impl Into<String>, instead: impl Into<String>) {
        self.mistakes.push(node.start_byte(), found, instead);
    }

    /// A name that is not declared; it may be where a declaration cannot be read.
    pub(crate) fn undeclared(&mut self, node: Node<'_>) {
        if self.all_declared {
            self.say(node, format!("{}, which is not declared", shown(node, self.text)), "a declared variable");
        }
    }

    /// Goes on one level deeper; `None`: that is too deep.
    pub(crate) fn deeper<T>(&mut self, node: Node<'_>, inside: impl FnOnce(&mut Self) -> T) -> Option<T> {
        if self.depth == DEPTH {
            if !self.too_deep {
                self.say(node, format!("more than {DEPTH} levels inside each other"), "a part of it by itself");
            }
            self.too_deep = true;
            return None;
        }
        self.depth += 1;
        let result = inside(self);
        self.depth -= 1;
        Some(result)
    }

    /// Whether a real that is not alone right of `:=` needs a name: digits are LREAL to some compilers, and REAL to none.
    pub(crate) fn has_named_reals(&self) -> bool {
        self.variables.real == RealKind::F32 || self.dialect == Dialect::Scl
    }
}
