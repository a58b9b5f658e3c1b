//! An independent model of the block `spindle`, in plain double precision: written from `docs/spindle.md`, and nothing of the
//! block may be copied into it.
//!
//! It is not a state machine of counters. The model numbers its cycles and keeps a log of when which state was entered, and
//! where; times and "in a row" are differences of numbers of cycles. A cycle ([`Model::cycle`]) first collects what is
//! wrong, then what the state would change to, then chooses one motion ([`motion::Motion`]), then appends to the log.
//! Requests are a queue ([`requests`]). Angles are remainders.
//!
//! # What is compared ([`agree`])
//!
//! Every output of every cycle of random histories ([`history`]): an interpolator, a drive and a person at the panel, closed over the
//! model, with what goes wrong at machines. Flags and integers must be the same; reals within 1e-9 of the largest
//! of 360 000 and the value, positions on the circle. With a velocity above 360 000 the position is a sum of steps of
//! that velocity, and the tolerance grows with it.
//!
//! # What the model took where the page leaves a choice
//!
//! 1. The first cycle, in which no request counts, is the first one of all, not the first one after the drive was off.
//! 2. An error that stays is not replaced by another one: a wrong cycle while 45 stays tells 45.
//! 3. Error 1 is none of those that ask for the mode of TO_VELOCITY and TO_POSITION in their own cycle: the mode is that of the cycle
//!    before, and 0 in the first cycle of all.
//! 4. A cycle that misses a sample, of whatever signal, makes no other test: not half a turn, not the take-over. Of 44, 46 and
//!    41 the first in this order is told.
//! 5. "No sample is missing" means the missing samples of POSITION, TO_VELOCITY and VELOCITY: neither 23 in BRAKE nor 18 in BRAKE and at the
//!    start keeps 42 and 43 away.
//! 6. Error 23 is told in each cycle of BRAKE, also while v_spindle is too high itself. The 3 cycles are counted from the first one
//!    of BRAKE, whose cycle before is one of another state, or of the error that stayed.
//! 7. A reset in the cycle in which POSITION changes to TO_VELOCITY lets it change: the job ends after the state, and nothing
//!    is remembered, for the state is POSITION.
//! 8. "In VELOCITY only STOP and TURN are served" is about the next state, in the last cycle of TO_VELOCITY too.
//! 9. Jobs are served in cycles that miss samples.
//! 10. Requests wait while an error stays.
//! 11. The fourth cycle without a sample tells its own error, whatever the three before it missed.
//! 12. A reset that lasts and a wrong cycle: BRAKE from the beginning in each cycle, with error 1.
//! 13. `velocity_command` is rounded half away from zero, as process data are elsewhere.

pub mod agree;
pub mod block;
pub mod cycle;
pub mod drives;
pub mod history;
pub mod interpolator;
pub mod motion;
pub mod parameters;
pub mod requests;
pub mod start;

pub use agree::agree;
pub use cycle::Model;
pub use history::history;
pub use parameters::Parameters;

/// Output `spindle_state`.
pub const POSITION: i32 = 0;
/// Output `spindle_state`.
pub const TO_VELOCITY: i32 = 1;
/// Output `spindle_state`.
pub const VELOCITY: i32 = 2;
/// Output `spindle_state`.
pub const BRAKE: i32 = 3;
/// Output `spindle_state`.
pub const TO_POSITION: i32 = 4;

/// One cycle's inputs.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Inputs {
    pub x_command: f64,
    pub v_interpolator: f64,
    pub x_actual: f64,
    pub v_actual: f64,
    pub s_word: f64,
    pub s_position: f64,
    pub m3: bool,
    pub m4: bool,
    pub m5: bool,
    pub m19: bool,
    pub putax: bool,
    pub g74: bool,
    pub job_done: bool,
    pub drive_on: bool,
    pub operation_mode_display: i32,
    pub feedforward_active: bool,
    pub feedforward_percentage: i32,
    pub reset: bool,
    pub task_cycle_ns: u32,
}

impl Inputs {
    /// As they start.
    pub const START: Self = Self {
        x_command: 0.0,
        v_interpolator: 0.0,
        x_actual: 0.0,
        v_actual: 0.0,
        s_word: 0.0,
        s_position: 0.0,
        m3: false,
        m4: false,
        m5: false,
        m19: false,
        putax: false,
        g74: false,
        job_done: false,
        drive_on: false,
        operation_mode_display: 0,
        feedforward_active: false,
        feedforward_percentage: 100,
        reset: false,
        task_cycle_ns: 0,
    };
}

/// One cycle's outputs. With position control in the CNC `operation_mode`, `velocity_command` and `limited` are 0.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Outputs {
    pub spindle_state: i32,
    pub loop_closed: bool,
    pub x_spindle: f64,
    pub v_spindle: f64,
    pub operation_mode: i32,
    pub velocity_command: i32,
    pub job: i32,
    pub job_number: u32,
    pub job_speed: f64,
    pub job_position: f64,
    pub waiting: u32,
    pub limited: bool,
    pub fault: bool,
    pub error_id: u32,
}

impl Outputs {
    /// As they start.
    pub const START: Self = Self {
        spindle_state: TO_POSITION,
        loop_closed: false,
        x_spindle: 0.0,
        v_spindle: 0.0,
        operation_mode: 0,
        velocity_command: 0,
        job: 0,
        job_number: 0,
        job_speed: 0.0,
        job_position: 0.0,
        waiting: 0,
        limited: false,
        fault: false,
        error_id: 0,
    };
}
