//! The part of the commissioning page about a stage: where its vibration is visible, the length of a record, its steps. No
//! design.

use super::rows::{PARTS, Row, Step, part, rows};
use crate::axis::{DirectSource, Filter, Mode};
use crate::blocks::ipc::filter as kinds;
use crate::blocks::ipc::stage::StageDesign;
use crate::design::band::warped;
use crate::design::response::{self, magnitude};
use crate::number::{digits, significant};
use crate::parameters::{Name, path_with};
use portable::Extreme;
use stability::Loop;
use std::f64::consts::PI;

/// First section number of the steps of a weight.
const FIRST_WEIGHT_STEP: usize = 4;
/// First section number for reading frequencies.
const FIRST_READ_STEP: usize = 3;
/// Time constants after which a section has come to rest: e^-10 is 5e-5.
const TIME_CONSTANTS: f64 = 10.0;
/// The length of a record with a Hann window that shows whether a peak lies within the band, in periods of the bandwidth.
const BANDS: f64 = 4.0;

/// An active stage.
pub(super) struct Stage {
    pub(super) index: usize,
    pub(super) mode: &'static str,
    pub(super) source: &'static str,
    /// the record in which its vibration is visible
    pub(super) seen_in: String,
    /// [Hz]
    pub(super) f0: String,
    /// of its first band-pass, -3 dB [Hz]
    pub(super) edges: [String; 2],
    pub(super) weight: String,
    pub(super) rows: Vec<Row>,
    /// time at constant velocity that resolves its band [s]
    pub(super) seconds: f64,
    /// time after which its sections are at rest [s]
    pub(super) quiet: f64,
    pub(super) f0_path: String,
    pub(super) mode_path: String,
    pub(super) num_path: String,
    pub(super) denom_path: String,
    pub(super) read_step: String,
    pub(super) weight_step: String,
}

impl Stage {
    /// The n-th active stage, with the loop of the axis, if there is one. `command`: what SET_POINT looks at.
    pub(super) fn new(n: usize, design: &StageDesign, command: &'static str, closed: Option<&Loop<'_>>) -> Self {
        let (stage, index) = (&design.stage, design.index);
        let first = stage.first_bandpass();
        let number = u32::try_from(index).expect("design: there are three stages");
        let path = |name: Name| path_with(name.parameter().path, [number, first]);
        let filter = design.filter.iter().flatten().find(|filter| filter.index == first as usize);
        let edges = filter.map_or([0.0; 2], |filter| filter.edges);
        let seconds = tenths(BANDS / (edges[1] - edges[0]));
        Self {
            index,
            mode: stage.mode.word(),
            source: if matches!(stage.mode, Mode::SetPoint { .. }) { command } else { stage.mode.source() },
            seen_in: seen_in(stage.mode),
            f0: digits(stage.f0()),
            edges: edges.map(|edge| significant(edge, 4)),
            weight: significant(stage.weight(), 4),
            rows: rows(stage, steps(design, closed)),
            seconds,
            quiet: quiet(design),
            f0_path: path(Name::FilterF0),
            mode_path: path(Name::Mode),
            num_path: path(Name::WeightFactNum),
            denom_path: path(Name::WeightFactDenom),
            read_step: format!("2.{}", FIRST_READ_STEP + n),
            weight_step: format!("4.{}", FIRST_WEIGHT_STEP + n),
        }
    }
}

/// The measured signal that shows the stage's vibration: the velocity itself, or the load, because the motor may not show
/// it.
fn seen_in(mode: Mode) -> String {
    match mode {
        Mode::Direct { .. } => format!("`{}`", mode.source()),
        Mode::Indirect { .. } | Mode::SetPoint { .. } => {
            "`a_load` (this vibration may be invisible in the velocity of the motor); without a sensor, of `following_error`".to_owned()
        }
    }
}

/// The effect of each part of the weight with the stated drive, else an ideal one; `None` if its loop oscillates. The
/// stages before it have their full weights, those after it 0.
///
/// A stage in the loop leaves the ratio of |S| with it to |S| without it at f0. A stage that filters the command leaves |1 +
/// H|, also in a loop; one with the velocity of the load leaves 1 / (1 + |H|) if nothing changes the phase of its counter-motion.
fn steps(design: &StageDesign, closed: Option<&Loop<'_>>) -> [Option<Step>; PARTS.len()] {
    let stage = &design.stage;
    let parts = PARTS.map(part);
    let h = || response::of_stage(&design.coeffs, warped(stage.f0(), design.cycle_time));
    let outside = |left: f64| Some(Step { left, ms: None });
    let effects =
        || closed.map(|closed| closed.effects(design.index, stage.f0(), parts.map(|part| stage.weight() * part)));
    match stage.mode {
        Mode::SetPoint { .. } => {
            let left = parts.map(|part| magnitude(h() * part + 1.0));
            let Some(effects) = effects() else { return left.map(outside) };
            std::array::from_fn(|k| Some(Step { left: left[k], ms: Some(effects[k]?[1]) }))
        }
        Mode::Direct { source: DirectSource::Direct } => parts.map(|part| outside(1.0 / (1.0 + magnitude(h() * part)))),
        Mode::Direct { source: DirectSource::Motor } | Mode::Indirect { .. } => {
            effects().unwrap_or_default().map(|effect| effect.map(|[left, ms]| Step { left, ms: Some(ms) }))
        }
    }
}

/// Time in which the slowest part comes to rest [s]: a band-pass of bandwidth f0/Q has the time constant Q / (pi f0), and
/// each of its sections at most this one; an oscillation 1 / (2 pi f0 D).
fn quiet(design: &StageDesign) -> f64 {
    let stage = &design.stage;
    let of_filter = |filter: &Filter| {
        let order = kinds::of(filter)?.order() as f64;
        filter.f0_and_q().map(|[f0, q_factor]| order * q_factor / (PI * f0))
    };
    let filters = stage.filter.iter().filter_map(of_filter);
    let oscillation = stage.mode.osc_damping().map(|damping| 1.0 / (2.0 * PI * stage.f0() * damping));
    tenths(TIME_CONSTANTS * filters.chain(oscillation).fold(0.0, f64::larger))
}

/// A time [s], rounded up to tenths of a second.
fn tenths(time: f64) -> f64 {
    libm::ceil(time * 10.0) / 10.0
}
