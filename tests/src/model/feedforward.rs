//! The block `feedforward` in exact numbers: the gain, the sums, the delays. Nothing of position control.

use super::calls::Calls;
use super::coefficients::{Coefficients, Delay, Terms};
use super::exact::Exact;
use super::history::Inputs;
use super::parameters::Parameters;
use super::rounding::{Expected, data, flag, id, real};
use std::collections::VecDeque;

/// Samples that a delay keeps: below six cycles, and one more to interpolate.
const SAMPLES: usize = 7;

/// What it remembers: the weighted quantities of the last cycles, for v, a, j.
#[derive(Clone, Debug, Default)]
pub struct Feedforward {
    delayed: [VecDeque<Exact>; 3],
}

/// What it puts out, before it is rounded to process data.
#[derive(Clone, Debug)]
pub struct Planned {
    /// conventional feedforward
    pub v_feedforward: Exact,
    /// weighted and delayed, not yet scaled
    pub v_additive: Exact,
    /// in increments, not yet rounded
    pub torque: Exact,
    /// 0, 14, 15, 16
    pub bad: u32,
}

impl Planned {
    fn nothing(bad: u32) -> Self {
        Self { v_feedforward: Exact::zero(), v_additive: Exact::zero(), torque: Exact::zero(), bad }
    }
}

impl Feedforward {
    /// One cycle; `stopped`: every output is 0, and the delays are filled anew afterwards.
    pub fn cycle(&mut self, c: &Coefficients, inputs: &Inputs, stopped: bool) -> Planned {
        let planned = [inputs.v_interpolator, inputs.a_interpolator, inputs.j_interpolator];
        let read = |i: usize| [&c.conventional, &c.additive, &c.torque].iter().any(|terms| terms[i].is_some());
        // The highest derivative is named.
        let bad = (0..3).rfind(|i| read(*i) && !is_in_range(c, planned[*i])).map_or(0, |i| [14, 15, 16][i]);
        if stopped || bad != 0 {
            *self = Self::default();
            return Planned::nothing(bad);
        }
        let gain = gain(c, inputs);
        let sum = |terms: &Terms| {
            let given = |i: usize| terms[i].as_ref().map(|factor| factor.times(&Exact::given(planned[i])));
            (0..3).filter_map(given).reduce(|sum, term| sum.plus(&term)).map(|sum| sum.times(&gain))
        };
        let v_additive = sum(&c.additive);
        let [acceleration, jerk] = [1, 2].map(|i| {
            let factor = c.torque[i].as_ref()?;
            Some((factor, gain.times(&Exact::given(planned[i]))))
        });
        let [of_v, of_a, of_j] = &mut self.delayed;
        let torque = [(acceleration, of_a, &c.delays[1]), (jerk, of_j, &c.delays[2])]
            .into_iter()
            .filter_map(|(term, kept, delay)| term.map(|(factor, x)| factor.times(&delayed(kept, delay, x))))
            .reduce(|sum, term| sum.plus(&term));
        Planned {
            v_feedforward: sum(&c.conventional).unwrap_or_else(Exact::zero),
            v_additive: v_additive.map_or_else(Exact::zero, |x| delayed(of_v, &c.delays[0], x)),
            torque: torque.unwrap_or_else(Exact::zero),
            bad,
        }
    }
}

/// The block that stands alone.
#[derive(Clone, Debug, Default)]
pub struct Alone(Feedforward, Calls);

impl Alone {
    /// One cycle: what each output may be.
    pub fn cycle(&mut self, p: &Parameters, c: &Coefficients, inputs: &Inputs) -> Expected {
        let calls = self.1.call(p.counts_calls, inputs.cycle_counter);
        if calls.restarts {
            self.0 = Feedforward::default();
        }
        let wrong_cycle = is_wrong_cycle(c, inputs);
        let stopped = wrong_cycle || calls.is_fault || inputs.reset || !inputs.position_controlled;
        let planned = self.0.cycle(c, inputs, stopped);
        let velocity = match &c.velocity {
            Some((scale, bits)) if c.additive.iter().any(Option::is_some) => {
                data(&scale.times(&planned.v_additive), c.u, *bits)
            }
            _ => data(&Exact::zero(), c.u, 32),
        };
        let torque = data(&planned.torque, c.u, c.torque_bits.unwrap_or(32));
        let error_id = match (wrong_cycle, calls.is_fault) {
            (true, _) => 1,
            (_, true) => 9,
            _ => planned.bad,
        };
        vec![
            ("v_feedforward", real(&planned.v_feedforward, c.u)),
            ("v_additive", real(&planned.v_additive, c.u)),
            ("additive_velocity", velocity.value),
            ("additive_torque", torque.value),
            ("velocity_limited", velocity.limited),
            ("torque_limited", torque.limited),
            ("fault", flag(error_id != 0)),
            ("error_id", id(error_id)),
        ]
    }
}

/// W p/100 while active, else 0.
fn gain(c: &Coefficients, inputs: &Inputs) -> Exact {
    let active = (inputs.feedforward_active || c.always) && !c.never;
    match inputs.feedforward_percentage.clamp(0, 100).unsigned_abs() {
        _ if !active => Exact::zero(),
        percent => c.weight.times(&Exact::ratio(percent, 100)),
    }
}

/// y[n] = (1-f) x[n-N] + f x[n-N-1]; the first x fills all.
fn delayed(kept: &mut VecDeque<Exact>, delay: &Delay, x: Exact) -> Exact {
    if kept.is_empty() {
        kept.extend(std::iter::repeat_n(x.clone(), SAMPLES));
    }
    kept.pop_back();
    kept.push_front(x);
    match &delay.parts {
        None => kept[delay.whole].clone(),
        Some([newer, older]) => newer.times(&kept[delay.whole]).plus(&older.times(&kept[delay.whole + 1])),
    }
}

/// Whether a real input is a number in range.
#[must_use]
pub fn is_in_range(c: &Coefficients, value: f64) -> bool {
    value.abs() <= c.largest
}

/// Whether the caller's cycle is another one than designed for; 0 is unchecked.
#[must_use]
pub fn is_wrong_cycle(c: &Coefficients, inputs: &Inputs) -> bool {
    inputs.task_cycle_ns != 0 && inputs.task_cycle_ns != c.cycle_ns
}
