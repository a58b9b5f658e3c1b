//! The variables of a block, by their names, and their slots. No declaration is read here.

use super::kind::{Kind, Value};
use super::machine::Slots;
use super::op::Base;
use portable::RealKind;
use std::collections::{BTreeMap, HashMap};

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

/// A variable.
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

/// The variables of a block.
#[derive(Clone, Debug)]
pub(crate) struct Variables {
    /// the real type
    pub(crate) real: RealKind,
    /// by their names in lower case
    by_name: HashMap<String, Variable>,
    /// instances, by their names in lower case
    inner: HashMap<String, Inner>,
    /// structures, by their names in lower case; each part of one is a variable by its path
    whole: BTreeMap<String, Whole>,
    /// arrays, by their names in lower case
    arrays: HashMap<String, Array>,
    /// the slots of the real numbers of the text, apart from start values, in its order
    pub(crate) numbers: Vec<u32>,
    /// start values of the slots
    pub(crate) slots: Slots<f64>,
}

impl Variables {
    /// No variables.
    pub(crate) fn new(real: RealKind) -> Self {
        let (by_name, inner, whole, arrays) = (HashMap::new(), HashMap::new(), BTreeMap::new(), HashMap::new());
        Self { real, by_name, inner, whole, arrays, numbers: Vec::new(), slots: Slots::default() }
    }

    /// A variable by its name.
    pub(crate) fn find(&self, name: &str) -> Option<Variable> {
        self.by_name.get(&name.to_ascii_lowercase()).copied()
    }

    /// An instance by its name.
    pub(crate) fn inner(&self, name: &str) -> Option<Inner> {
        self.inner.get(&name.to_ascii_lowercase()).copied()
    }

    /// A structure by its name.
    pub(crate) fn whole(&self, name: &str) -> Option<Whole> {
        self.whole.get(&name.to_ascii_lowercase()).copied()
    }

    /// The structures that the caller passes, by their names.
    pub(crate) fn shared(&self) -> impl Iterator<Item = (&str, Whole)> {
        let is_shared = |(_, whole): &(&String, &Whole)| whole.role == Role::Shared;
        self.whole.iter().filter(is_shared).map(|(name, whole)| (name.as_str(), *whole))
    }

    /// An array by its name.
    pub(crate) fn array(&self, name: &str) -> Option<Array> {
        self.arrays.get(&name.to_ascii_lowercase()).copied()
    }

    /// Adds an array.
    pub(crate) fn add_array(&mut self, name: &str, array: Array) {
        self.arrays.insert(name.to_ascii_lowercase(), array);
    }

    /// Adds a structure.
    pub(crate) fn add_whole(&mut self, name: &str, whole: Whole) {
        self.whole.insert(name.to_ascii_lowercase(), whole);
    }

    /// Adds a variable.
    pub(crate) fn add(&mut self, name: &str, variable: Variable) {
        self.by_name.insert(name.to_ascii_lowercase(), variable);
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
        self.inner.insert(name.to_ascii_lowercase(), Inner { of, base });
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
