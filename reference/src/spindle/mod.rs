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
pub use state::{Coeffs, Cycle, Seen, SpindleState, State, usual_none};
pub use usual::{remain_in_position, remain_in_velocity, stays_in_position, stays_in_velocity};

use crate::angle::wrapped;
use crate::call_rate;
use crate::signal::{error_cycle_time, error_none};
use calls::look_at_calls;
use change::resynchronise;
use jobs::WAITING;
use motion::{advance, slow_down};
use portable::{Block, Brake, Enable, Fn, Off, Real, portable};
use put_out::{put_out_job, put_out_mode, put_out_motion};
use seen::forget;
use start::{follow, release, seize};
use state::enter;
use transition::{brake, coast, interpolated, to_position, velocity};
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
pub fn is_at_start<R: Real>(state: &State<R>) -> bool {
    state.control == SpindleState::ToPosition && !state.is_moving
}

/// A reset: clears the waiting requests, and an error that stays.
#[portable]
pub fn reset<R: Real>(state: &mut State<R>, drive_on: bool) {
    state.queued = 0u32;
    if state.lasting_error != error_none() {
        state.lasting_error = error_none();
        state.returns = false;
        if drive_on {
            let begins = is_at_start(state);
            let mut next = SpindleState::Brake;
            if begins {
                forget(&mut state.seen);
                next = SpindleState::ToPosition;
            }
            enter(state, next);
        }
    } else if state.control == SpindleState::ToVelocity || state.control == SpindleState::Velocity {
        state.returns = true;
    }
}

/// The error of a cycle: first one that stays, then one of a sample, then one of a request.
#[portable]
pub fn error_of(lasting: u32, of_sample: u32, of_request: u32) -> u32 {
    if lasting != error_none() {
        lasting
    } else if of_sample != error_none() {
        of_sample
    } else {
        of_request
    }
}

/// The end of a cycle: the spindle coasts, or the next cycle begins in another state.
#[portable]
pub fn end<R: Real>(state: &mut State<R>, coeffs: &Coeffs<R>, inputs: &Inputs<R>, cycle: &mut Cycle) {
    if cycle.lacking != error_none() {
        coast(state, coeffs, cycle);
    }
    if cycle.resynchronises {
        resynchronise(state, coeffs, inputs, cycle);
    }
    if cycle.leaves {
        enter(state, cycle.next);
    }
}

/// Any cycle. Only the samples that the state uses are checked.
#[portable]
pub fn any_cycle<R: Real>(state: &mut State<R>, coeffs: &Coeffs<R>, inputs: &Inputs<R>, outputs: &mut Outputs<R>) {
    repair::repair(state, coeffs);
    let request_error = jobs::look(state, coeffs, inputs);
    if inputs.reset {
        reset(state, inputs.drive_on);
    }
    let is_wrong = inputs.task_cycle_ns != 0u32 && inputs.task_cycle_ns != coeffs.cycle_time_ns;
    if is_wrong && state.lasting_error == error_none() {
        state.lasting_error = error_cycle_time();
    }
    look_at_calls(state, coeffs, inputs);
    let mut cycle = Cycle::default();
    if !inputs.drive_on {
        release(state, coeffs);
    }
    outputs.spindle_state = state.control;
    let begins = is_at_start(state);
    let is_sound = state.lasting_error == error_none();
    // In the cycle in which the block takes over the spindle, the spindle keeps its velocity.
    let is_seized = inputs.drive_on && !is_sound && begins && state.cycles == 0u32;
    if begins && (!inputs.drive_on || is_sound || is_seized) {
        follow(state, coeffs, inputs, &mut cycle);
    }
    if is_seized {
        seize(state);
    } else if inputs.drive_on && is_sound {
        match state.control {
            SpindleState::Position | SpindleState::ToVelocity => interpolated(state, coeffs, inputs, &mut cycle),
            SpindleState::Velocity => velocity(state, coeffs, inputs, &mut cycle),
            SpindleState::Brake => brake(state, coeffs, inputs, &mut cycle),
            SpindleState::ToPosition => to_position(state, coeffs, inputs, &mut cycle),
        }
        end(state, coeffs, inputs, &mut cycle);
    }
    let has_failed = state.lasting_error != error_none();
    if has_failed && inputs.drive_on && !is_seized {
        slow_down(state, coeffs, R::ZERO, R::ZERO);
        advance(state, coeffs);
    }
    let x_wrapped = wrapped(state.x);
    state.x = x_wrapped;
    put_out_motion(state, coeffs, outputs);
    put_out_mode(coeffs, outputs, state.asks_velocity);
    let error_now = error_of(state.lasting_error, cycle.sample_error, request_error);
    outputs.error_id = error_now;
    outputs.fault = error_now != error_none();
    outputs.loop_closed =
        outputs.spindle_state == SpindleState::Position && !has_failed && cycle.sample_error == error_none();
    if !inputs.drive_on || inputs.reset || has_failed || state.control == SpindleState::Brake {
        jobs::stop(state);
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
    let in_position = stays_in_position(state, coeffs, inputs);
    if in_position {
        remain_in_position(state, coeffs, inputs, outputs);
    } else {
        let in_velocity = stays_in_velocity(state, coeffs, inputs);
        if in_velocity {
            remain_in_velocity(state, coeffs, inputs, outputs);
        } else {
            any_cycle(state, coeffs, inputs, outputs);
        }
    }
}

/// A spindle that is turned off brakes as after a reset, and stands still under position control.
pub const ENABLE: Enable = Enable {
    input: "reset",
    off: Off::Brake(Brake {
        velocity: "v_spindle",
        state: "spindle_state",
        resting: &[SpindleState::Position as i32, SpindleState::ToPosition as i32],
    }),
};

/// The block.
#[derive(Clone, Copy, Debug)]
pub struct Spindle;

impl<R: Real> Block<R> for Spindle {
    type Coeffs = Coeffs<R>;
    type State = State<R>;
    type Inputs = Inputs<R>;
    type Outputs = Outputs<R>;

    const NAME: &'static str = "spindle";
    const ENABLE: Option<Enable> = Some(ENABLE);
    const INIT: Fn = init::Ir::<R>::IR;
    const STEP: Fn = step::Ir::<R>::IR;

    fn is_usual_first(_: &Coeffs<R>) -> bool {
        true
    }

    fn memory() -> State<R> {
        State::default()
    }

    fn init(state: &mut State<R>) {
        init(state);
    }

    fn inputs(_: &Coeffs<R>) -> Inputs<R> {
        Inputs { feedforward_percentage: 100, ..Inputs::default() }
    }

    fn exercise(inputs: &mut Inputs<R>, coeffs: &Coeffs<R>) {
        inputs.drive_on = true;
        inputs.operation_mode_display = coeffs.position_mode;
    }

    fn outputs() -> Outputs<R> {
        Outputs::default()
    }

    fn step(state: &mut State<R>, coeffs: &Coeffs<R>, inputs: &Inputs<R>, outputs: &mut Outputs<R>) {
        step(state, coeffs, inputs, outputs);
    }
}
