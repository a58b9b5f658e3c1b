//! A run of a block that a user can repeat on the controller. No NaN and no infinity, because some runtimes stop on them. It
//! uses only operations that every controller executes with the same bits.

use super::inputs::{Calls, Exercise, Turn};
use super::noise::Noise;
use portable::Literal;
use std::sync::Arc;

/// The events of a run.
#[derive(Clone, Debug)]
pub(crate) struct Trial {
    pub(crate) exercise: Arc<Exercise>,
    /// the first samples with the full noise, and at rest
    pub(crate) scaled_from: [usize; 2],
    /// the samples in which an input differs from its usual value
    pub(crate) turns: Vec<Turn>,
    /// the compared samples: those before the first number, and those from the second one on
    pub(crate) compared: [usize; 2],
    /// the number of samples
    pub(crate) samples: usize,
}

/// Compared samples at the beginning.
const BEGINNING: usize = 8;
/// Samples with little noise after the beginning, once the block acts in full.
const QUIET_SAMPLES: usize = 24;
/// Samples with the full noise.
const LOUD_SAMPLES: usize = 8;
const TURN_DISTANCE: usize = 5;
const TURN_LENGTH: usize = 2;
/// Distance of jumps of a real input: a block that has detected one restarts in the second sample and acts in the third.
const JUMP_DISTANCE: usize = 3;
/// Irregular calls, and the increment of the counter there: one call is missing, which is tolerated; many are missing, which
/// is a pause; and twice the counter does not change, which is a fault.
const IRREGULAR: [(usize, u32); 4] = [(0, 2), (10, 9), (20, 0), (21, 0)];
/// The samples of a reset: after the pause, and after the fault.
const RESETS: [usize; 2] = [12, 40];
/// Samples at rest, at the end.
const REST_SAMPLES: usize = 5;
/// Limit of the start phase in a run, also for a slower block.
const LONGEST_START: usize = 10_000;

/// Consecutive turns.
struct Plan {
    turns: Vec<Turn>,
    next: usize,
}

impl Plan {
    /// Adds a turn of `length` samples; the next one begins `distance` samples after it.
    fn add(&mut self, input: usize, value: Literal, length: usize, distance: usize) {
        self.turns.push(Turn::new(self.next..self.next + length, input, value));
        self.next += distance;
    }

    /// Adds a turn that lies ahead of the next ones.
    fn ahead(&mut self, after: usize, input: usize, value: Literal) {
        let at = self.next + after;
        self.turns.push(Turn::new(at..at + 1, input, value));
    }

    /// Adds the irregular calls and their resets.
    fn add_irregular(&mut self, calls: Calls) {
        IRREGULAR.iter().for_each(|(after, more)| self.ahead(*after, calls.counter, Literal::U32(*more)));
        if let Some(reset) = calls.reset {
            RESETS.iter().for_each(|after| self.ahead(*after, reset, Literal::Bool(true)));
        }
        self.next += RESETS[1] + TURN_DISTANCE;
    }
}

impl Trial {
    /// The schedule: noise until the block acts in full, its drill, then one input after the other is turned or out of
    /// range.
    pub(crate) fn of(exercise: &Arc<Exercise>) -> Self {
        let acts_from = BEGINNING + exercise.start.min(LONGEST_START);
        let drill_from = acts_from + QUIET_SAMPLES;
        let drill: Vec<Turn> = exercise.drill.iter().map(|turn| turn.later(drill_from)).collect();
        let loud_from = drill.iter().map(|turn| turn.samples.end).max().unwrap_or(drill_from);
        let mut plan = Plan { turns: drill, next: loud_from + LOUD_SAMPLES };
        let (counter, reals) = (exercise.counter(), &exercise.reals);
        let switches = exercise.switches.iter().filter(|(input, _)| Some(*input) != counter);
        let others = switches.clone().flat_map(|(input, values)| values.iter().map(|value| (*input, *value)));
        for (input, value) in others.clone() {
            plan.add(input, value, TURN_LENGTH, TURN_DISTANCE);
        }
        // The turns again, each directly after a fault.
        for (input, value) in others.filter(|(_, value)| matches!(value, Literal::Bool(_))) {
            reals.iter().take(1).for_each(|real| plan.ahead(0, real.position, exercise.beyond));
            plan.next += 1;
            plan.add(input, value, TURN_LENGTH, TURN_DISTANCE);
        }
        if let Some((input, value)) = exercise.off {
            plan.add(input, value, TURN_LENGTH, TURN_DISTANCE);
            plan.turns.iter_mut().rev().take(1).for_each(|turn| turn.is_off = true);
        }
        if let Some(calls) = exercise.calls {
            plan.add_irregular(calls);
        }
        for value in [exercise.beyond, exercise.huge[0], exercise.huge[1]] {
            reals.iter().for_each(|real| plan.add(real.position, value, 1, JUMP_DISTANCE));
        }
        // What is huge is forgotten, and then nothing moves any more.
        let is_false = |(input, _): &&(usize, _)| exercise.usual[*input] == Literal::Bool(false);
        switches.clone().find(is_false).into_iter().for_each(|(input, _)| plan.ahead(0, *input, Literal::Bool(true)));
        Self {
            exercise: exercise.clone(),
            scaled_from: [loud_from, plan.next],
            samples: plan.next + REST_SAMPLES,
            turns: plan.turns,
            compared: [BEGINNING, acts_from],
        }
    }

    /// Whether an input is a fraction from 0 to 1.
    pub(crate) fn has_parts(&self) -> bool {
        self.exercise.reals.iter().any(|real| real.is_fraction)
    }

    /// Whether the answers in a sample are compared.
    pub(crate) fn compares(&self, sample: usize) -> bool {
        sample < self.compared[0] || sample >= self.compared[1]
    }

    /// The turns that apply in a sample.
    pub(crate) fn holding(&self, sample: usize) -> impl Iterator<Item = &Turn> {
        self.turns.iter().filter(move |turn| turn.samples.contains(&sample))
    }

    /// The turns of an input, in which it has other values.
    pub(crate) fn turns_of(&self, input: usize) -> impl Iterator<Item = &Turn> {
        self.turns.iter().filter(move |turn| turn.input == input)
    }

    /// The inputs of every sample, in the order of all inputs.
    pub(crate) fn inputs(&self) -> Vec<Vec<Literal>> {
        let exercise = &*self.exercise;
        let (mut noise, mut count) = (Noise::default(), 0u32);
        let sample = |sample: usize| {
            let scale = exercise.scales[self.scaled_from.iter().filter(|from| sample >= **from).count()];
            let mut inputs = exercise.usual.clone();
            for real in &exercise.reals {
                let number = noise.next(real, [scale, exercise.part]);
                // At first a fraction is constant, so that the block has usual cycles.
                if !(real.is_fraction && sample < self.scaled_from[0]) {
                    inputs[real.position] = number;
                }
            }
            self.holding(sample).for_each(|turn| inputs[turn.input] = turn.value);
            if let Some(counter) = exercise.counter()
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
