//! Two versions of a stage beside each other: what was set, and what it does at the centre frequencies.

use super::super::values::is_same;
use super::design::StageDesign;
use super::filter;
use crate::axis::Filter;
use crate::design::band::warped;
use crate::design::response::{magnitude, of_stage, phase};
use crate::number::{decibels, decimals, pair, significant};
use crate::parameters::words::{FilterType, StageMode, Words};

/// What differs, in one line; none: nothing.
pub(crate) fn difference(old: Option<&StageDesign>, new: Option<&StageDesign>) -> Option<String> {
    match (old, new) {
        (None, None) => None,
        (Some(old), None) => Some(format!("{} -> {}", description(old), StageMode::NotActive.name())),
        (None, Some(new)) => Some(format!("{} -> {}", StageMode::NotActive.name(), description(new))),
        (Some(old), Some(new)) => between(old, new),
    }
}

/// A stage that has no older version.
pub(crate) fn description(of: &StageDesign) -> String {
    let stage = &of.stage;
    let weight = stage.weight();
    let mut parts =
        vec![stage.mode.text(), format!("weight {} ({} dB)", significant(weight, 7), decimals(decibels(weight), 2))];
    parts.extend(stage.mode.osc_damping().map(|damping| format!("damping {damping}")));
    let filters = (0..stage.filter.len()).filter(|index| stage.filter[*index].kind() != FilterType::NoFilter);
    parts.extend(filters.map(|index| filter::description(&stage.filter[index], edges_of(of, index))));
    parts.join(", ")
}

fn between(old: &StageDesign, new: &StageDesign) -> Option<String> {
    let mut parts = Vec::new();
    let [source_old, source_new] = [old, new].map(|of| of.stage.mode.text());
    if source_old != source_new {
        parts.push(format!("{source_old} -> {source_new}"));
    }
    let [weight_old, weight_new] = [old, new].map(|of| of.stage.weight());
    if !is_same(weight_old, weight_new) {
        let [a, b] = [weight_old, weight_new].map(|weight| decimals(decibels(weight), 2));
        parts.push(format!("weight {} ({a} -> {b} dB)", pair(weight_old, weight_new, 4)));
    }
    match [old, new].map(|of| of.stage.mode.osc_damping()) {
        [Some(a), Some(b)] if !is_same(a, b) => parts.push(format!("damping {}", pair(a, b, 4))),
        [Some(a), None] => parts.push(format!("damping {a} -> none")),
        [None, Some(b)] => parts.push(format!("damping none -> {b}")),
        _ => {}
    }
    let several = [old, new].iter().any(|of| !of.stage.filter.contains(&Filter::NoFilter));
    for index in 0..old.stage.filter.len() {
        let prefix = if several { format!("filter[{index}]: ") } else { String::new() };
        let edges = [old, new].map(|of| edges_of(of, index));
        let differs = filter::difference([old, new].map(|of| &of.stage.filter[index]), edges);
        parts.extend(differs.map(|differs| format!("{prefix}{differs}")));
    }
    parts.extend(effects(old, new));
    let [decay_old, decay_new] = [old, new].map(decay);
    if significant(decay_old, 4) != significant(decay_new, 4) {
        parts.push(format!("slowest decay to 1/e {} s", pair(decay_old, decay_new, 4)));
    }
    (!parts.is_empty()).then(|| parts.join("; "))
}

/// The edges of a filter; 0 where there is none.
fn edges_of(of: &StageDesign, index: usize) -> [f64; 2] {
    of.passband[index].map_or([0.0; 2], |passband| passband.edges)
}

/// What the whole stage does at the old and at the new centre frequency, before and after; what stays is left out.
fn effects(old: &StageDesign, new: &StageDesign) -> Vec<String> {
    let [f0_old, f0_new] = [old, new].map(|of| of.stage.f0());
    let second = (!is_same(f0_old, f0_new)).then_some(f0_new);
    [Some(f0_old), second].into_iter().flatten().filter_map(|f0| effect(old, new, f0)).collect()
}

fn effect(old: &StageDesign, new: &StageDesign, f0: f64) -> Option<String> {
    // Beyond half the sampling frequency there is nothing to see.
    if [old, new].iter().any(|of| f0 * of.cycle_time >= 0.5) {
        return None;
    }
    let [before, after] = [old, new].map(|of| of_stage(&of.coeffs, warped(f0, of.cycle_time)));
    let gains = [before, after].map(|h| decimals(decibels(magnitude(h)), 2));
    let from = phase(before);
    let from = if from < -179.95 { from + 360.0 } else { from };
    // The shorter way round.
    let turn = phase(after) - from;
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
    -of.cycle_time / poles.fold(f64::NEG_INFINITY, f64::max)
}
