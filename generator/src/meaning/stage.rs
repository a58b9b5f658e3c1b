//! Two stages beside each other: what was set, and what it does at the centre frequencies.

use super::axis::same;
use super::number::{decibels, decimals, pair, percent, significant};
use crate::axis::{DirectSource, Filter, Mode, Prototype, Stage};
use crate::design::band::{band, edges, frequency, warped};
use crate::design::response::{magnitude, of_stage, phase};
use crate::design::stage::{coefficients, osc_damping};
use reference::filter::Type;
use reference::stage::Coeffs;

/// A stage and its coefficients.
pub struct Designed {
    stage: Stage,
    cycle_time: f64,
    coeffs: Coeffs<f64>,
}

impl Designed {
    /// The stage at a cycle time [s].
    pub fn new(stage: Stage, cycle_time: f64) -> Self {
        let coeffs = coefficients(Some(&stage), cycle_time);
        Self { stage, cycle_time, coeffs }
    }
}

/// What differs, in one line; none: nothing.
pub fn difference(old: Option<&Designed>, new: Option<&Designed>) -> Option<String> {
    match (old, new) {
        (None, None) => None,
        (Some(_), None) => Some(format!("{} -> NOT_ACTIVE", old.map(described)?)),
        (None, Some(new)) => Some(format!("NOT_ACTIVE -> {}", described(new))),
        (Some(old), Some(new)) => between(old, new),
    }
}

/// A stage that there was no other of.
pub fn described(designed: &Designed) -> String {
    let Designed { stage, cycle_time, .. } = designed;
    let weight = stage.weight();
    let mut parts =
        vec![source(stage.mode), format!("weight {} ({} dB)", significant(weight, 7), decimals(decibels(weight), 2))];
    parts.extend(osc_damping(stage.mode).map(|damping| format!("damping {damping}")));
    parts.extend(stage.filter.iter().filter(|filter| **filter != Filter::NoFilter).map(|one| filter(one, *cycle_time)));
    parts.join(", ")
}

fn between(old: &Designed, new: &Designed) -> Option<String> {
    let mut parts = Vec::new();
    let [source_old, source_new] = [old, new].map(|designed| source(designed.stage.mode));
    if source_old != source_new {
        parts.push(format!("{source_old} -> {source_new}"));
    }
    let [weight_old, weight_new] = [old, new].map(|designed| designed.stage.weight());
    if !same(weight_old, weight_new) {
        let [a, b] = [weight_old, weight_new].map(|weight| decimals(decibels(weight), 2));
        parts.push(format!("weight {} ({a} -> {b} dB)", pair(weight_old, weight_new, 4)));
    }
    match [old, new].map(|designed| osc_damping(designed.stage.mode)) {
        [Some(a), Some(b)] if !same(a, b) => parts.push(format!("damping {}", pair(a, b, 4))),
        [Some(a), None] => parts.push(format!("damping {a} -> none")),
        [None, Some(b)] => parts.push(format!("damping none -> {b}")),
        _ => {}
    }
    let several = [old, new].iter().any(|designed| !designed.stage.filter.contains(&Filter::NoFilter));
    for (index, pair) in old.stage.filter.iter().zip(&new.stage.filter).enumerate() {
        let prefix = if several { format!("filter[{index}]: ") } else { String::new() };
        let differs = filters(pair.0, pair.1, [old.cycle_time, new.cycle_time]);
        parts.extend(differs.map(|differs| format!("{prefix}{differs}")));
    }
    parts.extend(effects(old, new));
    let [decay_old, decay_new] = [old, new].map(decay);
    if significant(decay_old, 4) != significant(decay_new, 4) {
        parts.push(format!("slowest decay to 1/e {} s", pair(decay_old, decay_new, 4)));
    }
    (!parts.is_empty()).then(|| parts.join("; "))
}

fn source(mode: Mode) -> String {
    match mode {
        Mode::Direct { source: DirectSource::Motor } => "DIRECT from v_motor",
        Mode::Direct { source: DirectSource::Direct } => "DIRECT from v_direct",
        Mode::Indirect { .. } => "INDIRECT from v_motor",
        Mode::SetPoint { .. } => "SET_POINT from v_command",
    }
    .to_owned()
}

fn filter(filter: &Filter, cycle_time: f64) -> String {
    match *filter {
        Filter::NoFilter => "NO_FILTER".to_owned(),
        Filter::Bandpass { prototype, order, f0, q_factor } => {
            let edges = range(edges_of(f0, q_factor, cycle_time), 4);
            format!("BANDPASS {} order {order} at {f0} Hz, edges {edges} Hz", word(prototype))
        }
        Filter::Allpass { f0, q_factor } => {
            let [lower, upper] = edges_of(f0, q_factor, cycle_time).map(|edge| significant(edge, 4));
            format!("ALLPASS with -180 deg at {f0} Hz, -90 at {lower} and -270 at {upper} Hz")
        }
    }
}

fn filters(old: &Filter, new: &Filter, [cycle_old, cycle_new]: [f64; 2]) -> Option<String> {
    match (*old, *new) {
        (Filter::NoFilter, Filter::NoFilter) => None,
        (
            Filter::Bandpass { prototype: from, order: order_old, f0: f0_old, q_factor: q_old },
            Filter::Bandpass { prototype: to, order: order_new, f0: f0_new, q_factor: q_new },
        ) => {
            let mut parts = bands([f0_old, f0_new], [q_old, q_new], [cycle_old, cycle_new]);
            if order_old != order_new {
                parts.push(format!("order {order_old} -> {order_new}"));
            }
            // All prototypes of order 1 are the same filter.
            if from != to && order_old.max(order_new) > 1 {
                parts.push(format!("{} -> {}", word(from), word(to)));
            }
            (!parts.is_empty()).then(|| parts.join(", "))
        }
        (Filter::Allpass { f0: f0_old, q_factor: q_old }, Filter::Allpass { f0: f0_new, q_factor: q_new }) => {
            let parts = bands([f0_old, f0_new], [q_old, q_new], [cycle_old, cycle_new]);
            (!parts.is_empty()).then(|| format!("ALLPASS {}", parts.join(", ")))
        }
        (old, new) => Some(format!("{} -> {}", filter(&old, cycle_old), filter(&new, cycle_new))),
    }
}

/// Centre, quality factor and edges; the edges move with the cycle time too, by the warping of the frequency axis.
fn bands([f0_old, f0_new]: [f64; 2], [q_old, q_new]: [f64; 2], [cycle_old, cycle_new]: [f64; 2]) -> Vec<String> {
    let mut parts = Vec::new();
    if !same(f0_old, f0_new) {
        parts.push(format!("centre frequency {} Hz{}", pair(f0_old, f0_new, 4), percent(f0_old, f0_new)));
    }
    if !same(q_old, q_new) {
        let bandwidth = pair(f0_old / q_old, f0_new / q_new, 4);
        parts.push(format!("quality factor {}, bandwidth {bandwidth} Hz", pair(q_old, q_new, 4)));
    }
    let [old, new] = [edges_of(f0_old, q_old, cycle_old), edges_of(f0_new, q_new, cycle_new)];
    let text = |digits| [old, new].map(|edges| range(edges, digits));
    if !parts.is_empty() || text(7)[0] != text(7)[1] {
        let apart = (4..10).map(text).find(|[a, b]| a != b).unwrap_or_else(|| text(4));
        parts.push(format!("edges {} Hz", apart.join(" -> ")));
    }
    parts
}

/// What the whole stage does at the old and at the new centre frequency, before and after; what stays is left out.
fn effects(old: &Designed, new: &Designed) -> Vec<String> {
    let [f0_old, f0_new] = [old, new].map(|designed| designed.stage.f0());
    let second = (!same(f0_old, f0_new)).then_some(f0_new);
    [Some(f0_old), second].into_iter().flatten().filter_map(|f0| effect(old, new, f0)).collect()
}

fn effect(old: &Designed, new: &Designed, f0: f64) -> Option<String> {
    // Beyond half the sampling frequency there is nothing to see.
    if [old, new].iter().any(|designed| f0 * designed.cycle_time >= 0.5) {
        return None;
    }
    let [before, after] = [old, new].map(|designed| of_stage(&designed.coeffs, warped(f0, designed.cycle_time)));
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
fn decay(designed: &Designed) -> f64 {
    let Designed { coeffs, cycle_time, stage } = designed;
    let mut sections = Vec::new();
    if osc_damping(stage.mode).is_some() {
        sections.push([coeffs.oscillation.a1, coeffs.oscillation.a2]);
    }
    for filter in &coeffs.filter {
        match filter.kind {
            Type::NoFilter => {}
            Type::Bandpass => {
                sections.extend(filter.bandpass.iter().take(filter.order).map(|section| [section.a1, section.a2]));
            }
            Type::Allpass => sections.push([filter.allpass.a1, filter.allpass.a2]),
        }
    }
    let logarithm = |[a1, a2]: [f64; 2]| {
        let square = a1 * a1 / 4.0 - a2;
        if square < 0.0 { libm::log1p(a2 - 1.0) / 2.0 } else { libm::log(a1.abs() / 2.0 + libm::sqrt(square)) }
    };
    -cycle_time / sections.into_iter().map(logarithm).fold(f64::NEG_INFINITY, f64::max)
}

fn edges_of(f0: f64, q_factor: f64, cycle_time: f64) -> [f64; 2] {
    edges(&band(f0, q_factor, cycle_time)).map(|t| frequency(t, cycle_time))
}

fn range(edges: [f64; 2], digits: usize) -> String {
    edges.map(|edge| significant(edge, digits)).join("..")
}

fn word(prototype: Prototype) -> &'static str {
    match prototype {
        Prototype::CritDamping => "CRIT_DAMPING",
        Prototype::Butterworth => "BUTTERWORTH",
        Prototype::Bessel => "BESSEL",
    }
}
