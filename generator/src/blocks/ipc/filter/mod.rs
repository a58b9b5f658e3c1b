//! A filter of a stage, by its type: a file for each type has its rule, design, response and words. The common part is here.
//!
//! A new type needs a word ([`FilterType`]), a variant ([`Filter`]) and a file next to `bandpass.rs`; [`of`] and [`read`] do
//! not compile without it.

mod allpass;
mod bandpass;
mod designed;
mod kind;
mod rules;

use super::super::effects::is_same;
use crate::axis::Filter;
use crate::number::{digits, pair, percent};
use crate::parameters::Name;
use crate::parameters::words::{FilterType, Words};
use crate::rules::effective::Effective;
use allpass::Allpass;
use bandpass::Bandpass;
pub(crate) use designed::FilterDesign;
pub(crate) use kind::FilterKind;
use kind::range;

/// A filter as its type knows it; none: there is no filter.
pub(crate) fn of(filter: &Filter) -> Option<Box<dyn FilterKind>> {
    match *filter {
        Filter::NoFilter => None,
        Filter::Bandpass { prototype, order, f0, q_factor } => {
            Some(Box::new(Bandpass { prototype, order, f0, q_factor }))
        }
        Filter::Allpass { f0, q_factor } => Some(Box::new(Allpass { f0, q_factor })),
    }
}

/// The filter that the parameters describe; `None` after a reported error.
pub(super) fn read(e: &mut Effective<'_>, index: [u32; 2], cycle_time: Option<u32>) -> Option<Filter> {
    match e.deciding_word((Name::FilterType, index))? {
        FilterType::NoFilter => Some(Filter::NoFilter),
        FilterType::Bandpass => bandpass::read(e, index, cycle_time),
        FilterType::Allpass => allpass::read(e, index, cycle_time),
    }
}

/// Whether a filter passes only a band.
pub(crate) fn is_selective(filter: &Filter) -> bool {
    of(filter).is_some_and(|kind| kind.is_selective())
}

pub(crate) fn in_short(filter: &Filter) -> Option<String> {
    let [f0, q_factor] = filter.f0_and_q()?;
    Some(format!("{} at {f0} Hz, Q {q_factor}", of(filter)?.words()))
}

pub(crate) fn in_table(filter: &Filter) -> Option<String> {
    Some(of(filter)?.in_table())
}

pub(crate) fn note(design: &FilterDesign) -> Option<String> {
    Some(of(&design.filter)?.note(design.edges.map(digits)))
}

/// A filter with its edges [Hz].
pub(crate) fn with_edges(design: &FilterDesign) -> String {
    of(&design.filter).map_or_else(|| FilterType::NoFilter.name().to_owned(), |kind| kind.with_edges(design.edges))
}

/// What differs between two filters at the same place.
pub(crate) fn difference(both: [Option<&FilterDesign>; 2]) -> Option<String> {
    let types = both.map(|design| design.map_or(FilterType::NoFilter, |design| design.filter.kind()));
    if types[0] != types[1] {
        let words = both.map(|design| design.map_or_else(|| FilterType::NoFilter.name().to_owned(), with_edges));
        return Some(words.join(" -> "));
    }
    let [old, new] = [both[0]?, both[1]?];
    let kind = of(&old.filter)?;
    let mut parts = bands(old.filter.f0_and_q()?, new.filter.f0_and_q()?, [old.edges, new.edges]);
    parts.extend(kind.differences(&new.filter));
    if parts.is_empty() {
        return None;
    }
    let which = if kind.named_in_a_difference() { format!("{} ", types[0].name()) } else { String::new() };
    Some(format!("{which}{}", parts.join(", ")))
}

/// Changes of centre, quality factor and edges. The edges also depend on the cycle time, because the frequency axis is
/// warped.
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
