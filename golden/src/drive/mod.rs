//! The drive of an axis as stated in its keys `drive.*`, as a machine without mechanics; and whether its loop oscillates.

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

pub(crate) struct AxisDrive {
    /// the model, with the gain of the position controller
    pub model: DriveModel,
    /// gain of the position controller [1/s]
    pub position_gain: f64,
    setup: Setup,
    filter: Option<ResponseFilter>,
}

impl AxisDrive {
    /// The drive that the axis states, or the given one; and likewise a gain of the position controller [1/s].
    pub(crate) fn of(designed: &Designed, otherwise: Setup, position_gain: f64) -> Self {
        let (cycle, stated) = (designed.axis.cycle_time(), &designed.axis.drive);
        let position_gain = stated.position_gain.unwrap_or(position_gain);
        let [_, in_drive] = designed.axis.control.placed(Some(position_gain));
        let otherwise = if stated.is_given() { Setup::DELAY } else { otherwise };
        let setup = Setup {
            cycle,
            delay: stated.delay_cycles.unwrap_or(otherwise.delay),
            time_constant: stated.time_constant.unwrap_or(otherwise.time_constant),
            position_gain: in_drive,
        };
        let model = DriveModel {
            delay_cycles: Some(setup.delay),
            time_constant: (setup.time_constant > 0.0).then_some(setup.time_constant),
            // Its loop was closed only if the set states the gain.
            response: stated.response.clone().map(|measured| measured.in_position_loop(in_drive)),
            position_gain: Some(position_gain),
        };
        let filter = model.response.as_ref().map(|measured| ResponseFilter::new(&measured.response, cycle, in_drive));
        Self { model, position_gain, setup, filter }
    }

    /// Whether the position controller is in the CNC.
    pub(crate) fn is_in_cnc(&self) -> bool {
        self.setup.position_gain.is_none()
    }

    /// The machine at rest.
    pub(crate) fn machine(&self) -> Box<dyn Machine> {
        match &self.filter {
            Some(filter) => Box::new(filter.clone()),
            None => Box::new(Drive::new(self.setup)),
        }
    }

    /// The deviation of the filter of a measured response, and its frequency [Hz].
    pub(crate) fn deviation(&self) -> Option<[f64; 2]> {
        let measured = self.model.response.as_ref()?;
        Some(self.filter.as_ref()?.deviation(&measured.response))
    }
}
