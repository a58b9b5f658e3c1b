//! Single steps of a compiled block from states that are 0 but for one variable. No section is known here.
//!
//! Between its switches the block is linear: such a step shows one column of its state-space matrices. The amplitudes
//! are powers of two, so that dividing by them rounds nothing.

use compiler::interp::Machine;
use compiler::program::Program;
use portable::{Literal, RealKind};

/// What is 1 before a step; everything else is 0.
pub(super) enum Source {
    /// a variable of the state
    State(usize),
    /// an input
    Input(usize),
    /// an input, all sections but these at rest at it: they put out 0
    Alone {
        /// which one
        input: usize,
        /// of these sections
        states: Vec<usize>,
    },
}

/// A machine for single steps.
pub(super) struct Probe<'p> {
    machine: Machine<'p>,
    /// before the first cycle
    fresh: Vec<Literal>,
    /// preset, all sections 0
    rest: Vec<Literal>,
    /// what one step at rest leaves: the constant that keeps sections out of the subnormal range
    still: Vec<f64>,
    inputs: Vec<Literal>,
    outputs: Vec<Literal>,
    real: RealKind,
    limit: f64,
    v_add: usize,
    limited: usize,
}

impl<'p> Probe<'p> {
    /// A machine of this block.
    ///
    /// # Panics
    /// If the program is not the block `ipc`.
    pub(super) fn new(program: &'p Program, limit: f64) -> Self {
        let output = |path| program.outputs.iter().position(|variable| variable.path == path);
        let mut inputs: Vec<Literal> = program.inputs.iter().map(|variable| variable.start).collect();
        let mode = program.inputs.iter().position(|variable| variable.path == "mode");
        inputs[mode.expect("certificate: the block has a mode")] = Literal::I32(reference::ipc::mode_on());
        let machine = Machine::start(program);
        let fresh = machine.state().to_vec();
        let mut probe = Self {
            machine,
            rest: fresh.clone(),
            fresh,
            still: Vec::new(),
            inputs,
            outputs: Vec::new(),
            real: program.real,
            limit,
            v_add: output("v_add_calculated").expect("certificate: the block has the output v_add_calculated"),
            limited: output("limited").expect("certificate: the block has the output limited"),
        };
        probe.machine.step(&probe.inputs, &mut probe.outputs);
        probe.rest = probe.machine.state().to_vec();
        probe.machine.step(&probe.inputs, &mut probe.outputs);
        probe.still = probe.machine.state().iter().map(|value| number(*value)).collect();
        probe
    }

    /// The largest amplitude: within the sample limit, 1e15 or 1e9, and far above what a section at rest holds.
    fn large(&self) -> f64 {
        match self.real {
            RealKind::F64 => libm::ldexp(1.0, 49),
            RealKind::F32 => libm::ldexp(1.0, 29),
        }
    }

    /// The state after one step, for a source of 1.
    pub(super) fn column(&mut self, source: &Source) -> Vec<f64> {
        let amplitude = self.large();
        self.step(source, amplitude);
        let of = |(value, still): (&Literal, &f64)| (number(*value) - still) / amplitude;
        self.machine.state().iter().zip(&self.still).map(of).collect()
    }

    /// The output of the step, for a source of 1: measured where the limit does not act, nor what makes a small sum 0.
    pub(super) fn output(&mut self, source: &Source) -> f64 {
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
                amplitude = (amplitude * 65536.0).min(self.large());
            } else {
                return v_add / amplitude;
            }
        }
        0.0
    }

    fn step(&mut self, source: &Source, amplitude: f64) {
        let value = match self.real {
            RealKind::F64 => Literal::F64(amplitude),
            #[expect(clippy::cast_possible_truncation, reason = "a power of two")]
            RealKind::F32 => Literal::F32(amplitude as f32),
        };
        let input = match source {
            Source::State(index) => {
                let before = std::mem::replace(&mut self.rest[*index], value);
                self.machine.set_state(&self.rest);
                self.rest[*index] = before;
                None
            }
            Source::Input(input) => {
                self.machine.set_state(&self.rest);
                Some(*input)
            }
            Source::Alone { input, .. } => Some(*input),
        };
        let before = input.map(|input| std::mem::replace(&mut self.inputs[input], value));
        if let Source::Alone { states, .. } = source {
            self.machine.set_state(&self.fresh);
            self.machine.step(&self.inputs, &mut self.outputs);
            let mut preset = self.machine.state().to_vec();
            states.iter().for_each(|state| preset[*state] = self.rest[*state]);
            self.machine.set_state(&preset);
        }
        self.machine.step(&self.inputs, &mut self.outputs);
        if let (Some(input), Some(before)) = (input, before) {
            self.inputs[input] = before;
        }
    }
}

fn number(value: Literal) -> f64 {
    match value {
        Literal::F64(value) => value,
        Literal::F32(value) => f64::from(value),
        _ => 0.0,
    }
}
