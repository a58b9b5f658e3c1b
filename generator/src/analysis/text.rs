//! An analysis in words: a table for each drive, words on each stage and on the sum, and facts from the parameters
//! alone.

use super::{Analysis, OfDrive, OfStage, analyze, lead};
use crate::axis::Filter;
use crate::blocks::ipc::closed_loop;
use crate::blocks::ipc::stage::StageDesign;
use crate::blocks::{Designed, Reserve};
use crate::number::{decimals, digits, down_to, significant};
use stability::MAX_MS;

/// Above the first lag of a loop at f0 an all-pass is mandatory; above the second it is worth trying [degrees].
const MANDATORY: f64 = 90.0;
const WORTH_A_TRY: f64 = 20.0;

/// The lines for an axis.
#[must_use]
pub fn text(designed: &Designed) -> String {
    let axis = &designed.axis;
    let cycle = f64::from(axis.cycle_time_ns) / 1000.0;
    let Analysis { drives } = analyze(designed, &axis.drive);
    // Without a stage the drive does not matter, and its gain is that of the axis.
    let of_axis =
        || Some(format!("Kv {}/s", digits(f64::from(axis.control.kv.filter(|_| drives.is_empty())?) / 100.0)));
    let position = match closed_loop::position_words(designed).or_else(of_axis) {
        Some(position) => format!("position loop with {position}"),
        None => "without its position loop: Kv (P-AXIS-00099) is not given".to_owned(),
    };
    let mut lines = vec![format!("axis {}: cycle {cycle} us, {position}", axis.name)];
    lines.extend(outside(designed, drives.is_empty()).map(|line| format!("  {line}")));
    lines.extend(drives.iter().flat_map(of_drive));
    if let Some(first) = drives.first() {
        lines.extend(parameters(designed, first));
    }
    lines.iter().map(|line| format!("{line}\n")).collect()
}

/// The stages that the analysis leaves out, or the statement that no stage closes a loop.
#[must_use]
pub fn outside(designed: &Designed, is_empty: bool) -> Option<String> {
    let none = || is_empty.then(|| "no stage looks at v_motor or v_direct: the stages close no loop".to_owned());
    closed_loop::not_judged(designed).or_else(none)
}

fn of_drive(of: &OfDrive) -> Vec<String> {
    let mut lines = vec![format!("  {}", headline(of))];
    let mut line = |[stage, weight, phase, calm, stable, reserve]: [String; 6]| {
        let row = format!("    {stage:<5}  {weight:<6}  {phase:<11}  {calm:<10}  {stable:<12}  {reserve}");
        lines.push(row.trim_end().to_owned());
    };
    line(STAGE.map(str::to_owned));
    of.stages.iter().map(stage_cells).for_each(line);
    lines
}

/// The columns of a stage in a loop.
pub const STAGE: [&str; 6] = ["stage", "weight", "phase at f0", "calm up to", "stable up to", ""];

/// The cells of a stage in a loop.
#[must_use]
pub fn stage_cells(stage: &OfStage) -> [String; 6] {
    [
        stage.stage.to_string(),
        significant(stage.weight, 4),
        format!("{} deg", decimals(stage.phase_at_f0_deg, 0)),
        down_to(stage.largest_weight, 3),
        down_to(stage.largest_stable_weight, 3),
        reserve(stage).to_owned(),
    ]
}

/// A drive, and the sum of the stages with it.
#[must_use]
pub fn headline(of: &OfDrive) -> String {
    format!("{}: {}", of.drive.words(), sum(of))
}

fn sum(of: &OfDrive) -> String {
    let [verdict, ms, gain, phase] = margins(of);
    if ms.is_empty() { verdict } else { format!("{verdict}: Ms {ms}, gain margin {gain}, phase margin {phase}") }
}

/// The verdict on a loop, its Ms, gain margin and phase margin; the last three are empty if there are none.
#[must_use]
pub fn margins(of: &OfDrive) -> [String; 4] {
    let Some([ms, hz]) = of.margins.ms else {
        let verdict = match of.margins.stable {
            true => "stable, but perhaps not: within the errors of the measurement it may oscillate",
            false => "UNSTABLE: it oscillates",
        };
        return [verdict.to_owned(), String::new(), String::new(), String::new()];
    };
    let word = if ms <= MAX_MS { "calm" } else { "stable, with little reserve" };
    let margin = |value: Option<f64>, unit: &str| {
        value.map_or_else(|| "unlimited".to_owned(), |value| format!("{} {unit}", decimals(value, 1)))
    };
    [
        word.to_owned(),
        format!("{} at {} Hz", decimals(ms, 2), significant(hz, 3)),
        margin(of.margins.gain_db, "dB"),
        margin(of.margins.phase_deg, "deg"),
    ]
}

fn reserve(stage: &OfStage) -> &'static str {
    Reserve::of(stage.weight, [stage.largest_weight, stage.largest_stable_weight]).word()
}

/// Facts from the parameters without a loop, and the all-pass for the lag of a drive.
fn parameters(designed: &Designed, with: &OfDrive) -> Vec<String> {
    let stages: Vec<&StageDesign> = designed.stage.iter().flatten().collect();
    let mut lines = Vec::new();
    for of in &stages {
        let (index, f0) = (of.index, of.stage.f0());
        let others = stages.iter().filter(|other| other.index != index);
        let others: Vec<String> = others
            .map(|other| {
                let part = decimals(lead::interaction(of, other) * 100.0, 1);
                format!("; stage {} adds {part} % of what it adds there", other.index)
            })
            .collect();
        let delay = significant(lead::group_delay(of) * 1e3, 3);
        lines.push(format!("  stage {index} at {} Hz: group delay {delay} ms{}", significant(f0, 4), others.concat()));
        lines.extend(lag(designed, of, with));
    }
    lines
}

/// The lag of the drive at the f0 of a stage, and the all-pass that compensates it. Where none is mandatory, one is proposed
/// only if less is left of the vibration with it, both times with the largest calm weight: it turns other frequencies too.
fn lag(designed: &Designed, of: &StageDesign, with: &OfDrive) -> Option<String> {
    let lag = with.lag.iter().find(|(stage, _)| *stage == of.index)?.1;
    if lag < WORTH_A_TRY {
        return None;
    }
    let word = if lag > MANDATORY { "is mandatory" } else { "may help" };
    let proposal = match lead::allpass(of, lag) {
        Some([q_factor, f0]) => {
            let k = 1 - of.stage.first_bandpass();
            let mut axis = designed.axis.clone();
            let filters = axis.ipc.stage[of.index].iter_mut().map(|stage| &mut stage.filter[k as usize]);
            filters.for_each(|filter| *filter = Filter::Allpass { f0, q_factor });
            let at_best = |designed: &Designed| lead::at_best(designed, of, &with.drive);
            match (at_best(designed), at_best(&Designed::from(axis))) {
                (Some([_, without]), Some([calm, left])) if lag > MANDATORY || left < without => format!(
                    "an all-pass {word}: filter[{k}] with type ALLPASS, fg_f0 {}, q_factor {}; calm up to {} with it",
                    digits(f0),
                    significant(q_factor, 3),
                    down_to(calm, 3)
                ),
                _ => "an all-pass would not help".to_owned(),
            }
        }
        None => "no all-pass can be added that gives it back".to_owned(),
    };
    Some(format!("    this drive lags by {} deg there: {proposal}", decimals(lag, 0)))
}
