//! Drives for the histories: how the actual values and the displayed mode answer the block's outputs. Coarse, for it is only the
//! stimulus.

use super::motion::{TURN, near, weight};
use super::{Inputs, Outputs, POSITION, Parameters, TO_POSITION, TO_VELOCITY};
use crate::random::rng::Rng;

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
    v: f64,
    /// of the second order
    a: f64,
    displayed: i32,
    /// cycles for which the asked mode differs from the displayed one
    asked_for: u32,
    answers_after: u32,
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
            v: if rng.chance(30) { uniform(rng) * 2.0 * p.v_on.max(600_000.0) } else { 0.0 },
            a: 0.0,
            displayed: *rng.pick(&[0, p.position_mode, p.velocity_mode]),
            asked_for: 0,
            answers_after: 3,
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
            Late => (p.mode_timeout_cycles + any).saturating_sub(4),
            Silent => u32::MAX,
            _ => any,
        };
        self.left = if rng.chance(20) { rng.between(30, 300) } else { rng.between(1, 30) };
    }

    /// What it does with the block's last outputs.
    pub fn advance(&mut self, p: &Parameters, block: &Outputs, inputs: &Inputs, rng: &mut Rng) -> Told {
        let is_off = self.habit == Habit::Off && self.left > 0;
        self.left = self.left.saturating_sub(1);
        let is_in_position = match p.in_cnc {
            true => matches!(block.spindle_state, POSITION | TO_VELOCITY | TO_POSITION),
            false => self.displayed == p.position_mode,
        };
        let lag = near(block.x_spindle - self.x);
        let command = match is_in_position {
            true => (p.kv * lag).clamp(-1e8, 1e8) + weight(p, inputs) * block.v_spindle,
            false => block.v_spindle,
        };
        let wanted = match self.habit {
            _ if is_off => 0.0,
            Habit::FromAbove => command * 1.008,
            _ => command,
        };
        if self.habit == Habit::Overshooting {
            // Of a frequency of 0.3 a cycle, damping 0.3.
            self.a += 0.09 * (wanted - self.v) - 0.18 * self.a;
            self.v += self.a;
        } else {
            self.a = 0.0;
            self.v += if is_off { 0.02 } else { 0.25 } * (wanted - self.v);
        }
        // Block and drive may excite each other; a drive has an end of its velocity.
        self.v = self.v.clamp(-1e9, 1e9);
        self.x += self.v * p.cycle;
        if block.operation_mode == self.displayed {
            self.asked_for = 0;
        } else {
            self.asked_for += 1;
            if self.asked_for > self.answers_after && !is_off {
                self.displayed = block.operation_mode;
            }
        }
        self.lapse = self.lapse.and_then(|(mode, left)| Some((mode, left.checked_sub(1)?)));
        if self.lapse.is_none() && self.habit == Habit::Flickering && rng.chance(2) {
            let mode = *rng.pick(&[-1, 0, p.position_mode, p.velocity_mode, i32::MAX]);
            self.lapse = Some((mode, *rng.pick(&[0, 0, 1, 2, 2, 3, 4])));
        }
        let mode = self.lapse.map_or(self.displayed, |(mode, _)| mode);
        Told { x: self.x, v: self.v * (1.0 + 0.001 * uniform(rng)), mode, is_on: !is_off }
    }
}

/// Uniform in -1 to 1, with 53 random bits.
pub fn uniform(rng: &mut Rng) -> f64 {
    (rng.word() >> 11) as f64 / 2f64.powi(52) - 1.0
}
