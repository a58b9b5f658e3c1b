//! A value for each variable of a program.

use super::{Program, Var};
use std::ops::{Index, IndexMut};

/// A value for each variable of a program, in the order of its lists.
#[derive(Clone, Debug, Default)]
pub struct Table<T> {
    /// of the inputs
    pub inputs: Vec<T>,
    /// of the outputs
    pub outputs: Vec<T>,
    /// of the state
    pub state: Vec<T>,
    /// of the constants
    pub constants: Vec<T>,
    /// of the locals
    pub locals: Vec<T>,
}

impl<T: Clone> Table<T> {
    pub(crate) fn filled(program: &Program, value: T) -> Self {
        let of = |length| vec![value.clone(); length];
        Self {
            inputs: of(program.inputs.len()),
            outputs: of(program.outputs.len()),
            state: of(program.state.len()),
            constants: of(program.constants.len()),
            locals: of(program.locals.len()),
        }
    }
}

impl<T> Index<Var> for Table<T> {
    type Output = T;

    fn index(&self, var: Var) -> &T {
        match var {
            Var::Input(index) => &self.inputs[index],
            Var::Output(index) => &self.outputs[index],
            Var::State(index) => &self.state[index],
            Var::Constant(index) => &self.constants[index],
            Var::Local(index) => &self.locals[index],
        }
    }
}

impl<T> IndexMut<Var> for Table<T> {
    fn index_mut(&mut self, var: Var) -> &mut T {
        match var {
            Var::Input(index) => &mut self.inputs[index],
            Var::Output(index) => &mut self.outputs[index],
            Var::State(index) => &mut self.state[index],
            Var::Constant(index) => &mut self.constants[index],
            Var::Local(index) => &mut self.locals[index],
        }
    }
}
