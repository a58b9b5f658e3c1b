//! An interpolator for the histories: runs the block's jobs with ramps, and takes over where the block tells it to. Coarse, for it is
//! only the stimulus.

use super::drives::uniform;
use super::motion::{TURN, near, wrap};
use super::requests::Kind;
use super::{BRAKE, Outputs, POSITION, Parameters, TO_POSITION, TO_VELOCITY, VELOCITY};
use crate::random::rng::Rng;

/// What it remembers.
#[derive(Clone, Debug)]
pub struct Interpolator {
    acceleration: f64,
    /// turns that it does not take off
    turns: f64,
    /// whether it says anything where it has no say
    is_loose: bool,
    x: f64,
    v: f64,
    job_number: u32,
    /// cycles that HOME and RELEASE still take; none: never done
    left: Option<usize>,
    done: bool,
}

/// What it tells the block.
#[derive(Clone, Copy, Debug)]
pub struct Told {
    pub x: f64,
    pub v: f64,
    pub done: bool,
}

impl Interpolator {
    /// At rest.
    #[must_use]
    pub fn new(p: &Parameters, rng: &mut Rng) -> Self {
        let acceleration = p.deceleration * *rng.pick(&[0.5, 1.0, 3.0]);
        let turns = *rng.pick(&[0.0, 0.0, 7.0, -1e6]);
        let is_loose = rng.chance(50);
        Self { acceleration, turns, is_loose, x: 0.0, v: 0.0, job_number: 0, left: None, done: false }
    }

    /// Runs before the block, with what the block put out in the cycle before.
    pub fn advance(&mut self, p: &Parameters, block: &Outputs, rng: &mut Rng) -> Told {
        if block.job_number != self.job_number {
            self.job_number = block.job_number;
            self.done = false;
            self.left = (!rng.chance(5)).then(|| rng.between(0, 30));
        }
        match block.spindle_state {
            TO_POSITION => {
                (self.x, self.v) = (block.x_spindle, block.v_spindle);
                self.ramp(p, block);
                if rng.chance(4) {
                    let window = p.takeover_window;
                    self.x += *rng.pick(&[window * 1.2, -window * 0.8, TURN / 2.0, 0.3 * TURN, -0.3 * TURN]);
                }
            }
            POSITION | TO_VELOCITY => self.ramp(p, block),
            VELOCITY => {
                self.ramp(p, block);
                self.x = block.x_spindle;
            }
            BRAKE => (self.x, self.v) = (block.x_spindle, block.v_spindle),
            _ => {}
        }
        let has_no_say = matches!(block.spindle_state, BRAKE | TO_POSITION | VELOCITY);
        // In VELOCITY its position, elsewhere both; the block may have left that state in the meantime.
        if self.is_loose && has_no_say && block.spindle_state != TO_POSITION {
            let x = *rng.pick(&[f64::NAN, 1e300, 0.0, 123_456.0]);
            let v = if block.spindle_state == VELOCITY { self.v } else { *rng.pick(&[f64::NAN, 0.0, 1e14]) };
            return Told { x, v, done: self.done };
        }
        Told { x: self.x + self.turns * TURN, v: self.v, done: self.done }
    }

    /// Is somewhere else, as after a jump that nobody has seen.
    pub fn jump(&mut self, p: &Parameters, rng: &mut Rng) {
        self.x += *rng.pick(&[1.2, -1.2, 0.7]) * p.takeover_window;
    }

    /// A cycle of the job.
    fn ramp(&mut self, p: &Parameters, block: &Outputs) {
        let step = self.acceleration * p.cycle;
        let to = match block.job {
            1 => block.job_speed,
            2 if self.done => 0.0,
            2 => self.positioning(block, step),
            _ => 0.0,
        };
        self.v += (to - self.v).clamp(-step, step);
        self.x = wrap(self.x + self.v * p.cycle);
        if block.job == Kind::Position as i32 && !self.done {
            let left = near(block.job_position - self.x);
            if left.abs() <= (self.v.abs() * p.cycle).max(10.0) && self.v.abs() <= 3.0 * step {
                (self.x, self.v, self.done) = (wrap(block.job_position), 0.0, true);
            }
        }
        if block.job > 2 && self.v == 0.0 {
            self.done = self.left == Some(0);
            self.left = self.left.map(|left| left.saturating_sub(1));
        }
    }

    fn positioning(&self, block: &Outputs, step: f64) -> f64 {
        let direction = if block.job_speed < 0.0 { -1.0 } else { 1.0 };
        let left = wrap(direction * (block.job_position - self.x));
        let braking = (1.8 * self.acceleration * left).sqrt();
        direction * braking.min(block.job_speed.abs()).max(step)
    }
}

/// A number that is none, or the last one that is; of velocities the one that turns half a turn a cycle too.
pub fn bad(p: &Parameters, rng: &mut Rng) -> f64 {
    let half_a_turn = 180_000.0 / p.cycle;
    let any = uniform(rng) * 2.0 * half_a_turn;
    *rng.pick(&[
        f64::NAN,
        f64::INFINITY,
        f64::NEG_INFINITY,
        1e15,
        -1e15,
        1.000_000_1e15,
        7e14,
        -7.000_001e14,
        1e300,
        half_a_turn,
        -half_a_turn,
        any,
        any,
    ])
}
