//! A short run of a block that a user can repeat on the controller itself, with the answers of the reference. No NaN, no
//! infinity: some runtimes stop on them.

use crate::noise::{Noise, Run, Running, exercised, is_real};
use compiler::leaf;
use portable::{Block, Literal, Real};
use reference::signal::sample_limit;
use std::sync::{Arc, LazyLock};

/// What went in and what came out, sample by sample, in the order of the program's inputs and outputs.
#[derive(Clone, Debug, PartialEq)]
pub struct Vector {
    pub inputs: Vec<Vec<Literal>>,
    pub outputs: Vec<Vec<Literal>>,
}

/// A run that is recorded where it is first looked at: few targets print it.
pub(crate) type Recording = Arc<LazyLock<Vector, Box<dyn FnOnce() -> Vector + Send>>>;

/// Samples of a run.
pub(crate) const SAMPLES: usize = 192;
/// The first sample with the full noise. Before it no limit acts, and a fade of 100 cycles has ended.
const LOUD_FROM: usize = 112;
/// The sample in which the first switch is turned.
const FIRST_SWITCH: usize = 128;
/// From one switch to the next.
const SWITCH_DISTANCE: usize = 6;
/// For how long a switch stays turned.
const SWITCH_LENGTH: usize = 3;
/// The sample in which the first real is out of range.
const FIRST_OUT_OF_RANGE: usize = 168;
/// From one real out of range to the next.
const OUT_OF_RANGE_DISTANCE: usize = 3;

/// Runs the reference on noise; one switch after the other is turned for a few samples, one real after the other is out of range
/// for one.
///
/// `ranges` are the noise's: first one at which no limit acts, then the full one.
pub(crate) fn recording<R: Real, B: Block<R>>(coeffs: B::Coeffs, ranges: [f64; 2]) -> Recording {
    Arc::new(LazyLock::new(Box::new(move || record::<R, B>(coeffs, ranges))))
}

fn record<R: Real, B: Block<R>>(coeffs: B::Coeffs, ranges: [f64; 2]) -> Vector {
    let usual = exercised::<R, B>(&coeffs);
    let (reals, switches): (Vec<usize>, Vec<usize>) = (0..usual.len()).partition(|index| is_real(&usual[*index]));
    debug_assert!(FIRST_SWITCH + switches.len() * SWITCH_DISTANCE <= FIRST_OUT_OF_RANGE);
    debug_assert!(FIRST_OUT_OF_RANGE + reals.len() * OUT_OF_RANGE_DISTANCE <= SAMPLES);
    let beyond = leaf(sample_limit::<R>() + sample_limit::<R>());
    let (mut run, mut noise) = (Running::<R, B>::start(coeffs), Noise::<R>::within(ranges));
    let mut vector = Vector { inputs: Vec::with_capacity(SAMPLES), outputs: vec![Vec::new(); SAMPLES] };
    for (sample, outputs) in vector.outputs.iter_mut().enumerate() {
        let turned = in_turn(&switches, sample, FIRST_SWITCH, SWITCH_DISTANCE, SWITCH_LENGTH);
        let out_of_range = in_turn(&reals, sample, FIRST_OUT_OF_RANGE, OUT_OF_RANGE_DISTANCE, 1);
        let mut inputs = noise.inputs(&usual, sample >= LOUD_FROM);
        turned.into_iter().for_each(|index| inputs[index] = turn(inputs[index]));
        out_of_range.into_iter().for_each(|index| inputs[index] = beyond);
        run.step(&inputs, outputs);
        vector.inputs.push(inputs);
    }
    vector
}

/// Which of some inputs has its turn in a sample: each for `length` samples, `distance` after the one before.
fn in_turn(inputs: &[usize], sample: usize, first: usize, distance: usize, length: usize) -> Option<usize> {
    let since = sample.checked_sub(first).filter(|since| since % distance < length)?;
    inputs.get(since / distance).copied()
}

/// Another value of a switch.
fn turn(value: Literal) -> Literal {
    match value {
        Literal::Bool(value) => Literal::Bool(!value),
        Literal::I32(value) => Literal::I32(value.wrapping_add(1)),
        Literal::U32(value) => Literal::U32(value.wrapping_add(1)),
        other => other,
    }
}
