//! An axis without mechanics: the load is rigid, and the velocity follows the command with a delay and a time constant.
//!
//! ```text
//! v_cmd -> delay of d cycles -> 1 / (1 + Tc s) after the hold -> v,   x = sum of Ts v
//! ```
//!
//! The cycle in which a command is held is part of the delay: the ideal drive has d = 1, `v = z^-1 v_cmd`.

use super::line::{Fraction, Line};
use super::machine::{Machine, Measured};
use super::velocity::{Follows, Velocity};
use portable::Extreme;

/// Time constant of a usual velocity loop [s].
pub const TIME_CONSTANT: f64 = 5e-3;

/// Cycles of a drive that controls the position, in one of the controller.
const PARTS: u32 = 32;

/// The parameters of such an axis.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Setup {
    /// cycle of the controller Ts [s]
    pub cycle: f64,
    /// d: cycles, also fractional, from a command to the first measured value that it changes; at least 1
    pub delay: f64,
    /// Tc [s]; 0 for none
    pub time_constant: f64,
    /// Kv [1/s] of a drive that controls the position: it subtracts its present position, not the one that the command has
    pub position_gain: Option<f64>,
}

impl Setup {
    /// A drive with only a delay: half a cycle in addition to the hold.
    pub const DELAY: Self = Self { cycle: 1e-3, delay: 1.5, time_constant: 0.0, position_gain: None };
    /// A delay of half a cycle in addition to the hold, with the time constant of a usual velocity loop.
    pub const DELAY_AND_LAG: Self = Self { time_constant: TIME_CONSTANT, ..Self::DELAY };

    /// Cycles of the drive in one of the controller.
    fn parts(&self) -> u32 {
        if self.position_gain.is_some() { PARTS } else { 1 }
    }
}

/// The axis in operation.
#[derive(Clone, Debug)]
pub struct Drive {
    setup: Setup,
    line: Line<f64>,
    fraction: Option<Fraction>,
    follows: Follows,
    velocity: Velocity,
    now: Measured,
}

impl Drive {
    /// At rest. A delay below 1 counts as 1.
    #[must_use]
    pub fn new(setup: Setup) -> Self {
        let beyond = (setup.delay - 1.0).larger(0.0);
        let part = beyond - beyond.floor();
        // A short fraction is combined with a whole cycle: Thiran's all-pass is accurate from half a cycle on.
        let (whole, part) = if part > 0.0 && part < 0.5 && beyond > 1.0 {
            (beyond.floor() - 1.0, part + 1.0)
        } else {
            (beyond.floor(), part)
        };
        Self {
            setup,
            line: Line::new(cycles(whole), 0.0),
            fraction: (part > 0.0).then(|| Fraction::new(part)),
            follows: Follows::time_constant(setup.cycle / f64::from(setup.parts()), setup.time_constant),
            velocity: Velocity::default(),
            now: Measured::default(),
        }
    }
}

/// A whole number of cycles.
#[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "a delay of some cycles")]
fn cycles(whole: f64) -> usize {
    whole as usize
}

impl Machine for Drive {
    fn cycle(&self) -> f64 {
        self.setup.cycle
    }

    fn delay_cycles(&self) -> usize {
        cycles((self.setup.delay - 1.0).larger(0.0).ceil())
    }

    fn now(&self) -> Measured {
        self.now
    }

    fn step(&mut self, v_cmd: f64) -> Measured {
        let gain = self.setup.position_gain.unwrap_or(0.0);
        // The command of a controller with this gain contains the position that it has read: a drive with its own controller gets
        // the command of the position.
        let mut late = self.line.next(v_cmd + gain * self.now.x);
        if let Some(fraction) = &mut self.fraction {
            late = fraction.next(late);
        }
        let (before, cycle, parts) = (self.now, self.setup.cycle, self.setup.parts());
        let Measured { mut x, .. } = before;
        for _ in 0..parts {
            x += self.velocity.next(self.follows, late - gain * x) * (cycle / f64::from(parts));
        }
        let v = self.velocity.v;
        self.now = Measured { x, v_motor: v, v_load: v, a_load: (v - before.v_motor) / cycle };
        self.now
    }
}
