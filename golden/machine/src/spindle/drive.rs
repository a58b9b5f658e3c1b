//! A spindle's drive and the bus to it: actual values and changes of the operation mode are delayed by some cycles; a
//! velocity loop of first order and, in position control, a position loop with the feedforward of the drive. No controller
//! of the CNC.
//!
//! ```text
//! v_target = Kv (x_command - x) + w dx_command/dt      in position control: the steady lag is (1 - w) v / Kv
//! v_target = v_command                                 in velocity control
//! tau dv/dt = v_target - v,  dx/dt = v
//! ```

use super::display::Display;
use crate::drive::TIME_CONSTANT;
use crate::grid::{angle, rate, shortest};
use crate::line::Line;
use crate::velocity::{Follows, Velocity};

/// Cycles until the drive is in a requested mode.
const MODE_CYCLES: u32 = 3;

/// The parameters of a drive.
#[derive(Clone, Copy, Debug)]
pub struct Setup {
    /// [s]
    pub cycle: f64,
    /// cycles between a command and the actual value that it causes
    pub delay_cycles: u32,
    /// gain of its position loop [1/s]
    pub kv: f64,
    /// weight of its feedforward
    pub weight: f64,
    /// the number of the mode with position control; `None` if it has no such mode
    pub position_mode: Option<i32>,
}

/// The command to a drive.
#[derive(Clone, Copy, Debug)]
pub struct Command {
    pub x: f64,
    pub v: f64,
    pub mode: i32,
}

/// The actual values of a drive.
#[derive(Clone, Copy, Debug)]
pub struct Actual {
    /// 0 <= x < 360 000 [0.001 deg]
    pub x: f64,
    pub v: f64,
    pub mode: i32,
}

/// A drive in operation.
#[derive(Clone, Debug)]
pub struct Drive {
    setup: Setup,
    follows: Follows,
    velocity: Velocity,
    x: f64,
    /// command position of the previous cycle
    x_before: f64,
    display: Display<i32>,
    /// values delayed on the way to the CNC
    sent: Line<Actual>,
}

impl Drive {
    /// The drive at rest, and the values that the CNC reads.
    #[must_use]
    pub fn at(setup: Setup, x: f64) -> (Self, Actual) {
        let mode = setup.position_mode.unwrap_or(0);
        let rest = Actual { x: angle(x), v: 0.0, mode };
        let (follows, velocity) = (Follows::time_constant(setup.cycle, TIME_CONSTANT), Velocity::default());
        let sent = Line::new(setup.delay_cycles as usize, rest);
        (Self { setup, follows, velocity, x, x_before: x, display: Display::of(mode), sent }, rest)
    }

    /// One cycle with a command. Returns the values that the CNC reads for the next one.
    pub fn step(&mut self, command: Command) -> Actual {
        let Setup { cycle, kv, weight, position_mode, .. } = self.setup;
        self.display.ask(command.mode, Some(MODE_CYCLES));
        let mode = self.display.mode;
        let v_target = if position_mode == Some(mode) {
            kv * shortest(command.x - self.x) + weight * shortest(command.x - self.x_before) / cycle
        } else {
            command.v
        };
        self.x_before = command.x;
        self.x += self.velocity.next(self.follows, v_target) * cycle;
        self.sent.next(Actual { x: angle(self.x), v: rate(self.velocity.v), mode })
    }
}
