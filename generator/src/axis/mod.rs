//! One axis after reading and checking: physical, valid parameters. Plain data; no spans, no coefficients.

mod control;
mod drive_model;
mod excitation;
mod ipc;
mod spindle;

pub use crate::parameters::words::{DirectSource, Enable, Motor, Prototype, Width};
pub use control::{Control, Feedforward, PositionControl, Quantities, Ratio, Resolution, TimeBase, Torque, Velocity};
pub use drive_model::{DriveModel, MeasuredDrive};
pub use excitation::Excitation;
pub use ipc::{Filter, Ipc, Mode, Numbers, Stage, Tuning};
pub use reference::position_control::Location;
pub use spindle::{Bus, Changeover, Spindle};

use crate::parameters::words::{RealType, Words};
use portable::RealKind;
use reference::design::band::cycle_time;
use std::collections::BTreeMap;

/// An axis, ready to be designed.
#[derive(Clone, Debug, PartialEq)]
pub struct Axis {
    /// as named in the set
    pub name: String,
    /// real type of its blocks
    pub real: RealKind,
    /// whether names that the linker sees have at most 31 characters in C
    pub short_names: bool,
    /// position-controller cycle [ns]
    pub cycle_time_ns: u32,
    /// whether its blocks check the call rate
    pub counts_calls: bool,
    pub ipc: Ipc,
    pub control: Control,
    /// the excitation, if the set asks for it
    pub excitation: Option<Excitation>,
    /// the known behaviour of the drive, for the stability of the loop
    pub drive: DriveModel,
    /// every effective parameter, one `path value` a line, in the order of the parameter table
    pub canonical: String,
    /// the effective parameters of each block that does not use all of them, by its name
    pub canonical_of: BTreeMap<&'static str, String>,
}

impl Axis {
    /// Whether its parameters ask for no block but improved position control. A new block that an axis may have alone is named
    /// here: otherwise the axis gets `ipc`, too.
    pub(crate) fn asks_for_nothing_else(&self) -> bool {
        self.control.is_empty() && self.excitation.is_none()
    }

    /// Whether its stages act: those of a gantry slave never do.
    pub(crate) fn stages_act(&self) -> bool {
        self.ipc.is_active() && self.control.master.is_none()
    }

    /// The real type of its blocks, as written in sets and lists.
    pub(crate) fn real_name(&self) -> &'static str {
        match self.real {
            RealKind::F64 => RealType::F64.name(),
            RealKind::F32 => RealType::F32.name(),
        }
    }

    /// Whether its blocks check the call rate, in words.
    pub(crate) fn calls(&self) -> &'static str {
        if self.counts_calls { "counted" } else { "not counted" }
    }

    /// The effective parameters of a block: what its digest covers.
    pub fn canonical_of(&self, block: &str) -> &str {
        self.canonical_of.get(block).unwrap_or(&self.canonical)
    }

    /// Position-controller cycle Ts [s].
    pub fn cycle_time(&self) -> f64 {
        cycle_time(self.cycle_time_ns)
    }
}
