//! A jerk-limited move by its formula, as an interpolator plans it. Nothing of the control is here.

/// A move from standstill to standstill in seven phases, which last whole microseconds.
#[derive(Clone, Copy, Debug)]
pub struct Move {
    /// jerk while the acceleration changes [um/s^3]
    pub jerk: f64,
    /// duration of each of the four changes of the acceleration [us]
    pub change: u32,
    /// constant acceleration, and later constant deceleration [us]
    pub acceleration: u32,
    /// constant velocity [us]
    pub velocity: u32,
}

/// The outputs of the interpolator in one cycle.
#[derive(Clone, Copy, Debug, Default)]
pub struct Planned {
    /// position [um]
    pub x: f64,
    /// velocity [um/s]
    pub v: f64,
    /// acceleration [um/s^2]
    pub a: f64,
    /// jerk; at a jump, the value after it [um/s^3]
    pub j: f64,
}

impl Move {
    /// The phases: length [us], jerk [um/s^3].
    #[must_use]
    pub fn phases(&self) -> [(u32, f64); 7] {
        let (up, down) = ((self.change, self.jerk), (self.change, -self.jerk));
        let constant = (self.acceleration, 0.0);
        [up, constant, down, (self.velocity, 0.0), down, constant, up]
    }

    /// The end of a phase, counted from 0 [ns].
    #[must_use]
    pub fn end(&self, phase: usize) -> u64 {
        self.phases().iter().take(phase + 1).map(|(us, _)| u64::from(*us) * 1000).sum()
    }

    /// The largest acceleration, jerk * change [um/s^2].
    #[must_use]
    pub fn largest_acceleration(&self) -> f64 {
        self.jerk * seconds(u64::from(self.change) * 1000)
    }

    /// The largest velocity, `largest_acceleration` * (change + acceleration) [um/s].
    #[must_use]
    pub fn largest_velocity(&self) -> f64 {
        self.largest_acceleration() * seconds(u64::from(self.change + self.acceleration) * 1000)
    }

    /// The planned values at a time [ns]: cubic polynomials, phase by phase; at rest after the last phase.
    #[must_use]
    pub fn at(&self, ns: u64) -> Planned {
        let (mut now, mut rest) = (Planned::default(), ns);
        for (us, j) in self.phases() {
            let length = u64::from(us) * 1000;
            now = Planned { j, ..now }.after(seconds(rest.min(length)));
            if rest < length {
                return now;
            }
            rest -= length;
        }
        Planned { x: now.x, ..Planned::default() }
    }
}

impl Planned {
    /// After a time t at constant jerk: `x + v t + a t^2/2 + j t^3/6`.
    fn after(self, t: f64) -> Self {
        let Self { x, v, a, j } = self;
        Self { x: x + t * (v + t * (a / 2.0 + t * j / 6.0)), v: v + t * (a + t * j / 2.0), a: a + t * j, j }
    }
}

/// Nanoseconds as seconds, rounded once.
#[must_use]
pub fn seconds(ns: u64) -> f64 {
    ns as f64 / 1e9
}
