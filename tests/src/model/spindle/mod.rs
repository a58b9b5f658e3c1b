//! An independent model of the block `spindle`, in plain double precision: written from `docs/spindle.md`, and nothing of the
//! block may be copied into it.
//!
//! It is no state machine of counters. The model numbers its cycles and keeps a log of when which state was entered; times are
//! differences of numbers of cycles. A cycle first collects what is wrong ([`Model::cycle`]), then chooses one motion
//! ([`motion::Motion`]), then appends to the log what is next. Requests are a queue ([`requests`]). Angles are remainders.
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
//! 1. Several errors in one cycle: one that stays is told, else the first in the order of the page. Of 32 to 35 only the
//!    first is one.
//! 2. A request that is the only one of its cycle and is refused (32 to 35) does not let another one of that cycle in.
//!    `m3` and `m4` that become TRUE together are error 32, not 31.
//! 3. The direction of M19 is the level of `m4` in the cycle in which `m19` becomes TRUE; in later cycles `m3` and `m4` are
//!    requests although `m19` is still TRUE.
//! 4. `operation_mode` changes in TO_VELOCITY and TO_POSITION, and with the drive off, nowhere else: BRAKE after a reset in POSITION keeps the
//!    mode of position control.
//! 5. Requests that change a job in a cycle are seen in this cycle's `job`, `job_number`, `waiting`; `state` is the one before the
//!    change.
//! 6. The first cycle of a state is cycle 1; the error of the time comes in cycle N + 1, also where a sample is bad in it.
//! 7. With a bad sample there are no tests 44 to 46, and no state changes; a request is served, for no error stays. The mode is put out.
//!    The test 46 stays due until there is a cycle of POSITION with good samples.
//! 8. BRAKE is an exception: it brakes on with a bad `v_actual` or `x_actual`.
//! 9. BRAKE integrates its position with the new velocity.
//! 10. A request that begins in a cycle is tested by that cycle's BRAKE of VELOCITY, and served in that cycle.
//! 11. STOP of BRAKE is a new job, also where the job is STOP.
//! 12. `loop_closed` is FALSE with any `fault`, a refused request too.
//! 13. `feedforward_percentage` counts within 0 to 100, as in the block `feedforward`.

pub mod agree;
pub mod cycle;
pub mod drives;
pub mod history;
pub mod interpolator;
pub mod motion;
pub mod parameters;
pub mod requests;
#[cfg(test)]
mod tests;

pub use agree::agree;
pub use cycle::Model;
pub use history::history;
pub use parameters::Parameters;

/// Output `state`.
pub const POSITION: i32 = 0;
/// Output `state`.
pub const TO_VELOCITY: i32 = 1;
/// Output `state`.
pub const VELOCITY: i32 = 2;
/// Output `state`.
pub const BRAKE: i32 = 3;
/// Output `state`.
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
    pub state: i32,
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
    #[must_use]
    pub fn start(p: &Parameters) -> Self {
        Self {
            state: TO_POSITION,
            loop_closed: false,
            x_spindle: 0.0,
            v_spindle: 0.0,
            operation_mode: if p.in_cnc { 0 } else { p.position_mode },
            velocity_command: 0,
            job: 0,
            job_number: 0,
            job_speed: 0.0,
            job_position: 0.0,
            waiting: 0,
            limited: false,
            fault: false,
            error_id: 0,
        }
    }
}
