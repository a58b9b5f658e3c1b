//! The drive is switched on, or is off: what the block knows of a spindle that it does not move yet, and how it takes it
//! over. A spindle that turns too fast for position control is caught: BRAKE begins at its actual velocity.

use super::change::{is_displayed, lead_time};
use super::motion::ahead;
use super::seen::{look, turns_with};
use super::signals::Inputs;
use super::state::{Coeffs, Cycle, SpindleState, State};
use crate::angle::{position_limit, wrapped};
use crate::signal::{error_none, error_to_position, error_too_fast, error_v_actual, error_x_actual};
use portable::{Real, in_range, note, portable, within};

/// The position command for this cycle with which a drive that follows it turns with v_spindle: it leads by one cycle less
/// than the command for the next cycle.
#[portable]
pub fn show<R: Real>(state: &mut State<R>, coeffs: &Coeffs<R>, inputs: &Inputs<R>) {
    let lead_shown = lead_time(coeffs, inputs) - coeffs.cycle_time;
    let x_shown = wrapped(ahead(inputs.x_actual, state.v * lead_shown));
    state.x = x_shown;
}

/// The drive is off: nothing is asked for, and what was is forgotten.
#[portable]
pub fn release<R: Real>(state: &mut State<R>, cycle: &mut Cycle<R>) {
    note("the drive is off: the start begins again");
    cycle.forgets = cycle.forgets || cycle.control != SpindleState::ToPosition || state.is_moving;
    cycle.control = SpindleState::ToPosition;
    state.catches = false;
    state.is_moving = false;
    state.takes_over = false;
}

/// Limits the velocity command to a velocity, in the same direction.
#[portable]
pub fn hold_back<R: Real>(state: &mut State<R>, v_turning: R) {
    let mut v_low = R::ZERO;
    let mut v_high = v_turning;
    if v_turning < R::ZERO {
        v_low = v_turning;
        v_high = R::ZERO;
    }
    if state.v > v_high {
        state.v = v_high;
    } else if state.v < v_low {
        state.v = v_low;
    }
}

/// The commands follow a spindle that the block does not move yet, so that the drive does not stop it with a step. If the
/// drive is on, the velocity command is that of the spindle. If it is off, the command is not faster than the spindle, and
/// `go_on` lowers it: a drive that is on after all then brakes. Position control is asked for only where both samples
/// show that it moves nothing: with an old position a drive would turn the spindle back, and a turning one would be stopped
/// with a step.
#[portable]
pub fn follow<R: Real>(
    state: &mut State<R>,
    coeffs: &Coeffs<R>,
    inputs: &Inputs<R>,
    cycle: &mut Cycle<R>,
    is_known: bool,
) {
    note("the block does not move the spindle yet: the commands follow it");
    let is_found = in_range(inputs.x_actual, position_limit());
    let mut can_hold = false;
    if is_known {
        look(&mut state.seen, coeffs, inputs.v_actual);
        let v_turning = turns_with(&state.seen, coeffs);
        cycle.v_turning = v_turning;
        if inputs.drive_on {
            state.v = v_turning;
            can_hold = is_found && within(v_turning, coeffs.v_taken_up);
        } else {
            can_hold = is_found && within(v_turning, R::ZERO);
            cycle.holds_back = true;
        }
    }
    state.asks_velocity = !(coeffs.only_position || can_hold);
    cycle.shows = is_found;
    // Without a sample of the position, a drive that is on goes on with the velocity.
    cycle.advances = inputs.drive_on;
    if !is_known && inputs.drive_on {
        cycle.sample_error = error_v_actual();
    } else if !(is_found || coeffs.only_velocity) {
        cycle.sample_error = error_x_actual();
    }
}

/// An error that stays has outlasted a drive that was off: the spindle brakes from its present velocity.
#[portable]
pub fn seize<R: Real>(state: &mut State<R>) {
    state.catches = state.asks_velocity;
    state.is_moving = true;
}

/// TO_POSITION at the start: the drive is on, and the block takes hold of the spindle. Returns whether position control begins.
/// The test of three samples takes two cycles more than a change of the mode.
#[portable]
pub fn start<R: Real>(state: &mut State<R>, coeffs: &Coeffs<R>, inputs: &Inputs<R>, cycle: &mut Cycle<R>) -> bool {
    let is_measured = state.seen.samples >= 3u32 && cycle.sample_error == error_none();
    let turns_slowly = is_measured && state.seen.slow >= 3u32;
    let mut completes = false;
    if is_measured && !within(state.v, coeffs.v_taken_up) {
        if coeffs.only_position {
            cycle.sample_error = error_too_fast();
            state.cycles = 0u32;
        } else {
            note("TO_POSITION -> BRAKE: the spindle turns too fast for position control, and is caught");
            state.catches = true;
            state.is_moving = true;
            cycle.next = SpindleState::Brake;
        }
    } else if turns_slowly && !within(state.v, R::ZERO) {
        note("TO_POSITION: the spindle turns slowly, and goes on doing so");
        cycle.resynchronises = true;
    } else {
        completes = turns_slowly && is_displayed(coeffs, inputs, coeffs.position_mode);
        if !completes && state.cycles > coeffs.start_cycles {
            state.lasting_error = error_to_position();
        }
    }
    completes
}
