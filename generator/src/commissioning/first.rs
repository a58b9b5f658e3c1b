//! The commissioning page of an axis without an active stage: from the machine to its first stages. What the page says is in its
//! template; the numbers of the excitation are in `excite.rs`.

use super::excite::Excite;
use super::names::Names;
use super::{AGREEMENT, LEAST_DRIVE, LEAST_QUIET, LEAST_WINDOW, cycle};
use crate::axis::{Axis, PositionControl};
use crate::blocks::EXCITATION;
use crate::number::digits;
use crate::target::Target;
use askama::Template;

/// What the template shows.
#[derive(Template)]
#[template(path = "commissioning/first.md")]
pub(super) struct First<'a> {
    axis: &'a Axis,
    /// of the block `excitation`
    names: Names,
    has_notices: bool,
    /// inputs of the block `excitation` that hold it at rest
    off: &'static str,
    unit: &'static str,
    /// whether the drive controls the position: stages and excitation need its additive velocity, and a measured response is
    /// not that of its velocity loop
    in_drive: bool,
    additive: &'static str,
    cycle: String,
    /// [s]
    window: String,
    drive_time: String,
    quiet: String,
    /// `None`: the axis does not have the block `excitation`
    excite: Option<Excite>,
    /// number of the section about proposals
    section: u32,
    /// the command that proposes stages, and the proposal to begin with
    tune: String,
    proposal: &'static str,
}

/// The page of an axis without an active stage, for these targets.
pub(super) fn page<'a>(axis: &'a Axis, targets: &[Target]) -> First<'a> {
    let excite = Excite::of(axis);
    let recorded = format!("axgen tune SET --axis {} --recording moves.csv", axis.name);
    let (section, tune, proposal) = match &excite {
        Some(excite) => {
            (4, format!("{recorded} --excited excited.csv --excitation {}", excite.sequence), "recommended")
        }
        None => (3, recorded, "first"),
    };
    First {
        axis,
        names: Names::new(axis, EXCITATION, targets),
        has_notices: true,
        off: "`hold_to_run := FALSE`",
        unit: axis.control.velocity_unit(),
        in_drive: !axis.control.commands_by_position(),
        additive: PositionControl::ADDITIVE_VELOCITY,
        cycle: cycle(axis),
        window: digits(LEAST_WINDOW),
        drive_time: digits(LEAST_DRIVE),
        quiet: digits(LEAST_QUIET),
        excite,
        section,
        tune,
        proposal,
    }
}
