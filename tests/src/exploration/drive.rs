//! Models of a drive and of an interpolator that take few values, and the small coefficients that belong to them. No search.

use machine::spindle::display::Display;
use machine::velocity::{Follows, Velocity};
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

/// A drive.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Model {
    /// how many cycles later than at once it displays the mode that it is asked for: with 1 in the last cycle that is allowed, with 2 too late;
    /// none: never
    pub answer: Option<u32>,
    /// how it moves
    pub follows: Follows,
    /// whether the spindle turns on while the drive is off; else it stands at once
    pub coasts: bool,
}

/// The drive that does all at once.
pub const IDEAL: Model = Model { answer: Some(0), follows: Follows::AtOnce, coasts: false };

/// State of a drive.
#[derive(Clone, Copy, Debug, Default)]
pub struct Drive {
    /// whether it is under velocity control
    pub velocity_control: Display<bool>,
    /// actual position
    pub x: f64,
    /// actual velocity
    pub velocity: Velocity,
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
        v_usual_position: V_ON.next_down(),
        v_usual_velocity: 127.0 * GRAIN,
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
        self.velocity_control.ask(block.asks_velocity, if in_drive { model.answer } else { Some(0) });
        if !is_on {
            let v = if model.coasts { self.velocity.v } else { 0.0 };
            self.velocity = Velocity::of(v);
            self.x = wrap(self.x + v);
            return;
        }
        // The position goes with the command, so that it takes few values.
        let late = if model.follows == Follows::Late { block.v } else { 0.0 };
        self.x = wrap(if self.velocity_control.mode { self.x + block.v } else { block.x - late });
        self.velocity.next(model.follows, block.v);
    }

    /// What a drive and an interpolator that do what they should give to the block.
    #[must_use]
    pub fn samples(&self, coeffs: &Coeffs<f64>, block: &State<f64>) -> Inputs<f64> {
        let goal = if block.present.kind == Job::Turn { block.present.speed } else { 0.0 };
        let is_free = matches!(block.present.kind, Job::Stop | Job::Turn);
        let display = if self.velocity_control.mode { coeffs.velocity_mode } else { coeffs.position_mode };
        Inputs {
            x_command: block.x + block.v,
            v_interpolator: block.v + (goal - block.v).clamp(-V_STEP, V_STEP),
            x_actual: self.x,
            v_actual: self.velocity.v,
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
