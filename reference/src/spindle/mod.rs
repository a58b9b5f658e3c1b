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
//! Positions grow with positive velocities. What a cycle puts out follows the state with which it began; a transition acts from the
//! next cycle on.

mod jobs;
mod motion;
mod signals;
mod transition;

pub use jobs::{Before, Job, Request};
pub use signals::{Inputs, Outputs};

use crate::angle::wrapped;
use crate::process_data;
use crate::signal::{error_cycle_time, error_none};
use motion::{advance, follow, slow_down};
use portable::{Block, Enable, Fn, Real, portable};
use transition::{brake, position, to_position, to_velocity, velocity};

/// What controls the spindle.
#[portable]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum SpindleState {
    /// position control
    Position,
    /// velocity control is asked for
    ToVelocity,
    /// velocity control
    Velocity,
    /// velocity control, on the way to the velocity at which position control is taken up
    Brake,
    /// position control is asked for
    #[default]
    ToPosition,
}

/// Coefficients.
#[portable]
#[derive(Clone, Copy, Debug, Default)]
pub struct Coeffs<R> {
    /// cycle time that all coefficients were designed for [ns]
    pub cycle_time_ns: u32,
    /// cycle time T [s]
    pub cycle_time: R,
    /// whether the drive controls the position, and is told its mode
    pub in_drive: bool,
    /// Von: a faster TURN leads to velocity control [0.001 deg/s]
    pub v_velocity_control_on: R,
    /// Voff: position control is taken up there [0.001 deg/s]
    pub v_position_control_on: R,
    /// -Voff [0.001 deg/s]
    pub v_position_control_on_negative: R,
    /// by which |v_actual| is above |v_spindle| at most where position control is taken up [0.001 deg/s]
    pub window: R,
    /// deceleration * T: largest change of the velocity in a cycle [0.001 deg/s]
    pub v_step: R,
    /// 180 deg / T: from here on the drive cannot tell the direction [0.001 deg/s]
    pub v_half_turn: R,
    /// the position command leads x_actual by the way of this time: (Nd + 1) T + (1 - w) / Kv, in the CNC T + 1 / Kv [s]
    pub lead_time: R,
    /// whether the CNC's feedforward shortens that time
    pub has_feedforward: bool,
    /// whether the feedforward is active despite G137 (P-AXIS-00255)
    pub default_active: bool,
    /// by which each percent of the feedforward does [s]
    pub lead_time_per_percent: R,
    /// largest step of the position command where the interpolator takes over [0.001 deg]
    pub takeover_window: R,
    /// cycles within which the drive displays a new mode
    pub mode_cycles: u32,
    /// cycles within which the spindle has braked
    pub brake_cycles: u32,
    /// operation mode of position control
    pub position_mode: i32,
    /// operation mode of velocity control
    pub velocity_mode: i32,
    /// velocity command: increments for 0.001 deg/s
    pub velocity_scale: R,
    /// range of the velocity command
    pub velocity_range: process_data::Coeffs<R>,
}

/// State.
#[portable]
#[derive(Clone, Copy, Debug, Default)]
pub struct State<R> {
    /// what controls the spindle
    pub control: SpindleState,
    /// cycles in this state, this one included
    pub cycles: u32,
    /// cycles in which v_actual has been settled
    pub settled: u32,
    /// cycles in which a sample has been missing
    pub missing: u32,
    /// an error that stays until reset
    pub lasting_error: u32,
    /// whether velocity control is asked for
    pub asks_velocity: bool,
    /// whether a reset leads back to position control
    pub returns: bool,
    /// whether position control is taken up at x_start; else x follows the actual position
    pub is_moving: bool,
    /// whether the interpolator has to go on from x
    pub takes_over: bool,
    /// the position command [0.001 deg]
    pub x: R,
    /// where position control is taken up [0.001 deg]
    pub x_start: R,
    /// the velocity command [0.001 deg/s]
    pub v: R,
    /// the job
    pub present: Request<R>,
    /// how many jobs there were
    pub jobs: u32,
    /// how many requests wait
    pub queued: u32,
    /// the requests that wait, the first one first
    pub request: [Request<R>; 4],
    /// the request inputs of the last cycle
    pub before: Before,
}

/// What is found in one cycle.
#[portable]
#[derive(Clone, Copy, Debug, Default)]
pub struct Cycle {
    /// of a sample that is needed and out of range
    pub sample_error: u32,
}

/// Before the first cycle: a request that is TRUE then is none.
#[portable]
pub fn init<R: Real>(state: &mut State<R>) {
    state.control = SpindleState::ToPosition;
    state.cycles = 0u32;
    state.settled = 0u32;
    state.missing = 0u32;
    state.lasting_error = error_none();
    state.asks_velocity = false;
    state.returns = false;
    state.is_moving = false;
    state.takes_over = false;
    state.x = R::ZERO;
    state.v = R::ZERO;
    state.present.kind = Job::Stop;
    state.present.speed = R::ZERO;
    state.present.position = R::ZERO;
    state.jobs = 0u32;
    state.queued = 0u32;
    state.before.m3 = true;
    state.before.m4 = true;
    state.before.m5 = true;
    state.before.m19 = true;
    state.before.putax = true;
    state.before.g74 = true;
}

/// The next cycle begins in another state.
#[portable]
pub fn enter<R: Real>(state: &mut State<R>, next: SpindleState) {
    state.control = next;
    state.cycles = 0u32;
    state.settled = 0u32;
    state.missing = 0u32;
}

/// A reset: nothing waits any more, and an error that stays is gone.
#[portable]
pub fn reset<R: Real>(state: &mut State<R>, drive_on: bool) {
    state.queued = 0u32;
    if state.lasting_error != error_none() {
        state.lasting_error = error_none();
        state.returns = false;
        if drive_on {
            enter(state, SpindleState::Brake);
        }
    } else if state.control == SpindleState::ToVelocity || state.control == SpindleState::Velocity {
        state.returns = true;
    }
}

/// What the drive gets.
#[portable]
pub fn command<R: Real>(state: &State<R>, coeffs: &Coeffs<R>, outputs: &mut Outputs<R>) {
    outputs.x_spindle = state.x;
    outputs.v_spindle = state.v;
    if coeffs.in_drive {
        outputs.operation_mode = if state.asks_velocity { coeffs.velocity_mode } else { coeffs.position_mode };
        let mut datum = process_data::Datum::default();
        let increments = coeffs.velocity_scale * state.v;
        process_data::round(&mut datum, &coeffs.velocity_range, increments);
        outputs.velocity_command = datum.value;
        outputs.limited = datum.limited;
    } else {
        outputs.operation_mode = 0i32;
        outputs.velocity_command = 0i32;
        outputs.limited = false;
    }
}

/// The error of a cycle: one that stays before one of a sample, before one of a request.
#[portable]
pub fn error_of(lasting_error: u32, sample_error: u32, request_error: u32) -> u32 {
    if lasting_error != error_none() {
        lasting_error
    } else if sample_error != error_none() {
        sample_error
    } else {
        request_error
    }
}

/// One cycle. Only the samples that the state uses are checked.
#[portable]
pub fn step<R: Real>(state: &mut State<R>, coeffs: &Coeffs<R>, inputs: &Inputs<R>, outputs: &mut Outputs<R>) {
    let request_error = jobs::take(state, inputs);
    if inputs.reset {
        reset(state, inputs.drive_on);
    }
    let is_wrong = inputs.task_cycle_ns != 0u32 && inputs.task_cycle_ns != coeffs.cycle_time_ns;
    if is_wrong && state.lasting_error == error_none() {
        state.lasting_error = error_cycle_time();
    }
    if !inputs.drive_on {
        enter(state, SpindleState::ToPosition);
    }
    outputs.spindle_state = state.control;
    let mut cycle = Cycle::default();
    if !inputs.drive_on {
        follow(state, inputs, &mut cycle);
    } else if state.lasting_error == error_none() {
        state.cycles += 1u32;
        match state.control {
            SpindleState::Position => position(state, coeffs, inputs, &mut cycle),
            SpindleState::ToVelocity => to_velocity(state, coeffs, inputs, &mut cycle),
            SpindleState::Velocity => velocity(state, coeffs, inputs, &mut cycle),
            SpindleState::Brake => brake(state, coeffs, inputs, &mut cycle),
            SpindleState::ToPosition => to_position(state, coeffs, inputs, &mut cycle),
        }
    }
    let has_failed = state.lasting_error != error_none();
    if has_failed && inputs.drive_on {
        slow_down(state, coeffs, R::ZERO, R::ZERO);
        advance(state, coeffs);
    }
    let x_wrapped = wrapped(state.x);
    state.x = x_wrapped;
    command(state, coeffs, outputs);
    let error_id = error_of(state.lasting_error, cycle.sample_error, request_error);
    outputs.error_id = error_id;
    outputs.fault = error_id != error_none();
    outputs.loop_closed =
        outputs.spindle_state == SpindleState::Position && !has_failed && cycle.sample_error == error_none();
    if !inputs.drive_on || inputs.reset || has_failed || state.control == SpindleState::Brake {
        jobs::stop(state);
    } else {
        jobs::serve(state, inputs.job_done);
    }
    outputs.job = state.present.kind;
    outputs.job_speed = state.present.speed;
    outputs.job_position = state.present.position;
    outputs.job_number = state.jobs;
    outputs.waiting = state.queued;
}

/// The block.
#[derive(Clone, Copy, Debug)]
pub struct Spindle;

impl<R: Real> Block<R> for Spindle {
    type Coeffs = Coeffs<R>;
    type State = State<R>;
    type Inputs = Inputs<R>;
    type Outputs = Outputs<R>;

    const NAME: &'static str = "spindle";
    const ENABLE: Option<Enable> = Some(Enable { input: "drive_on", mode: None });
    const INIT: Fn = init::Ir::<R>::IR;
    const STEP: Fn = step::Ir::<R>::IR;

    fn state() -> State<R> {
        let mut state = State::default();
        init(&mut state);
        state
    }

    fn inputs(_: &Coeffs<R>) -> Inputs<R> {
        Inputs { feedforward_percentage: 100, ..Inputs::default() }
    }

    fn exercise(inputs: &mut Inputs<R>) {
        inputs.drive_on = true;
    }

    fn outputs() -> Outputs<R> {
        Outputs::default()
    }

    fn step(state: &mut State<R>, coeffs: &Coeffs<R>, inputs: &Inputs<R>, outputs: &mut Outputs<R>) {
        step(state, coeffs, inputs, outputs);
    }
}
