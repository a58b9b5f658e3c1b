//! What the self-test of a block does, and the answers that the reference gives. Every target prints it its own way.

use crate::noise::{Noise, Run, Running, exercised};
use compiler::leaf;
use compiler::legalise::{Own, RealInput};
use compiler::program::{Program, Variable};
use portable::{Block, Literal, Real, RealKind};

/// A short run on noise: it finds a build that fuses, reorders or shortens operations, or that takes a NaN for a number.
#[derive(Clone, Debug)]
pub(crate) struct SelfTest {
    /// inputs that differ from their start, by position
    pub(crate) switches: Vec<(usize, Literal)>,
    /// the factors of the noise on the real inputs, powers of two: first one at which no limit acts, then the full one
    pub(crate) scales: [Literal; 2],
    /// the first sample with the full noise
    pub(crate) loud_from: usize,
    /// the samples in which a real input is no number, with the input
    pub(crate) bad: Vec<(usize, RealInput)>,
    /// after each sample the digest of all outputs and of the whole state up to there
    pub(crate) expected: Vec<u64>,
}

impl SelfTest {
    /// Whether an input gets noise that is scaled: one that is no part from 0 to 1.
    pub(crate) fn is_scaled(&self) -> bool {
        self.bad.iter().any(|(_, input)| !input.is_fraction)
    }
}

/// Samples with little noise, behind the bad ones. In each of them every state and every output can show an operation that
/// was not done as written.
const QUIET_SAMPLES: usize = 24;
/// Samples with the full noise.
const LOUD_SAMPLES: usize = 8;
/// From a bad sample to the next: a block that has noticed it starts anew in the second sample and acts in the third.
const BAD_SAMPLE_DISTANCE: usize = 3;

/// Runs the reference on noise from the generator that every target has too. At the beginning each real input is no
/// number for a sample: a build that takes it for one goes on with other bits.
///
/// `state_paths` are the paths of all leaves of the reference's state; `ranges` are the noise's, each above 0.
pub(crate) fn record<R: Real, B: Block<R>>(
    coeffs: B::Coeffs,
    own: &Own,
    state_paths: &[String],
    ranges: [f64; 2],
) -> SelfTest {
    let switched = exercised::<R, B>(&coeffs);
    let inputs = own.program.inputs.iter().zip(own.inputs.iter().map(|index| switched[*index])).enumerate();
    let switches = inputs.filter(|(_, (input, value))| *value != input.start).map(|(index, (_, value))| (index, value));
    let reals = own.reals();
    let places = (1..).step_by(BAD_SAMPLE_DISTANCE);
    let kept = kept(&own.program, state_paths);
    let mut noise = Noise::<R>::within(ranges);
    let loud_from = BAD_SAMPLE_DISTANCE * reals.len() + QUIET_SAMPLES;
    let (mut run, mut outputs) = (Running::<R, B>::start(coeffs), Vec::new());
    let (mut digest, mut expected) = (0, Vec::new());
    for sample in 0..loud_from + LOUD_SAMPLES {
        let mut inputs = noise.inputs(&switched, &reals, sample >= loud_from);
        for (_, real) in places.clone().zip(&reals).filter(|(bad, _)| *bad == sample) {
            inputs[real.position] = leaf(R::lit(f64::NAN));
        }
        run.step(&inputs, &mut outputs);
        let reached = run.state();
        let shown = own.outputs.iter().map(|output| &outputs[*output]);
        let values = shown.chain(kept.iter().map(|leaf| &reached[*leaf]));
        digest = values.fold(digest, |digest, value| fold(digest, *value, R::KIND));
        expected.push(digest);
    }
    let bad = places.zip(reals).collect();
    SelfTest { switches: switches.collect(), scales: noise.scales, loud_from, bad, expected }
}

/// Where the parts of a program's state stand among all leaves of the reference's.
pub(crate) fn kept(program: &Program, state_paths: &[String]) -> Vec<usize> {
    let place = |part: &Variable| state_paths.iter().position(|path| *path == part.path);
    let places: Option<Vec<usize>> = program.state.iter().map(place).collect();
    places.expect("self-test: the program's state is part of the reference's")
}

/// The digest with one more value: turned by five bits, and the bits added, in as many bits as a real has.
fn fold(digest: u64, value: Literal, real: RealKind) -> u64 {
    let bits = match value {
        Literal::Bool(value) => u64::from(value),
        Literal::I32(value) => u64::from(value.cast_unsigned()),
        Literal::U32(value) => u64::from(value),
        Literal::F64(value) => value.to_bits(),
        Literal::F32(value) => u64::from(value.to_bits()),
        Literal::Usize(_) | Literal::Variant(_) => panic!("self-test: {value:?} does not exist at run time"),
    };
    match real {
        RealKind::F64 => digest.rotate_left(5).wrapping_add(bits),
        RealKind::F32 => ((digest << 5 | digest >> 27) + bits) & u64::from(u32::MAX),
    }
}
