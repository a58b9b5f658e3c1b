//! Single steps of a compiled block from states in which all variables except one are 0. No section is known here.
//!
//! Between its switches the block is linear: such a step shows one column of its state-space matrices. The amplitudes
//! are powers of two, so that dividing by them rounds nothing.

use crate::design::rounding::literal;
use compiler::arithmetic::wide;
use compiler::interp::Machine;
use compiler::program::{Program, Variable};
use portable::Extreme;
use portable::{Literal, RealKind};

/// The variable that is 1 before a step; all others are 0. Variables and inputs by their positions in the program.
pub enum Source {
    /// a variable of the state
    State(usize),
    Input(usize),
    /// an input, with all sections at rest at it, so that they output 0, except the one with these states
    Alone(usize, [usize; 2]),
}

/// A machine for single steps.
pub struct Probe<'p> {
    machine: Machine<'p>,
    real: RealKind,
    /// the real type of the block, which bounds its samples
    samples: RealKind,
    limit: f64,
    /// state before the first cycle
    fresh: Vec<Literal>,
    /// preset, all sections 0
    rest: Vec<Literal>,
    /// state after one step at rest: the constant that keeps sections out of the subnormal range
    still: Vec<f64>,
    inputs: Vec<Literal>,
    outputs: Vec<Literal>,
    v_add: usize,
    limited: usize,
}

impl<'p> Probe<'p> {
    /// A probe for a block with samples of this real type; the program may compute with another one.
    ///
    /// # Panics
    /// If the program is not the block `ipc`.
    pub fn new(program: &'p Program, samples: RealKind, limit: f64) -> Self {
        let at = |variables: &[Variable], path| {
            let found = variables.iter().position(|variable| variable.path == path);
            found.unwrap_or_else(|| panic!("certificate: the block has no {path}"))
        };
        // The tunable values have their designed start values.
        let start =
            |input: &Variable| if program.is_fraction(input) { literal(1.0, program.real) } else { input.start };
        let mut inputs: Vec<_> = program.inputs.iter().map(start).collect();
        inputs[at(&program.inputs, "mode")] = Literal::I32(reference::ipc::mode_on());
        let mut outputs = Vec::new();
        let mut machine = Machine::start(program);
        let fresh = machine.state().to_vec();
        machine.step(&inputs, &mut outputs);
        let rest = machine.state().to_vec();
        machine.step(&inputs, &mut outputs);
        let still = machine.state().iter().map(|value| number(*value)).collect();
        let [v_add, limited] = ["v_add_calculated", "limited"].map(|path| at(&program.outputs, path));
        Self { machine, real: program.real, samples, limit, fresh, rest, still, inputs, outputs, v_add, limited }
    }

    /// The largest amplitude: within the sample limit, 1e15 or 1e9, and far above the state of a section at rest.
    fn large(&self) -> f64 {
        libm::ldexp(1.0, if self.samples == RealKind::F64 { 49 } else { 29 })
    }

    /// The state after one step, for a source of 1.
    pub fn column(&mut self, source: &Source) -> Vec<f64> {
        let amplitude = self.large();
        self.step(source, amplitude);
        let of = |(value, still): (&Literal, &f64)| (number(*value) - still) / amplitude;
        self.machine.state().iter().zip(&self.still).map(of).collect()
    }

    /// The output of the step for a source of 1, measured where neither the limit nor the suppression of small sums acts.
    pub fn output(&mut self, source: &Source) -> f64 {
        if self.limit <= 0.0 {
            return 0.0;
        }
        let mut amplitude = libm::exp2(libm::floor(libm::log2(self.limit)) - 6.0);
        for _ in 0..64 {
            self.step(source, amplitude);
            let v_add = number(self.outputs[self.v_add]);
            if self.outputs[self.limited] == Literal::Bool(true) {
                amplitude /= 256.0;
            } else if v_add == 0.0 && amplitude < self.large() {
                amplitude = (amplitude * 65536.0).smaller(self.large());
            } else {
                return v_add / amplitude;
            }
        }
        0.0
    }

    fn step(&mut self, source: &Source, amplitude: f64) {
        let value = literal(amplitude, self.real);
        let (mut state, mut inputs) = (self.rest.clone(), self.inputs.clone());
        match source {
            Source::State(index) => state[*index] = value,
            Source::Input(input) => inputs[*input] = value,
            Source::Alone(input, states) => {
                inputs[*input] = value;
                self.machine.set_state(&self.fresh);
                self.machine.step(&inputs, &mut self.outputs);
                state = self.machine.state().to_vec();
                states.iter().for_each(|at| state[*at] = self.rest[*at]);
            }
        }
        self.machine.set_state(&state);
        self.machine.step(&inputs, &mut self.outputs);
    }
}

/// A real; 0 for any other value.
fn number(value: Literal) -> f64 {
    wide(value).unwrap_or(0.0)
}
