//! The loops of the demonstration plant: the drive's velocity loop, the CNC's position controller, and the delays between them.

use super::Plant;
use super::mechanics::{Mechanics, Place};
use std::collections::VecDeque;

/// Micrometres of a metre.
pub const UM: f64 = 1e6;

/// Gains, cycles and delays.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Control {
    /// cycle of the CNC Ts [s]; a whole number of cycles of the drive
    pub cycle: f64,
    /// cycle of the velocity loop [s]
    pub drive_cycle: f64,
    /// proportional gain of the velocity loop Kp [Ns/m]
    pub kp: f64,
    /// reset time of the velocity loop Tn [s]
    pub tn: f64,
    /// gain of the position controller Kv [1/s]
    pub kv: f64,
    /// part of the planned velocity that is fed forward
    pub feedforward: f64,
    /// cycles Ts from an actual value to the CNC that computes with it
    pub actual_delay: usize,
    /// cycles Ts from a command of the CNC to the drive that obeys it
    pub command_delay: usize,
}

impl Default for Control {
    fn default() -> Self {
        Self {
            cycle: 1e-3,
            drive_cycle: 125e-6,
            kp: 9.2e5,
            tn: 20e-3,
            kv: 20.0,
            feedforward: 1.0,
            actual_delay: 1,
            command_delay: 1,
        }
    }
}

impl Control {
    /// Cycles of the velocity loop in a cycle of the CNC.
    ///
    /// # Panics
    /// If that is no whole number.
    #[must_use]
    pub fn drive_cycles(&self) -> u32 {
        let cycles = self.cycle / self.drive_cycle;
        let whole = (1..1000).find(|whole| (f64::from(*whole) - cycles).abs() < 1e-6);
        whole.unwrap_or_else(|| panic!("plant: {cycles} cycles of the drive in one of the CNC"))
    }
}

/// What improved position control sees in a cycle [um/s].
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Signals {
    /// output of the position controller with feedforward, before v_add is added
    pub v_soll: f64,
    /// velocity of the motor
    pub v_ist1: f64,
    /// velocity of the carriage against the bed
    pub v_ist2: f64,
}

/// Actual values on their way to the CNC.
#[derive(Clone, Copy, Debug, Default)]
struct Actual {
    /// [m]
    q1: f64,
    /// v_ist1 and v_ist2 [m/s]
    v: [f64; 2],
}

/// The plant while it runs.
#[derive(Clone, Debug)]
pub struct Machine {
    of: Plant,
    /// where everything is
    pub mechanics: Place,
    /// integral of the velocity error / Tn [m/s]
    integral: f64,
    actual: VecDeque<Actual>,
    /// velocity commands on their way to the drive [m/s]
    commands: VecDeque<f64>,
}

impl Machine {
    /// At rest.
    #[must_use]
    pub fn new(of: &Plant) -> Self {
        let Control { actual_delay, command_delay, .. } = of.control;
        Self {
            of: *of,
            mechanics: Place::default(),
            integral: 0.0,
            actual: vec![Actual::default(); actual_delay].into(),
            commands: vec![0.0; command_delay].into(),
        }
    }

    /// The acceleration of the carriage [m/s^2].
    #[must_use]
    pub fn sensor(&self) -> f64 {
        self.of.mechanics.sensor(&self.mechanics)
    }

    /// The begin of a cycle: what the position controller makes of a position command [m] and its velocity [m/s].
    pub fn sample(&mut self, x: f64, v: f64) -> Signals {
        let Control { kv, feedforward, .. } = self.of.control;
        let now = Actual { q1: self.mechanics.q1(), v: [self.mechanics.v1(), self.mechanics.v2()] };
        self.actual.push_back(now);
        let Actual { q1, v: [v1, v2] } = self.actual.pop_front().expect("it has just been pushed");
        let v_soll = kv * (x - q1) + feedforward * v;
        Signals { v_soll: v_soll * UM, v_ist1: v1 * UM, v_ist2: v2 * UM }
    }

    /// The rest of the cycle, with a velocity command v_cmd [um/s].
    pub fn advance(&mut self, v_cmd: f64) {
        let Plant { mechanics, control } = self.of;
        self.commands.push_back(v_cmd / UM);
        let v_cmd = self.commands.pop_front().expect("it has just been pushed");
        for _ in 0..control.drive_cycles() {
            let force = self.force(v_cmd, &control);
            Mechanics::advance(&mechanics, &mut self.mechanics, force, control.drive_cycle);
        }
    }

    /// The velocity loop: Kp (e + integral of e / Tn), the integral over the cycles before.
    fn force(&mut self, v_cmd: f64, control: &Control) -> f64 {
        let error = v_cmd - self.mechanics.v1();
        let force = control.kp * (error + self.integral);
        self.integral += error * control.drive_cycle / control.tn;
        force
    }
}
