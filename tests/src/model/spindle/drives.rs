//! Drives for the histories: how the actual values and the displayed mode answer the block's outputs. Coarse, for it is only the
//! stimulus.

use super::motion::{TURN, near, weight};
use super::{Inputs, Outputs, POSITION, Parameters, TO_POSITION, TO_VELOCITY};
use crate::random::rng::Rng;
use machine::spindle::display::Display;
use machine::velocity::{Follows, Velocity};

/// How a drive behaves for a while.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Habit {
    /// first order
    Lagging,
    /// second order
    Overshooting,
    /// a little faster than it should be
    FromAbove,
    /// displays its mode about when the time is over
    Late,
    /// does not display another mode
    Silent,
    /// displays something else now and then, for some cycles
    Flickering,
    Off,
}

/// A spindle's drive.
#[derive(Clone, Debug)]
pub struct Drive {
    pub habit: Habit,
    /// turns not taken off
    x: f64,
    velocity: Velocity,
    display: Display<i32>,
    /// none: it does not answer
    answers_after: Option<u32>,
    /// cycles until it goes off or on
    left: usize,
    /// displays something else for some cycles
    lapse: Option<(i32, usize)>,
}

/// What a drive tells.
#[derive(Clone, Copy, Debug)]
pub struct Told {
    pub x: f64,
    pub v: f64,
    pub mode: i32,
    pub is_on: bool,
}

impl Drive {
    /// At rest somewhere.
    #[must_use]
    pub fn new(p: &Parameters, rng: &mut Rng) -> Self {
        let turns = *rng.pick(&[0.0, 0.0, -3.0, 1000.0, -1e6]);
        Self {
            habit: Habit::Lagging,
            x: (uniform(rng) + turns) * TURN,
            // Some spindles turn when the block starts.
            velocity: Velocity::of(if rng.chance(30) { uniform(rng) * 2.0 * p.v_on.max(600_000.0) } else { 0.0 }),
            display: Display::of(*rng.pick(&[0, p.position_mode, p.velocity_mode])),
            answers_after: Some(3),
            left: 0,
            lapse: None,
        }
    }

    /// Another habit from now on.
    pub fn change(&mut self, p: &Parameters, rng: &mut Rng) {
        use Habit::{Flickering, FromAbove, Lagging, Late, Off, Overshooting, Silent};
        let habits =
            [Lagging, Lagging, Lagging, Overshooting, FromAbove, FromAbove, Late, Late, Silent, Flickering, Off];
        self.habit = *rng.pick(&habits);
        let any = u32::try_from(rng.between(0, 6)).expect("small");
        self.answers_after = match self.habit {
            Late => Some((p.mode_timeout_cycles + any).saturating_sub(4)),
            Silent => None,
            _ => Some(any),
        };
        self.left = if rng.chance(20) { rng.between(30, 300) } else { rng.between(1, 30) };
    }

    /// What it does with the block's last outputs.
    pub fn advance(&mut self, p: &Parameters, block: &Outputs, inputs: &Inputs, rng: &mut Rng) -> Told {
        let is_off = self.habit == Habit::Off && self.left > 0;
        self.left = self.left.saturating_sub(1);
        let is_in_position = match p.in_cnc {
            true => matches!(block.spindle_state, POSITION | TO_VELOCITY | TO_POSITION),
            false => self.display.mode == p.position_mode,
        };
        let lag = near(block.x_spindle - self.x);
        let command = match is_in_position {
            true => (p.kv * lag).clamp(-1e8, 1e8) + weight(p, inputs) * block.v_spindle,
            false => block.v_spindle,
        };
        let (follows, wanted) = match self.habit {
            _ if is_off => (Follows::Lagging(0.02), 0.0),
            Habit::FromAbove => (Follows::Lagging(0.25), command * 1.008),
            // Of a frequency of 0.3 a cycle, damping 0.3.
            Habit::Overshooting => (Follows::Overshooting(0.09, 0.18), command),
            _ => (Follows::Lagging(0.25), command),
        };
        // Block and drive may excite each other; a drive has an end of its velocity.
        self.velocity.v = self.velocity.next(follows, wanted).clamp(-1e9, 1e9);
        self.x += self.velocity.v * p.cycle;
        self.display.ask(block.operation_mode, self.answers_after.filter(|_| !is_off));
        self.lapse = self.lapse.and_then(|(mode, left)| Some((mode, left.checked_sub(1)?)));
        if self.lapse.is_none() && self.habit == Habit::Flickering && rng.chance(2) {
            let mode = *rng.pick(&[-1, 0, p.position_mode, p.velocity_mode, i32::MAX]);
            self.lapse = Some((mode, *rng.pick(&[0, 0, 1, 2, 2, 3, 4])));
        }
        let mode = self.lapse.map_or(self.display.mode, |(mode, _)| mode);
        Told { x: self.x, v: self.velocity.v * (1.0 + 0.001 * uniform(rng)), mode, is_on: !is_off }
    }
}

/// Uniform in -1 to 1, with 53 random bits.
pub fn uniform(rng: &mut Rng) -> f64 {
    (rng.word() >> 11) as f64 / 2f64.powi(52) - 1.0
}
