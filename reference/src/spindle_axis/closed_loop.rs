//! The closed position loop: the lag of the spindle in the CNC, and the axis that acts on it.

use super::held;
use super::put_out::{put_out, tell_trip};
use super::signals::{Inputs, Outputs};
use super::state::{Coeffs, State};
use crate::angle::{certain, full_turn, half_turn, is_certain, shortest};
use crate::axis;
use crate::position_control::Location;
use crate::signal::{error_lag, error_none, sample_limit};
use crate::spindle::{self, SpindleState};
use portable::{Real, copy, from_u32, in_range, note, portable, within};

/// largest position lag of a loop in the CNC: above half a turn the loop would turn the spindle the other way [0.001 deg]
#[portable]
pub fn lag_limit<R: Real>() -> R {
    R::lit(170_000.0)
}

/// The lag that continues from the previous one: beyond half a turn the shortest way would turn the spindle back. `missed`
/// samples were missing, after the velocity `v_missed`: meanwhile the lag of a spindle that follows has not grown, and that of a
/// blocked one by the whole way.
#[portable]
pub fn continued<R: Real>(state: &State<R>, coeffs: &Coeffs<R>, difference: R, missed: u32, v_missed: R) -> R {
    let mut lag = if within(difference, half_turn()) { difference } else { shortest(difference) };
    if in_range(state.lag_before, lag_limit()) {
        let mut expected = state.lag_before;
        if missed > 0u32 {
            if in_range(v_missed, sample_limit()) {
                let half_cycles = from_u32::<R>(missed + 1u32) * R::lit(0.5);
                expected = expected + v_missed * (coeffs.spindle.cycle_time * half_cycles);
            } else {
                note("reached only if the block's memory was corrupted");
            }
        }
        let lag_step = lag - expected;
        if lag_step > half_turn() {
            lag = lag - full_turn();
        } else if lag_step < -half_turn::<R>() {
            lag = lag + full_turn();
        }
    } else {
        note("reached only if the block's memory was corrupted");
    }
    lag
}

/// The lag in any cycle. `missed` samples were missing before it, after the velocity `v_missed`.
#[portable]
pub fn lag_of<R: Real>(
    state: &State<R>,
    coeffs: &Coeffs<R>,
    inputs: &Inputs<R>,
    x_spindle: R,
    missed: u32,
    v_missed: R,
) -> R {
    if missed == 0u32 && is_certain(x_spindle, inputs.x_actual) {
        certain(x_spindle - inputs.x_actual)
    } else {
        continued(state, coeffs, x_spindle - inputs.x_actual, missed, v_missed)
    }
}

/// The lag is near half a turn: the error stays, the loop opens in the next cycle, and the spindle brakes.
#[portable]
pub fn give_up<R: Real>(state: &mut State<R>, coeffs: &Coeffs<R>, outputs: &mut Outputs<R>) {
    let v_whole = held::whole(&state.held, coeffs);
    spindle::hold_back(&mut state.spindle, v_whole);
    state.spindle.lasting_error = error_lag();
    state.spindle.usual = spindle::usual_none();
    outputs.error_id = error_lag();
    outputs.fault = true;
}

/// The axis follows the spindle's commands.
#[portable]
pub fn act<R: Real>(
    state: &mut State<R>,
    coeffs: &Coeffs<R>,
    inputs: &Inputs<R>,
    spindle_outputs: &spindle::Outputs<R>,
    axis_outputs: &mut axis::Outputs<R>,
    lag: R,
) {
    let mut axis_inputs = axis::Inputs::<R>::default();
    axis_inputs.x_command = spindle_outputs.x_spindle;
    if coeffs.axis.position_control.location == Location::Cnc {
        state.lag_before = lag;
        axis_inputs.following_error = lag;
        axis_inputs.x_actual = spindle_outputs.x_spindle - lag;
    }
    axis_inputs.v_interpolator = spindle_outputs.v_spindle;
    if spindle_outputs.spindle_state != SpindleState::ToPosition {
        copy!(axis_inputs = inputs: a_interpolator, j_interpolator);
    }
    copy!(axis_inputs = inputs:
        v_motor, v_direct, tuning_weight, tuning_limit, mode, feedforward_active, feedforward_percentage);
    // A reset ends what is added, as everywhere; the position loop still holds the spindle.
    let improves = spindle_outputs.loop_closed && !inputs.reset;
    let v_additive = axis::act(&mut state.axis, &coeffs.axis, &axis_inputs, axis_outputs, improves);
    held::keep(&mut state.held, coeffs, axis_outputs.v_command, v_additive);
}

/// Under position control: the axis acts.
#[portable]
pub fn close<R: Real>(
    state: &mut State<R>,
    coeffs: &Coeffs<R>,
    inputs: &Inputs<R>,
    spindle_outputs: &spindle::Outputs<R>,
    outputs: &mut Outputs<R>,
    lag: R,
) {
    let mut axis_outputs = axis::Outputs::<R>::default();
    act(state, coeffs, inputs, spindle_outputs, &mut axis_outputs, lag);
    put_out(coeffs, spindle_outputs, &axis_outputs, outputs);
    let error_now = if axis_outputs.fault { axis_outputs.error_id } else { spindle_outputs.error_id };
    outputs.error_id = error_now;
    outputs.fault = error_now != error_none();
    if coeffs.axis.ipc.tuning.active && error_now == error_none() {
        note("not a fault: a tuning input is invalid, its last valid value stays active");
        outputs.error_id = axis_outputs.error_id;
    }
    tell_trip(coeffs, &axis_outputs, outputs);
}
