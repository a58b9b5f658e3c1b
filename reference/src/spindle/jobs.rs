//! The jobs of a spindle: requests are taken, wait in programmed order, and are served. No motion.

use super::signals::Inputs;
use super::{Cycle, State};
use crate::angle::position_limit;
use crate::signal::{error_direction, error_requests, error_s_position, error_s_word, error_waiting, sample_limit};
use portable::{Real, in_range, portable};

/// How many requests may wait.
const WAITING: usize = 4;

/// What the interpolator has to do.
#[portable]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Job {
    /// M5, and what stops the spindle otherwise
    #[default]
    Stop,
    /// M3 or M4
    Turn,
    /// M19
    Position,
    /// S[PUTAX]
    Release,
    /// G74
    Home,
}

/// A job with what belongs to it.
#[portable]
#[derive(Clone, Copy, Debug, Default)]
pub struct Request<R> {
    /// what to do
    pub kind: Job,
    /// how fast, below 0 in negative direction [0.001 deg/s]
    pub speed: R,
    /// where to [0.001 deg]
    pub position: R,
}

/// Which request inputs were TRUE in the last cycle.
#[portable]
#[derive(Clone, Copy, Debug, Default)]
pub struct Before {
    /// turn in positive direction
    pub m3: bool,
    /// turn in negative direction
    pub m4: bool,
    /// stop
    pub m5: bool,
    /// stop at a position
    pub m19: bool,
    /// give the axis away
    pub putax: bool,
    /// homing
    pub g74: bool,
}

/// Takes the request of this cycle, if there is one: G74 before S[PUTAX] before M19 before M5 before M3 and M4.
#[portable]
pub fn take<R: Real>(state: &mut State<R>, inputs: &Inputs<R>, cycle: &mut Cycle) {
    let new_m19 = inputs.m19 && !state.before.m19;
    // With M19, M3 and M4 are its direction.
    let new_turn = !new_m19 && (inputs.m3 && !state.before.m3 || inputs.m4 && !state.before.m4);
    let new_m5 = inputs.m5 && !state.before.m5;
    let new_putax = inputs.putax && !state.before.putax;
    let new_g74 = inputs.g74 && !state.before.g74;
    state.before.m3 = inputs.m3;
    state.before.m4 = inputs.m4;
    state.before.m5 = inputs.m5;
    state.before.m19 = inputs.m19;
    state.before.putax = inputs.putax;
    state.before.g74 = inputs.g74;
    if !inputs.reset && (new_g74 || new_putax || new_m19 || new_m5 || new_turn) {
        let mut job = Job::Turn;
        let mut is_alone = true;
        if new_g74 {
            job = Job::Home;
            is_alone = !(new_putax || new_m19 || new_m5 || new_turn);
        } else if new_putax {
            job = Job::Release;
            is_alone = !(new_m19 || new_m5 || new_turn);
        } else if new_m19 {
            job = Job::Position;
            is_alone = !new_m5;
        } else if new_m5 {
            job = Job::Stop;
            is_alone = !new_turn;
        }
        if !is_alone {
            cycle.error_id = error_requests();
        }
        let is_moving = job == Job::Turn || job == Job::Position;
        if is_moving && inputs.m3 && inputs.m4 {
            cycle.error_id = error_direction();
        } else if is_moving && !in_range(inputs.s_word, sample_limit()) {
            cycle.error_id = error_s_word();
        } else if job == Job::Position && !in_range(inputs.s_position, position_limit()) {
            cycle.error_id = error_s_position();
        } else if state.waiting >= 4u32 {
            cycle.error_id = error_waiting();
        } else {
            let mut speed = R::ZERO;
            if is_moving {
                let magnitude = if inputs.s_word < R::ZERO { -inputs.s_word } else { inputs.s_word };
                speed = if inputs.m4 { -magnitude } else { magnitude };
            }
            let mut position = R::ZERO;
            if job == Job::Position {
                position = inputs.s_position;
            }
            match state.waiting {
                0u32 => fill(&mut state.request[0], job, speed, position),
                1u32 => fill(&mut state.request[1], job, speed, position),
                2u32 => fill(&mut state.request[2], job, speed, position),
                _ => fill(&mut state.request[3], job, speed, position),
            }
            state.waiting += 1u32;
        }
    }
}

/// Writes down a request.
#[portable]
pub fn fill<R: Real>(request: &mut Request<R>, job: Job, speed: R, position: R) {
    request.kind = job;
    request.speed = speed;
    request.position = position;
}

/// Whether a job needs no position control.
#[portable]
pub fn is_free<R: Real>(request: &Request<R>) -> bool {
    request.kind == Job::Stop || request.kind == Job::Turn
}

/// The first request that waits becomes the job, if the present one is over.
#[portable]
pub fn serve<R: Real>(state: &mut State<R>, job_done: bool) {
    let is_over = is_free(&state.job) || job_done;
    if is_over && state.waiting > 0u32 {
        state.job.kind = state.request[0].kind;
        state.job.speed = state.request[0].speed;
        state.job.position = state.request[0].position;
        for place in 1..WAITING {
            state.request[place - 1].kind = state.request[place].kind;
            state.request[place - 1].speed = state.request[place].speed;
            state.request[place - 1].position = state.request[place].position;
        }
        state.waiting -= 1u32;
        state.job_number += 1u32;
    }
}

/// The job ends: STOP begins, unless it is the job already.
#[portable]
pub fn stop<R: Real>(state: &mut State<R>) {
    if state.job.kind != Job::Stop {
        state.job.kind = Job::Stop;
        state.job.speed = R::ZERO;
        state.job.position = R::ZERO;
        state.job_number += 1u32;
    }
}
