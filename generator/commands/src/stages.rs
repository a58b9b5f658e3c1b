//! The numbers of a stage that a page edits: an axis with another one, and the file of the user with it. No file is written.

use crate::refused;
use generator::apply::{self, Applied};
use generator::axis::{Filter, Mode, Stage};
use generator::blocks::Designed;
use generator::codes;
use generator::config::{ListOptions, Load};
use generator::diagnostics::{Report, Slashes};
use serde::Deserialize;
use std::path::Path;

/// A number of a stage.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Number {
    /// of its first band-pass [Hz]
    F0,
    /// of its first band-pass
    QFactor,
    /// of the simulated oscillation
    Damping,
    Weight,
}

/// The denominator of a weight that the one in the parameters does not express.
const DENOMINATOR: u32 = 1000;

/// The axis with another number of an active stage, designed. A number that the stage does not have changes nothing. Ranges
/// are not validated here.
#[must_use]
pub fn with(designed: &Designed, stage: usize, number: Number, value: f64) -> Designed {
    let mut axis = designed.axis.clone();
    if let Some(stage) = axis.ipc.stage.get_mut(stage).and_then(Option::as_mut) {
        set(stage, number, value);
    }
    Designed::from(axis)
}

fn set(stage: &mut Stage, number: Number, value: f64) {
    let bandpass = stage.filter.iter_mut().find_map(|filter| match filter {
        Filter::Bandpass { f0, q_factor, .. } => Some((f0, q_factor)),
        Filter::NoFilter | Filter::Allpass { .. } => None,
    });
    match (number, bandpass, &mut stage.mode) {
        (Number::F0, Some((f0, _)), _) => *f0 = value,
        (Number::QFactor, Some((_, q_factor)), _) => *q_factor = value,
        (Number::Damping, _, Mode::Indirect { osc_damping } | Mode::SetPoint { osc_damping }) => *osc_damping = value,
        (Number::Weight, ..) => {
            let is_whole = |of: f64| of.to_bits() == of.round().to_bits();
            if !is_whole(value * f64::from(stage.weight_fact_denom)) {
                stage.weight_fact_denom = DENOMINATOR;
            }
            let numerator = (value * f64::from(stage.weight_fact_denom)).round();
            #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "clamped")]
            let numerator = numerator.clamp(0.0, f64::from(u32::MAX)) as u32;
            stage.weight_fact_num = numerator;
        }
        (Number::F0 | Number::QFactor | Number::Damping, ..) => {}
    }
}

/// The file of an axis with the stages of a version of it, and with enable DRYRUN: the other bytes stay.
///
/// # Errors
/// The stages cannot be written there, or their values are not allowed.
pub fn written(
    (path, options, load): (&Path, &ListOptions, Load<'_>),
    version: &Designed,
) -> Result<(Applied, Report), Report> {
    let all = &version.axis.ipc.stage;
    let stages: Vec<Stage> = all.iter().flatten().cloned().collect();
    if all.iter().take(stages.len()).any(Option::is_none) {
        let found = "a stage that is not active stands before an active one: edit the file by hand";
        return Err(refused::input(codes::NOT_WRITTEN, path.slashes(), found));
    }
    let (applied, report) = apply::stages(path, options, &version.axis.name, &stages, load);
    match applied {
        Some(applied) => Ok((applied, report)),
        None => Err(report),
    }
}
