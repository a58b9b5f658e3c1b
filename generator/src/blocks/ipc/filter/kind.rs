//! The interface that the file of each filter type implements.

use crate::axis::Filter;
use crate::design::{band::Band, response::Complex, trapezoidal::Output};
use crate::number::significant;
use reference::{design::poles::Prototype, filter};

/// What the generator knows of a type of filter.
pub(crate) trait FilterKind {
    /// its type, and what tells it from others of the type
    fn words(&self) -> String;
    /// its type and its parameters for a table with separate columns for frequency and quality factor of the band-pass
    fn in_table(&self) -> String;
    /// its type and its number of sections
    fn structure(&self) -> String;
    /// its note, with its edges [Hz]
    fn note(&self, edges: [String; 2]) -> String;
    /// the note of a section, with centre [Hz], quality factor and gain at that centre; `None` if the note of the filter
    /// covers it
    fn note_of_section(&self, section: usize, shape: [String; 3]) -> Option<String>;
    /// the filter with its edges [Hz]
    fn with_edges(&self, edges: [f64; 2]) -> String;
    /// the differences from another filter of the same type, except frequency and quality factor
    fn differences(&self, new: &Filter) -> Vec<String>;
    /// whether the text of a difference begins with the type
    fn named_in_a_difference(&self) -> bool;
    /// the part of the response that is compressed near half the sampling frequency
    fn squeezed(&self) -> &'static str;
    /// the number of sections by which its time constant is multiplied
    fn order(&self) -> usize;
    /// whether it passes only a band: an active stage needs such a filter
    fn is_selective(&self) -> bool;
    /// the phase [deg] at t = tan(pi f Ts); `None` for a filter that is not used for its phase
    fn phase(&self, band: &Band, t: f64) -> Option<f64>;
    /// writes what decides on its structure; returns the prototype, which only a band-pass has
    fn decide(&self, coeffs: &mut filter::Coeffs<f64>) -> Prototype;
    /// the designed numbers of a section
    fn numbers(&self, coeffs: &filter::Coeffs<f64>, section: usize) -> Numbers;
    /// the place of a section's coefficients among those of the filter
    fn place(&self, section: usize) -> String;
    /// the output of each section
    fn output(&self) -> Output;
    /// the designed response at t = tan(pi f Ts), from a formula without coefficients
    fn response(&self, band: &Band, t: f64) -> Complex;
}

/// Coefficients of a section.
pub(crate) struct Numbers {
    /// a1 and a2 of the biquad
    pub denominator: [f64; 2],
    /// A, B and C of the trapezoidal section
    pub trapezoidal: [f64; 3],
}

/// Lower and upper edge in words.
pub(crate) fn range(edges: [f64; 2], digits: u32) -> String {
    edges.map(|edge| significant(edge, digits)).join("..")
}
