//! A motor and a load, coupled by a spring and a damper, in a velocity loop with a PI controller and a lag of its current loop:
//! a plant that takes a tenth of the time of [`crate::plant`], for thousands of random loops. Translatory: kg, N/m, m.

use super::line::Line;
use super::machine::{Machine, Measured};

/// Cycle of the velocity controller [s], and steps of the integration in it.
const VELOCITY_CYCLE: f64 = 125e-6;
const STEPS: u32 = 5;
/// Time constant of the current loop [s].
const CURRENT: f64 = 0.4e-3;

/// The parameters of such a machine.
#[derive(Clone, Copy, Debug)]
pub struct TwoMasses {
    /// motor and load
    pub mass: [f64; 2],
    pub stiffness: f64,
    pub damping: f64,
    /// gain of the velocity controller [Ns/m], and gain divided by its reset time [N/m]
    pub gain: f64,
    pub integral_gain: f64,
    /// cycle of the controller [ns], a whole number of cycles of the velocity controller
    pub cycle_ns: u32,
    /// cycles from a command to the drive
    pub delay_cycles: usize,
}

impl TwoMasses {
    /// At rest.
    #[must_use]
    pub fn at_rest(self) -> Running {
        let commands = Line::new(self.delay_cycles, 0.0);
        let (x, v, forces) = ([0.0; 2], [0.0; 2], [0.0; 2]);
        Running { of: self, forces, x, v, integral: 0.0, force: 0.0, load_acceleration: 0.0, commands }
    }
}

/// The machine in operation.
#[derive(Clone, Debug)]
pub struct Running {
    of: TwoMasses,
    /// constant forces on motor and load from now on [N]
    pub forces: [f64; 2],
    /// positions of motor and load
    x: [f64; 2],
    v: [f64; 2],
    /// the controller's integral, and the force [N]
    integral: f64,
    force: f64,
    load_acceleration: f64,
    /// commands delayed on the way to the drive
    commands: Line<f64>,
}

impl Running {
    /// Sets the velocity of the load [m/s].
    pub fn push(&mut self, v: f64) {
        self.v[1] += v;
    }

    /// A cycle of the velocity controller.
    fn advance(&mut self, command: f64) {
        let TwoMasses { mass, stiffness, damping, gain, integral_gain, .. } = self.of;
        let h = VELOCITY_CYCLE / f64::from(STEPS);
        let error = command - self.v[0];
        self.integral += integral_gain * error * VELOCITY_CYCLE;
        let asked = gain * error + self.integral;
        for _ in 0..STEPS {
            self.force += h / CURRENT * (asked - self.force);
            let spring = stiffness * (self.x[0] - self.x[1]) + damping * (self.v[0] - self.v[1]);
            self.load_acceleration = (spring + self.forces[1]) / mass[1];
            self.v[0] += h * (self.force - spring + self.forces[0]) / mass[0];
            self.v[1] += h * (spring + self.forces[1]) / mass[1];
            self.x[0] += h * self.v[0];
            self.x[1] += h * self.v[1];
        }
    }
}

impl Machine for Running {
    fn cycle(&self) -> f64 {
        f64::from(self.of.cycle_ns) / 1e9
    }

    fn delay_cycles(&self) -> usize {
        self.of.delay_cycles
    }

    fn now(&self) -> Measured {
        let ([x, _], [v_motor, v_load]) = (self.x, self.v);
        Measured { x, v_motor, v_load, a_load: self.load_acceleration }
    }

    fn step(&mut self, v_cmd: f64) -> Measured {
        let command = self.commands.next(v_cmd);
        for _ in 0..self.of.cycle_ns / 125_000 {
            self.advance(command);
        }
        self.now()
    }
}
