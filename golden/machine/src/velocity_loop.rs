//! An axis that consists only of its velocity loop: exact between two changes of its command. No control here.

use super::line::Line;
use super::machine::{Machine, Measured};
use super::seven_phases::seconds;

/// The response of the velocity to its command. `Ta` is the equivalent time constant, the time lag on a ramp.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Loop {
    /// exp(-Ta s)
    DeadTime,
    /// 1 / (1 + Ta s)
    Pt1,
    /// 1 / (1 + Ta s + T2^2 s^2)
    Pt2 {
        /// T2 [s]
        t2: f64,
    },
}

/// Substeps per cycle: a dead time is a whole number of them.
const SUBSTEPS: u32 = 20;

/// Terms of the Taylor series. A substep is at most 0.04 of Ta and of T2^2/Ta in all uses: the first omitted term is below
/// the last bit of a double, 0.04^9/9! < 2^-52.
const TERMS: usize = 9;

/// A velocity loop, and the position of its axis.
#[derive(Clone, Debug)]
pub struct VelocityLoop {
    of: Loop,
    /// equivalent time constant [s]
    t_a: f64,
    /// cycle Ts, and length of a substep [s]
    cycle: f64,
    h: f64,
    /// substeps of a dead time, and delayed commands
    substeps: u32,
    delayed: Line<f64>,
    /// acceleration, of a PT2
    a: f64,
    v: f64,
    x: f64,
}

impl VelocityLoop {
    /// At rest.
    ///
    /// # Panics
    /// If a dead time is not a whole number of substeps.
    #[must_use]
    pub fn new(of: Loop, t_a_ns: u32, cycle_ns: u32) -> Self {
        let substep_ns = cycle_ns / SUBSTEPS;
        let substeps = if of == Loop::DeadTime { t_a_ns / substep_ns } else { 0 };
        let is_whole = of != Loop::DeadTime || substeps * substep_ns == t_a_ns;
        assert!(is_whole, "velocity loop: a dead time of {t_a_ns} ns in substeps of {substep_ns} ns");
        let [t_a, cycle, h] = [t_a_ns, cycle_ns, substep_ns].map(|ns| seconds(ns.into()));
        Self { of, t_a, cycle, h, substeps, delayed: Line::new(substeps as usize, 0.0), a: 0.0, v: 0.0, x: 0.0 }
    }

    /// One substep with a constant velocity command.
    fn advance(&mut self, v_command: f64) {
        let u = self.delayed.next(v_command);
        let d = self.derivatives(u);
        self.x += self.h * taylor(&d[..TERMS], self.h, 1);
        self.v = taylor(&d[..TERMS], self.h, 0);
        self.a = taylor(&d[1..], self.h, 0);
    }

    /// The velocity and its derivatives at the beginning of a substep, by repeated differentiation of the differential
    /// equation.
    fn derivatives(&self, u: f64) -> [f64; TERMS + 1] {
        let mut d = [0.0; TERMS + 1];
        match self.of {
            Loop::DeadTime => d[0] = u,
            Loop::Pt1 => {
                d[0] = self.v;
                d[1] = (u - self.v) / self.t_a;
                for k in 2..=TERMS {
                    d[k] = -d[k - 1] / self.t_a;
                }
            }
            Loop::Pt2 { t2 } => {
                d[0] = self.v;
                d[1] = self.a;
                d[2] = (u - self.v - self.t_a * self.a) / (t2 * t2);
                for k in 3..=TERMS {
                    d[k] = -(d[k - 2] + self.t_a * d[k - 1]) / (t2 * t2);
                }
            }
        }
        d
    }
}

impl Machine for VelocityLoop {
    fn cycle(&self) -> f64 {
        self.cycle
    }

    fn delay_cycles(&self) -> usize {
        self.substeps.div_ceil(SUBSTEPS) as usize
    }

    fn now(&self) -> Measured {
        Measured { x: self.x, v_motor: self.v, v_load: self.v, a_load: self.a }
    }

    fn step(&mut self, v_cmd: f64) -> Measured {
        (0..SUBSTEPS).for_each(|_| self.advance(v_cmd));
        self.now()
    }
}

/// `sum of d_k h^k / ((1 + s) (2 + s) ... (k + s))`: with s = 0 the Taylor series of the function, with s = 1 that of its mean
/// over the substep.
fn taylor(derivatives: &[f64], h: f64, s: u8) -> f64 {
    let (mut sum, mut factor) = (0.0, 1.0);
    for (derivative, k) in derivatives.iter().zip(1u8..) {
        sum += factor * derivative;
        factor *= h / f64::from(k + s);
    }
    sum
}
