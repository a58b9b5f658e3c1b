//! The reference in operation, and the digest of its outputs and state. Its inputs are decided elsewhere.

use super::inputs::Exercise;
use portable::{Block, Literal, Portable, Real};

/// A reference in operation.
pub trait Run {
    /// One cycle: takes the scalars of the inputs and writes those of the outputs.
    fn step(&mut self, inputs: &[Literal], outputs: &mut Vec<Literal>);

    /// Calls `take` with the scalars of its state at these places.
    fn state(&self, places: &[usize], take: &mut dyn FnMut(Literal));
}

pub(crate) struct Running<R: Real, B: Block<R>> {
    coeffs: B::Coeffs,
    state: B::State,
    outputs: B::Outputs,
}

impl<R: Real, B: Block<R>> Running<R, B> {
    /// The reference before the first cycle.
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

    fn state(&self, places: &[usize], take: &mut dyn FnMut(Literal)) {
        places.iter().for_each(|place| take(self.state.leaf(*place).at_run_time()));
    }
}

impl Exercise {
    /// The digest with all outputs of a cycle, and with the whole state after it.
    pub(super) fn digest(&self, digest: u32, run: &dyn Run, outputs: &[Literal]) -> u32 {
        let mut digest = self.outputs.iter().fold(digest, |digest, output| fold(digest, outputs[*output]));
        run.state(&self.state, &mut |leaf| digest = fold(digest, leaf));
        digest
    }
}

/// The digest with one more value, word by word, the low word first. Two different words give different digests, for any
/// previous digest.
#[expect(clippy::cast_possible_truncation, reason = "the two words of a number of 64 bits")]
fn fold(digest: u32, value: Literal) -> u32 {
    let word = |digest: u32, word: u32| (digest.rotate_left(5) ^ word).wrapping_mul(0x9e37_79b1);
    match value {
        Literal::Bool(value) => word(digest, u32::from(value)),
        Literal::I32(value) => word(digest, value.cast_unsigned()),
        Literal::U32(value) => word(digest, value),
        Literal::F32(value) => word(digest, value.to_bits()),
        Literal::F64(value) => {
            let [low, high] = [value.to_bits() as u32, (value.to_bits() >> 32) as u32];
            word(word(digest, low), high)
        }
        Literal::Usize(_) | Literal::Variant(_) => panic!("exercise: {value:?} does not exist at run time"),
    }
}
