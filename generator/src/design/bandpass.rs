//! A band-pass of order 1 to 3 as second-order sections.

use super::band::Band;
use super::denominator::denominator;
use super::prototype::{Pole, poles};
use crate::axis::Prototype;
use portable::Real;

/// A section c k g s / (s^2 + k g s + g^2), before the transform s = (1 - z^-1) / (1 + z^-1).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Section {
    /// centre on the warped frequency axis: tan(pi f Ts)
    pub g: f64,
    /// reciprocal of the section's quality factor
    pub k: f64,
    /// gain at the section's own centre; its gain at the centre of the whole filter is 1
    pub c: f64,
}

/// The sections of a band-pass, in the order of their execution (P-AXIS-00848, P-AXIS-00750).
///
/// The low-pass prototype is transformed by s_LP = (s^2 + Omega0^2) / (B s). With q = Omega0 / B
///
/// - a real pole sigma gives one section g = Omega0, k = sigma / q, c = 1;
/// - a pair sigma, omega gives two sections g = Omega0 / W and g = Omega0 W with k = 1 / Qs and the same c, where
///
/// ```text
/// e  = (sigma^2 + omega^2) / q^2          G  = sqrt((4 + e)^2 - 16 sigma^2 / q^2)
/// Qs = sqrt((4 + e + G) / 2) q / (2 sigma)
/// m  = (e (G + 4) + 8 (omega^2 - sigma^2) / q^2 + e^2) / (8 (G + 4))
/// W  = sqrt(1 + m) + sqrt(m)              c  = sqrt(1 + 4 Qs^2 m)
/// ```
///
/// This form is free of the cancellation in W + 1/W = sqrt((4 + e + G) / 2): m = (W - 1/W)^2 / 4 is small in a narrow band.
///
/// Sections follow each other with rising quality factor, equal ones with the lower centre first. |H| = 1 and phase 0
/// at the centre hold for each order; each section has |H| = 1 there, so that no overall gain is needed.
#[must_use]
pub fn sections(prototype: Prototype, order: usize, band: &Band) -> Vec<Section> {
    let q = band.omega0 / band.bandwidth;
    let mut sections = Vec::with_capacity(order);
    for pole in poles(prototype, order) {
        match *pole {
            Pole::Real { sigma } => sections.push(Section { g: band.omega0, k: sigma / q, c: 1.0 }),
            Pole::Pair { sigma, omega } => sections.extend(pair(sigma, omega, q, band.omega0)),
        }
    }
    sections.sort_by(|a, b| b.k.total_cmp(&a.k).then(a.g.total_cmp(&b.g)));
    sections
}

/// Coefficients of one section, with a0 = 1 and the signs of `y = -b2 x + s1; s1 = s2 - a1 y; s2 = b2 x - a2 y`.
///
/// b0 = c k g / d, b1 = 0, b2 = -b0, which alone is kept; a1 and a2 from [`denominator`]. All in f64, each rounded once to `R`.
#[must_use]
pub fn coefficients<R: Real>(section: &Section) -> reference::bandpass::Coeffs<R> {
    let d = denominator(section.g, section.k);
    reference::bandpass::Coeffs {
        b2: R::lit(-(section.c * section.k * section.g / d.divisor)),
        a1: R::lit(d.a1),
        a2: R::lit(d.a2),
    }
}

/// The two sections of a conjugate pair, the lower centre first.
fn pair(sigma: f64, omega: f64, q: f64, omega0: f64) -> [Section; 2] {
    let qq = q * q;
    let e = (sigma * sigma + omega * omega) / qq;
    let root = libm::sqrt((4.0 + e) * (4.0 + e) - 16.0 * sigma * sigma / qq);
    let quality = libm::sqrt((4.0 + e + root) / 2.0) * q / (2.0 * sigma);
    let m = (e * (root + 4.0) + 8.0 * (omega - sigma) * (omega + sigma) / qq + e * e) / (8.0 * (root + 4.0));
    let m = m.max(0.0); // it is never negative; a rounding may not make it so
    let w = libm::sqrt(1.0 + m) + libm::sqrt(m);
    let k = 1.0 / quality;
    let c = libm::sqrt(1.0 + 4.0 * quality * quality * m);
    [Section { g: omega0 / w, k, c }, Section { g: omega0 * w, k, c }]
}
