//! A spindle changes between position control, in which it stops at an angle, and velocity control, in which it turns fast.
//!
//! ```text
//! POSITION    --- TURN faster than Von, and |v| >= Von --->  TO_VELOCITY  --- the drive says so --->  VELOCITY
//!     ^                                                                                                   |
//!     |                                                                       M19, G74, S[PUTAX], reset   |
//!     |                                                                                                   v
//!     +--------------- the drive says so ---  TO_POSITION  <--- |v_actual| has settled at Voff  ---     BRAKE
//! ```
//!
//! Positions grow in the direction of positive velocity. The outputs of a cycle follow the state at its start; a transition
//! takes effect in the next cycle.

mod calls;
mod change;
mod jobs;
mod motion;
mod put_out;
mod repair;
mod request;
mod seen;
mod signals;
mod start;
mod state;
mod transition;
mod usual;

pub use request::{Before, Job, Request};
pub use signals::{Inputs, Outputs};
pub use start::hold_back;
pub use state::{Coeffs, Cycle, Seen, SpindleState, State, usual_none};
pub use usual::{
    remain_in_brake, remain_in_position, remain_in_velocity, stays_in_brake, stays_in_position, stays_in_velocity,
};

use crate::angle::{position_limit, wrapped};
use crate::call_rate;
use crate::signal::{error_cycle_time, error_none, sample_limit};
use calls::look_at_calls;
use change::{is_displayed, resynchronise};
use jobs::WAITING;
use motion::{advance, slow_down};
use portable::{Block, Brake, Enable, Off, Real, in_range, note, portable};
use put_out::{put_out_job, put_out_mode, put_out_motion};
use seen::forget;
use start::{follow, release, seize, show};
use state::enter;
use transition::act;
use usual::next_usual;

/// Before the first cycle: an input that is already TRUE then is not a request.
#[portable]
pub fn init<R: Real>(state: &mut State<R>) {
    state.control = SpindleState::ToPosition;
    state.control_copy = SpindleState::ToPosition;
    state.cycles = 0u32;
    state.settled = 0u32;
    state.missing = 0u32;
    state.lasting_error = error_none();
    state.seen.samples = 0u32;
    state.seen.slow = 0u32;
    state.seen.v_last = R::ZERO;
    state.seen.v_before = R::ZERO;
    state.seen.v = R::ZERO;
    state.catches = false;
    state.asks_velocity = false;
    state.returns = false;
    state.is_moving = false;
    state.takes_over = false;
    state.x = R::ZERO;
    state.x_start = R::ZERO;
    state.v = R::ZERO;
    state.present.kind = Job::Stop;
    state.present.speed = R::ZERO;
    state.present.position = R::ZERO;
    state.turns_fast = false;
    state.jobs = 0u32;
    state.queued = 0u32;
    for place in 0..WAITING {
        state.request[place].kind = Job::Stop;
        state.request[place].speed = R::ZERO;
        state.request[place].position = R::ZERO;
    }
    state.before.m3 = true;
    state.before.m4 = true;
    state.before.m5 = true;
    state.before.m19 = true;
    state.before.putax = true;
    state.before.g74 = true;
    state.before.any = true;
    // The next cycle is not a usual one. The functions that begin a block have no named constants.
    state.usual = 0u32;
    call_rate::init(&mut state.call_rate);
}

/// Whether the block does not move the spindle yet: the drive is off, or has just been switched on.
#[portable]
pub fn is_at_start<R: Real>(state: &State<R>, control: SpindleState) -> bool {
    control == SpindleState::ToPosition && !state.is_moving
}

/// A reset: an error that stays is gone.
#[portable]
pub fn reset<R: Real>(state: &mut State<R>, cycle: &mut Cycle<R>, drive_on: bool) {
    if state.lasting_error != error_none() {
        note("the reset ends the error that stayed");
        state.lasting_error = error_none();
        if drive_on {
            cycle.begins = true;
            let at_start = is_at_start(state, cycle.control);
            if at_start {
                cycle.forgets = true;
            } else {
                cycle.control = SpindleState::Brake;
            }
        }
    } else if cycle.control == SpindleState::ToVelocity || cycle.control == SpindleState::Velocity {
        note("the reset leads back to position control");
        state.returns = true;
    }
}

/// The error of a cycle: first one that stays, then one of a sample, then one of a request.
#[portable]
pub fn error_of<R: Real>(state: &State<R>, of_sample: u32, of_request: u32) -> u32 {
    if state.lasting_error != error_none() {
        state.lasting_error
    } else if of_sample != error_none() {
        of_sample
    } else {
        of_request
    }
}

/// The state with which a cycle begins: what has been overwritten, a reset and the drive decide. Gives the error of the request.
#[portable]
pub fn begin<R: Real>(
    state: &mut State<R>,
    coeffs: &Coeffs<R>,
    inputs: &Inputs<R>,
    cycle: &mut Cycle<R>,
    is_job: bool,
) -> u32 {
    repair::repair(state, coeffs, inputs, cycle, is_job);
    let request_error = jobs::look(state, coeffs, inputs);
    if inputs.reset {
        reset(state, cycle, inputs.drive_on);
    }
    let is_wrong = inputs.task_cycle_ns != 0u32 && inputs.task_cycle_ns != coeffs.cycle_time_ns;
    if is_wrong && state.lasting_error == error_none() {
        state.lasting_error = error_cycle_time();
    }
    look_at_calls(state, coeffs, inputs);
    if !inputs.drive_on {
        release(state, cycle);
    }
    if inputs.reset || !inputs.drive_on {
        state.queued = 0u32;
    }
    state.control = cycle.control;
    state.control_copy = cycle.control;
    cycle.next = cycle.control;
    if cycle.begins || !inputs.drive_on {
        enter(state);
        state.returns = false;
    }
    request_error
}

/// The motion that the interpolator does not lead. The velocity command of a spindle that is stopped, or whose drive
/// is off, goes to 0. Its position command stays at the spindle, unless the drive displays position control: a drive that
/// takes up position control late, or is on after all, then brakes the spindle and does not turn it to an old position.
#[portable]
pub fn go_on<R: Real>(
    state: &mut State<R>,
    coeffs: &Coeffs<R>,
    inputs: &Inputs<R>,
    cycle: &Cycle<R>,
    is_stopped: bool,
) {
    if is_stopped || cycle.brakes || !inputs.drive_on {
        let mut v_end = R::ZERO;
        let mut v_end_negative = R::ZERO;
        if cycle.brakes {
            v_end = coeffs.v_position_control_on;
            v_end_negative = coeffs.v_position_control_on_negative;
        }
        slow_down(state, coeffs, v_end, v_end_negative);
    }
    if cycle.holds_back {
        hold_back(state, cycle.v_turning);
    }
    let is_late = is_stopped && !is_displayed(coeffs, inputs, coeffs.position_mode);
    if cycle.shows || is_late && in_range(inputs.x_actual, position_limit()) {
        show(state, coeffs, inputs);
    } else if is_stopped || cycle.advances {
        advance(state, coeffs);
    }
}

/// The state with which the next cycle begins.
#[portable]
pub fn end<R: Real>(state: &mut State<R>, coeffs: &Coeffs<R>, inputs: &Inputs<R>, cycle: &Cycle<R>) {
    if cycle.resynchronises {
        resynchronise(state, coeffs, inputs);
    }
    if cycle.resynchronises || cycle.next != state.control {
        state.control = cycle.next;
        state.control_copy = cycle.next;
        enter(state);
    }
}

/// Any cycle. Only the samples that the state uses are checked.
#[portable]
pub fn any_cycle<R: Real>(state: &mut State<R>, coeffs: &Coeffs<R>, inputs: &Inputs<R>, outputs: &mut Outputs<R>) {
    let mut cycle = Cycle::<R>::default();
    let is_job = repair::is_request(&state.present);
    let request_error = begin(state, coeffs, inputs, &mut cycle, is_job);
    outputs.spindle_state = cycle.control;
    let at_start = is_at_start(state, cycle.control);
    if at_start {
        repair::repair_seen(state, &mut cycle);
    }
    let may_act = state.lasting_error == error_none();
    // In the cycle in which the block takes over the spindle, the spindle keeps its velocity.
    let is_seized = inputs.drive_on && !may_act && at_start && state.cycles == 0u32;
    let is_followed = at_start && (!inputs.drive_on || may_act || is_seized);
    let is_known = in_range(inputs.v_actual, sample_limit());
    if cycle.forgets || is_followed && !is_known {
        forget(&mut state.seen);
    }
    if is_followed {
        follow(state, coeffs, inputs, &mut cycle, is_known);
    }
    if is_seized {
        seize(state);
    } else if inputs.drive_on && may_act {
        act(state, coeffs, inputs, &mut cycle, is_known);
    }
    let has_failed = state.lasting_error != error_none();
    go_on(state, coeffs, inputs, &cycle, has_failed && inputs.drive_on && !is_seized);
    end(state, coeffs, inputs, &cycle);
    let x_wrapped = wrapped(state.x);
    state.x = x_wrapped;
    put_out_motion(state, coeffs, outputs);
    put_out_mode(coeffs, outputs, state.asks_velocity);
    let error_now = error_of(state, cycle.sample_error, request_error);
    outputs.error_id = error_now;
    outputs.fault = error_now != error_none();
    outputs.loop_closed =
        outputs.spindle_state == SpindleState::Position && !has_failed && cycle.sample_error == error_none();
    if !is_job || !inputs.drive_on || inputs.reset || has_failed || state.control == SpindleState::Brake {
        jobs::stop(state, is_job);
    } else {
        jobs::serve(state, coeffs, inputs.job_done);
    }
    put_out_job(state, outputs);
    outputs.waiting = state.queued;
    state.usual = next_usual(state);
}

/// One cycle.
#[portable]
pub fn step<R: Real>(state: &mut State<R>, coeffs: &Coeffs<R>, inputs: &Inputs<R>, outputs: &mut Outputs<R>) {
    if stays_in_position(&*state, coeffs, inputs) {
        remain_in_position(state, coeffs, inputs, outputs);
    } else if stays_in_velocity(&*state, coeffs, inputs) {
        remain_in_velocity(state, coeffs, inputs, outputs);
    } else if stays_in_brake(&*state, coeffs, inputs) {
        remain_in_brake(state, coeffs, inputs, outputs);
    } else {
        note("any other cycle: requests, changes of the state, missing samples, errors");
        any_cycle(state, coeffs, inputs, outputs);
    }
}

/// A spindle that is turned off brakes as after a reset, and stands still under position control. A drive with velocity control
/// alone stands still in TO_POSITION, and stays there.
#[must_use]
pub fn enable(only_velocity: bool) -> Enable {
    let (position, to_position) = (&[SpindleState::Position as i32], &[SpindleState::ToPosition as i32]);
    Enable {
        input: "reset",
        off: Off::Brake(Brake {
            velocity: "v_spindle",
            state: "spindle_state",
            resting: if only_velocity { to_position } else { position },
            // With the drive on, its mode may still be velocity control.
            drive: ("drive_on", SpindleState::ToPosition as i32),
        }),
    }
}

/// The block.
#[derive(Clone, Copy, Debug)]
pub struct Spindle;

impl<R: Real> Block<R> for Spindle {
    types_init_and_step!(R, State<R>);

    const NAME: &'static str = "spindle";

    fn enable(coeffs: &Coeffs<R>) -> Option<Enable> {
        Some(enable(coeffs.only_velocity))
    }

    fn is_usual_first(_: &Coeffs<R>) -> bool {
        true
    }

    fn inputs(_: &Coeffs<R>) -> Inputs<R> {
        Inputs { feedforward_percentage: 100, ..Inputs::default() }
    }

    fn exercise(inputs: &mut Inputs<R>, coeffs: &Coeffs<R>) {
        inputs.drive_on = true;
        inputs.operation_mode_display = coeffs.position_mode;
    }
}
