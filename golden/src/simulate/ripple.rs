//! A velocity ripple of the motor that is not commanded, on any machine. Nothing of the control is here.

use machine::{Machine, Measured};
use std::f64::consts::TAU;

/// Amplitude at each frequency: 1 mm/s [m/s].
pub const AMPLITUDE: f64 = 1e-3;

/// A machine whose motor vibrates at some frequencies.
pub struct Ripple<M> {
    machine: M,
    /// [Hz]
    frequencies: Vec<f64>,
    cycles: f64,
    /// whether the position contains the ripple
    in_position: bool,
    /// present velocity of the ripple
    v: f64,
    x: f64,
}

impl<M: Machine> Ripple<M> {
    /// At rest except for the ripple.
    pub fn new(machine: M, frequencies: Vec<f64>, in_position: bool) -> Self {
        Self { machine, frequencies, in_position, cycles: 0.0, v: 0.0, x: 0.0 }
    }

    fn on(&self, of: Measured) -> Measured {
        Measured { x: of.x + self.x, v_motor: of.v_motor + self.v, v_load: of.v_load + self.v, ..of }
    }
}

impl<M: Machine> Machine for Ripple<M> {
    fn cycle(&self) -> f64 {
        self.machine.cycle()
    }

    fn delay_cycles(&self) -> usize {
        self.machine.delay_cycles()
    }

    fn now(&self) -> Measured {
        self.on(self.machine.now())
    }

    fn step(&mut self, v_cmd: f64) -> Measured {
        self.cycles += 1.0;
        let time = self.cycles * self.cycle();
        self.v = self.frequencies.iter().map(|hz| AMPLITUDE * libm::sin(TAU * hz * time)).sum();
        // The position includes the ripple's velocity: a position controller in the CNC sees the ripple too. One in the
        // drive does not: the ripple is what it leaves.
        if self.in_position {
            self.x += self.v * self.cycle();
        }
        let measured = self.machine.step(v_cmd);
        self.on(measured)
    }
}
