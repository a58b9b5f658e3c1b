//! The meaning of stages, limit and start of improved position control for the machine: a table, and words on each stage.
//! Nothing is decided here; warnings are in `advice` and `phase`.

use super::certificate::{designed, noise};
use super::closed_loop::{self, Known};
use super::filter;
use super::row::{ActiveStage, Reserve, StageRow, WithDrive};
use super::stage::StageDesign;
use crate::axis::{Axis, Enable, Mode};
use crate::blocks::designed::Designed;
use crate::blocks::kind::Details;
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

/// The stages of the block, and its lines, which begin with their table.
pub(super) fn details(designed: &Designed) -> Details {
    let active: Vec<&StageDesign> = designed.stage.iter().flatten().collect();
    let stages = rows(designed);
    if active.is_empty() {
        return Details {
            stages,
            lines: vec!["improved position control: no stage is active, it adds nothing".to_owned()],
        };
    }
    let mut lines = table(&stages);
    lines.extend([limit(&designed.axis), start(&designed.axis, designed.ipc.fade_cycles)]);
    let figures = || stages.iter().filter_map(|row| Some((row.stage, row.active.as_ref()?)));
    lines.extend(figures().map(|(stage, of)| format!("stage {stage}: {}", of.verdict)));
    if figures().any(|(_, of)| !of.reserves.is_empty()) && designed.axis.drive.response.is_none() {
        let of_mechanics = "mechanics are not in them; a measured response has them (drive.response)";
        lines.push(format!("the weights hold for the drive alone: {of_mechanics}"));
    }
    if designed.axis.real == RealKind::F32 {
        lines.push(precision(&active, &designed.axis));
    }
    lines.extend(neighbours(active));
    Details { stages, lines }
}

/// The ratio of a vibration to the roundings of single precision.
fn precision(stages: &[&StageDesign], axis: &Axis) -> String {
    let ratios = stages.iter().map(|stage| (stage.index, noise::of_design(stage)));
    noise::text(&ratios.collect::<Vec<_>>(), axis.ipc.v_max, axis.control.velocity_unit())
}

/// The stages with their numbers and verdicts.
fn rows(designed: &Designed) -> Vec<StageRow> {
    let drives = Known::of(&designed.axis.drive);
    let points = closed_loop::points(designed, &drives, designed.axis.drive.position_gain);
    let closed = |points| drives.iter().map(move |known| (known.words(), Loop::new(points, known.drive())));
    let loops: Vec<(String, Loop<'_>)> = points.iter().flat_map(closed).collect();
    let row = |(stage, design): (usize, &Option<StageDesign>)| StageRow {
        stage,
        mode: design.as_ref().map_or(StageMode::NotActive.name(), |design| design.stage.mode.word()),
        active: design.as_ref().map(|design| active(designed, design, &loops)),
    };
    designed.stage.iter().enumerate().map(row).collect()
}

fn active(designed: &Designed, design: &StageDesign, loops: &[(String, Loop<'_>)]) -> ActiveStage {
    let stage = &design.stage;
    let [f0, q_factor] = stage.filter[stage.first_bandpass() as usize].f0_and_q().unwrap_or_default();
    let loops = if closed_loop::closes_loop(&designed.axis.control, stage.mode) { loops } else { &[] };
    let reserves: Vec<WithDrive> = loops.iter().map(|of| with_drive(design, of)).collect();
    ActiveStage {
        source: stage.mode.source(),
        f0,
        q_factor,
        damping: stage.mode.osc_damping(),
        weight: stage.weight(),
        asked_weight: stage.asked_weight(),
        phase_at_f0_deg: angle(at_f0(design)),
        filters: stage.filter.iter().filter_map(filter::in_table).collect(),
        reserve: reserves.first().map(|of| of.reserve),
        verdict: verdict(designed, design, &reserves),
        reserves,
    }
}

/// Each stage with the drive that is known best.
pub(super) fn margins(designed: &Designed) -> impl Iterator<Item = Option<WithDrive>> {
    rows(designed).into_iter().map(|row| row.active?.reserves.into_iter().next())
}

fn with_drive(design: &StageDesign, (drive, closed): &(String, Loop<'_>)) -> WithDrive {
    let [stable, calm] = closed.largest_weights(design.index);
    let reserve = Reserve::of(design.stage.weight(), [calm, stable]);
    WithDrive { drive: drive.clone(), calm_up_to: calm, stable_up_to: stable, reserve }
}

/// A row for each stage, in columns.
fn table(stages: &[StageRow]) -> Vec<String> {
    let head = StageRow::COLUMNS.map(str::to_owned).to_vec();
    let rows: Vec<Vec<String>> = std::iter::once(head).chain(stages.iter().map(StageRow::cells)).collect();
    let width = |column: usize| rows.iter().filter_map(|row| row.get(column)).map(String::len).max().unwrap_or(0);
    let line = |row: &Vec<String>| {
        let cells = row.iter().enumerate().map(|(column, cell)| format!("{cell:<width$}", width = width(column)));
        cells.collect::<Vec<_>>().join("  ").trim_end().to_owned()
    };
    rows.iter().map(line).collect()
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
fn verdict(designed: &Designed, design: &StageDesign, reserves: &[WithDrive]) -> String {
    let stage = &design.stage;
    let weight = significant(stage.weight(), 4);
    let figures = || reserves.iter().enumerate().map(bears).collect::<Vec<_>>().join("; ");
    match stage.mode {
        Mode::SetPoint { .. } => {
            let filters = filters_command(design);
            match closed_loop::position_words(designed).filter(|_| !reserves.is_empty()) {
                Some(position) => format!(
                    "weight {weight}; {}; filters v_command inside the position loop ({position}): {filters}",
                    figures()
                ),
                None => format!("filters the command, so that no loop can become unstable: {filters}"),
            }
        }
        Mode::Direct { source: DirectSource::Direct } => {
            format!("weight {weight}; measure first: the load lags behind the motor, and no drive alone says how far")
        }
        Mode::Direct { source: DirectSource::Motor } | Mode::Indirect { .. } => {
            format!("weight {weight}; {}", figures())
        }
    }
}

/// The rest of the command at f0.
fn filters_command(design: &StageDesign) -> String {
    let (f0, h) = (design.stage.f0(), at_f0(design));
    let left = |h: Complex| decimals(magnitude(h + 1.0) * 100.0, 0);
    let (left, late) = (left(h), left(h * response::delay(warped(f0, design.cycle_time))));
    let turn = decimals(360.0 * f0 * design.cycle_time, 1);
    format!(
        "{left} % of it pass at {} Hz; {late} % where the drive gets v_add a cycle late, which turns it by 360 f0 Ts = {turn} deg",
        significant(f0, 4)
    )
}

/// The weights up to which the loop stays well damped, and stable, with a drive; for a further drive only the numbers.
fn bears((n, of): (usize, &WithDrive)) -> String {
    let (drive, [calm, stable]) = (&of.drive, [of.calm_up_to, of.stable_up_to].map(|weight| down_to(weight, 2)));
    match n {
        0 => format!("{drive} stays calm (Ms <= {MAX_MS}) up to {calm} and stable up to {stable}"),
        _ => format!("{drive}: {calm} and {stable}"),
    }
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
