//! Feedforward control: the planned velocity and acceleration go directly to the velocity and the current loop, so that no
//! position lag is needed.
//!
//! ```text
//! gain          = weight * percentage / 100 while active, else 0
//! v_feedforward = gain * (v + t_a a + t_j j)                  the quantities without an additive output
//! v_additive    = delay(gain * v)                             in um/s or 0.001 deg/s
//! torque        = torque_acceleration * delay(gain * a) + torque_jerk * delay(gain * j)
//! ```
//!
//! Positive values act in the direction of positive motion. The quantities are selected per axis when the block is generated;
//! unused ones cost nothing.

mod signals;

pub use signals::{Inputs, Outputs};

use crate::signal::{error_a_interpolator, error_call_rate, error_cycle_time, error_j_interpolator, error_none};
use crate::signal::{error_state, error_v_interpolator, sample_limit};
use crate::sum::empty_sum;
use crate::{call_rate, delay, process_data};
use portable::{Block, Enable, Off, Real, from_i32, in_range, portable};

/// The quantities of a sum.
#[portable]
#[derive(Clone, Copy, Debug, Default)]
pub struct Quantities {
    /// velocity
    pub velocity: bool,
    /// acceleration, weighted with t_a
    pub acceleration: bool,
    /// jerk, weighted with t_j
    pub jerk: bool,
}

/// Coefficients.
#[portable]
#[derive(Clone, Copy, Debug, Default)]
pub struct Coeffs<R> {
    /// cycle time that all coefficients were designed for [ns]
    pub cycle_time_ns: u32,
    /// active despite G137 (P-AXIS-00255)
    pub default_active: bool,
    /// inactive despite G135 (P-AXIS-00256)
    pub global_disable: bool,
    /// quantities of the conventional feedforward, added to the position controller's output
    pub conventional: Quantities,
    /// quantities of the additive velocity for the drive
    pub additive: Quantities,
    /// quantities of the additive torque for the drive
    pub torque: Quantities,
    /// weight of the whole feedforward at 100 %
    pub weight: R,
    /// weight / 100
    pub weight_per_percent: R,
    /// time constant of the acceleration [s]
    pub t_a: R,
    /// square of the time constant of the jerk [s^2]
    pub t_j: R,
    /// delay of the additive velocity
    pub velocity_delay: delay::Coeffs<R>,
    /// delay of the additive torque of the acceleration
    pub acceleration_delay: delay::Coeffs<R>,
    /// delay of the additive torque of the jerk
    pub jerk_delay: delay::Coeffs<R>,
    /// additive velocity: increments for 1 um/s or 0.001 deg/s
    pub velocity_scale: R,
    /// range of the additive velocity
    pub velocity_range: process_data::Coeffs<R>,
    /// additive torque: increments for 1 um/s^2 or 0.001 deg/s^2
    pub torque_acceleration: R,
    /// additive torque: increments for 1 um/s^3 or 0.001 deg/s^3
    pub torque_jerk: R,
    /// range of the additive torque
    pub torque_range: process_data::Coeffs<R>,
    /// the rate of the calls
    pub call_rate: call_rate::Coeffs,
}

/// State.
#[portable]
#[derive(Clone, Copy, Debug, Default)]
pub struct State<R> {
    /// TRUE after the delays have been filled
    pub preset: bool,
    /// delay of the additive velocity
    pub velocity_delay: delay::State<R>,
    /// delay of the additive torque of the acceleration
    pub acceleration_delay: delay::State<R>,
    /// delay of the additive torque of the jerk
    pub jerk_delay: delay::State<R>,
    /// the rate of the calls
    pub call_rate: call_rate::State,
}

/// Whether any quantity is selected.
#[portable]
pub fn has_any(quantities: &Quantities) -> bool {
    quantities.velocity || quantities.acceleration || quantities.jerk
}

/// The weight in this cycle: 0 if feedforward is not active.
#[portable]
pub fn gain<R: Real>(coeffs: &Coeffs<R>, inputs: &Inputs<R>) -> R {
    let mut gain_now = R::ZERO;
    let is_active = coeffs.default_active || inputs.feedforward_active;
    if !coeffs.global_disable && is_active && inputs.feedforward_percentage > 0i32 {
        gain_now = if inputs.feedforward_percentage >= 100i32 {
            coeffs.weight
        } else {
            coeffs.weight_per_percent * from_i32(inputs.feedforward_percentage)
        };
    }
    gain_now
}

/// v + t_a a + t_j j, with the selected quantities only.
#[portable]
pub fn sum<R: Real>(quantities: &Quantities, coeffs: &Coeffs<R>, inputs: &Inputs<R>) -> R {
    let mut v = empty_sum();
    if quantities.velocity {
        v = v + inputs.v_interpolator;
    }
    let mut v_a = v;
    if quantities.acceleration {
        v_a = v + coeffs.t_a * inputs.a_interpolator;
    }
    let mut v_a_j = v_a;
    if quantities.jerk {
        v_a_j = v_a + coeffs.t_j * inputs.j_interpolator;
    }
    v_a_j
}

/// Before the first cycle. The delays need nothing: the first active cycle fills them.
#[portable]
pub fn init<R: Real>(state: &mut State<R>) {
    state.preset = false;
    call_rate::init(&mut state.call_rate);
}

/// A cycle in which the block must not act.
#[portable]
pub fn stop<R: Real>(state: &mut State<R>, outputs: &mut Outputs<R>, error_id: u32) {
    state.preset = false;
    outputs.v_feedforward = R::ZERO;
    outputs.v_additive = R::ZERO;
    outputs.additive_velocity = 0i32;
    outputs.additive_torque = 0i32;
    outputs.velocity_limited = false;
    outputs.torque_limited = false;
    outputs.fault = error_id != error_none();
    outputs.error_id = error_id;
}

/// Fills the delays if this has not been done since the block started.
#[portable]
pub fn preset<R: Real>(state: &mut State<R>, coeffs: &Coeffs<R>, v: R, a: R, j: R) {
    if !state.preset {
        if has_any(&coeffs.additive) {
            delay::preset(&mut state.velocity_delay, v);
        }
        if coeffs.torque.acceleration {
            delay::preset(&mut state.acceleration_delay, a);
        }
        if coeffs.torque.jerk {
            delay::preset(&mut state.jerk_delay, j);
        }
        state.preset = true;
    }
}

/// A delay found a corrupted sample and returned the present one: a fault. The next cycle refills all delays.
#[portable]
pub fn start_anew<R: Real>(state: &mut State<R>, outputs: &mut Outputs<R>) {
    state.preset = false;
    outputs.fault = true;
    outputs.error_id = error_state();
}

/// The additive torque in increments, not yet rounded.
#[portable]
pub fn torque<R: Real>(state: &mut State<R>, coeffs: &Coeffs<R>, outputs: &mut Outputs<R>, a: R, j: R) -> R {
    let mut torque_a = empty_sum();
    if coeffs.torque.acceleration {
        let mut a_delayed = delay::Delayed::<R>::default();
        delay::step(&mut state.acceleration_delay, &coeffs.acceleration_delay, a, &mut a_delayed);
        torque_a = torque_a + coeffs.torque_acceleration * a_delayed.y;
        if a_delayed.overwritten {
            start_anew(state, outputs);
        }
    }
    let mut torque_a_j = torque_a;
    if coeffs.torque.jerk {
        let mut j_delayed = delay::Delayed::<R>::default();
        delay::step(&mut state.jerk_delay, &coeffs.jerk_delay, j, &mut j_delayed);
        torque_a_j = torque_a + coeffs.torque_jerk * j_delayed.y;
        if j_delayed.overwritten {
            start_anew(state, outputs);
        }
    }
    torque_a_j
}

/// A cycle in which the block acts.
#[portable]
pub fn act<R: Real>(state: &mut State<R>, coeffs: &Coeffs<R>, inputs: &Inputs<R>, outputs: &mut Outputs<R>) {
    outputs.fault = false;
    outputs.error_id = error_none();
    let gain_now = gain(coeffs, inputs);
    if has_any(&coeffs.conventional) {
        outputs.v_feedforward = gain_now * sum(&coeffs.conventional, coeffs, inputs);
    } else {
        outputs.v_feedforward = R::ZERO;
    }
    let v = gain_now * sum(&coeffs.additive, coeffs, inputs);
    let a = gain_now * inputs.a_interpolator;
    let j = gain_now * inputs.j_interpolator;
    preset(state, coeffs, v, a, j);
    if has_any(&coeffs.additive) {
        let mut v_delayed = delay::Delayed::<R>::default();
        delay::step(&mut state.velocity_delay, &coeffs.velocity_delay, v, &mut v_delayed);
        if v_delayed.overwritten {
            start_anew(state, outputs);
        }
        outputs.v_additive = v_delayed.y;
        let velocity = coeffs.velocity_scale * v_delayed.y;
        let mut datum = process_data::Datum::default();
        process_data::round(&mut datum, &coeffs.velocity_range, velocity);
        outputs.additive_velocity = datum.value;
        outputs.velocity_limited = datum.limited;
    } else {
        outputs.v_additive = R::ZERO;
        outputs.additive_velocity = 0i32;
        outputs.velocity_limited = false;
    }
    if has_any(&coeffs.torque) {
        let increments = torque(state, coeffs, outputs, a, j);
        let mut datum = process_data::Datum::default();
        process_data::round(&mut datum, &coeffs.torque_range, increments);
        outputs.additive_torque = datum.value;
        outputs.torque_limited = datum.limited;
    } else {
        outputs.additive_torque = 0i32;
        outputs.torque_limited = false;
    }
}

/// Whether a sum uses the velocity.
#[portable]
pub fn reads_velocity<R: Real>(coeffs: &Coeffs<R>) -> bool {
    coeffs.conventional.velocity || coeffs.additive.velocity
}

/// Whether a sum or the torque uses the acceleration.
#[portable]
pub fn reads_acceleration<R: Real>(coeffs: &Coeffs<R>) -> bool {
    coeffs.conventional.acceleration || coeffs.additive.acceleration || coeffs.torque.acceleration
}

/// Whether a sum or the torque uses the jerk.
#[portable]
pub fn reads_jerk<R: Real>(coeffs: &Coeffs<R>) -> bool {
    coeffs.conventional.jerk || coeffs.additive.jerk || coeffs.torque.jerk
}

/// Whether every input that is used is in range.
#[portable]
pub fn is_in_range<R: Real>(coeffs: &Coeffs<R>, inputs: &Inputs<R>) -> bool {
    (!reads_velocity(coeffs) || in_range(inputs.v_interpolator, sample_limit()))
        && (!reads_acceleration(coeffs) || in_range(inputs.a_interpolator, sample_limit()))
        && (!reads_jerk(coeffs) || in_range(inputs.j_interpolator, sample_limit()))
}

/// The id of the input that [`is_in_range`] found out of range; of several the one of the highest derivative.
#[portable]
pub fn error_of<R: Real>(coeffs: &Coeffs<R>, inputs: &Inputs<R>) -> u32 {
    if reads_jerk(coeffs) && !in_range(inputs.j_interpolator, sample_limit()) {
        error_j_interpolator()
    } else if reads_acceleration(coeffs) && !in_range(inputs.a_interpolator, sample_limit()) {
        error_a_interpolator()
    } else {
        error_v_interpolator()
    }
}

/// One cycle.
#[portable]
pub fn step<R: Real>(state: &mut State<R>, coeffs: &Coeffs<R>, inputs: &Inputs<R>, outputs: &mut Outputs<R>) {
    if coeffs.call_rate.active {
        let has_paused = call_rate::step(&mut state.call_rate, inputs.cycle_counter);
        if has_paused {
            state.preset = false;
        }
    }
    if inputs.task_cycle_ns != 0u32 && inputs.task_cycle_ns != coeffs.cycle_time_ns {
        stop(state, outputs, error_cycle_time());
    } else if call_rate::is_wrong(&state.call_rate, &coeffs.call_rate) {
        stop(state, outputs, error_call_rate());
    } else if !is_in_range(coeffs, inputs) {
        let id = error_of(coeffs, inputs);
        stop(state, outputs, id);
    } else if !inputs.position_controlled || inputs.reset {
        stop(state, outputs, error_none());
    } else {
        act(state, coeffs, inputs, outputs);
    }
}

/// The block.
#[derive(Clone, Copy, Debug)]
pub struct Feedforward;

impl<R: Real> Block<R> for Feedforward {
    types_init_and_step!(R, State<R>);

    const NAME: &'static str = "feedforward";

    fn enable(_: &Coeffs<R>) -> Option<Enable> {
        Some(Enable { input: "position_controlled", off: Off::False })
    }

    fn inputs(_: &Coeffs<R>) -> Inputs<R> {
        Inputs { feedforward_percentage: 100, position_controlled: true, ..Inputs::default() }
    }

    fn exercise(inputs: &mut Inputs<R>, _: &Coeffs<R>) {
        inputs.feedforward_active = true;
        inputs.feedforward_percentage = 87;
    }
}
