//! Improved position control of two versions of an axis: its own values; for each stage its parameters, and its effect at
//! the centre frequencies.

use super::super::effects::is_same;
use super::{details, filter, row::WithDrive, stage::StageDesign};
use crate::axis::{Ipc, Tuning};
use crate::blocks::designed::Designed;
use crate::design::{band::warped, response};
use crate::number::{decibels, decimals, down_to, pair, significant};
use crate::parameters::words::{StageMode, Words};
use portable::Extreme;
use stability::MAX_MS;

/// The differences: one line each for the limit and the properties of the block, then a line for each stage,
/// and one for each stage that bears other weights.
pub(crate) fn differences(old: &Designed, new: &Designed) -> Vec<String> {
    let ipc = [old, new].map(|of| &of.axis.ipc);
    let of_block = [
        limit([old, new]),
        changed(ipc.map(|of| of.enable), |[old, new]| format!("starts {} -> {}", old.name(), new.name())),
        fades([old, new]),
        changed(ipc.map(|of| of.ride_through), |[old, new]| {
            format!("rides through {old} -> {new} bad samples in a row")
        }),
        changed(ipc.map(Ipc::tuning), |tuning| {
            let [old, new] = tuning.map(|of| of.map_or_else(|| "nothing".to_owned(), started));
            format!("the caller tunes {old} -> {new}")
        }),
        changed(ipc.map(|of| of.watch), |[_, is_new]| {
            format!("{} its loop", if is_new { "watches" } else { "no longer watches" })
        }),
    ];
    let mut lines: Vec<_> = of_block.into_iter().flatten().collect();
    let stages = old.stage.iter().zip(&new.stage).map(|(old, new)| of_stages(old.as_ref(), new.as_ref()));
    let margins = details::margins(old).zip(details::margins(new)).map(|(old, new)| of_margins(&old?, &new?));
    let of_stage = stages.enumerate().chain(margins.enumerate());
    lines.extend(of_stage.filter_map(|(index, line)| Some(format!("stage[{index}]: {}", line?))));
    lines.extend(changed(ipc.map(Ipc::takes_sets), |takes| {
        let [old, new] = takes.map(|takes| if takes { "taken over" } else { "none" });
        format!("parameter sets {old} -> {new}")
    }));
    lines
}

/// A line about the old and the new value of something; `None` if they are equal.
fn changed<T: PartialEq>([old, new]: [T; 2], line: impl FnOnce([T; 2]) -> String) -> Option<String> {
    (old != new).then(|| line([old, new]))
}

fn limit(both: [&Designed; 2]) -> Option<String> {
    let [old, new] = both.map(|of| of.axis.ipc.limit());
    let parts = both.map(part);
    let parts = if is_same(parts[0], parts[1]) { significant(parts[0], 7) } else { pair(parts[0], parts[1], 4) };
    (!is_same(old, new)).then(|| format!("limit {} ({parts} % of v_max)", pair(old, new, 7)))
}

fn fades(both: [&Designed; 2]) -> Option<String> {
    let [old, new] = both.map(fade);
    (!is_same(old, new)).then(|| format!("fade {} s", pair(old, new, 4)))
}

/// The values of an axis that has no older version.
pub(crate) fn added(of: &Designed) -> Vec<String> {
    let ipc = &of.axis.ipc;
    if let Some(master) = of.axis.control.master {
        return vec![format!("gantry slave of axis {master}")];
    }
    let mut lines = vec![format!(
        "limit {} ({} % of v_max), starts {}, fade {} s",
        significant(ipc.limit(), 7),
        significant(part(of), 7),
        ipc.enable.name(),
        significant(fade(of), 4),
    )];
    let stages = of.stage.iter().flatten();
    lines.extend(stages.map(|stage| format!("stage[{}]: {}", stage.index, of_stage(stage))));
    lines.extend(ipc.takes_sets().then(|| "parameter sets taken over".to_owned()));
    lines
}

/// The largest weights of a stage, where they are others than before.
fn of_margins(old: &WithDrive, new: &WithDrive) -> Option<String> {
    let texts = |of: &WithDrive| [down_to(of.calm_up_to, 2), down_to(of.stable_up_to, 2), of.drive.clone()];
    let [old, new] = [old, new].map(texts);
    let [calm, stable, drive] = std::array::from_fn(|n| match [&old[n], &new[n]] {
        [old, new] if old == new => new.clone(),
        [old, new] => format!("{old} -> {new}"),
    });
    (old != new).then(|| format!("largest weight: calm (Ms <= {MAX_MS}) {calm}, stable {stable}, with {drive}"))
}

/// The inputs for tuning and their start values.
fn started(tuning: Tuning) -> String {
    let Tuning { limit, weight: [first, second, third] } = tuning;
    format!("weights (starting at {first}, {second}, {third} of each) and limit (starting at {limit} of it)")
}

/// The limit as a part of v_max [%].
fn part(of: &Designed) -> f64 {
    f64::from(of.axis.ipc.v_add_max_fact) / 10.0
}

/// The fade of the block, in whole cycles [s].
fn fade(of: &Designed) -> f64 {
    f64::from(of.ipc.fade_cycles) * of.axis.cycle_time()
}

/// The differences between two versions of a stage, in one line; `None` if there are none.
fn of_stages(old: Option<&StageDesign>, new: Option<&StageDesign>) -> Option<String> {
    match (old, new) {
        (None, None) => None,
        (Some(old), None) => Some(format!("{} -> {}", of_stage(old), StageMode::NotActive.name())),
        (None, Some(new)) => Some(format!("{} -> {}", StageMode::NotActive.name(), of_stage(new))),
        (Some(old), Some(new)) => between(old, new),
    }
}

/// A stage that has no older version.
fn of_stage(of: &StageDesign) -> String {
    let stage = &of.stage;
    let weight = stage.weight();
    let mut parts = vec![
        stage.mode.text(),
        format!("weight {}{} ({} dB)", significant(weight, 7), stage.cap(), decimals(decibels(weight), 2)),
    ];
    parts.extend(stage.mode.osc_damping().map(|damping| format!("damping {damping}")));
    parts.extend(of.filter.iter().flatten().map(filter::with_edges));
    parts.join(", ")
}

fn between(old: &StageDesign, new: &StageDesign) -> Option<String> {
    let source = changed([old, new].map(|of| of.stage.mode.text()), |both| both.join(" -> "));
    let mut parts = Vec::from_iter(source);
    let [weight_old, weight_new] = [old, new].map(|of| of.stage.weight());
    // A capped weight is marked: the blocks may be equal although the parameters differ.
    let [cap_old, cap_new] = [old, new].map(|of| of.stage.cap());
    if !is_same(weight_old, weight_new) || cap_old != cap_new {
        let [a, b] = [weight_old, weight_new].map(|weight| decimals(decibels(weight), 2));
        let weights = pair(weight_old, weight_new, 4).replace(" -> ", &format!("{cap_old} -> "));
        parts.push(format!("weight {weights}{cap_new} ({a} -> {b} dB)"));
    }
    match [old, new].map(|of| of.stage.mode.osc_damping()) {
        [Some(a), Some(b)] if !is_same(a, b) => parts.push(format!("damping {}", pair(a, b, 4))),
        [Some(a), None] => parts.push(format!("damping {a} -> none")),
        [None, Some(b)] => parts.push(format!("damping none -> {b}")),
        _ => {}
    }
    let several = [old, new].iter().any(|of| of.filter.iter().all(Option::is_some));
    for (index, both) in old.filter.iter().zip(&new.filter).enumerate() {
        let prefix = if several { format!("filter[{index}]: ") } else { String::new() };
        let differs = filter::difference([both.0.as_ref(), both.1.as_ref()]);
        parts.extend(differs.map(|differs| format!("{prefix}{differs}")));
    }
    parts.extend(responses(old, new));
    let [decay_old, decay_new] = [old, new].map(decay);
    if significant(decay_old, 4) != significant(decay_new, 4) {
        parts.push(format!("slowest decay to 1/e {} s", pair(decay_old, decay_new, 4)));
    }
    (!parts.is_empty()).then(|| parts.join("; "))
}

/// The effect of the whole stage at the old and at the new centre frequency, before and after; unchanged values are left
/// out.
fn responses(old: &StageDesign, new: &StageDesign) -> Vec<String> {
    let [f0_old, f0_new] = [old, new].map(|of| of.stage.f0());
    let second = (!is_same(f0_old, f0_new)).then_some(f0_new);
    [Some(f0_old), second].into_iter().flatten().filter_map(|f0| response(old, new, f0)).collect()
}

fn response(old: &StageDesign, new: &StageDesign, f0: f64) -> Option<String> {
    // Above half the sampling frequency there is no response.
    if [old, new].iter().any(|of| f0 * of.cycle_time >= 0.5) {
        return None;
    }
    let [before, after] = [old, new].map(|of| response::of_stage(&of.coeffs, warped(f0, of.cycle_time)));
    let gains = [before, after].map(|h| decimals(decibels(response::magnitude(h)), 2));
    let from = response::phase(before);
    let from = if from < -179.95 { from + 360.0 } else { from };
    // The shorter way round.
    let turn = response::phase(after) - from;
    let phases = [from, from + turn - 360.0 * libm::round(turn / 360.0)].map(|degrees| decimals(degrees, 1));
    if gains[0] == gains[1] && phases[0] == phases[1] {
        return None;
    }
    let text = |[a, b]: [String; 2]| if a == b { a } else { format!("{a} -> {b}") };
    Some(format!("at {} Hz: {} dB, {} deg", significant(f0, 7), text(gains), text(phases)))
}

/// Time in which the slowest pole of a stage decays to 1/e [s]: -Ts / ln r, r its distance from the origin.
fn decay(of: &StageDesign) -> f64 {
    let logarithm = |[a1, a2]: [f64; 2]| {
        let square = a1 * a1 / 4.0 - a2;
        if square < 0.0 { libm::log1p(a2 - 1.0) / 2.0 } else { libm::log(a1.abs() / 2.0 + libm::sqrt(square)) }
    };
    let poles = of.section.iter().map(|section| logarithm(section.denominator));
    -of.cycle_time / poles.fold(f64::NEG_INFINITY, f64::larger)
}
