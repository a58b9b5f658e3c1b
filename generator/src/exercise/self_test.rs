//! The self-test of a build: a short run on noise. It detects a build that fuses, reorders or shortens operations, or that
//! treats a NaN as a number.

use super::inputs::Exercise;
use super::noise::Noise;
use super::run::Run;
use compiler::legalise::RealInput;
use portable::Literal;

/// The part of a self-test beyond its exercise, and the digests of the reference.
#[derive(Clone, Debug)]
pub(crate) struct SelfTest {
    /// the first sample with the full noise
    pub(crate) loud_from: usize,
    /// the samples in which a real input is not a number, with the input
    pub(crate) bad: Vec<(usize, RealInput)>,
    /// for each sample the digest of all outputs and of the whole state so far
    pub(crate) expected: Vec<u32>,
}

/// Samples with little noise, after the bad ones. In each of them every state and every output can reveal an operation that
/// was not executed as written.
const QUIET_SAMPLES: usize = 24;
/// Samples with the full noise.
const LOUD_SAMPLES: usize = 8;
/// Distance of bad samples: a block that has detected one restarts in the second sample and acts in the third.
const BAD_SAMPLE_DISTANCE: usize = 3;

impl SelfTest {
    /// Runs the reference. At the beginning each real input is a NaN for one sample: a build that treats it as a number
    /// continues with other bits.
    pub(crate) fn record(exercise: &Exercise, run: &mut dyn Run) -> Self {
        let bad: Vec<_> =
            (BAD_SAMPLE_DISTANCE..).step_by(BAD_SAMPLE_DISTANCE).zip(exercise.reals.iter().copied()).collect();
        let loud_from = BAD_SAMPLE_DISTANCE * bad.len() + exercise.wait + QUIET_SAMPLES;
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
