//! What a runner does on a user's own board, and the answers of the reference: a long run that the board makes itself, sample by sample,
//! from a generator of integers. Only digests are kept, one for each stretch of samples.

use crate::noise::{Noise, Run, Running, exercised};
use crate::self_test::kept;
use crate::trial::{Drill, Set, others};
use compiler::leaf;
use compiler::legalise::{Own, RealInput};
use compiler::program::Program;
use portable::{Block, Literal, Real};
use reference::signal::sample_limit;
use std::ops::Range;

/// A long run.
#[derive(Clone, Debug)]
pub struct Runner {
    /// how many samples there are
    pub(crate) samples: usize,
    /// how many of them have one digest
    pub(crate) stretch: usize,
    pub(crate) period: Period,
    /// the inputs that are no reals, by position among those that the axis has, as they mostly are
    pub(crate) usual: Vec<(usize, Literal)>,
    /// the input that counts the calls, by position among those that the axis has
    pub(crate) counter: Option<usize>,
    /// the real inputs
    pub(crate) reals: Vec<RealInput>,
    /// the factors of the noise on them, powers of two: first one at which no limit acts, then the full one
    pub(crate) scales: [Literal; 2],
    /// what the block is led through in each period: the samples of the period, the input, its value
    pub(crate) drill: Vec<(Range<usize>, usize, Literal)>,
    /// other values of inputs that are no reals, one of which holds for a while
    pub(crate) turns: Vec<(usize, Literal)>,
    /// a number out of the range of samples
    pub(crate) beyond: Literal,
    /// the digest of all outputs and of the state, for each stretch
    pub(crate) expected: Vec<u32>,
}

/// How many samples a run has, if nobody says it.
pub const USUAL_SAMPLES: usize = 100_000;
/// How many digests a run has at most that is longer than that.
const DIGESTS: usize = 100;
/// The fewest samples with a digest of their own.
const SHORTEST_STRETCH: usize = 1000;

/// Where the parts of a period begin; it repeats itself. A short run is one period.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Period {
    /// little noise is there from the beginning; here the drill begins in it
    pub(crate) drill: usize,
    /// the full noise
    pub(crate) loud: usize,
    /// little noise, with disturbances
    pub(crate) disturbed: usize,
    /// the full noise, with disturbances
    pub(crate) disturbed_loud: usize,
    /// rest
    pub(crate) rest: usize,
    /// how many samples it has
    pub(crate) samples: usize,
}

impl Period {
    /// The period of a run of so many samples.
    fn of(samples: usize) -> Self {
        let part = samples.clamp(20, 20_000) / 20;
        let [drill, loud, disturbed, disturbed_loud, rest, samples] = [4, 6, 12, 14, 16, 20].map(|parts| parts * part);
        Self { drill, loud, disturbed, disturbed_loud, rest, samples }
    }
}

/// Runs the reference.
///
/// `state_paths` are the paths of all leaves of the reference's state; `ranges` are the noise's, each above 0.
pub(crate) fn record<R: Real, B: Block<R>>(
    coeffs: B::Coeffs,
    (program, own): (&Program, &Own),
    state_paths: &[String],
    ranges: [f64; 2],
    drill: &[Drill],
    samples: usize,
) -> Runner {
    let (usual, period) = (exercised::<R, B>(&coeffs), Period::of(samples));
    let (reals, signals) = (own.reals(), own.signals());
    let is_other = |at: &usize| reals.iter().all(|real| real.own != *at) && signals.contains(&own.inputs[*at]);
    let others_there: Vec<usize> = (0..own.inputs.len()).filter(is_other).collect();
    let turns = others_there.iter().flat_map(|at| others(usual[own.inputs[*at]]).into_iter().map(|value| (*at, value)));
    let own_place = |path: &str| {
        let place = program.inputs.iter().position(|input| input.path == path)?;
        own.inputs.iter().position(|kept| *kept == place)
    };
    let drill = drill.iter().filter_map(|part| {
        let value = match part.value {
            Set::Bool(value) => Literal::Bool(value),
            Set::I32(value) => Literal::I32(value),
            Set::Real(value) => leaf(R::lit(value)),
        };
        let samples = period.drill + part.samples.start..period.drill + part.samples.end;
        Some((samples, own_place(part.input)?, value))
    });
    let mut noise = Noise::<R>::within(ranges);
    let mut runner = Runner {
        samples,
        period,
        stretch: samples.div_ceil(DIGESTS).max(SHORTEST_STRETCH).min(samples),
        usual: others_there.iter().map(|at| (*at, usual[own.inputs[*at]])).collect(),
        counter: own.program.inputs.iter().position(|input| input.path == "cycle_counter"),
        reals,
        scales: noise.scales,
        drill: drill.collect(),
        turns: turns.collect(),
        beyond: leaf(sample_limit::<R>() + sample_limit::<R>()),
        expected: Vec::new(),
    };
    runner.expected = runner.digests::<R, B>(coeffs, usual, own, state_paths, &mut noise);
    runner
}

impl Runner {
    fn digests<R: Real, B: Block<R>>(
        &self,
        coeffs: B::Coeffs,
        usual: Vec<Literal>,
        own: &Own,
        state_paths: &[String],
        noise: &mut Noise<R>,
    ) -> Vec<u32> {
        let kept = kept(&own.program, state_paths);
        let (mut run, mut outputs, mut turn) = (Running::<R, B>::start(coeffs), Vec::new(), Turn::default());
        let (mut digest, mut digests) = (0, Vec::new());
        for sample in 0..self.samples {
            let mut inputs = usual.clone();
            self.sample(sample, noise, &mut turn, |at, value| inputs[own.inputs[at]] = value);
            run.step(&inputs, &mut outputs);
            let reached = run.state();
            let shown = own.outputs.iter().map(|output| &outputs[*output]);
            digest =
                shown.chain(kept.iter().map(|leaf| &reached[*leaf])).fold(digest, |digest, value| fold(digest, *value));
            if (sample + 1) % self.stretch == 0 || sample + 1 == self.samples {
                digests.push(std::mem::take(&mut digest));
            }
        }
        digests
    }

    /// Sets the inputs of a sample of the period; the template of C does the same, in the same order.
    fn sample<R: Real>(
        &self,
        sample: usize,
        noise: &mut Noise<R>,
        turn: &mut Turn,
        mut set: impl FnMut(usize, Literal),
    ) {
        let Period { loud, disturbed, disturbed_loud, rest, samples, .. } = self.period;
        let at = sample % samples;
        let is_loud = (loud..disturbed).contains(&at) || at >= disturbed_loud;
        let scale = if at >= rest { R::ZERO } else { R::build(&mut || self.scales[usize::from(is_loud)]) };
        self.reals.iter().for_each(|real| set(real.own, noise.next(real, scale)));
        if let Some(counter) = self.counter {
            let counted = u32::try_from(sample).unwrap_or(u32::MAX).wrapping_add(1);
            set(counter, Literal::U32(counted));
        }
        for (_, input, value) in self.drill.iter().filter(|(samples, ..)| samples.contains(&at)) {
            set(*input, *value);
        }
        if !(disturbed..rest).contains(&at) {
            turn.left = 0;
            return;
        }
        let [begin, length, bad] = [(); 3].map(|()| noise.integer());
        if turn.left == 0 && begin >> 18 == 0 && !self.turns.is_empty() {
            *turn = Turn { which: (begin >> 4) as usize % self.turns.len(), left: 1 + (length >> 18) };
        }
        if turn.left > 0 {
            turn.left -= 1;
            let (input, value) = self.turns[turn.which];
            set(input, value);
        }
        if bad >> 16 == 0 && !self.reals.is_empty() {
            let value = if bad & 4 == 0 { self.beyond } else { leaf(R::lit(f64::NAN)) };
            set(self.reals[(bad >> 3) as usize % self.reals.len()].own, value);
        }
    }
}

/// What is turned, and for how many samples more.
#[derive(Clone, Copy, Debug, Default)]
struct Turn {
    which: usize,
    left: u32,
}

/// The digest with one more value, word by word, the low one first. A word can be told from each other one, whatever the digest is.
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
        Literal::Usize(_) | Literal::Variant(_) => panic!("runner: {value:?} does not exist at run time"),
    }
}
