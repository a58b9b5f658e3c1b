//! What the generator knows of a type of filter, whichever it is: the interface that each file of a type fills.

use crate::axis::Filter;
use crate::design::{band::Band, response::Complex, section::Shape, trapezoidal::Output};
use crate::number::significant;
use reference::filter;

/// What the generator knows of a type of filter.
pub(crate) trait FilterKind {
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

/// Lower and upper edge in words.
pub(crate) fn range(edges: [f64; 2], digits: usize) -> String {
    edges.map(|edge| significant(edge, digits)).join("..")
}
