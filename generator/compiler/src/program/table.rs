//! A value for each variable of a program, in the order of its lists.

use super::{Program, Var};
use std::ops::{Index, IndexMut};

#[derive(Clone, Debug, Default)]
pub struct Table<T> {
    pub inputs: Vec<T>,
    pub outputs: Vec<T>,
    pub state: Vec<T>,
    pub constants: Vec<T>,
    pub locals: Vec<T>,
}

impl<T: Clone> Table<T> {
    pub(crate) fn filled(program: &Program, value: T) -> Self {
        let all = |length| vec![value.clone(); length];
        Self {
            inputs: all(program.inputs.len()),
            outputs: all(program.outputs.len()),
            state: all(program.state.len()),
            constants: all(program.constants.len()),
            locals: all(program.locals.len()),
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
