//! What is said of a filter, by its type: its note, its part of the summary and of an advice, what differs between two of them.

use super::super::values::is_same;
use super::design::Passband;
use crate::axis::Filter;
use crate::number::{digits, pair, percent, significant};
use crate::parameters::words::{FilterType, Words};

pub(crate) fn summary(filter: &Filter) -> Option<String> {
    let kind = filter.kind().name();
    match filter {
        Filter::NoFilter => None,
        Filter::Bandpass { prototype, order, f0, q_factor } => {
            Some(format!("{kind} {} order {order} at {f0} Hz, Q {q_factor}", prototype.name()))
        }
        Filter::Allpass { f0, q_factor } => Some(format!("{kind} at {f0} Hz, Q {q_factor}")),
    }
}

pub(crate) fn note(filter: &Filter, passband: Option<&Passband>) -> Option<String> {
    let [lower, upper] = passband?.edges.map(digits);
    let kind = filter.kind().name();
    match filter {
        Filter::NoFilter => None,
        Filter::Bandpass { prototype, order, f0, q_factor } => Some(format!(
            "{kind} {} order {order} (P-AXIS-00849, 00848, 00750): centre frequency {f0} Hz (P-AXIS-00751), quality factor \
             {q_factor} (P-AXIS-00752), -3 dB at {lower} and {upper} Hz",
            prototype.name()
        )),
        Filter::Allpass { f0, q_factor } => Some(format!(
            "{kind} (P-AXIS-00849): -180 deg at {f0} Hz (P-AXIS-00751), quality factor {q_factor} (P-AXIS-00752), -90 deg at \
             {lower} and -270 deg at {upper} Hz"
        )),
    }
}

/// A filter with its edges [Hz].
pub(crate) fn description(filter: &Filter, edges: [f64; 2]) -> String {
    let kind = filter.kind().name();
    match *filter {
        Filter::NoFilter => kind.to_owned(),
        Filter::Bandpass { prototype, order, f0, .. } => {
            format!("{kind} {} order {order} at {f0} Hz, edges {} Hz", prototype.name(), range(edges, 4))
        }
        Filter::Allpass { f0, .. } => {
            let [lower, upper] = edges.map(|edge| significant(edge, 4));
            format!("{kind} with -180 deg at {f0} Hz, -90 at {lower} and -270 at {upper} Hz")
        }
    }
}

/// What lies above its centre frequency.
pub(crate) fn above(filter: &Filter) -> &'static str {
    match filter {
        Filter::Allpass { .. } => "phase above it",
        Filter::Bandpass { .. } | Filter::NoFilter => "upper skirt",
    }
}

/// What differs between two filters at the same place.
pub(crate) fn difference([old, new]: [&Filter; 2], edges: [[f64; 2]; 2]) -> Option<String> {
    match (*old, *new) {
        (Filter::NoFilter, Filter::NoFilter) => None,
        (
            Filter::Bandpass { prototype: from, order: order_old, f0: f0_old, q_factor: q_old },
            Filter::Bandpass { prototype: to, order: order_new, f0: f0_new, q_factor: q_new },
        ) => {
            let mut parts = bands([f0_old, f0_new], [q_old, q_new], edges);
            if order_old != order_new {
                parts.push(format!("order {order_old} -> {order_new}"));
            }
            // All prototypes of order 1 are the same filter.
            if from != to && order_old.max(order_new) > 1 {
                parts.push(format!("{} -> {}", from.name(), to.name()));
            }
            (!parts.is_empty()).then(|| parts.join(", "))
        }
        (Filter::Allpass { f0: f0_old, q_factor: q_old }, Filter::Allpass { f0: f0_new, q_factor: q_new }) => {
            let parts = bands([f0_old, f0_new], [q_old, q_new], edges);
            (!parts.is_empty()).then(|| format!("{} {}", FilterType::Allpass.name(), parts.join(", ")))
        }
        _ => Some(format!("{} -> {}", description(old, edges[0]), description(new, edges[1]))),
    }
}

/// Centre, quality factor and edges; the edges move with the cycle time too, by the warping of the frequency axis.
fn bands([f0_old, f0_new]: [f64; 2], [q_old, q_new]: [f64; 2], edges: [[f64; 2]; 2]) -> Vec<String> {
    let mut parts = Vec::new();
    if !is_same(f0_old, f0_new) {
        parts.push(format!("centre frequency {} Hz{}", pair(f0_old, f0_new, 4), percent(f0_old, f0_new)));
    }
    if !is_same(q_old, q_new) {
        let bandwidth = pair(f0_old / q_old, f0_new / q_new, 4);
        parts.push(format!("quality factor {}, bandwidth {bandwidth} Hz", pair(q_old, q_new, 4)));
    }
    let text = |digits| edges.map(|edges| range(edges, digits));
    if !parts.is_empty() || text(7)[0] != text(7)[1] {
        let apart = (4..10).map(text).find(|[a, b]| a != b).unwrap_or_else(|| text(4));
        parts.push(format!("edges {} Hz", apart.join(" -> ")));
    }
    parts
}

fn range(edges: [f64; 2], digits: usize) -> String {
    edges.map(|edge| significant(edge, digits)).join("..")
}
