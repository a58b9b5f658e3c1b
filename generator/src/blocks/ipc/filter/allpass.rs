//! An all-pass: its rule, design, response and words.

use super::kind::{FilterKind, Numbers};
use super::rules::f0;
use crate::axis::Filter;
use crate::design::band::Band;
use crate::design::response::Complex;
use crate::design::trapezoidal::Output;
use crate::number::significant;
use crate::parameters::Name;
use crate::parameters::words::{FilterType, Words};
use crate::rules::effective::Effective;
use reference::{allpass, design::poles, filter};

/// An all-pass of second order.
pub(crate) struct Allpass {
    pub f0: f64,
    pub q_factor: f64,
}

/// The all-pass that the parameters describe; `None` after a reported error.
pub(super) fn read(e: &mut Effective<'_>, index: [u32; 2], cycle_time: Option<u32>) -> Option<Filter> {
    let f0 = f0(e, index, cycle_time);
    let q_factor = e.real((Name::FilterQ, index));
    Some(Filter::Allpass { f0: f0?, q_factor: q_factor? })
}

impl FilterKind for Allpass {
    fn words(&self) -> String {
        FilterType::Allpass.name().to_owned()
    }

    fn in_table(&self) -> String {
        let Self { f0, q_factor } = self;
        format!("{} at {f0} Hz, Q {q_factor}", self.words())
    }

    fn structure(&self) -> String {
        self.words()
    }

    fn note(&self, [lower, upper]: [String; 2]) -> String {
        let Self { f0, q_factor } = self;
        format!(
            "{} (P-AXIS-00849): -180 deg at {f0} Hz (P-AXIS-00751), quality factor {q_factor} (P-AXIS-00752), -90 deg at \
             {lower} and -270 deg at {upper} Hz",
            self.words()
        )
    }

    /// The note of the filter covers its section.
    fn note_of_section(&self, _: usize, _: [String; 3]) -> Option<String> {
        None
    }

    fn with_edges(&self, edges: [f64; 2]) -> String {
        let [lower, upper] = edges.map(|edge| significant(edge, 4));
        format!("{} with -180 deg at {} Hz, -90 at {lower} and -270 at {upper} Hz", self.words(), self.f0)
    }

    fn differences(&self, _: &Filter) -> Vec<String> {
        Vec::new()
    }

    fn named_in_a_difference(&self) -> bool {
        true
    }

    fn squeezed(&self) -> &'static str {
        "phase above it"
    }

    fn order(&self) -> usize {
        1
    }

    fn is_selective(&self) -> bool {
        false
    }

    /// In degrees, 0 to -360.
    fn phase(&self, Band { omega0, bandwidth }: &Band, t: f64) -> Option<f64> {
        Some(-2.0 * libm::atan2(bandwidth * t, (omega0 - t) * (omega0 + t)).to_degrees())
    }

    fn decide(&self, coeffs: &mut filter::Coeffs<f64>) -> poles::Prototype {
        coeffs.kind = filter::Type::Allpass;
        poles::Prototype::default()
    }

    fn numbers(&self, coeffs: &filter::Coeffs<f64>, _: usize) -> Numbers {
        let allpass::Coeffs { a1, a2, a, b, c, .. } = coeffs.allpass;
        Numbers { denominator: [a1, a2], trapezoidal: [a, b, c] }
    }

    fn place(&self, _: usize) -> String {
        "allpass".to_owned()
    }

    fn output(&self) -> Output {
        Output::Allpass
    }

    /// (Omega0^2 - t^2 - j B t) / (Omega0^2 - t^2 + j B t)
    fn response(&self, Band { omega0, bandwidth }: &Band, t: f64) -> Complex {
        let (re, im) = ((omega0 - t) * (omega0 + t), bandwidth * t);
        Complex { re, im: -im } / Complex { re, im }
    }
}
