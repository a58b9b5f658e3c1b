//! The effect of an axis's blocks in a few lines for the user, and its meaning for the machine.

use crate::axis::{Axis, Changeover, Location, Numbers};
use crate::blocks::{self, Designed, Reserve, StageRow, Summary};
use crate::number::rounded;
use crate::parameters::words::{DriveType, Words};
use serde::Serialize;

/// The lines for an axis.
pub fn text(designed: &Designed) -> String {
    let summaries: Vec<Summary> = blocks::of_axis(&designed.axis).map(|kind| kind.summary(designed)).collect();
    let heads: String = summaries.iter().map(|summary| summary.head.as_str()).collect();
    let lines = summaries.into_iter().flat_map(|summary| summary.lines).collect();
    AxisRow { lines, ..head(&designed.axis) }.with(&heads)
}

/// The blocks of an axis and their meaning for the machine, as data; [`AxisRow::text`] prints it.
#[derive(Clone, Debug, Serialize)]
pub struct AxisRow {
    pub axis: String,
    pub blocks: Vec<&'static str>,
    pub real: &'static str,
    pub cycle_time_us: f64,
    /// of improved position control; empty if the axis does not have it
    pub stages: Vec<StageRow>,
    /// the worst of its stages
    pub reserve: Option<Reserve>,
    pub lines: Vec<String>,
    pub assumed: Vec<String>,
}

/// The details of an axis's blocks.
pub fn details(designed: &Designed) -> AxisRow {
    let axis = &designed.axis;
    let (mut stages, mut lines) = (Vec::new(), Vec::new());
    for of in blocks::of_axis(axis).map(|kind| kind.details(designed)) {
        stages.extend(of.stages);
        lines.extend(of.lines);
    }
    lines.extend(drive(axis).into_iter().chain(keys(designed)));
    AxisRow { reserve: stages.iter().filter_map(|row| row.active.as_ref()?.reserve).max(), stages, lines, ..head(axis) }
}

/// An axis, without what its blocks mean.
fn head(axis: &Axis) -> AxisRow {
    AxisRow {
        axis: axis.name.clone(),
        blocks: blocks::names(axis),
        real: axis.real_name(),
        cycle_time_us: f64::from(axis.cycle_time_ns) / 1000.0,
        stages: Vec::new(),
        reserve: None,
        lines: Vec::new(),
        assumed: axis.control.assumed.clone(),
    }
}

impl AxisRow {
    /// The lines for an axis.
    pub fn text(&self) -> String {
        self.with("")
    }

    /// The same, with a text after the first line.
    fn with(&self, heads: &str) -> String {
        let Self { axis, blocks, real, cycle_time_us, lines, assumed, .. } = self;
        let mut text = format!("axis {axis}: {}, {real}, cycle {cycle_time_us} us{heads}\n", blocks.join(", "));
        for line in lines {
            text.extend(["  ", line, "\n"]);
        }
        if !assumed.is_empty() {
            text.extend(["  assumed: ", &assumed.join(", "), "\n"]);
        }
        text
    }
}

/// The drive, and its gain, which must equal that of the controller.
fn drive(axis: &Axis) -> Vec<String> {
    let control = &axis.control;
    let drive_type = control.drive_type.map(|of| match of {
        DriveType::Virtual => {
            "drive: VIRTUAL, by kenngr.antr_typ (P-AXIS-00020): no motor follows this axis".to_owned()
        }
        DriveType::Simulation => {
            "drive: SIMULATION, by kenngr.antr_typ (P-AXIS-00020): no motor follows this axis".to_owned()
        }
        DriveType::Conventional
        | DriveType::Sercos
        | DriveType::Profidrive
        | DriveType::Lightbus
        | DriveType::Terminal
        | DriveType::RtEthernet
        | DriveType::CanOpen
        | DriveType::CanBus => format!("drive: {} (P-AXIS-00020)", of.name()),
    });
    let in_drive = match (&control.spindle, &control.position_control) {
        (Some(of), _) => matches!(of.drive, Changeover::Drive { .. }) && !of.only_velocity(),
        (None, of) => of.as_ref().is_some_and(|of| of.location != Location::Cnc),
    };
    let kv = control.kv.filter(|_| in_drive).map(|kv| {
        let kv = f64::from(kv) / 100.0;
        let of_sercos = format!("SERCOS S-0-0104: {} in 1000/min", rounded(kv * 0.06));
        let of_drive = match control.drive_type {
            Some(DriveType::Sercos) => format!(" ({of_sercos})"),
            Some(DriveType::CanOpen) => " (CANopen 30C0h:01)".to_owned(),
            Some(DriveType::Profidrive) => String::new(),
            _ => format!(" ({of_sercos}, CANopen 30C0h:01)"),
        };
        format!("Kv {kv}/s (P-AXIS-00099): that of the drive must be equal{of_drive}")
    });
    drive_type.into_iter().chain(kv).collect()
}

/// The effect of axgen's own keys in a set.
fn keys(designed: &Designed) -> Vec<String> {
    let axis = &designed.axis;
    let tunable = match axis.ipc.numbers {
        Numbers::Weights(of) if axis.stages_act() => {
            Some(format!("tunable: the weights and the limit; the limit starts at {} of it", of.limit))
        }
        Numbers::Fixed | Numbers::Weights(_) => None,
        Numbers::Sets { lowest_f0: None } => Some("tunable: all numbers, by parameter sets".to_owned()),
        Numbers::Sets { lowest_f0: Some(f0) } => {
            Some(format!("tunable: all parameters, by parameter sets of the block set_design, f0 from {f0} Hz"))
        }
    };
    let watch = (designed.ipc.watch.active)
        .then(|| "watch: fades out where the loop becomes unstable, output `tripped`".to_owned());
    tunable.into_iter().chain(watch).collect()
}
