//! The engine `reference`: the Rust source itself.

use crate::samples::{Samples, Shape};
use compiler::leaves;
use generator::axis::Axis;
use generator::block::{Block, Part, Visitor, with_part};
use portable::{Portable, Real, RealKind};

/// Runs a block.
pub fn run(axis: &Axis, block: &Block, inputs: &Samples) -> Samples {
    match axis.real {
        RealKind::F64 => run_as::<f64>(axis, block, inputs),
        RealKind::F32 => run_as::<f32>(axis, block, inputs),
    }
}

fn run_as<R: Real>(axis: &Axis, block: &Block, inputs: &Samples) -> Samples {
    with_part::<R, _>(block.program.block, Run { axis, block, inputs })
}

/// What is to be run.
struct Run<'a> {
    axis: &'a Axis,
    block: &'a Block,
    inputs: &'a Samples,
}

impl<R: Real> Visitor<R> for Run<'_> {
    type Value = Samples;

    fn visit<P: Part<R>>(self) -> Samples {
        run_block::<R, P>(&P::coefficients(self.axis), self.block, self.inputs)
    }
}

fn run_block<R: Real, B: Part<R>>(coeffs: &B::Coeffs, block: &Block, inputs: &Samples) -> Samples {
    let shape = Shape::of(&block.program.outputs, block.program.real);
    let mut samples = Samples::with_capacity(shape, inputs.len());
    let (mut state, mut outputs, mut values) = (B::state(), B::outputs(), Vec::new());
    for sample in 0..inputs.len() {
        inputs.read(sample, &mut values);
        let mut next = values.iter().copied();
        let input = B::Inputs::build(&mut || next.next().expect("engine: as many values as inputs"));
        B::step(&mut state, coeffs, &input, &mut outputs);
        samples.push(&leaves(&outputs));
    }
    samples
}
