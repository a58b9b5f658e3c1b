//! The jobs of a spindle: requests are taken, wait in programmed order, and are served. No motion.

use super::repair::is_request;
use super::request::{Job, Request};
use super::signals::Inputs;
use super::state::{Coeffs, SpindleState, State};
use crate::angle::position_limit;
use crate::signal::{
    error_direction, error_drive_off, error_none, error_only_velocity, error_requests, error_s_position, error_s_word,
    error_waiting, sample_limit,
};
use portable::{Real, copy, in_range, note, portable};

/// How many requests may wait.
pub(super) const WAITING: usize = 4;

/// The direction and the speed of a request to turn.
#[portable]
pub fn speed_of<R: Real>(inputs: &Inputs<R>) -> R {
    let is_negative = inputs.s_word < R::ZERO;
    if is_negative == inputs.m4 { inputs.s_word } else { -inputs.s_word }
}

/// The reason why a request is refused.
#[portable]
pub fn refusal<R: Real>(state: &State<R>, coeffs: &Coeffs<R>, inputs: &Inputs<R>, wanted: Job) -> u32 {
    let has_speed = wanted == Job::Turn || wanted == Job::Orient;
    if has_speed && inputs.m3 && inputs.m4 {
        error_direction()
    } else if has_speed && !in_range(inputs.s_word, sample_limit()) {
        error_s_word()
    } else if wanted == Job::Orient && !in_range(inputs.s_position, position_limit()) {
        error_s_position()
    } else if coeffs.only_velocity && wanted != Job::Turn && wanted != Job::Stop {
        error_only_velocity()
    } else if !inputs.drive_on {
        error_drive_off()
    } else if state.queued >= 4u32 {
        error_waiting()
    } else {
        error_none()
    }
}

/// Takes the request of this cycle: G74 before S[PUTAX] before M19 before M5 before M3 and M4. Returns the error.
#[portable]
pub fn take<R: Real>(state: &mut State<R>, coeffs: &Coeffs<R>, inputs: &Inputs<R>) -> u32 {
    let new_m19 = inputs.m19 && !state.before.m19;
    // M3 or M4 together with M19 only gives its direction.
    let new_turn = !new_m19 && (inputs.m3 && !state.before.m3 || inputs.m4 && !state.before.m4);
    let new_m5 = inputs.m5 && !state.before.m5;
    let new_putax = inputs.putax && !state.before.putax;
    let new_g74 = inputs.g74 && !state.before.g74;
    copy!(state.before = inputs: m3, m4, m5, m19, putax, g74);
    let mut error_taken = error_none();
    if !inputs.reset && (new_g74 || new_putax || new_m19 || new_m5 || new_turn) {
        let mut wanted = Job::Turn;
        let mut has_others = false;
        if new_g74 {
            wanted = Job::Home;
            has_others = new_putax || new_m19 || new_m5 || new_turn;
        } else if new_putax {
            wanted = Job::Release;
            has_others = new_m19 || new_m5 || new_turn;
        } else if new_m19 {
            wanted = Job::Orient;
            has_others = new_m5;
        } else if new_m5 {
            wanted = Job::Stop;
            has_others = new_turn;
        }
        let why = refusal(state, coeffs, inputs, wanted);
        if why != error_none() {
            error_taken = why;
        } else {
            let speed = if wanted == Job::Turn || wanted == Job::Orient { speed_of(inputs) } else { R::ZERO };
            let target = if wanted == Job::Orient { inputs.s_position } else { R::ZERO };
            match state.queued {
                0u32 => fill(&mut state.request[0], wanted, speed, target),
                1u32 => fill(&mut state.request[1], wanted, speed, target),
                2u32 => fill(&mut state.request[2], wanted, speed, target),
                _ => fill(&mut state.request[3], wanted, speed, target),
            }
            state.queued += 1u32;
            error_taken = if has_others { error_requests() } else { error_none() };
        }
    }
    error_taken
}

/// Takes the request of this cycle, if there is one. Returns the error.
#[portable]
pub fn look<R: Real>(state: &mut State<R>, coeffs: &Coeffs<R>, inputs: &Inputs<R>) -> u32 {
    let is_any = inputs.m3 || inputs.m4 || inputs.m5 || inputs.m19 || inputs.putax || inputs.g74;
    let mut request_error = error_none();
    // In most cycles there is no request, now or in the previous cycle.
    if is_any || state.before.any {
        note("requests: each counts in the cycle in which its input becomes TRUE");
        request_error = take(state, coeffs, inputs);
        state.before.any = is_any;
    }
    request_error
}

/// Fills in a request.
#[portable]
pub fn fill<R: Real>(request: &mut Request<R>, wanted: Job, speed: R, target: R) {
    request.kind = wanted;
    request.speed = speed;
    request.position = target;
}

/// Whether a job needs no position control.
#[portable]
pub fn is_free<R: Real>(request: &Request<R>) -> bool {
    request.kind == Job::Stop || request.kind == Job::Turn
}

/// The first waiting request becomes the job, if the present one is finished and the state of the next cycle permits it.
#[portable]
pub fn serve<R: Real>(state: &mut State<R>, coeffs: &Coeffs<R>, job_done: bool) {
    if state.queued > 0u32 {
        let is_over = is_free(&state.present) || job_done;
        let can_serve = state.control == SpindleState::Position
            || state.control == SpindleState::Velocity && !state.returns && is_free(&state.request[0]);
        if is_over && can_serve {
            next(state, coeffs);
        }
    }
}

/// The first waiting request becomes the job.
#[portable]
pub fn next<R: Real>(state: &mut State<R>, coeffs: &Coeffs<R>) {
    let is_intact = is_request(&state.request[0]);
    if !is_intact {
        note("the request was corrupted");
        fill(&mut state.request[0], Job::Stop, R::ZERO, R::ZERO);
    }
    let is_fast =
        state.request[0].speed > coeffs.v_velocity_control_on || -state.request[0].speed > coeffs.v_velocity_control_on;
    state.turns_fast = state.request[0].kind == Job::Turn && is_fast;
    state.present = state.request[0];
    for place in 1..WAITING {
        state.request[place - 1] = state.request[place];
    }
    state.queued -= 1u32;
    state.jobs = if state.jobs < u32::MAX { state.jobs + 1u32 } else { 0u32 };
}

/// The job ends: STOP begins, unless it is the job already. So does a job that something has overwritten.
#[portable]
pub fn stop<R: Real>(state: &mut State<R>, is_job: bool) {
    if state.present.kind != Job::Stop || !is_job {
        state.turns_fast = false;
        state.present.kind = Job::Stop;
        state.present.speed = R::ZERO;
        state.present.position = R::ZERO;
        state.jobs = if state.jobs < u32::MAX { state.jobs + 1u32 } else { 0u32 };
    }
}
