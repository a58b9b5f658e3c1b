//! A spindle's drive and the bus to it: actual values some cycles late, operation modes that change some cycles late, a velocity
//! loop of first order and, in position control, a position loop with the feedforward of the drive. No controller of the CNC.
//!
//! ```text
//! v_target = Kv (x_command - x) + w dx_command/dt      in position control: the steady lag is (1 - w) v / Kv
//! v_target = v_command                                 in velocity control
//! tau dv/dt = v_target - v,  dx/dt = v
//! ```

use super::grid::{angle, rate, shortest};
use std::collections::VecDeque;

/// Time constant of the velocity loop [s].
const TAU: f64 = 0.005;

/// Cycles after which the drive is in a mode that it is asked for.
const MODE_CYCLES: u32 = 3;

/// Numbers of a drive.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Setup {
    /// [s]
    pub(crate) cycle: f64,
    /// cycles between a command and the actual value that it causes
    pub(crate) delay_cycles: u32,
    /// gain of its position loop [1/s]
    pub(crate) kv: f64,
    /// weight of its feedforward
    pub(crate) weight: f64,
    /// the number of the mode in which it controls the position; none: it never does
    pub(crate) position_mode: Option<i32>,
}

/// What a drive is told.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Command {
    pub(crate) x: f64,
    pub(crate) v: f64,
    pub(crate) mode: i32,
}

/// What a drive tells.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Actual {
    /// 0 <= x < 360 000 [0.001 deg]
    pub(crate) x: f64,
    pub(crate) v: f64,
    pub(crate) mode: i32,
}

/// A drive that turns.
pub(crate) struct Drive {
    setup: Setup,
    x: f64,
    v: f64,
    /// command position of the cycle before
    x_before: f64,
    mode: i32,
    /// cycles for which another mode has been asked for
    asked: u32,
    /// on the way to the CNC
    sent: VecDeque<Actual>,
}

impl Drive {
    /// At rest.
    pub(crate) fn at(setup: Setup, x: f64) -> Self {
        let mode = setup.position_mode.unwrap_or(0);
        let sent = (0..setup.delay_cycles).map(|_| Actual { x: angle(x), v: 0.0, mode }).collect();
        Self { setup, x, v: 0.0, x_before: x, mode, asked: 0, sent }
    }

    /// What arrives in this cycle.
    pub(crate) fn actual(&mut self) -> Actual {
        let now = Actual { x: angle(self.x), v: rate(self.v), mode: self.mode };
        self.sent.push_back(now);
        self.sent.pop_front().unwrap_or(now)
    }

    /// One cycle with a command.
    pub(crate) fn obey(&mut self, command: Command) {
        let Setup { cycle, kv, weight, position_mode, .. } = self.setup;
        self.asked = if command.mode == self.mode { 0 } else { self.asked + 1 };
        if self.asked > MODE_CYCLES {
            (self.mode, self.asked) = (command.mode, 0);
        }
        let v_target = if position_mode == Some(self.mode) {
            kv * shortest(command.x - self.x) + weight * shortest(command.x - self.x_before) / cycle
        } else {
            command.v
        };
        self.x_before = command.x;
        self.v += (v_target - self.v) * (1.0 - libm::exp(-cycle / TAU));
        self.x += self.v * cycle;
    }
}
