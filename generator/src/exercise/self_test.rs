//! The self-test of a build: a short run on noise. It finds a build that fuses, reorders or shortens operations, or that takes a NaN for a
//! number.

use super::inputs::Exercise;
use super::noise::Noise;
use super::run::Run;
use compiler::legalise::RealInput;
use portable::Literal;

/// What a self-test does next to what its exercise says, and the digests that the reference gives.
#[derive(Clone, Debug)]
pub(crate) struct SelfTest {
    /// the first sample with the full noise
    pub(crate) loud_from: usize,
    /// the samples in which a real input is not a number, with the input
    pub(crate) bad: Vec<(usize, RealInput)>,
    /// after each sample the digest of all outputs and of the whole state up to there
    pub(crate) expected: Vec<u32>,
}

/// Samples with little noise, after the bad ones. In each of them every state and every output can show an operation that
/// was not done as written.
const QUIET_SAMPLES: usize = 24;
/// Samples with the full noise.
const LOUD_SAMPLES: usize = 8;
/// From a bad sample to the next: a block that has noticed it starts anew in the second sample and acts in the third.
const BAD_SAMPLE_DISTANCE: usize = 3;

impl SelfTest {
    /// Runs the reference. At the beginning each real input is not a number for a sample: a build that takes it for one goes
    /// on with other bits.
    pub(crate) fn record(exercise: &Exercise, run: &mut dyn Run) -> Self {
        let bad: Vec<_> =
            (BAD_SAMPLE_DISTANCE..).step_by(BAD_SAMPLE_DISTANCE).zip(exercise.reals.iter().copied()).collect();
        let loud_from = BAD_SAMPLE_DISTANCE * bad.len() + QUIET_SAMPLES;
        let (mut noise, mut outputs, mut digest) = (Noise::default(), Vec::new(), 0);
        let mut sample = |sample: usize| {
            let mut inputs: Vec<Literal> = exercise.usual_at(sample);
            for (bad, real) in &bad {
                let scale = exercise.scales[usize::from(sample >= loud_from)];
                let number = noise.next(real, [scale, exercise.part]);
                inputs[real.position] = if *bad == sample { exercise.not_a_number } else { number };
            }
            run.step(&inputs, &mut outputs);
            digest = exercise.digest(digest, run, &outputs);
            digest
        };
        let expected = (0..loud_from + LOUD_SAMPLES).map(&mut sample).collect();
        Self { loud_from, bad, expected }
    }
}
