//! Moves forward and back with a rest between, as from an interpolator. Nothing of the control is here.

use portable::Extreme;

/// Rest, ramp up, dwell, ramp down, rest, and the same moves backward.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sequence {
    /// before the first ramp [s]
    pub rest_before: f64,
    /// [m/s]
    pub speed: f64,
    /// the largest acceleration of a ramp [m/s^2]
    pub acceleration: f64,
    /// rise time and fall time of the acceleration in a ramp [s]
    pub rise: f64,
    /// at constant speed [s]
    pub dwell: f64,
    /// before the way back [s]
    pub rest_between: f64,
    /// after the last ramp [s]
    pub rest_after: f64,
}

impl Sequence {
    /// The moves in which the demonstration plant vibrates.
    pub const DEMONSTRATION: Self = Self {
        rest_before: 0.3,
        speed: 0.53,
        acceleration: 2.4,
        rise: 33.3e-3,
        dwell: 1.5,
        rest_between: 0.9,
        rest_after: 1.2,
    };
}

/// A sequence, cycle by cycle. The position is the one for the next cycle: `x[n] = x[n-1] + Ts v[n+1]`.
#[derive(Clone, Debug, Default)]
pub struct Planned {
    /// each ramp: its first cycle, and the one after its last
    pub ramps: Vec<[usize; 2]>,
    /// position command [m]
    pub x: Vec<f64>,
    /// velocity [m/s]
    pub v: Vec<f64>,
}

impl Sequence {
    /// The outputs of an interpolator in each cycle Ts [s].
    #[must_use]
    pub fn planned(&self, cycle: f64) -> Planned {
        let mut planned = Planned::default();
        let ramp = self.ramp(cycle);
        planned.hold(0.0, self.rest_before, cycle);
        for speed in [self.speed, -self.speed] {
            planned.change(&ramp, 0.0, speed);
            planned.hold(speed, self.dwell, cycle);
            planned.change(&ramp, speed, -speed);
            let rest = if speed > 0.0 { self.rest_between } else { self.rest_after };
            planned.hold(0.0, rest, cycle);
        }
        planned.integrate(cycle);
        planned
    }

    /// The fraction of the velocity change in each cycle of a ramp; their sum is 1. The trapezoid of the acceleration is
    /// sampled at half cycles and scaled, so that the ramp ends exactly at its speed.
    fn ramp(&self, cycle: f64) -> Vec<f64> {
        let length = self.speed / self.acceleration + self.rise;
        let sample = |n: u32| {
            let t = (f64::from(n) + 0.5) * cycle;
            (t.smaller(length - t) / self.rise).smaller(1.0)
        };
        let shares: Vec<f64> = (0..).map(sample).take_while(|share| *share > 0.0).collect();
        let sum: f64 = shares.iter().sum();
        shares.into_iter().map(|share| share / sum).collect()
    }
}

impl Planned {
    /// Integrates the velocities to positions.
    fn integrate(&mut self, cycle: f64) {
        let next = self.v.iter().skip(1).chain(self.v.last());
        let sum = |x: &mut f64, v: &f64| {
            *x += cycle * v;
            Some(*x)
        };
        self.x = next.scan(0.0, sum).collect();
    }

    /// A constant velocity [m/s] for a time [s], in whole cycles.
    fn hold(&mut self, v: f64, time: f64, cycle: f64) {
        let cycles = (0u32..).take_while(|n| (f64::from(*n) + 0.5) * cycle < time);
        self.v.extend(cycles.map(|_| v));
    }

    /// A ramp from a velocity by a change [m/s].
    fn change(&mut self, shares: &[f64], from: f64, change: f64) {
        let first = self.v.len();
        let mut done = 0.0;
        for share in shares {
            done += share;
            self.v.push(from + change * done);
        }
        self.ramps.push([first, self.v.len()]);
    }
}
