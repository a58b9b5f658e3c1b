//! A velocity loop with a PI controller and a lag of its current loop, a motor, and a load behind a spring and a damper. No position control.

/// Cycle of the velocity controller [s], and steps of the integration in it.
const VELOCITY_CYCLE: f64 = 125e-6;
const STEPS: u32 = 5;
/// Time constant of the current loop [s].
const CURRENT: f64 = 0.4e-3;

/// In SI units, translatory: kg, N/m, m.
#[derive(Clone, Debug)]
pub struct Drive {
    /// motor and load
    pub mass: [f64; 2],
    pub stiffness: f64,
    pub damping: f64,
    /// of the velocity controller [Ns/m], and divided by its reset time [N/m]
    pub gain: f64,
    pub integral_gain: f64,
    /// positions of motor and load
    pub x: [f64; 2],
    v: [f64; 2],
    /// the controller's integral, and the force [N]
    integral: f64,
    force: f64,
}

impl Drive {
    /// At rest.
    #[must_use]
    pub fn new(mass: [f64; 2], [stiffness, damping]: [f64; 2], [gain, integral_gain]: [f64; 2]) -> Self {
        let (x, v, integral, force) = ([0.0; 2], [0.0; 2], 0.0, 0.0);
        Self { mass, stiffness, damping, gain, integral_gain, x, v, integral, force }
    }

    /// The load gets a velocity [m/s].
    pub fn push(&mut self, v: f64) {
        self.v[1] += v;
    }

    /// Of both masses [m/s].
    #[must_use]
    pub fn largest_velocity(&self) -> f64 {
        self.v[0].abs().max(self.v[1].abs())
    }

    /// A cycle of the position controller with a constant command [m/s] and constant forces on motor and load [N].
    pub fn advance(&mut self, command: f64, cycle_ns: u32, forces: [f64; 2]) {
        let h = VELOCITY_CYCLE / f64::from(STEPS);
        for _ in 0..cycle_ns / 125_000 {
            let error = command - self.v[0];
            self.integral += self.integral_gain * error * VELOCITY_CYCLE;
            let asked = self.gain * error + self.integral;
            for _ in 0..STEPS {
                self.force += h / CURRENT * (asked - self.force);
                let spring = self.stiffness * (self.x[0] - self.x[1]) + self.damping * (self.v[0] - self.v[1]);
                self.v[0] += h * (self.force - spring + forces[0]) / self.mass[0];
                self.v[1] += h * (spring + forces[1]) / self.mass[1];
                self.x[0] += h * self.v[0];
                self.x[1] += h * self.v[1];
            }
        }
    }
}
