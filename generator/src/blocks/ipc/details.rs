//! The meaning of stages, limit and start of improved position control for the machine: a table, and words on each stage.
//! Nothing is decided here; warnings are in `advice` and `phase`.

use super::certificate::{designed, noise};
use super::closed_loop::{self, Known};
use super::filter;
use super::stage::StageDesign;
use crate::axis::{Axis, Enable, Mode};
use crate::blocks::designed::Designed;
use crate::design::band::warped;
use crate::design::response::{self, Complex, angle, magnitude};
use crate::number::{decimals, down_to, significant};
use crate::parameters::words::{DirectSource, StageMode, Words};
use portable::Extreme;
use portable::RealKind;
use stability::{Loop, MAX_MS};

/// Limits in 0.1 % of the largest velocity: below the first, a stage that excites the vibration has little effect; above the
/// second, much.
const SMALL_LIMIT: u32 = 50;
const LARGE_LIMIT: u32 = 500;

/// The lines of the block.
pub(super) fn lines(designed: &Designed) -> Vec<String> {
    let stages: Vec<&StageDesign> = designed.stage.iter().flatten().collect();
    if stages.is_empty() {
        return vec!["improved position control: no stage is active, it adds nothing".to_owned()];
    }
    let mut lines = table(designed);
    lines.extend([limit(&designed.axis), start(&designed.axis, designed.ipc.fade_cycles)]);
    lines.extend(self::stages(designed));
    if designed.axis.real == RealKind::F32 {
        lines.push(precision(&stages, &designed.axis));
    }
    lines.extend(neighbours(stages));
    lines
}

/// The ratio of a vibration to the roundings of single precision.
fn precision(stages: &[&StageDesign], axis: &Axis) -> String {
    let ratios = stages.iter().map(|stage| (stage.index, noise::of_design(stage)));
    noise::text(&ratios.collect::<Vec<_>>(), axis.ipc.v_max)
}

/// A row for each stage, in columns.
fn table(designed: &Designed) -> Vec<String> {
    let head = ["stage", "mode", "f0", "Q", "weight", "phase at f0", "filters"].map(str::to_owned).to_vec();
    let rows = designed.stage.iter().enumerate().map(|(i, design)| match design {
        None => vec![i.to_string(), StageMode::NotActive.name().to_owned()],
        Some(design) => row(design),
    });
    let rows: Vec<Vec<String>> = std::iter::once(head).chain(rows).collect();
    let width = |column: usize| rows.iter().filter_map(|row| row.get(column)).map(String::len).max().unwrap_or(0);
    let line = |row: &Vec<String>| {
        let cells = row.iter().enumerate().map(|(column, cell)| format!("{cell:<width$}", width = width(column)));
        cells.collect::<Vec<_>>().join("  ").trim_end().to_owned()
    };
    rows.iter().map(line).collect()
}

fn row(design: &StageDesign) -> Vec<String> {
    let stage = &design.stage;
    let [f0, q_factor] = stage.filter[stage.first_bandpass() as usize].f0_and_q().unwrap_or_default();
    let damping = stage.mode.osc_damping().map_or_else(String::new, |damping| format!(", D {damping}"));
    let filters: Vec<String> = stage.filter.iter().filter_map(filter::in_table).collect();
    vec![
        design.index.to_string(),
        format!("{}{damping}", stage.mode.text()),
        format!("{f0} Hz"),
        q_factor.to_string(),
        format!("{}{}", significant(stage.weight(), 4), stage.cap()),
        format!("{} deg", decimals(angle(at_f0(design)), 0)),
        filters.join(", "),
    ]
}

/// The response of a stage at its f0, from its input velocity to its output.
fn at_f0(design: &StageDesign) -> Complex {
    designed(design, warped(design.stage.f0(), design.cycle_time))
}

fn limit(axis: &Axis) -> String {
    let (ipc, unit) = (&axis.ipc, axis.control.velocity_unit());
    let word = match ipc.v_add_max_fact {
        0 => "none, the block puts out 0",
        fact if fact <= SMALL_LIMIT => "small",
        fact if fact <= LARGE_LIMIT => "medium",
        _ => "large, a wrong stage can move the axis fast",
    };
    let part = f64::from(ipc.v_add_max_fact) / 10.0;
    format!("limit: {word}: |v_add| <= {} {unit}, {part} % of vb_max {}", ipc.limit(), ipc.v_max)
}

fn start(axis: &Axis, fade_cycles: u32) -> String {
    let word = match axis.ipc.enable {
        Enable::On => "acts from the first cycle on",
        Enable::Off => "puts out 0 until the input mode is ON",
        Enable::DryRun => "computes v_add_calculated, and puts out 0 until the input mode is ON",
    };
    let time = f64::from(fade_cycles) * f64::from(axis.cycle_time_ns) / 1e6;
    format!("start: {}: {word}; fades in {} ms", axis.ipc.enable.name(), significant(time, 4))
}

/// A stage without a loop; for one with a loop, its largest weights with several drives.
fn of_stage(design: &StageDesign, loops: &[(String, Loop<'_>)]) -> String {
    let (stage, index) = (&design.stage, design.index);
    let [f0, weight] = [stage.f0(), stage.weight()].map(|value| significant(value, 4));
    match stage.mode {
        Mode::SetPoint { .. } => {
            let h = at_f0(design);
            let left = |h: Complex| decimals(magnitude(h + 1.0) * 100.0, 0);
            let (left, late) = (left(h), left(h * response::delay(warped(stage.f0(), design.cycle_time))));
            let turn = decimals(360.0 * stage.f0() * design.cycle_time, 1);
            format!(
                "stage {index}: filters the command, so that no loop can become unstable: {left} % of it pass at {f0} Hz; \
                 {late} % where the drive gets v_add a cycle late, which turns it by 360 f0 Ts = {turn} deg"
            )
        }
        Mode::Direct { source: DirectSource::Direct } => format!(
            "stage {index}: weight {weight}; measure first: the load lags behind the motor, and no drive alone says how far"
        ),
        Mode::Direct { source: DirectSource::Motor } | Mode::Indirect { .. } => {
            let figures: Vec<String> = loops.iter().enumerate().map(|(n, of)| bears(n, of, index)).collect();
            format!("stage {index}: weight {weight}; {}", figures.join("; "))
        }
    }
}

/// The weights up to which the loop stays well damped, and stable, with a drive; for a further drive only the numbers.
fn bears(n: usize, (drive, closed): &(String, Loop<'_>), stage: usize) -> String {
    let [calm, stable] = [closed.largest_weight(stage), closed.largest_stable_weight(stage)];
    let [calm, stable] = [calm, stable].map(|weight| down_to(weight, 2));
    match n {
        0 => format!("{drive} stays calm (Ms <= {MAX_MS}) up to {calm} and stable up to {stable}"),
        _ => format!("{drive}: {calm} and {stable}"),
    }
}

/// The stages in words, and their restrictions.
fn stages(designed: &Designed) -> Vec<String> {
    let drives = Known::of(&designed.axis.drive);
    let points = closed_loop::points(designed, &drives, designed.axis.drive.position_gain);
    let closed = |points| drives.iter().map(move |known| (known.words(), Loop::new(points, known.drive())));
    let loops: Vec<(String, Loop<'_>)> = points.iter().flat_map(closed).collect();
    let mut lines: Vec<String> = designed.stage.iter().flatten().map(|design| of_stage(design, &loops)).collect();
    if points.is_some() && designed.axis.drive.response.is_none() {
        lines.push(
            "the weights hold for the drive alone: mechanics are not in them; a measured response has them (drive.response)"
                .to_owned(),
        );
    }
    lines
}

/// The distances of stages with adjacent bands.
fn neighbours(mut stages: Vec<&StageDesign>) -> Vec<String> {
    stages.sort_by(|a, b| a.stage.f0().total_cmp(&b.stage.f0()));
    let band = |design: &StageDesign| super::advice::band_of(design);
    let pair = |pair: &[&StageDesign]| {
        let [low, high] = [pair[0], pair[1]].map(band);
        let (gap, wider) = (high[0] - low[1], (high[1] - high[0]).larger(low[1] - low[0]));
        let (i, j) = (pair[0].index, pair[1].index);
        let text = |value| significant(value, 3);
        match gap {
            ..=0.0 => format!(
                "stages {i} and {j}: overlap: each acts on the other's vibration, so put them into operation together"
            ),
            _ if gap < wider => {
                format!(
                    "stages {i} and {j}: close: {} Hz between their bands; look at both when one is changed",
                    text(gap)
                )
            }
            _ => format!(
                "stages {i} and {j}: apart: {} Hz between their bands, they hardly influence each other",
                text(gap)
            ),
        }
    };
    stages.windows(2).map(pair).collect()
}
