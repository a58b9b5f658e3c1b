//! The block `ipc` of a set or a list, run by its reference, signal by signal: what a program on a controller would be.

use super::Signals;
use compiler::program::Type;
use generator::blocks::{self, Designed};
use generator::config::ListOptions;
use generator::pipeline;
use golden::case::named_block;
use golden::csv::{self, Reals};
use golden::samples::{Samples, Shape};
use portable::{Literal, RealKind};
use std::path::Path;

/// One cycle of the reference: from the scalars of its inputs to those of its outputs.
type Cycle = Box<dyn FnMut(&[Literal], &mut Vec<Literal>)>;

/// The block `ipc` of an axis between two cycles.
pub struct Subject {
    cycle: Cycle,
    real: RealKind,
    names: [Vec<String>; 2],
    inputs: Vec<Literal>,
    outputs: Vec<Literal>,
    recorded: [Samples; 2],
}

impl Subject {
    /// Before the first cycle, with the start values of its inputs.
    ///
    /// # Panics
    /// If the axis has no block `ipc`.
    #[must_use]
    pub fn new(designed: &Designed) -> Self {
        let block = named_block(designed, "ipc").unwrap_or_else(|error| panic!("plant: {error}"));
        let real = designed.axis.real;
        let shapes = [&block.program.inputs, &block.program.outputs].map(|signals| Shape::of(signals, real));
        let names = shapes.each_ref().map(|shape| shape.signals.iter().map(|signal| signal.name.clone()).collect());
        let inputs = shapes[0].signals.iter().map(|signal| signal.start.at_run_time()).collect();
        let recorded = shapes.map(|shape| Samples::with_capacity(shape, 0));
        let mut reference = blocks::named("ipc").expect("named above").start(designed);
        let cycle: Cycle = Box::new(move |inputs, outputs| reference.step(inputs, outputs));
        Self { cycle, real, names, inputs, outputs: Vec::new(), recorded }
    }

    /// The block of the only axis of a set or a list.
    ///
    /// # Panics
    /// If it cannot be read, with the message; if it has several axes.
    #[must_use]
    pub fn of(path: &Path, cycle_time: Option<&str>) -> Self {
        let options = ListOptions { cycle_time: cycle_time.map(str::to_owned), ..ListOptions::default() };
        let (set, report) = pipeline::read(path, &options);
        let set = set.unwrap_or_else(|| panic!("plant: {report}"));
        assert_eq!(set.axes.len(), 1, "plant: {}", path.display());
        Self::new(&set.axes[0])
    }

    /// Whether it has such an input.
    #[must_use]
    pub fn has(&self, input: &str) -> bool {
        self.names[0].iter().any(|name| name == input)
    }

    /// Writes an input; the value has the input's type, reals are in double precision.
    ///
    /// # Panics
    /// If there is no such input, or the number does not fit it.
    pub fn set(&mut self, input: &str, value: f64) {
        let at = self.names[0].iter().position(|name| name == input);
        let at = at.unwrap_or_else(|| panic!("plant: no input `{input}`: {:?}", self.names[0]));
        let ty = self.recorded[0].shape.signals[at].ty;
        self.inputs[at] = match (ty, self.real) {
            (Type::Real, RealKind::F64) => Literal::F64(value),
            #[expect(clippy::cast_possible_truncation, reason = "single precision rounds")]
            (Type::Real, RealKind::F32) => Literal::F32(value as f32),
            _ => csv::parse(&value.to_string(), &self.recorded[0].shape.signals[at], self.real)
                .unwrap_or_else(|| panic!("plant: {value} is no value of {input}")),
        };
    }

    /// The value that an input has until somebody writes it.
    ///
    /// # Panics
    /// If there is no such input.
    #[must_use]
    pub fn start(&self, input: &str) -> f64 {
        let at = self.names[0].iter().position(|name| name == input);
        let at = at.unwrap_or_else(|| panic!("plant: no input `{input}`: {:?}", self.names[0]));
        number(self.recorded[0].shape.signals[at].start.at_run_time(), input)
    }

    /// An output of the last cycle, FALSE and TRUE as 0 and 1.
    ///
    /// # Panics
    /// If there is no such output, or no cycle yet.
    #[must_use]
    pub fn get(&self, output: &str) -> f64 {
        let at = self.names[1].iter().position(|name| name == output);
        number(self.outputs[at.unwrap_or_else(|| panic!("plant: no output `{output}`: {:?}", self.names[1]))], output)
    }

    /// One cycle; gives `v_add` [um/s].
    pub fn step(&mut self, signals: &Signals) -> f64 {
        let Signals { v_soll, v_ist1, v_ist2 } = *signals;
        for (input, value) in [("v_command", v_soll), ("v_motor", v_ist1), ("v_direct", v_ist2)] {
            if self.has(input) {
                self.set(input, value);
            }
        }
        (self.cycle)(&self.inputs, &mut self.outputs);
        self.recorded[0].push(&self.inputs);
        self.recorded[1].push(&self.outputs);
        self.get("v_add")
    }

    /// What went in and came out so far is forgotten.
    pub fn record_anew(&mut self) {
        self.recorded.iter_mut().for_each(|samples| samples.bytes.clear());
    }

    /// What went in and what came out since then, or since the start, as CSV.
    #[must_use]
    pub fn csv(&self) -> String {
        csv::write(&[&self.recorded[0], &self.recorded[1]], Reals::Decimal)
    }
}

/// A value of this signal, FALSE and TRUE as 0 and 1.
fn number(value: Literal, signal: &str) -> f64 {
    match value {
        Literal::F64(value) => value,
        Literal::F32(value) => f64::from(value),
        Literal::Bool(value) => f64::from(u8::from(value)),
        Literal::I32(value) => f64::from(value),
        Literal::U32(value) => f64::from(value),
        other => panic!("plant: {signal} is {other:?}"),
    }
}
