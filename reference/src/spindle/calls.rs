//! The call rate of a spindle: an error that stays. No transition.

use super::change::lead_time;
use super::signals::Inputs;
use super::start::hold_back;
use super::state::{Coeffs, State};
use crate::angle::position_limit;
use crate::call_rate;
use crate::signal::{error_call_rate, error_none, sample_limit};
use portable::{Real, in_range, portable};

/// After a pause the commands begin at the actual state of the spindle: at its actual velocity, and at the position for
/// which the position controller has its lag. An unknown value keeps its last output. In the pause the drive kept its last
/// command: what v_actual shows beyond that is a difference of positions over the whole pause.
#[portable]
pub fn catch_up<R: Real>(state: &mut State<R>, coeffs: &Coeffs<R>, inputs: &Inputs<R>) {
    if in_range(inputs.v_actual, sample_limit()) {
        hold_back(state, inputs.v_actual);
        if in_range(inputs.x_actual, position_limit()) {
            let lead = lead_time(coeffs, inputs);
            let x_caught = inputs.x_actual + state.v * lead;
            if in_range(x_caught, position_limit()) {
                state.x = x_caught;
            }
        }
    }
}

/// Checks the call rate. While the drive is on, a pause alone is an error that stays: the motion of the spindle in the pause
/// is unknown.
#[portable]
pub fn look_at_calls<R: Real>(state: &mut State<R>, coeffs: &Coeffs<R>, inputs: &Inputs<R>) {
    if coeffs.call_rate.active {
        let has_paused = call_rate::step(&mut state.call_rate, inputs.cycle_counter);
        let is_late = has_paused && inputs.drive_on;
        if is_late {
            catch_up(state, coeffs, inputs);
        }
        if (is_late || call_rate::is_wrong(&state.call_rate, &coeffs.call_rate)) && state.lasting_error == error_none()
        {
            state.lasting_error = error_call_rate();
        }
    }
}
