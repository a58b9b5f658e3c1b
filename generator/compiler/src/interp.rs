//! Runs a [`Program`] sample by sample, so that it can be compared with the reference without any compiler.

use crate::arithmetic::{binary, intrinsic, unary};
use crate::program::{Expr, Program, Statement, Var};
use portable::{Binary, Literal};

/// A block in operation: the values of its variables.
pub struct Machine<'p> {
    program: &'p Program,
    inputs: Vec<Literal>,
    outputs: Vec<Literal>,
    state: Vec<Literal>,
    locals: Vec<Option<Literal>>,
}

impl<'p> Machine<'p> {
    /// A block before its first cycle, after `init`.
    pub fn start(program: &'p Program) -> Self {
        let values = |variables: &[crate::program::Variable]| variables.iter().map(|variable| variable.start).collect();
        let mut machine = Self {
            program,
            inputs: values(&program.inputs),
            outputs: values(&program.outputs),
            state: values(&program.state),
            locals: vec![None; program.locals.len()],
        };
        machine.run(&program.init, &mut |_, _| {});
        machine
    }

    /// One cycle.
    pub fn step(&mut self, inputs: &[Literal], outputs: &mut Vec<Literal>) {
        self.step_watched(inputs, outputs, &mut |_, _| {});
    }

    /// One cycle; `watch` is called for every write of an output, with its position and its new value.
    pub fn step_watched(
        &mut self,
        inputs: &[Literal],
        outputs: &mut Vec<Literal>,
        watch: &mut impl FnMut(usize, Literal),
    ) {
        self.inputs.clear();
        self.inputs.extend_from_slice(inputs);
        self.locals.fill(None);
        self.run(&self.program.step, watch);
        outputs.clear();
        outputs.extend_from_slice(&self.outputs);
    }

    /// The state of the block, in the order of [`Program::state`].
    pub fn state(&self) -> &[Literal] {
        &self.state
    }

    /// Sets the state of the block, which may be one that it cannot reach: a single step then shows the effect of one part
    /// of the state. In the order of [`Program::state`], each value of its variable's type.
    ///
    /// # Panics
    /// If the number of values differs from the number of variables.
    pub fn set_state(&mut self, state: &[Literal]) {
        self.state.copy_from_slice(state);
    }

    fn run(&mut self, statements: &'p [Statement], watch: &mut impl FnMut(usize, Literal)) {
        for statement in statements {
            match statement {
                Statement::Note(_) => {}
                Statement::Assign { target, value } => {
                    let value = self.value(value);
                    match *target {
                        Var::Output(index) => {
                            self.outputs[index] = value;
                            watch(index, value);
                        }
                        Var::State(index) => self.state[index] = value,
                        Var::Local(index) => self.locals[index] = Some(value),
                        Var::Input(_) | Var::Constant(_) => panic!("interp: {target:?} is written"),
                    }
                }
                Statement::If { condition, then, otherwise } => {
                    let holds = self.value(condition) == Literal::Bool(true);
                    self.run(if holds { then } else { otherwise }, watch);
                }
                Statement::Apart(body) => self.run(body, watch),
                Statement::Choose { by, arms } => {
                    let value = self.value(by);
                    let is_chosen = |label: &Expr| label.known(&self.program.constants) == Some(value);
                    let arm = arms.iter().find(|arm| arm.labels.iter().any(is_chosen)).or(arms.last());
                    self.run(arm.map_or(&[], |arm| &arm.body), watch);
                }
            }
        }
    }

    fn value(&self, expr: &Expr) -> Literal {
        match expr {
            Expr::Literal(literal) => *literal,
            Expr::Var(var) => match *var {
                Var::Input(index) => self.inputs[index],
                Var::Output(index) => self.outputs[index],
                Var::State(index) => self.state[index],
                Var::Constant(index) => self.program.constants[index].value,
                Var::Local(index) => self.locals[index].expect("interp: a local is read after it was assigned"),
            },
            Expr::Unary(operator, operand) => unary(*operator, self.value(operand)),
            Expr::Binary(operator @ (Binary::And | Binary::Or), left, right) => {
                let decides = Literal::Bool(*operator == Binary::Or);
                if self.value(left) == decides { decides } else { self.value(right) }
            }
            Expr::Binary(operator, left, right) => binary(*operator, self.value(left), self.value(right)),
            Expr::Intrinsic(called, operands) => match operands.as_slice() {
                [a] => intrinsic(*called, &[self.value(a)], self.program.real),
                [a, b] => intrinsic(*called, &[self.value(a), self.value(b)], self.program.real),
                _ => panic!("interp: {called:?} with {} operands", operands.len()),
            },
            Expr::Element(row, index) => match self.value(index) {
                Literal::U32(index) if (index as usize) < row.length => self.state[row.first + index as usize],
                index => panic!("interp: element {index:?} of {row:?}"),
            },
        }
    }
}
