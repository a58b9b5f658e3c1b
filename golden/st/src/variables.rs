//! The variables of a block, by their names, and their slots. No declaration is read here.

use super::kind::{Kind, Value};
use super::machine::Slots;
use super::op::Base;
use portable::RealKind;
use std::collections::BTreeMap;

/// The writer of a variable.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Role {
    /// the caller
    Input,
    /// the block, for the caller
    Output,
    /// the block
    Local,
    /// the block and its caller, who passes one of its own variables: `VAR_IN_OUT`
    Shared,
    /// the block; the value does not outlive the cycle
    Temporary,
    /// never written
    Constant,
}

#[derive(Clone, Copy, Debug)]
pub(crate) struct Variable {
    /// its type
    pub(crate) kind: Kind,
    /// its writer
    pub(crate) role: Role,
    /// its slot, among those of its type
    pub(crate) slot: u32,
    /// whether its type is known; if not, its uses are not reported as further errors
    pub(crate) known: bool,
}

/// An instance of another block.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Inner {
    /// index of the other block
    pub(crate) of: usize,
    /// its first slots
    pub(crate) base: Base,
}

/// A variable that is a structure.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Whole {
    /// index of the structure
    pub(crate) of: usize,
    /// the writer of its parts
    pub(crate) role: Role,
}

/// An array, whose elements are variables by their names, `x[0]`, with consecutive slots.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Array {
    /// its first element
    pub(crate) first: Variable,
    /// the number of its elements
    pub(crate) length: u32,
}

/// What has a name, by the names in lower case.
#[derive(Clone, Debug)]
pub(crate) struct Names<T>(BTreeMap<String, T>);

impl<T: Copy> Names<T> {
    fn new() -> Self {
        Self(BTreeMap::new())
    }

    pub(crate) fn get(&self, name: &str) -> Option<T> {
        self.0.get(&name.to_ascii_lowercase()).copied()
    }

    pub(crate) fn add(&mut self, name: &str, named: T) {
        self.0.insert(name.to_ascii_lowercase(), named);
    }
}

/// The variables of a block.
#[derive(Clone, Debug)]
pub(crate) struct Variables {
    /// the real type
    pub(crate) real: RealKind,
    /// those with a slot
    pub(crate) single: Names<Variable>,
    /// instances
    pub(crate) inner: Names<Inner>,
    /// structures; each part of one is a variable by its path
    pub(crate) whole: Names<Whole>,
    pub(crate) arrays: Names<Array>,
    /// the slots of the real numbers of the text, apart from start values, in its order
    pub(crate) numbers: Vec<u32>,
    /// start values of the slots
    pub(crate) slots: Slots<f64>,
}

impl Variables {
    /// No variables.
    pub(crate) fn new(real: RealKind) -> Self {
        let (single, inner, whole, arrays) = (Names::new(), Names::new(), Names::new(), Names::new());
        Self { real, single, inner, whole, arrays, numbers: Vec::new(), slots: Slots::default() }
    }

    /// The structures that the caller passes, by their names.
    pub(crate) fn shared(&self) -> impl Iterator<Item = (&str, Whole)> {
        let is_shared = |(_, whole): &(&String, &Whole)| whole.role == Role::Shared;
        self.whole.0.iter().filter(is_shared).map(|(name, whole)| (name.as_str(), *whole))
    }

    /// Adds an instance with its own slots, whose start values are those of its block.
    pub(crate) fn add_inner(&mut self, name: &str, of: usize, start: &Slots<f64>) {
        let slots = &mut self.slots;
        let base = Base {
            reals: number(slots.reals.len()),
            bools: number(slots.bools.len()),
            words: number(slots.words.len()),
        };
        slots.reals.extend(&start.reals);
        slots.bools.extend(&start.bools);
        slots.words.extend(&start.words);
        self.inner.add(name, Inner { of, base });
    }

    /// Adds a slot.
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
            Kind::Dint | Kind::Udint | Kind::Int | Kind::Uint => {
                slots.words.push(if let Some(Value::Word(value)) = value { value } else { 0 });
                slots.words.len() - 1
            }
        };
        number(slot)
    }
}

/// The slot of an instance's variable.
pub(crate) fn slot_of(inner: Inner, variable: Variable) -> u32 {
    let base = match variable.kind {
        Kind::Real => inner.base.reals,
        Kind::Bool => inner.base.bools,
        Kind::Dint | Kind::Udint | Kind::Int | Kind::Uint => inner.base.words,
    };
    base + variable.slot
}

/// The number of a slot or of an operation.
pub(crate) fn number(at: usize) -> u32 {
    u32::try_from(at).expect("engine: a text is shorter than 2^32 bytes")
}
