//! Mechanics in the velocity loop of their drive, with the delays of commands and actual values, and the parameters of the
//! demonstration plant.
//!
//! ```text
//! v_cmd --> delay --> velocity loop --> current loop --> mechanics --> delay --> x, v_motor, v_load, a_load
//! ```
//!
//! Metres, seconds, newtons and kilograms.

use super::line::Line;
use super::machine::{Machine, Measured};
use super::mechanics::{Mechanics, Mesh, Place};
use portable::Extreme;

/// The parameters of a machine. A caller overrides those of the demonstration plant: `Plant { cycle: 2e-3, ..DEMONSTRATION
/// }`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Plant {
    /// masses, springs, mesh, current loop
    pub mechanics: Mechanics,
    /// cycle of the velocity loop [s]; the nearest value that divides Ts evenly is used
    pub drive_cycle: f64,
    /// proportional gain of the velocity loop Kp [Ns/m]
    pub kp: f64,
    /// reset time of the velocity loop Tn [s]
    pub tn: f64,
    /// cycle of the CNC Ts [s]
    pub cycle: f64,
    /// cycles Ts from a command of the CNC to the drive
    pub command_delay: usize,
    /// cycles Ts from an actual value to its use in the CNC
    pub actual_delay: usize,
}

/// A rack-and-pinion axis that reproduces the application example of the manual: the carriage vibrates at 53 Hz while it
/// moves, the bed at 11 Hz after each ramp. It is one plant of a random search. It shows that the documented result is
/// possible, not that it is typical.
pub const DEMONSTRATION: Plant = Plant {
    mechanics: Mechanics {
        m1: 700.0,
        m2: 1300.0,
        m3: 4000.0,
        k1: 9.0e7,
        c1: 34_210.0,
        k2: 2.619e7,
        c2: 25_890.0,
        mesh: Mesh { force: 1569.0, pitch: 0.010 },
        current_lag: 0.4e-3,
    },
    drive_cycle: 125e-6,
    kp: 9.2e5,
    tn: 20e-3,
    cycle: 1e-3,
    command_delay: 1,
    actual_delay: 1,
};

impl Plant {
    /// The machine with another mass of the carriage: m2 times the factor.
    #[must_use]
    pub fn with_mass_factor(self, factor: f64) -> Self {
        Self { mechanics: Mechanics { m2: self.mechanics.m2 * factor, ..self.mechanics }, ..self }
    }

    /// The machine without the force of the teeth: it is linear.
    #[must_use]
    pub fn without_mesh(self) -> Self {
        let mesh = Mesh { force: 0.0, ..self.mechanics.mesh };
        Self { mechanics: Mechanics { mesh, ..self.mechanics }, ..self }
    }

    /// The plant before its first cycle.
    #[must_use]
    pub fn at_rest(self) -> Running {
        let drive_cycles = self.drive_cycles();
        Running {
            of: Self { drive_cycle: self.cycle / f64::from(drive_cycles), ..self },
            drive_cycles,
            place: Place::default(),
            integral: 0.0,
            commands: Line::new(self.command_delay, 0.0),
            actual: Line::new(self.actual_delay, Measured::default()),
        }
    }

    /// Cycles of the velocity loop per cycle of the CNC, at least one.
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "saturates")]
    fn drive_cycles(&self) -> u32 {
        libm::round(self.cycle / self.drive_cycle).larger(1.0) as u32
    }
}

/// A plant in operation.
#[derive(Clone, Debug)]
pub struct Running {
    of: Plant,
    drive_cycles: u32,
    place: Place,
    /// integral of the velocity error / Tn [m/s]
    integral: f64,
    /// velocity commands delayed on the way to the drive [m/s]
    commands: Line<f64>,
    /// actual values delayed on the way to the CNC
    actual: Line<Measured>,
}

impl Running {
    /// The velocity loop: Kp (e + integral of e / Tn), with the integral over the previous cycles.
    fn force(&mut self, v_cmd: f64) -> f64 {
        let Plant { kp, tn, drive_cycle, .. } = self.of;
        let error = v_cmd - self.place.v1();
        let force = kp * (error + self.integral);
        self.integral += error * drive_cycle / tn;
        force
    }
}

impl Machine for Running {
    fn cycle(&self) -> f64 {
        self.of.cycle
    }

    fn delay_cycles(&self) -> usize {
        self.of.command_delay + self.of.actual_delay
    }

    fn now(&self) -> Measured {
        let place = &self.place;
        Measured { x: place.q1(), v_motor: place.v1(), v_load: place.v2(), a_load: self.of.mechanics.a2(place) }
    }

    fn step(&mut self, v_cmd: f64) -> Measured {
        let v_cmd = self.commands.next(v_cmd);
        for _ in 0..self.drive_cycles {
            let force = self.force(v_cmd);
            self.of.mechanics.advance(&mut self.place, force, self.of.drive_cycle);
        }
        let now = self.now();
        self.actual.next(now)
    }
}
