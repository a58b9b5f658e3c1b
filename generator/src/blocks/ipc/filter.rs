//! What is said of a filter, by its type: its note, its part of the summary, what differs between two of them.

use super::super::values::is_same;
use super::stage::FilterDesign;
use crate::axis::Filter;
use crate::number::{digits, pair, percent, significant};
use crate::parameters::words::{FilterType, Words};

/// Its type; of a band-pass its prototype and its order too.
fn kind(filter: &Filter) -> String {
    let kind = filter.kind().name();
    match filter {
        Filter::NoFilter | Filter::Allpass { .. } => kind.to_owned(),
        Filter::Bandpass { prototype, order, .. } => format!("{kind} {} order {order}", prototype.name()),
    }
}

pub(crate) fn summary(filter: &Filter) -> Option<String> {
    let [f0, q_factor] = filter.f0_and_q()?;
    Some(format!("{} at {f0} Hz, Q {q_factor}", kind(filter)))
}

/// The same in a table that has frequency and quality factor of the band-pass in columns of their own.
pub(crate) fn in_table(filter: &Filter) -> Option<String> {
    match filter {
        Filter::NoFilter => None,
        Filter::Bandpass { .. } => Some(kind(filter)),
        Filter::Allpass { .. } => summary(filter),
    }
}

pub(crate) fn note(of: &FilterDesign) -> Option<String> {
    let [lower, upper] = of.edges.map(digits);
    let kind = kind(&of.filter);
    match of.filter {
        Filter::NoFilter => None,
        Filter::Bandpass { f0, q_factor, .. } => Some(format!(
            "{kind} (P-AXIS-00849, 00848, 00750): centre frequency {f0} Hz (P-AXIS-00751), quality factor {q_factor} \
             (P-AXIS-00752), -3 dB at {lower} and {upper} Hz"
        )),
        Filter::Allpass { f0, q_factor } => Some(format!(
            "{kind} (P-AXIS-00849): -180 deg at {f0} Hz (P-AXIS-00751), quality factor {q_factor} (P-AXIS-00752), -90 deg at \
             {lower} and -270 deg at {upper} Hz"
        )),
    }
}

/// A filter with its edges [Hz].
pub(crate) fn description(of: &FilterDesign) -> String {
    let kind = kind(&of.filter);
    match of.filter {
        Filter::NoFilter => kind,
        Filter::Bandpass { f0, .. } => format!("{kind} at {f0} Hz, edges {} Hz", range(of.edges, 4)),
        Filter::Allpass { f0, .. } => {
            let [lower, upper] = of.edges.map(|edge| significant(edge, 4));
            format!("{kind} with -180 deg at {f0} Hz, -90 at {lower} and -270 at {upper} Hz")
        }
    }
}

/// What differs between two filters at the same place.
pub(crate) fn difference(both: [Option<&FilterDesign>; 2]) -> Option<String> {
    let [kind, other] = both.map(|of| of.map_or(FilterType::NoFilter, |of| of.filter.kind()));
    if kind != other {
        let words = both.map(|of| of.map_or_else(|| FilterType::NoFilter.name().to_owned(), description));
        return Some(words.join(" -> "));
    }
    let [old, new] = [both[0]?, both[1]?];
    let mut parts = bands(old.filter.f0_and_q()?, new.filter.f0_and_q()?, [old.edges, new.edges]);
    if let (
        Filter::Bandpass { prototype: from, order: order_old, .. },
        Filter::Bandpass { prototype: to, order: order_new, .. },
    ) = (old.filter, new.filter)
    {
        if order_old != order_new {
            parts.push(format!("order {order_old} -> {order_new}"));
        }
        // All prototypes of order 1 are the same filter.
        if from != to && order_old.max(order_new) > 1 {
            parts.push(format!("{} -> {}", from.name(), to.name()));
        }
    }
    if parts.is_empty() {
        return None;
    }
    let which = if kind == FilterType::Allpass { format!("{} ", kind.name()) } else { String::new() };
    Some(format!("{which}{}", parts.join(", ")))
}

/// Centre, quality factor and edges; the edges move with the cycle time too, by the warping of the frequency axis.
fn bands([f0_old, q_old]: [f64; 2], [f0_new, q_new]: [f64; 2], edges: [[f64; 2]; 2]) -> Vec<String> {
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
