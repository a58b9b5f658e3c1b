//! The command `analyze`: the loop of each axis with its drives, for machines, and its curves as numbers.

use generator::analysis::{self, Known, OfDrive, OfStage};
use generator::blocks::Designed;
use serde::Serialize;

/// An axis, and its loop with each drive.
#[derive(Clone, Debug, Serialize)]
pub struct Analyzed<'d> {
    pub axis: &'d str,
    pub cycle_time_ns: u32,
    /// empty if no stage closes a loop
    pub drives: Vec<WithDrive>,
}

/// A loop: `null` is what it does not have.
#[derive(Clone, Debug, Serialize)]
pub struct WithDrive {
    pub delay_cycles: Option<f64>,
    pub time_constant_s: Option<f64>,
    /// the file of a measured response
    pub response: Option<String>,
    pub stable: bool,
    pub ms: Option<f64>,
    pub ms_hz: Option<f64>,
    pub gain_margin_db: Option<f64>,
    pub phase_margin_deg: Option<f64>,
    pub stages: Vec<OfStage>,
}

/// The analysis of an axis.
#[must_use]
pub fn analyze(designed: &Designed) -> Analyzed<'_> {
    let axis = &designed.axis;
    let drives = analysis::analyze(designed, &axis.drive).drives.into_iter().map(with_drive).collect();
    Analyzed { axis: &axis.name, cycle_time_ns: axis.cycle_time_ns, drives }
}

fn with_drive(of: OfDrive) -> WithDrive {
    let (delay_cycles, time_constant_s, response) = match of.drive {
        Known::Delay { cycles, time_constant } => (Some(cycles), time_constant, None),
        Known::Measured(measured) => (None, None, Some(measured.file)),
    };
    WithDrive {
        delay_cycles,
        time_constant_s,
        response,
        stable: of.margins.stable,
        ms: of.margins.ms.map(|[ms, _]| ms),
        ms_hz: of.margins.ms.map(|[_, hz]| hz),
        gain_margin_db: of.margins.gain_db,
        phase_margin_deg: of.margins.phase_deg,
        stages: of.stages,
    }
}
