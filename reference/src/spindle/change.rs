//! The change of the mode: whether the drive has done it, where position control is taken up, and what follows.

use super::motion::ahead;
use super::signals::Inputs;
use super::state::{Coeffs, Cycle, SpindleState, State};
use crate::angle::{position_limit, wrapped};
use portable::{Real, from_i32, in_range, note, portable};

/// Whether the drive displays a mode; always true for the CNC, and for a drive with only one mode.
#[portable]
pub fn is_displayed<R: Real>(coeffs: &Coeffs<R>, inputs: &Inputs<R>, mode: i32) -> bool {
    !coeffs.in_drive || coeffs.only_velocity || inputs.operation_mode_display == mode
}

/// The time by which the position command leads the actual position [s].
#[portable]
pub fn lead_time<R: Real>(coeffs: &Coeffs<R>, inputs: &Inputs<R>) -> R {
    let mut lead = coeffs.lead_time;
    let is_active = coeffs.default_active || inputs.feedforward_active;
    if coeffs.has_feedforward && is_active && inputs.feedforward_percentage > 0i32 {
        let percentage = if inputs.feedforward_percentage < 100i32 { inputs.feedforward_percentage } else { 100i32 };
        lead = coeffs.lead_time - coeffs.lead_time_per_percent * from_i32(percentage);
    }
    lead
}

/// Position control begins in the next cycle: at the actual position when the command arrives, with the lag that the
/// controller needs for this velocity.
#[portable]
pub fn resynchronise<R: Real>(state: &mut State<R>, coeffs: &Coeffs<R>, inputs: &Inputs<R>) {
    // Only a spindle without position control goes on without its position.
    let is_unknown = coeffs.only_velocity && !in_range(inputs.x_actual, position_limit());
    let x_from = if is_unknown { state.x } else { inputs.x_actual };
    let lead = lead_time(coeffs, inputs);
    let x_first = wrapped(ahead(x_from, state.v * lead));
    state.x_start = x_first;
    state.is_moving = true;
    state.catches = false;
}

/// The drive has the requested mode, or need not change it: the interpolator takes over.
#[portable]
pub fn complete<R: Real>(state: &mut State<R>, coeffs: &Coeffs<R>, cycle: &mut Cycle<R>) {
    state.takes_over = true;
    state.is_moving = true;
    if coeffs.only_velocity {
        note("TO_POSITION -> VELOCITY: the drive has no position control");
        cycle.next = SpindleState::Velocity;
    } else {
        if coeffs.in_drive {
            note("TO_POSITION -> POSITION: the drive displays position control");
        } else {
            note("TO_POSITION -> POSITION: the CNC closes its position loop");
        }
        cycle.next = SpindleState::Position;
    }
}
