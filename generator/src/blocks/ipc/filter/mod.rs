//! A filter of a stage, by its type: a file for each holds its rule, design, response and words. What they share is here.
//!
//! A new type is a word ([`FilterType`]), a variant ([`Filter`]) and a file beside `bandpass.rs`; [`of`] and [`read`] do not compile without it.

mod allpass;
mod bandpass;

use super::super::values::is_same;
use super::stage::FilterDesign;
use crate::axis::Filter;
use crate::design::{band::Band, response::Complex, section::Shape, trapezoidal::Output};
use crate::number::{digits, pair, percent, significant};
use crate::parameters::Name;
use crate::parameters::words::{FilterType, Words};
use crate::rules::effective::Effective;
use allpass::Allpass;
use bandpass::Bandpass;
use reference::filter;

/// What the generator knows of a type of filter.
pub(crate) trait Kind {
    /// its type, and what tells it from others of the type
    fn words(&self) -> String;
    /// the same in a table that has frequency and quality factor of the stage's band-pass in columns of their own
    fn in_table(&self) -> String;
    /// its type and how many sections it has
    fn structure(&self) -> String;
    /// its note, with its edges [Hz]
    fn note(&self, edges: [String; 2]) -> String;
    /// the note of a section, with centre [Hz], quality factor and gain at that centre; none: the note of the filter says all
    fn note_of_section(&self, section: usize, shape: [String; 3]) -> Option<String>;
    /// the filter with its edges [Hz]
    fn description(&self, edges: [f64; 2]) -> String;
    /// what differs in another filter of the same type, but for frequency and quality factor
    fn differences(&self, new: &Filter) -> Vec<String>;
    /// whether a difference begins with its type
    fn named_in_a_difference(&self) -> bool;
    /// what is squeezed where it lies near half the sampling frequency
    fn squeezed(&self) -> &'static str;
    /// by how many sections its time constant is longer
    fn order(&self) -> usize;
    /// whether it lets a band pass alone: an active stage needs such a filter
    fn is_selective(&self) -> bool;
    /// the phase [deg] at t = tan(pi f Ts), of a filter that is there for its phase
    fn phase(&self, band: &Band, t: f64) -> Option<f64>;
    /// its sections before the transform, in the order of their execution
    fn shapes(&self, band: &Band) -> Vec<Shape>;
    /// writes its coefficients, and gives the numbers of each section
    fn design(&self, shapes: &[Shape], coeffs: &mut filter::Coeffs<f64>) -> Vec<Numbers>;
    /// where the coefficients of a section are among those of the filter
    fn place(&self, section: usize) -> String;
    /// what each section puts out
    fn output(&self) -> Output;
    /// the designed response at t = tan(pi f Ts), by a formula that no coefficient is in
    fn response(&self, band: &Band, t: f64) -> Complex;
}

/// Coefficients of a section.
pub(crate) struct Numbers {
    /// a1 and a2 of the biquad
    pub denominator: [f64; 2],
    /// A, B and C of the trapezoidal section
    pub trapezoidal: [f64; 3],
}

/// A filter as its type knows it; none: there is no filter.
pub(crate) fn of(filter: &Filter) -> Option<Box<dyn Kind>> {
    match *filter {
        Filter::NoFilter => None,
        Filter::Bandpass { prototype, order, f0, q_factor } => {
            Some(Box::new(Bandpass { prototype, order, f0, q_factor }))
        }
        Filter::Allpass { f0, q_factor } => Some(Box::new(Allpass { f0, q_factor })),
    }
}

/// The filter that the parameters describe; none: an error, which has been said.
pub(super) fn read(e: &mut Effective<'_>, index: [u32; 2], cycle_time: Option<u32>) -> Option<Filter> {
    match e.word((Name::FilterType, index))? {
        FilterType::NoFilter => Some(Filter::NoFilter),
        FilterType::Bandpass => bandpass::read(e, index, cycle_time),
        FilterType::Allpass => allpass::read(e, index, cycle_time),
    }
}

/// Whether a filter lets a band pass alone.
pub(crate) fn is_selective(filter: &Filter) -> bool {
    of(filter).is_some_and(|kind| kind.is_selective())
}

pub(crate) fn summary(filter: &Filter) -> Option<String> {
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
pub(crate) fn description(design: &FilterDesign) -> String {
    of(&design.filter).map_or_else(|| FilterType::NoFilter.name().to_owned(), |kind| kind.description(design.edges))
}

/// What differs between two filters at the same place.
pub(crate) fn difference(both: [Option<&FilterDesign>; 2]) -> Option<String> {
    let types = both.map(|design| design.map_or(FilterType::NoFilter, |design| design.filter.kind()));
    if types[0] != types[1] {
        let words = both.map(|design| design.map_or_else(|| FilterType::NoFilter.name().to_owned(), description));
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
