//! The results of a simulation. Nothing is computed here.

use crate::drive::Oscillation;
use machine::closed_loop::Record;

/// The machine of a simulation.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Moved {
    /// a drive without mechanics, with the numbers or the response of the axis, and a ripple at the f0 of each stage
    Drive,
    /// the demonstration plant
    Demonstration,
}

/// All runs of an axis.
pub struct Simulation {
    pub moved: Moved,
    /// gain of the position controller [1/s]
    pub kv: f64,
    /// the f0 of each stage, with its number [Hz]
    pub stages: Vec<(usize, f64)>,
    /// off, each stage alone, all
    pub rows: Vec<Row>,
    /// deviation of the filter of a measured response, and its frequency [Hz]
    pub deviation: Option<[f64; 2]>,
}

/// A run.
pub struct Row {
    pub name: String,
    /// for the demonstration plant at 53 Hz, at 11 Hz, and the ring-down [m/s^2]; else of v_motor at each f0 [mm/s]
    pub amplitudes: Vec<f64>,
    /// [mm]
    pub following_error: f64,
    /// [um/s]
    pub peak_v_add: f64,
    /// `None` if the loop is unstable, or may be
    pub ms: Option<f64>,
    /// whether Ms is known: for the demonstration plant only if no stage has the input `v_direct`
    pub is_judged: bool,
    /// time of v_add at its limit without a ramp [s]
    pub at_limit: f64,
    /// the first error id that the block reported
    pub error_id: Option<f64>,
    pub record: Record,
}

impl Row {
    /// Ms, or why there is none.
    #[must_use]
    pub fn ms_in_words(&self) -> String {
        match self.ms {
            Some(ms) => format!("{ms:.2}"),
            None if self.is_judged => "unstable".to_owned(),
            None => "not judged".to_owned(),
        }
    }

    /// Whether the loop oscillates.
    #[must_use]
    pub fn oscillation(&self) -> Oscillation {
        Oscillation { is_stable: self.is_judged.then_some(self.ms.is_some()), at_limit: self.at_limit }
    }
}
