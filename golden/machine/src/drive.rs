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

/// The parameters of such an axis.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Setup {
    /// cycle of the controller Ts [s]
    pub cycle: f64,
    /// d: cycles, also fractional, from a command to the first measured value that it changes; at least 1
    pub delay: f64,
    /// Tc [s]; 0 for none
    pub time_constant: f64,
}

impl Setup {
    /// A drive with only a delay: half a cycle in addition to the hold.
    pub const DELAY: Self = Self { cycle: 1e-3, delay: 1.5, time_constant: 0.0 };
    /// A delay of half a cycle in addition to the hold, with the time constant of a usual velocity loop.
    pub const DELAY_AND_LAG: Self = Self { time_constant: TIME_CONSTANT, ..Self::DELAY };
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
            follows: Follows::time_constant(setup.cycle, setup.time_constant),
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
        let mut late = self.line.next(v_cmd);
        if let Some(fraction) = &mut self.fraction {
            late = fraction.next(late);
        }
        let (before, v, cycle) = (self.now, self.velocity.next(self.follows, late), self.setup.cycle);
        self.now = Measured { x: before.x + v * cycle, v_motor: v, v_load: v, a_load: (v - before.v_motor) / cycle };
        self.now
    }
}
