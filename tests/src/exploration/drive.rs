//! Models of a drive and of an interpolator that take few values, and the small coefficients that belong to them. No search.

use reference::process_data;
use reference::spindle::{Coeffs, Inputs, Job, State};

/// An eighth of a turn a cycle [0.001 deg/s]: the unit of all velocities here. The cycle is 1 s, so that it is the unit of
/// all positions, too.
pub const U: f64 = 45_000.0;

/// What all numbers are multiples of.
pub const GRAIN: f64 = U / 8.0;

/// Von.
pub const V_ON: f64 = 2.0 * U;

/// How fast the interpolator changes the velocity in a cycle, and mostly the ramp.
pub const V_STEP: f64 = 2.0 * U;

/// The operation modes of the drive.
pub const POSITION_MODE: i32 = 3;
/// The operation modes of the drive.
pub const VELOCITY_MODE: i32 = 4;

/// Cycles within which the drive answers.
pub const MODE_CYCLES: u32 = 2;

/// Cycles within which the spindle has braked.
pub const BRAKE_CYCLES: u32 = 6;

/// The same with a slower ramp.
pub const SLOW_BRAKE_CYCLES: u32 = 9;

/// After how many cycles the drive displays the mode that it is asked for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Answer {
    /// So many cycles later than at once: with 1 in the last cycle that is allowed, with 2 too late.
    After(u8),
    /// never
    Never,
}

/// How the actual velocity follows the command.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Follows {
    /// at once
    AtOnce,
    /// a cycle late, in position and velocity
    Late,
    /// beyond each change by as much again, for a cycle
    Beyond,
    /// by a quarter of the interpolator's acceleration: a drive at its current limit
    Weak,
    /// from above, but for 0: a unit too fast behind each change, then halved in each cycle, so many times
    FromAbove(u8),
}

/// A drive.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Model {
    /// how it changes its mode
    pub answer: Answer,
    /// how it moves
    pub follows: Follows,
    /// whether the spindle turns on while the drive is off; else it stands at once
    pub coasts: bool,
}

/// The drive that does all at once.
pub const IDEAL: Model = Model { answer: Answer::After(0), follows: Follows::AtOnce, coasts: false };

/// State of a drive.
#[derive(Clone, Copy, Debug, Default)]
pub struct Drive {
    /// whether it is under velocity control, and displays that
    pub is_velocity: bool,
    /// for how many cycles it has been asked for the other mode
    pub asked: u8,
    /// actual position
    pub x: f64,
    /// actual velocity
    pub v: f64,
    /// the command of the cycle before
    pub v_before: f64,
    /// how often the excess has been halved
    pub halved: u8,
}

/// The coefficients: lead time 3 s, a window of U/4 around the velocity and of U/2 at the take-over.
#[must_use]
pub fn coefficients(in_drive: bool, v_off: f64, v_step: f64) -> Coeffs<f64> {
    Coeffs {
        cycle_time_ns: 1_000_000_000,
        cycle_time: 1.0,
        in_drive,
        v_velocity_control_on: V_ON,
        v_position_control_on: v_off,
        v_position_control_on_negative: 0.0 - v_off,
        window: U / 4.0,
        v_taken_up: v_off + U / 4.0,
        v_step,
        v_largest: 180_000.0_f64.next_down(),
        lead_time: 3.0,
        takeover_window: U / 2.0,
        mode_cycles: MODE_CYCLES,
        start_cycles: MODE_CYCLES + 2,
        brake_cycles: if v_step < V_STEP { SLOW_BRAKE_CYCLES } else { BRAKE_CYCLES },
        position_mode: if in_drive { POSITION_MODE } else { 0 },
        velocity_mode: if in_drive { VELOCITY_MODE } else { 0 },
        velocity_scale: if in_drive { 1.0 / GRAIN } else { 0.0 },
        velocity_range: process_data::Coeffs { lowest: -128, highest: 127, lower_limit: -128.5, upper_limit: 127.4 },
        ..Coeffs::default()
    }
}

impl Drive {
    /// A cycle with the commands of the block's last one. A drive that is off lets the spindle turn on.
    pub fn advance(&mut self, model: Model, in_drive: bool, is_on: bool, block: &State<f64>) {
        if block.asks_velocity == self.is_velocity {
            self.asked = 0;
        } else if !in_drive || matches!(model.answer, Answer::After(cycles) if self.asked >= cycles) {
            self.is_velocity = block.asks_velocity;
            self.asked = 0;
        } else {
            self.asked = (self.asked + 1).min(3);
        }
        if !is_on {
            self.v = if model.coasts { self.v } else { 0.0 };
            self.x = wrap(self.x + self.v);
            (self.v_before, self.halved) = (0.0, 0);
            return;
        }
        // The position goes with the command, so that it takes few values.
        let late = if model.follows == Follows::Late { block.v } else { 0.0 };
        self.x = wrap(if self.is_velocity { self.x + block.v } else { block.x - late });
        self.halved = if block.v == self.v_before { self.halved + 1 } else { 0 };
        self.v = match model.follows {
            Follows::AtOnce => block.v,
            Follows::Late => self.v_before,
            Follows::Beyond => 2.0 * block.v - self.v_before,
            Follows::Weak => self.v + (block.v - self.v).clamp(-U / 2.0, U / 2.0),
            Follows::FromAbove(often) => {
                self.halved = self.halved.min(often);
                let excess = if block.v == 0.0 { 0.0 } else { U.copysign(block.v) };
                block.v + excess / f64::from(1 << self.halved)
            }
        };
        if !matches!(model.follows, Follows::FromAbove(_)) {
            self.halved = 0;
        }
        self.v_before = if matches!(model.follows, Follows::AtOnce | Follows::Weak) { 0.0 } else { block.v };
    }

    /// What a drive and an interpolator that do what they should give to the block.
    #[must_use]
    pub fn samples(&self, coeffs: &Coeffs<f64>, block: &State<f64>) -> Inputs<f64> {
        let goal = if block.present.kind == Job::Turn { block.present.speed } else { 0.0 };
        let is_free = matches!(block.present.kind, Job::Stop | Job::Turn);
        let display = if self.is_velocity { coeffs.velocity_mode } else { coeffs.position_mode };
        Inputs {
            x_command: block.x + block.v,
            v_interpolator: block.v + (goal - block.v).clamp(-V_STEP, V_STEP),
            x_actual: self.x,
            v_actual: self.v,
            s_word: 3.0 * U,
            s_position: 2.0 * U,
            job_done: !is_free && block.v == 0.0,
            drive_on: true,
            operation_mode_display: display,
            feedforward_percentage: 100,
            task_cycle_ns: coeffs.cycle_time_ns,
            ..Inputs::default()
        }
    }
}

/// The angle within one turn, by another way than the block's.
#[must_use]
pub fn wrap(x: f64) -> f64 {
    x.rem_euclid(360_000.0)
}
