//! The model of the drive: the response P from the commanded velocity to the motor's, at the sampling instants.

use crate::frequency::{Controller, Point};
use crate::{Complex64, Response, turned};

/// A drive without mechanics, or a measured one.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Drive<'a> {
    /// the motor follows the command after some cycles, at least 1, and optionally after a time constant [s]: P = exp(-j 2
    /// pi f d T) (1 - e)/(1 - e z^-1), e = exp(-T/Tc). If it controls the position: [`in_position_loop`] in place of the
    /// fraction
    Delay { cycles: f64, time_constant: Option<f64> },
    /// a measured response; if the drive controls the position, its loop was closed
    Measured(&'a Response),
}

/// P at a frequency.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Value {
    pub response: Complex64,
    /// two standard errors of P, divided by its magnitude
    pub uncertainty: f64,
}

impl Drive<'_> {
    /// Cycles of pure delay, as far as they are known without the measured lines.
    pub(crate) fn delay_cycles(&self) -> f64 {
        match self {
            Self::Delay { cycles, .. } => *cycles,
            Self::Measured(_) => 0.0,
        }
    }

    /// The frequencies of the measured lines [Hz].
    pub(crate) fn lines(&self) -> &[f64] {
        match self {
            Self::Delay { .. } => &[],
            Self::Measured(response) => response.frequencies(),
        }
    }

    pub(crate) fn at(&self, controller: &Controller<'_>, point: &Point) -> Value {
        match *self {
            Self::Delay { cycles, time_constant } => {
                let mut response = turned(-2.0 * cycles * point.half);
                if let Some(gain) = controller.gain_in_drive {
                    response *= in_position_loop(gain, time_constant, controller.cycle_time, point.delay());
                } else if let Some(time_constant) = time_constant.filter(|time| *time > 0.0) {
                    let e = libm::exp(-controller.cycle_time / time_constant);
                    response = response * (1.0 - e) / (1.0 - e * point.delay());
                }
                Value { response, uncertainty: 0.0 }
            }
            Self::Measured(response) => response.at(controller.hz(point.half)),
        }
    }
}

/// A drive that controls the position, from an additive velocity that it holds for a cycle to the velocity at its end, without
/// the cycle: the delay of the bus is not in its position loop.
///
/// ```text
/// s/(Tc s^2 + s + Kv) = s/(Tc (s - p1) (s - p2))   becomes   B/Tc (1 - z^-1)/((1 - q1 z^-1) (1 - q2 z^-1)),   q = exp(p T)
/// B = (q1 - q2)/(p1 - p2);   without Tc   q1 (1 - z^-1)/(1 - q1 z^-1),   q1 = exp(-Kv T)
/// ```
fn in_position_loop(gain: f64, time_constant: Option<f64>, cycle_time: f64, back: Complex64) -> Complex64 {
    let Some(time_constant) = time_constant.filter(|time| *time > 0.0) else {
        let q1 = libm::exp(-gain * cycle_time);
        return (1.0 - back) * q1 / (1.0 - back * q1);
    };
    let (half, product) = (0.5 / time_constant, gain / time_constant);
    let square = half * half - product;
    let root = square.abs().sqrt();
    let angle = root * cycle_time;
    // q1 + q2 and B. p1 p2 = Kv/Tc: the root near 0 without cancellation.
    let [sum, b] = if square > 0.0 && angle > SAME {
        let [q1, q2] = [-product / (half + root), -(half + root)].map(|p| libm::exp(p * cycle_time));
        [q1 + q2, (q1 - q2) / (2.0 * root)]
    } else {
        let (sin, cos) = libm::sincos(angle);
        let sinc = if angle > SAME { sin / root } else { cycle_time };
        [2.0 * cos, sinc].map(|of| of * libm::exp(-half * cycle_time))
    };
    let last = libm::exp(-2.0 * half * cycle_time);
    (1.0 - back) * (b / time_constant) / (1.0 - back * (sum - back * last))
}

/// Two roots with a smaller distance are taken as equal [1/T].
const SAME: f64 = 1e-6;
