//! The run of a runner on a user's own board, and the answers of the reference: a long run whose inputs the board generates
//! itself, sample by sample, from a generator of integers. Only digests are kept, one for each stretch of samples.

use super::inputs::{Exercise, Turn};
use super::noise::Noise;
use super::run::Run;
use portable::Literal;

/// A long run.
#[derive(Clone, Debug)]
pub struct Runner {
    /// the number of samples
    pub(crate) samples: usize,
    /// the number of samples per digest
    pub(crate) stretch: usize,
    pub(crate) period: Period,
    /// alternative values of inputs that are not reals; one of them applies for a while
    pub(crate) turns: Vec<(usize, Literal)>,
    /// the digest of all outputs and of the state, for each stretch
    pub(crate) expected: Vec<u32>,
}

/// The largest number of digests of a longer run.
const DIGESTS: usize = 100;
/// The smallest number of samples per digest.
const SHORTEST_STRETCH: usize = 1000;

/// The starts of the parts of a period, which repeats. A short run is one period.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Period {
    /// the drill, within the little noise with which the period begins
    pub(crate) drill: usize,
    /// the full noise
    pub(crate) loud: usize,
    /// little noise, with disturbances
    pub(crate) disturbed: usize,
    /// the full noise, with disturbances
    pub(crate) disturbed_loud: usize,
    pub(crate) rest: usize,
    /// the number of samples of a period
    pub(crate) samples: usize,
}

impl Period {
    /// The period of a run of N samples.
    fn of(samples: usize) -> Self {
        let part = samples.clamp(20, 20_000) / 20;
        let [drill, loud, disturbed, disturbed_loud, rest, samples] = [4, 6, 12, 14, 16, 20].map(|parts| parts * part);
        Self { drill, loud, disturbed, disturbed_loud, rest, samples }
    }
}

/// Runs the reference for this number of samples.
pub(crate) fn record(exercise: &Exercise, run: &mut dyn Run, samples: usize) -> Runner {
    let turns = exercise.switches.iter().flat_map(|(input, values)| values.iter().map(|value| (*input, *value)));
    let mut runner = Runner {
        samples,
        period: Period::of(samples),
        stretch: samples.div_ceil(DIGESTS).max(SHORTEST_STRETCH).min(samples),
        turns: turns.collect(),
        expected: Vec::new(),
    };
    let (mut noise, mut outputs, mut turned, mut digest) = (Noise::default(), Vec::new(), Turned::default(), 0);
    for sample in 0..samples {
        run.step(&runner.inputs(exercise, sample, &mut noise, &mut turned), &mut outputs);
        digest = exercise.digest(digest, run, &outputs);
        if (sample + 1) % runner.stretch == 0 || sample + 1 == samples {
            runner.expected.push(std::mem::take(&mut digest));
        }
    }
    runner
}

impl Runner {
    /// The inputs of a sample. The template of C generates them in this order, too.
    fn inputs(&self, exercise: &Exercise, sample: usize, noise: &mut Noise, turned: &mut Turned) -> Vec<Literal> {
        let Period { loud, disturbed, disturbed_loud, rest, samples, .. } = self.period;
        let mut inputs = exercise.usual_at(sample);
        let at = sample % samples;
        let is_loud = (loud..disturbed).contains(&at) || at >= disturbed_loud;
        let scale = exercise.scales[if at >= rest { 2 } else { usize::from(is_loud) }];
        for real in &exercise.reals {
            inputs[real.position] = noise.next(real, [scale, exercise.part]);
        }
        for turn in self.drill(exercise).filter(|turn| turn.samples.contains(&at)) {
            inputs[turn.input] = turn.value;
        }
        if !(disturbed..rest).contains(&at) {
            turned.left = 0;
            return inputs;
        }
        let [begin, length, bad] = [(); 3].map(|()| noise.integer());
        if turned.left == 0 && begin >> 16 == 0 && !self.turns.is_empty() {
            *turned = Turned { which: (begin >> 4) as usize % self.turns.len(), left: 1 + (length >> 16) };
        }
        if turned.left > 0 {
            turned.left -= 1;
            let (input, value) = self.turns[turned.which];
            inputs[input] = value;
        }
        if bad >> 14 == 0 && !exercise.reals.is_empty() {
            let position = exercise.reals[(bad >> 3) as usize % exercise.reals.len()].position;
            inputs[position] = if bad >> 13 == 0 { exercise.beyond } else { exercise.not_a_number };
        }
        inputs
    }

    /// The drill of each period.
    pub(crate) fn drill(&self, exercise: &Exercise) -> impl Iterator<Item = Turn> {
        exercise.drill.iter().map(|turn| turn.later(self.period.drill))
    }
}

/// The alternative value that applies, and the number of remaining samples.
#[derive(Clone, Copy, Debug, Default)]
struct Turned {
    which: usize,
    left: u32,
}
