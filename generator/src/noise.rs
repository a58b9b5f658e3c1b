//! What a recorded run is made of: the reference in operation, and noise that every target can make itself, exact in both real
//! types. Nothing is recorded here.

use crate::design::rounding::literal;
use compiler::legalise::RealInput;
use compiler::{leaf, leaves};
use portable::{Block, Literal, Portable, Real, RealKind};
use std::marker::PhantomData;

/// A reference in operation.
pub trait Run {
    /// One cycle: takes the scalars of the inputs, gives those of the outputs.
    fn step(&mut self, inputs: &[Literal], outputs: &mut Vec<Literal>);

    /// The scalars of its state.
    fn state(&self) -> Vec<Literal>;
}

pub(crate) struct Running<R: Real, B: Block<R>> {
    coeffs: B::Coeffs,
    state: B::State,
    outputs: B::Outputs,
}

impl<R: Real, B: Block<R>> Running<R, B> {
    /// Before the first cycle.
    pub(crate) fn start(coeffs: B::Coeffs) -> Self {
        Self { coeffs, state: B::state(), outputs: B::outputs() }
    }
}

impl<R: Real, B: Block<R>> Run for Running<R, B> {
    fn step(&mut self, inputs: &[Literal], outputs: &mut Vec<Literal>) {
        let mut next = inputs.iter().copied();
        let inputs = B::Inputs::build(&mut || next.next().expect("run: as many values as inputs"));
        B::step(&mut self.state, &self.coeffs, &inputs, &mut self.outputs);
        outputs.clear();
        self.outputs.visit(&mut |output| outputs.push(output.at_run_time()));
    }

    fn state(&self) -> Vec<Literal> {
        leaves(&self.state).into_iter().map(Literal::at_run_time).collect()
    }
}

/// The inputs with which a block does all that it can.
pub(crate) fn exercised<R: Real, B: Block<R>>(coeffs: &B::Coeffs) -> Vec<Literal> {
    let mut inputs = B::inputs(coeffs);
    B::exercise(&mut inputs, coeffs);
    leaves(&inputs)
}

/// 2^-24: makes a part of 1 of the noise's integers.
const PART: f64 = 1.0 / 16_777_216.0;

/// The same for a target.
pub(crate) fn part(real: RealKind) -> Literal {
    literal(PART, real)
}

/// The generator of the noise of C's self-test: scale * (integer of 24 bits - 2^23).
pub(crate) struct Noise<R> {
    random: u32,
    pub(crate) scales: [Literal; 2],
    real: PhantomData<R>,
}

impl<R: Real> Noise<R> {
    /// Noise of two ranges, each above 0: its factors are powers of two within them.
    pub(crate) fn within(ranges: [f64; 2]) -> Self {
        let scale = |range| leaf(R::lit(libm::exp2(libm::floor(libm::log2(range)) - 23.0)));
        Self { random: 1, scales: ranges.map(scale), real: PhantomData }
    }

    /// The inputs of a cycle: noise on the reals at these positions, the others as they are usually.
    pub(crate) fn inputs(&mut self, usual: &[Literal], reals: &[RealInput], is_loud: bool) -> Vec<Literal> {
        let mut inputs = usual.to_vec();
        let scale = R::build(&mut || self.scales[usize::from(is_loud)]);
        reals.iter().for_each(|real| inputs[real.position] = self.next(real, scale));
        inputs
    }

    /// The next number for an input: of a signal times a factor, of a part from 0 to 1.
    pub(crate) fn next(&mut self, real: &RealInput, scale: R) -> Literal {
        let integer = R::from_u32(self.integer());
        leaf(if real.is_fraction { integer * R::lit(PART) } else { (integer - R::lit(8_388_608.0)) * scale })
    }

    /// The next integer, of 24 bits.
    pub(crate) fn integer(&mut self) -> u32 {
        self.random = self.random.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
        self.random >> 8
    }
}
