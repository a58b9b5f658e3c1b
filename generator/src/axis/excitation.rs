//! The excitation of one axis after the check: plain data. No coefficients.

use identification::excitation::{self, Sequence};

/// What excites an axis (key `excitation`).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Excitation {
    /// A [um/s or 0.001 deg/s]
    pub amplitude: f64,
    /// bits of the register, and cycles of a clock
    pub sequence: Sequence,
    /// periods that are measured M, after one that settles
    pub periods: u32,
}

impl Excitation {
    /// At a cycle time [s]: what a start of it means for the machine.
    #[must_use]
    pub fn at(&self, cycle_time: f64) -> excitation::Excitation {
        let Self { amplitude, sequence, periods } = *self;
        excitation::Excitation { sequence, cycle_time, amplitude, periods: periods as usize }
    }
}
