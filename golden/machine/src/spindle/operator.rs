//! The operator of a spindle: requests every job at every speed, switches the drive off, resets, and occasionally causes a
//! bad sample. Everything depends only on the state of the changeover and on a count. No drive, no block.

use super::interpolator::State;

/// Cycles for which a drive keeps its mode although another one is requested, so that the timeout of the control expires.
const STUCK: u32 = 600;
/// Cycles for which a request is TRUE.
const REQUESTED: u32 = 2;

/// The operator who requests jobs, switches the drive and resets.
#[derive(Clone, Debug)]
pub struct Operator {
    random: u64,
    /// speeds: slow and fast [0.001 deg/s]
    speeds: [f64; 3],
    /// cycles from 0 to the fastest speed
    ramp: u32,
    /// cycles until the next request
    pause: u32,
    /// cycles for which the present request is TRUE
    asked: u32,
    asks: &'static [&'static str],
    /// S word [0.001 deg/s] and position [0.001 deg] of the request
    pub speed: f64,
    pub target: f64,
    /// cycles for which the drive is off
    pub off: u32,
    /// cycles for which the drive displays an unchanged mode
    pub stuck: u32,
    /// the bad sample, and its number of cycles
    bad: Bad,
    bad_for: u32,
    /// number of times that each state has begun
    entries: [u32; 5],
    /// number of cycles with a fault
    fault: u32,
    before: State,
}

/// A bad sample.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Bad {
    /// the interpolator's velocity is far too large
    Huge,
    /// it is not a number
    Interpolator,
    /// the actual position is not a number
    Position,
    /// the actual velocity is not a number
    Velocity,
}

impl Operator {
    /// The state before the first cycle. A slow and a fast speed [0.001 deg/s], and the cycles from 0 to the fast one.
    #[must_use]
    pub fn of(slow: f64, fast: f64, ramp: u32) -> Self {
        Self {
            random: 0x9E37_79B9_7F4A_7C15,
            speeds: [slow, fast, fast],
            ramp,
            pause: 60,
            asked: 0,
            asks: &[],
            speed: 0.0,
            target: 0.0,
            off: 3,
            stuck: 0,
            bad: Bad::Huge,
            bad_for: 0,
            entries: [0; 5],
            fault: 0,
            before: State::ToPosition,
        }
    }

    /// Whether a request is TRUE, by the name of its input.
    #[must_use]
    pub fn asks_for(&self, request: &str) -> bool {
        self.asked > 0 && self.asks.contains(&request)
    }

    /// Whether a sample is bad in this way.
    #[must_use]
    pub fn spoils(&self, bad: Bad) -> bool {
        self.bad_for > 0 && self.bad == bad
    }

    /// A random number below another one.
    fn below(&mut self, end: u32) -> u32 {
        self.random ^= self.random << 13;
        self.random ^= self.random >> 7;
        self.random ^= self.random << 17;
        (self.random >> 32) as u32 % end.max(1)
    }

    /// Noise within a range, in steps of 1/32768 of it.
    pub fn noise(&mut self, range: f64) -> f64 {
        (f64::from(self.below(65_536)) / 32_768.0 - 1.0) * range
    }

    /// One cycle: running counts decrease; a state that has just begun may be disturbed. Returns whether the operator
    /// resets.
    pub fn next(&mut self, state: State, nothing_waits: bool, has_fault: bool) -> bool {
        for left in [&mut self.off, &mut self.stuck, &mut self.asked, &mut self.bad_for] {
            *left = left.saturating_sub(1);
        }
        self.disturb(state);
        self.fault = if has_fault { self.fault + 1 } else { 0 };
        let resets = self.fault > 50 && self.below(100) == 0;
        self.pause = self.pause.saturating_sub(1);
        if self.pause == 0 && nothing_waits {
            self.ask();
            self.pause = 40 + self.below(self.ramp + 400);
        }
        self.before = state;
        resets
    }

    /// Causes disturbances: each of them in each state, one after the other, at the beginning of the state; occasionally
    /// within it.
    fn disturb(&mut self, state: State) {
        let which = if state == self.before {
            self.below(20_000)
        } else {
            let entries = &mut self.entries[state as usize];
            *entries += 1;
            *entries % 12
        };
        match which {
            2 => self.off = 1 + self.below(40) * self.below(20),
            4 => (self.bad, self.bad_for) = (Bad::Huge, 1),
            5 => (self.bad, self.bad_for) = (Bad::Interpolator, 8),
            7 => self.stuck = STUCK,
            9 => (self.bad, self.bad_for) = (Bad::Position, 1 + self.below(8)),
            11 => (self.bad, self.bad_for) = (Bad::Velocity, 1 + self.below(8)),
            _ => {}
        }
    }

    /// The next request: every job at every speed; occasionally one that is impossible for any spindle.
    fn ask(&mut self) {
        const ASKED: [&[&str]; 12] = [
            &["m3"],
            &["m4"],
            &["m3"],
            &["m5"],
            &["m19", "m3"],
            &["m19", "m4"],
            &["putax"],
            &["g74"],
            &["m3"],
            &["m3", "m4"],
            &["m19", "m5"],
            &["m4"],
        ];
        self.asks = ASKED[self.below(12) as usize];
        self.asked = REQUESTED;
        self.speed = self.speeds[self.below(3) as usize];
        self.target = f64::from(self.below(360_000));
        match self.below(40) {
            0 => self.speed = f64::NAN,
            1 => self.target = f64::INFINITY,
            _ => {}
        }
    }
}
