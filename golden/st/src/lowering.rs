//! The data of a block while it is lowered, and the places of its expressions' values.

use super::constant::word;
use super::kind::{Kind, Value};
use super::known::Known;
use super::mistake::Mistakes;
use super::op::{Code, Op};
use super::syntax::{said, shown};
use super::variables::Variables;
use super::{DEPTH, Dialect};
use portable::RealKind;
use std::collections::BTreeSet;
use std::ops::Range;
use tree_sitter::Node;

/// The place of an expression's value.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Operand {
    Slot {
        /// its type
        kind: Kind,
        /// its number
        slot: u32,
        /// whether it is the result of the last operation, which nothing else uses
        part: bool,
    },
    /// an integer literal, whose type is that of the other operand
    Integer(i64),
}

/// An operand with a known type: its type, its slot, and whether it is the result of the last operation.
pub(crate) type Typed = (Kind, u32, bool);

/// A block while it is being lowered.
pub(crate) struct Lowering<'a, 't> {
    pub(crate) text: &'a str,
    /// the form of the file
    pub(crate) dialect: Dialect,
    /// declarations of other files
    pub(crate) known: Known<'a>,
    /// the variables, and the slots of numbers and of parts of expressions
    pub(crate) variables: &'a mut Variables,
    /// the errors
    pub(crate) mistakes: &'a mut Mistakes<'t>,
    /// the operations so far
    pub(crate) ops: Vec<Op>,
    /// the operations of each assignment so far
    pub(crate) assignments: Vec<Range<usize>>,
    /// the temporaries that have a value here on every path, by type and slot
    pub(crate) assigned: BTreeSet<(usize, u32)>,
    /// nesting depth of this place
    pub(crate) depth: usize,
    /// whether too deep nesting has been reported
    pub(crate) too_deep: bool,
    /// whether all declarations can be read
    pub(crate) all_declared: bool,
}

impl Lowering<'_, '_> {
    /// Reports an error at a node.
    pub(crate) fn say(&mut self, node: Node<'_>, found: impl Into<String>, instead: impl Into<String>) {
        self.mistakes.push(node.start_byte(), found, instead);
    }

    /// Reports a name that is not a variable; it may be declared in an unreadable declaration.
    pub(crate) fn no_variable(&mut self, node: Node<'_>) {
        let name = shown(node, self.text);
        if self.variables.inner.get(said(node, self.text)).is_some() {
            self.say(node, format!("the instance {name} by itself"), "a variable, or one of its outputs");
        } else if self.variables.whole.get(said(node, self.text)).is_some() {
            self.say(node, format!("the structure {name} by itself"), "one of its parts");
        } else if self.all_declared {
            self.say(node, format!("{name}, which is not declared"), "a declared variable");
        }
    }

    /// Lowers one level deeper; `None` if the nesting is too deep.
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

    /// Whether a real that is not alone to the right of `:=` needs a name: digits are LREAL for some compilers, and never
    /// REAL.
    pub(crate) fn has_named_reals(&self) -> bool {
        self.variables.real == RealKind::F32 || self.dialect == Dialect::Scl
    }

    /// The name of an operand's type.
    pub(crate) fn kind_name(&self, operand: Operand) -> &'static str {
        match operand {
            Operand::Slot { kind, .. } => self.name(kind),
            Operand::Integer(_) => "an integer literal",
        }
    }

    /// The name of a type.
    pub(crate) fn name(&self, kind: Kind) -> &'static str {
        kind.name(self.variables.real)
    }

    /// A slot for a number of the text.
    pub(crate) fn literal(&mut self, kind: Kind, value: Value) -> Operand {
        let slot = self.variables.slot(kind, Some(value));
        if kind == Kind::Real {
            self.variables.numbers.push(slot);
        }
        Operand::Slot { kind, slot, part: false }
    }

    /// An operand; a literal takes the wanted type if it fits.
    pub(crate) fn typed(&mut self, operand: Operand, wanted: Kind, node: Node<'_>) -> Option<Typed> {
        match (operand, wanted) {
            (Operand::Slot { kind, slot, part }, _) => Some((kind, slot, part)),
            (Operand::Integer(value), Kind::Dint | Kind::Udint | Kind::Int | Kind::Uint) => {
                if let Some(word) = word(value, wanted) {
                    return Some((wanted, self.variables.slot(wanted, Some(Value::Word(word))), false));
                }
                let instead = format!("an integer that fits a {}", self.name(wanted));
                self.say(node, format!("`{value}`"), instead);
                None
            }
            (Operand::Integer(value), _) => {
                let name = self.name(wanted);
                let instead =
                    if wanted == Kind::Real { format!("`{value}.0`") } else { "`TRUE` or `FALSE`".to_owned() };
                self.say(node, format!("the integer `{value}` where a {name} belongs"), instead);
                None
            }
        }
    }

    /// Appends an operation whose result is stored in a new slot.
    pub(crate) fn emit(&mut self, code: Code, result: Kind, operands: &[Typed]) -> Operand {
        let slot = self.variables.slot(result, None);
        let of = |at: usize| operands.get(at).map_or(0, |&(_, slot, _)| slot);
        self.ops.push(Op { part: true, ..Op::new(code, slot, [of(0), of(1)]) });
        Operand::Slot { kind: result, slot, part: true }
    }
}
