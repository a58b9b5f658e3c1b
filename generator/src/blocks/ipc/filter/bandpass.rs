//! A band-pass of order 1 to 3: its rule, design, response and words.

use super::kind::{FilterKind, Numbers, range};
use super::rules::f0;
use crate::axis::{Filter, Prototype};
use crate::codes;
use crate::design::band::Band;
use crate::design::response::Complex;
use crate::design::trapezoidal::Output;
use crate::parameters::Name;
use crate::parameters::words::{FilterType, Words};
use crate::rules::effective::{Effective, as_written};
use reference::design::poles::{self, has_pair, pair_omega, pair_sigma, real_poles, real_sigma};
use reference::{bandpass, filter};

/// A band-pass.
pub(crate) struct Bandpass {
    pub prototype: Prototype,
    /// the number of sections
    pub order: usize,
    pub f0: f64,
    pub q_factor: f64,
}

/// The band-pass that the parameters describe; `None` after a reported error.
pub(super) fn read(e: &mut Effective<'_>, index: [u32; 2], cycle_time: Option<u32>) -> Option<Filter> {
    let prototype = prototype(e, index);
    let order = e.integer((Name::FilterOrder, index));
    let f0 = f0(e, index, cycle_time);
    let q_factor = e.real((Name::FilterQ, index));
    let order = usize::try_from(order?).ok()?;
    Some(Filter::Bandpass { prototype: prototype?, order, f0: f0?, q_factor: q_factor? })
}

/// The prototype. It has a default only in the first filter.
fn prototype(e: &mut Effective<'_>, index: [u32; 2]) -> Option<Prototype> {
    let key = (Name::FilterPrototype, index);
    let parameter = key.0.parameter();
    if index[1] > 0 && e.given(key).is_none() {
        let found = format!(
            "{} is missing: it must be given explicitly for the band-pass in filter[{}]",
            parameter.title(parameter.path, index),
            index[1]
        );
        let of_type = (Name::FilterType, index);
        let instead = as_written(&e.place_of(of_type), key, &[Prototype::CritDamping.name()]);
        e.refuse(codes::PROTOTYPE, of_type, found, [Some(parameter.allowed()), Some(instead)]);
        return None;
    }
    e.word(key)
}

impl FilterKind for Bandpass {
    fn words(&self) -> String {
        format!("{} {} order {}", FilterType::Bandpass.name(), self.prototype.name(), self.order)
    }

    /// The table has separate columns for frequency and quality factor.
    fn in_table(&self) -> String {
        self.words()
    }

    fn structure(&self) -> String {
        format!("{} order {}", FilterType::Bandpass.name(), self.order)
    }

    fn note(&self, [lower, upper]: [String; 2]) -> String {
        let Self { f0, q_factor, .. } = self;
        format!(
            "{} (P-AXIS-00849, 00848, 00750): centre frequency {f0} Hz (P-AXIS-00751), quality factor {q_factor} \
             (P-AXIS-00752), -3 dB at {lower} and {upper} Hz",
            self.words()
        )
    }

    fn note_of_section(&self, section: usize, [centre, quality, gain]: [String; 3]) -> Option<String> {
        let Self { order, f0, .. } = self;
        Some(format!(
            "section {} of {order}: centre frequency {centre} Hz, quality factor {quality}, gain {gain} at its centre and 1 at {f0} Hz",
            section + 1
        ))
    }

    fn with_edges(&self, edges: [f64; 2]) -> String {
        format!("{} at {} Hz, edges {} Hz", self.words(), self.f0, range(edges, 4))
    }

    fn differences(&self, new: &Filter) -> Vec<String> {
        let Filter::Bandpass { prototype, order, .. } = *new else { return Vec::new() };
        let mut parts = Vec::new();
        if order != self.order {
            parts.push(format!("order {} -> {order}", self.order));
        }
        // All prototypes are equal for order 1.
        if prototype != self.prototype && order.max(self.order) > 1 {
            parts.push(format!("{} -> {}", self.prototype.name(), prototype.name()));
        }
        parts
    }

    fn named_in_a_difference(&self) -> bool {
        false
    }

    fn squeezed(&self) -> &'static str {
        "upper skirt"
    }

    fn order(&self) -> usize {
        self.order
    }

    fn is_selective(&self) -> bool {
        true
    }

    fn phase(&self, _: &Band, _: f64) -> Option<f64> {
        None
    }

    fn decide(&self, coeffs: &mut filter::Coeffs<f64>) -> poles::Prototype {
        (coeffs.kind, coeffs.order) = (filter::Type::Bandpass, self.order);
        portable(self.prototype)
    }

    fn numbers(&self, coeffs: &filter::Coeffs<f64>, section: usize) -> Numbers {
        let bandpass::Coeffs { a1, a2, a, b, c, .. } = coeffs.bandpass[section];
        Numbers { denominator: [a1, a2], trapezoidal: [a, b, c] }
    }

    fn place(&self, section: usize) -> String {
        format!("bandpass[{section}]")
    }

    fn output(&self) -> Output {
        Output::Bandpass
    }

    /// Its low-pass prototype at w = (t^2 - Omega0^2) / (B t): the product of sigma / (sigma + j w) and of
    /// (sigma^2 + omega^2) / (sigma^2 + omega^2 - w^2 + 2 j sigma w).
    fn response(&self, Band { omega0, bandwidth }: &Band, t: f64) -> Complex {
        let w = (t - omega0) * (t + omega0) / (bandwidth * t);
        let (prototype, order) = (portable(self.prototype), self.order);
        let sigma = real_sigma(prototype, order);
        let real = Complex::from(sigma) / Complex { re: sigma, im: w };
        let h = (0..real_poles(prototype, order)).fold(Complex::from(1.0), |h, _| h * real);
        if !has_pair(prototype, order) {
            return h;
        }
        let (sigma, omega): (f64, f64) = (pair_sigma(prototype, order), pair_omega(prototype, order));
        let square = sigma * sigma + omega * omega;
        h * (Complex::from(square) / Complex { re: square - w * w, im: 2.0 * sigma * w })
    }
}

/// The prototype as the design names it.
fn portable(prototype: Prototype) -> poles::Prototype {
    match prototype {
        Prototype::CritDamping => poles::Prototype::CritDamping,
        Prototype::Butterworth => poles::Prototype::Butterworth,
        Prototype::Bessel => poles::Prototype::Bessel,
    }
}
