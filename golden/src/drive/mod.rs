//! The drive of an axis as its keys `drive.*` state it, as a machine without mechanics; and whether the loop that it closes oscillates.
//!
//! ```text
//! response_filter  a measured response as a machine
//! margins          stability and Ms of the loop
//! oscillation      what a run shows of an unstable loop
//! ```

pub(crate) mod margins;
mod oscillation;
mod response_filter;

pub(crate) use oscillation::AtLimit;
pub use oscillation::Oscillation;

use generator::axis::DriveModel;
use generator::blocks::Designed;
use machine::Machine;
use machine::drive::{Drive, Setup};
use response_filter::ResponseFilter;

/// The drive of an axis.
pub(crate) struct AxisDrive {
    /// what it is, with the gain of the position controller
    pub model: DriveModel,
    /// that gain [1/s]
    pub position_gain: f64,
    setup: Setup,
    filter: Option<ResponseFilter>,
}

impl AxisDrive {
    /// The drive that the axis states; another one where it states none; and a gain of the position controller, likewise [1/s].
    pub(crate) fn of(designed: &Designed, otherwise: Setup, position_gain: f64) -> Self {
        let (cycle, stated) = (designed.axis.cycle_time(), &designed.axis.drive);
        let setup = match stated.is_given() {
            true => Setup {
                cycle,
                delay: stated.delay_cycles.unwrap_or(Setup::DELAY.delay),
                time_constant: stated.time_constant.unwrap_or(0.0),
            },
            false => Setup { cycle, ..otherwise },
        };
        let position_gain = stated.position_gain.unwrap_or(position_gain);
        let model = DriveModel {
            delay_cycles: Some(setup.delay),
            time_constant: (setup.time_constant > 0.0).then_some(setup.time_constant),
            response: stated.response.clone(),
            position_gain: Some(position_gain),
        };
        let filter = model.response.as_ref().map(|measured| ResponseFilter::new(&measured.response, cycle));
        Self { model, position_gain, setup, filter }
    }

    /// At rest.
    pub(crate) fn machine(&self) -> Box<dyn Machine> {
        match &self.filter {
            Some(filter) => Box::new(filter.clone()),
            None => Box::new(Drive::new(self.setup)),
        }
    }

    /// How far the filter of a measured response is from it, and where [Hz].
    pub(crate) fn deviation(&self) -> Option<[f64; 2]> {
        let measured = self.model.response.as_ref()?;
        Some(self.filter.as_ref()?.deviation(&measured.response))
    }
}
