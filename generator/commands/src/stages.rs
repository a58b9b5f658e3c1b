//! The numbers of a stage that a page edits: an axis with another one, and the user's own text with it. No file is written.

use crate::files::Files;
use crate::refused;
use generator::axis::{Filter, Mode, Stage};
use generator::blocks::Designed;
use generator::codes;
use generator::config::{ListOptions, Load, Unreadable};
use generator::diagnostics::{Report, Slashes};
use generator::parameters::Name;
use generator::pipeline::{self, Shown};
use generator::set_number::{Changed, set_number};
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

/// The stages with another number of an active one. A number that the stage does not have changes nothing. Ranges are not
/// validated here, and nothing is designed.
#[must_use]
pub fn with(designed: &Designed, stage: usize, number: Number, value: f64) -> [Option<Stage>; 3] {
    let mut stages = designed.axis.ipc.stage.clone();
    if let Some(stage) = stages.get_mut(stage).and_then(Option::as_mut) {
        set(stage, number, value);
    }
    stages
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

/// Files of the user with another number of a stage, and what was read from them.
#[derive(Clone, Debug)]
pub struct Written {
    pub files: Files,
    pub shown: Shown,
    /// the messages about the set
    pub report: Report,
}

/// The files of the user with another number of a stage: its digits are replaced where they stand, all other bytes stay. The
/// result is read: the axis then has exactly the stages of [`with`].
///
/// # Errors
/// The stage has no such number, or it is not given in the file, stands in a form that is not edited, or is not allowed.
pub fn written(
    (path, options, load): (&Path, &ListOptions, Load<'_>),
    designed: &Designed,
    (stage, number, value): (usize, Number, f64),
) -> Result<Written, Report> {
    let (axis, version) = (&designed.axis.name, with(designed, stage, number, value));
    let mut files = Files::default();
    let refused = |found: String| refused::input(codes::NOT_WRITTEN, path.slashes(), found);
    let numbers = given(&version, stage, number, value);
    if numbers.is_empty() {
        return Err(refused(format!("stage {stage} of the axis {axis} has no such number")));
    }
    for (names, index, value) in numbers {
        let changed = set_number((path, options, &over(&files, load)), axis, (names, index), value)?;
        let id = names[0].parameter().id.unwrap_or_default();
        let Changed { file, after } = changed.ok_or_else(|| {
            refused(format!("{id} of stage {stage} of the axis {axis} is not given: its default is used"))
        })?;
        files.0.insert(file, after);
    }
    let (shown, report) = pipeline::read_to_show(path, options, &over(&files, load));
    let Some(shown) = shown.filter(|shown| shown.is_whole) else { return Err(report) };
    let stages = shown.set.axes.iter().find(|of| of.axis.name == *axis).map(|of| &of.axis.ipc.stage);
    if stages != Some(&version) {
        return Err(refused(format!("the stage {stage} of the axis {axis} stands in a form that is not edited")));
    }
    Ok(Written { files, shown, report })
}

/// Loads a changed file as it is now, any other as before.
fn over<'a>(changed: &'a Files, load: Load<'a>) -> impl Fn(&Path) -> Result<Vec<u8>, Unreadable> + Sync + 'a {
    |path| changed.0.get(path).map_or_else(|| load(path), |bytes| Ok(bytes.clone()))
}

/// The parameters of a number of a stage, each with its predecessor, its indices and its value.
fn given(version: &[Option<Stage>], at: usize, number: Number, value: f64) -> Vec<(&'static [Name], [u32; 2], f64)> {
    let Some(stage) = version.get(at).and_then(Option::as_ref) else { return Vec::new() };
    let index = u32::try_from(at).unwrap_or(u32::MAX);
    let of_stage = [index, 0];
    let of_filter = [index, stage.first_bandpass()];
    match number {
        Number::F0 => vec![(&[Name::FilterF0], of_filter, value)],
        Number::QFactor => vec![(&[Name::FilterQ], of_filter, value)],
        Number::Damping if matches!(stage.mode, Mode::Direct { .. }) => Vec::new(),
        Number::Damping => vec![(&[Name::OscDamping, Name::FilterDamping], of_stage, value)],
        Number::Weight => vec![
            (&[Name::WeightFactNum], of_stage, f64::from(stage.weight_fact_num)),
            (&[Name::WeightFactDenom], of_stage, f64::from(stage.weight_fact_denom)),
        ],
    }
}
