//! A run of a block that a user can repeat on the controller itself, with the answers of the reference. No NaN, no infinity: some
//! runtimes stop on them. What it does is so simple that every controller can do it too, to the bit.

use crate::noise::{Run, Running, exercised};
use compiler::leaf;
use compiler::legalise::{Own, RealInput};
use compiler::program::{Off, Program};
use portable::{Block, Brake, Literal, Real};
use reference::signal::sample_limit;
use std::ops::Range;
use std::sync::{Arc, LazyLock};

/// What a run does, and what came out.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Trial {
    /// the inputs as they mostly are, in the order of all inputs; of one that counts, by how much it grows from sample to sample
    pub(crate) usual: Vec<Literal>,
    /// the input that counts the calls
    pub(crate) counter: Option<usize>,
    /// the real inputs that the axis reads: they get noise
    pub(crate) reals: Vec<RealInput>,
    /// the factors of the noise, powers of two: one at which no limit acts, the full one, and 0 at the end
    pub(crate) scales: [Literal; 3],
    /// the factor of noise that is a part from 0 to 1
    pub(crate) part: Literal,
    /// the first samples with the second and the third factor
    pub(crate) scaled_from: [usize; 2],
    /// the samples in which something is not as it mostly is
    pub(crate) turns: Vec<Turn>,
    /// the samples in which a real input is out of range or huge: sample, input, value
    pub(crate) jumps: Vec<(usize, usize, Literal)>,
    /// the samples that are compared: those before the first number, and those from the second one on
    pub(crate) compared: [usize; 2],
    /// how many samples there are
    pub(crate) samples: usize,
    /// the answers in the samples that are compared
    pub(crate) answers: Vec<Answer>,
}

/// Some samples in which something is not as it mostly is.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Turn {
    pub(crate) from: usize,
    pub(crate) to: usize,
    /// the input, and what it is; where the block is turned off, whatever turns it off
    pub(crate) input: usize,
    pub(crate) value: Literal,
    pub(crate) is_off: bool,
}

/// A part of what a block is led through, because noise alone would not: an input, its value, and the samples in which it has it,
/// counted from where the drill begins.
#[derive(Clone, Debug, PartialEq)]
pub struct Drill {
    pub(crate) input: &'static str,
    pub(crate) value: Set,
    pub(crate) samples: Range<usize>,
}

/// The same with the position of the input.
type Led = (usize, Set, Range<usize>);

/// The inputs that matter where calls are counted.
#[derive(Clone, Copy, Debug)]
struct Calls {
    counter: usize,
    cycle: usize,
    reset: usize,
}

/// The value of an input in a drill.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Set {
    Bool(bool),
    I32(i32),
    Real(f64),
}

/// What the reference answers in a sample.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Answer {
    pub(crate) sample: usize,
    /// whether it is turned off
    pub(crate) is_off: bool,
    /// whether it has to be called further on when it is turned off
    pub(crate) is_busy: bool,
    /// all outputs
    pub(crate) outputs: Vec<Literal>,
}

/// A run that is recorded where it is first looked at: not every target prints it.
pub(crate) type Recording = Arc<LazyLock<Trial, Box<dyn FnOnce() -> Trial + Send>>>;

/// Samples at the beginning that are compared.
const BEGINNING: usize = 8;
/// Samples with little noise behind the beginning, once the block acts in full.
const QUIET_SAMPLES: usize = 24;
/// Samples with the full noise.
const LOUD_SAMPLES: usize = 8;
/// From one turn to the next.
const TURN_DISTANCE: usize = 5;
/// For how long something stays turned.
const TURN_LENGTH: usize = 2;
/// From one jump to the next: a block that has noticed it starts anew in the second sample and acts in the third.
const JUMP_DISTANCE: usize = 3;
/// Calls that are not regular, and by how much the counter grows there: one is missing, which is tolerated; many are missing, which is a
/// pause; and twice the same one is there again, which is a fault.
const IRREGULAR: [(usize, u32); 4] = [(0, 2), (10, 9), (20, 0), (21, 0)];
/// Where a reset comes: behind the pause, and behind the fault.
const RESETS: [usize; 2] = [12, 40];
/// Samples at rest, at the end.
const REST_SAMPLES: usize = 5;
/// A run is not longer for a block that takes its time.
const LONGEST_START: usize = 10_000;

/// The noise: an integer of 16 bits, less half of its range, times a factor. No product is above 2^31.
#[derive(Clone, Copy)]
pub(crate) struct Noise(pub(crate) u32);

impl Noise {
    pub(crate) const FACTOR: u32 = 25_173;
    pub(crate) const SUMMAND: u32 = 13_849;
    pub(crate) const RANGE: u32 = 1 << 16;
    pub(crate) const HALF: i32 = 1 << 15;
    /// Below it the number is made smaller: terms of a sum are of one size then, whatever their coefficients are.
    pub(crate) const SMALL_BELOW: u32 = 1 << 14;
    /// So much smaller.
    pub(crate) const SMALL: f32 = 1.0 / 256.0;

    fn is_small(self) -> bool {
        self.0 < Self::SMALL_BELOW
    }

    /// The next number, between -2^15 and 2^15.
    fn next(&mut self) -> i32 {
        self.0 = (self.0 * Self::FACTOR + Self::SUMMAND) % Self::RANGE;
        self.0.cast_signed() - Self::HALF
    }
}

/// Runs the reference: noise until it acts in full, then one input after the other is turned or out of range.
///
/// `state_paths` are the paths of all leaves of the reference's state; `ranges` are the noise's, each above 0; `start` is how many
/// cycles the block takes until it acts in full.
pub(crate) fn recording<R: Real, B: Block<R>>(
    coeffs: B::Coeffs,
    (program, own): (&Program, &Own),
    state_paths: &[String],
    ranges: [f64; 2],
    start: usize,
    (drill, cycle_time_ns): (&[Drill], u32),
) -> Recording {
    let (inputs, reals) = (own.signals(), own.reals());
    let position = |path: &str| program.inputs.iter().position(|input| input.path == path);
    let drill: Vec<Led> = drill
        .iter()
        .filter_map(|part| Some((position(part.input)?, part.value, part.samples.clone())))
        .filter(|(input, ..)| inputs.contains(input))
        .collect();
    // Where calls are counted, TwinCAT looks at the task if these are 0.
    let counter = position("cycle_counter").filter(|input| inputs.contains(input));
    let others = [position("task_cycle_ns"), position("reset")];
    let calls = counter.and_then(|counter| Some(Calls { counter, cycle: others[0]?, reset: others[1]? }));
    let off = program.switch.as_ref().map(|switch| (switch.input, switch.off.value()));
    let works = Works::of(program, state_paths);
    Arc::new(LazyLock::new(Box::new(move || {
        let mut usual = exercised::<R, B>(&coeffs);
        if let Some(Calls { counter, cycle, .. }) = calls {
            (usual[counter], usual[cycle]) = (Literal::U32(1), Literal::U32(cycle_time_ns));
        }
        let mut trial = plan::<R>(usual, (&inputs, reals, off), ranges, start.min(LONGEST_START), (&drill, calls));
        record::<R, B>(&mut trial, coeffs, works);
        trial
    })))
}

/// What happens when.
fn plan<R: Real>(
    usual: Vec<Literal>,
    (inputs, reals, off): (&[usize], Vec<RealInput>, Option<(usize, Literal)>),
    ranges: [f64; 2],
    start: usize,
    (drill, calls): (&[Led], Option<Calls>),
) -> Trial {
    let [quiet, loud] = ranges.map(|range| leaf(R::lit(libm::exp2(libm::floor(libm::log2(range)) - 15.0))));
    let acts_from = BEGINNING + start;
    let drill_from = acts_from + QUIET_SAMPLES;
    let loud_from = drill_from + drill.iter().map(|(.., samples)| samples.end).max().unwrap_or(0);
    let mut next = loud_from + LOUD_SAMPLES;
    let beyond = leaf(sample_limit::<R>() + sample_limit::<R>());
    let (mut turns, mut jumps) = (Vec::new(), Vec::new());
    for (input, value, samples) in drill {
        let [from, to] = [samples.start, samples.end].map(|sample| drill_from + sample);
        match value {
            Set::Real(value) => jumps.extend((from..to).map(|at| (at, *input, leaf(R::lit(*value))))),
            Set::Bool(value) => turns.push(turn(from..to, *input, Literal::Bool(*value))),
            Set::I32(value) => turns.push(turn(from..to, *input, Literal::I32(*value))),
        }
    }
    let mut add = |input, value, is_off, next: &mut usize| {
        turns.push(Turn { from: *next, to: *next + TURN_LENGTH, input, value, is_off });
        *next += TURN_DISTANCE;
    };
    let counter = calls.map(|calls| calls.counter);
    let is_switch = |input: &&usize| Some(**input) != counter && reals.iter().all(|real| real.position != **input);
    for &input in inputs.iter().filter(is_switch) {
        others(usual[input]).into_iter().for_each(|value| add(input, value, false, &mut next));
    }
    // Once more, each directly behind a fault.
    for &input in inputs.iter().filter(|input| matches!(usual[**input], Literal::Bool(_))) {
        jumps.extend(reals.first().map(|real| (next, real.position, beyond)));
        next += 1;
        others(usual[input]).into_iter().for_each(|value| add(input, value, false, &mut next));
    }
    if let Some((input, value)) = off {
        add(input, value, true, &mut next);
    }
    if let Some(Calls { counter, reset, .. }) = calls {
        for (after, more) in IRREGULAR {
            turns.push(turn(next + after..next + after + 1, counter, Literal::U32(more)));
        }
        for after in RESETS {
            turns.push(turn(next + after..next + after + 1, reset, Literal::Bool(true)));
        }
        next += RESETS[1] + TURN_DISTANCE;
    }
    let huge = sample_limit::<R>() * R::lit(0.125);
    for value in [beyond, leaf(huge), leaf(-huge)] {
        for real in &reals {
            jumps.push((next, real.position, value));
            next += JUMP_DISTANCE;
        }
    }
    // What is huge is forgotten, and then nothing moves any more.
    if let Some(input) = inputs.iter().find(|input| is_switch(input) && usual[**input] == Literal::Bool(false)) {
        turns.push(Turn { from: next, to: next + 1, input: *input, value: Literal::Bool(true), is_off: false });
    }
    Trial {
        samples: next + REST_SAMPLES,
        scales: [quiet, loud, leaf(R::ZERO)],
        part: leaf(R::lit(1.0 / f64::from(Noise::RANGE))),
        scaled_from: [loud_from, next],
        turns,
        jumps,
        compared: [BEGINNING, acts_from],
        answers: Vec::new(),
        usual,
        counter,
        reals,
    }
}

impl Trial {
    /// Whether an input is a part of something.
    pub(crate) fn has_parts(&self) -> bool {
        self.reals.iter().any(|real| real.is_fraction)
    }

    /// The inputs of every sample, in the order of all inputs.
    pub(crate) fn inputs(&self) -> Vec<Vec<Literal>> {
        let (mut noise, mut count) = (Noise(0), 0u32);
        let sample = |sample: usize| {
            let scale = self.scales[self.scaled_from.iter().filter(|from| sample >= **from).count()];
            let mut inputs = self.usual.clone();
            for real in &self.reals {
                let integer = noise.next();
                inputs[real.position] = match real.is_fraction {
                    // At first a part stays, so that the block has usual cycles.
                    true if sample < self.scaled_from[0] => self.usual[real.position],
                    true => scaled(integer + Noise::HALF, self.part, 1.0),
                    false => scaled(integer, scale, if noise.is_small() { Noise::SMALL } else { 1.0 }),
                };
            }
            for turn in self.turns.iter().filter(|turn| turn.holds(sample)) {
                inputs[turn.input] = turn.value;
            }
            for (_, real, value) in self.jumps.iter().filter(|(at, ..)| *at == sample) {
                inputs[*real] = *value;
            }
            if let Some(counter) = self.counter
                && let Literal::U32(more) = inputs[counter]
            {
                count = count.wrapping_add(more);
                inputs[counter] = Literal::U32(count);
            }
            inputs
        };
        (0..self.samples).map(sample).collect()
    }
}

impl Turn {
    fn holds(&self, sample: usize) -> bool {
        (self.from..self.to).contains(&sample)
    }
}

/// An integer of 16 bits times two powers of two: exact in both real types.
fn scaled(integer: i32, scale: Literal, small: f32) -> Literal {
    match scale {
        Literal::F64(scale) => Literal::F64(f64::from(integer) * scale * f64::from(small)),
        Literal::F32(scale) => Literal::F32(integer as f32 * scale * small),
        other => panic!("trial: {other:?} is no factor"),
    }
}

/// What shows that a block that was turned off is not at rest yet.
#[derive(Clone, Copy)]
enum Works {
    Never,
    /// a part of the state
    Fades(usize),
    /// two outputs
    Brakes {
        velocity: usize,
        state: usize,
        resting: &'static [i32],
    },
}

impl Works {
    fn of(program: &Program, state_paths: &[String]) -> Self {
        let output = |path: &str| program.outputs.iter().position(|output| output.path == path);
        let found = match program.switch.as_ref().map(|switch| &switch.off) {
            Some(Off::Mode(_, Some(fades))) => {
                state_paths.iter().position(|path| path == program.path(*fades)).map(Self::Fades)
            }
            Some(Off::Brake(Brake { velocity, state, resting })) => {
                output(velocity).zip(output(state)).map(|(velocity, state)| Self::Brakes { velocity, state, resting })
            }
            Some(Off::Mode(_, None) | Off::False) | None => None,
        };
        found.unwrap_or(Self::Never)
    }

    fn shows(self, state: &[Literal], outputs: &[Literal]) -> bool {
        match self {
            Self::Never => false,
            Self::Fades(leaf) => state[leaf] == Literal::Bool(true),
            Self::Brakes { velocity, state, resting } => {
                let stands = matches!(outputs[velocity], Literal::F64(0.0) | Literal::F32(0.0));
                let rests = matches!(outputs[state], Literal::I32(number) if resting.contains(&number));
                !(stands && rests)
            }
        }
    }
}

fn record<R: Real, B: Block<R>>(trial: &mut Trial, coeffs: B::Coeffs, works: Works) {
    let (mut run, mut outputs) = (Running::<R, B>::start(coeffs), Vec::new());
    for (sample, inputs) in trial.inputs().into_iter().enumerate() {
        run.step(&inputs, &mut outputs);
        if sample < trial.compared[0] || sample >= trial.compared[1] {
            trial.answers.push(Answer {
                sample,
                is_off: trial.turns.iter().any(|turn| turn.is_off && turn.holds(sample)),
                is_busy: works.shows(&run.state(), &outputs),
                outputs: outputs.clone(),
            });
        }
    }
}

fn turn(samples: Range<usize>, input: usize, value: Literal) -> Turn {
    Turn { from: samples.start, to: samples.end, input, value, is_off: false }
}

/// Other values of a switch; of an integer those beside it, and two far away.
pub(crate) fn others(value: Literal) -> Vec<Literal> {
    match value {
        Literal::Bool(value) => vec![Literal::Bool(!value)],
        Literal::I32(value) => [1, -1, 200, -200].map(|more| Literal::I32(value.wrapping_add(more))).into(),
        Literal::U32(value) => vec![Literal::U32(value.wrapping_add(1))],
        other => panic!("trial: {other:?} is no switch"),
    }
}
