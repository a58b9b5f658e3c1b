//! The model of the drive: the response P from the commanded velocity to the motor's, at the sampling instants.

use crate::frequency::{Controller, Point};
use crate::{Complex64, Response, turned};

/// A drive without mechanics, or a measured one.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Drive<'a> {
    /// the motor follows the command after some cycles, at least 1, and optionally after a time constant [s]: P = exp(-j 2
    /// pi f d T) (1 - e)/(1 - e z^-1), e = exp(-T/Tc)
    Delay { cycles: f64, time_constant: Option<f64> },
    /// a measured response
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
                if let Some(time_constant) = time_constant.filter(|time| *time > 0.0) {
                    let e = libm::exp(-controller.cycle_time / time_constant);
                    response = response * (1.0 - e) / (1.0 - e * point.delay());
                }
                Value { response, uncertainty: 0.0 }
            }
            Self::Measured(response) => response.at(controller.hz(point.half)),
        }
    }
}
