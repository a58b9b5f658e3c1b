//! A band-pass of order 1 to 3 as second-order sections.

use super::band::Band;
use super::prototype::{Pole, poles};
use super::section::Shape;
use crate::axis::Prototype;

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
pub(crate) fn sections(prototype: Prototype, order: usize, band: &Band) -> Vec<Shape> {
    let q = band.omega0 / band.bandwidth;
    let mut sections = Vec::with_capacity(order);
    for pole in poles(prototype, order) {
        match *pole {
            Pole::Real { sigma } => sections.push(Shape { g: band.omega0, k: sigma / q, c: 1.0 }),
            Pole::Pair { sigma, omega } => sections.extend(pair(sigma, omega, q, band.omega0)),
        }
    }
    sections.sort_by(|a, b| b.k.total_cmp(&a.k).then(a.g.total_cmp(&b.g)));
    sections
}

/// The two sections of a conjugate pair, the lower centre first.
fn pair(sigma: f64, omega: f64, q: f64, omega0: f64) -> [Shape; 2] {
    let qq = q * q;
    let e = (sigma * sigma + omega * omega) / qq;
    let root = libm::sqrt((4.0 + e) * (4.0 + e) - 16.0 * sigma * sigma / qq);
    let quality = libm::sqrt((4.0 + e + root) / 2.0) * q / (2.0 * sigma);
    let m = (e * (root + 4.0) + 8.0 * (omega - sigma) * (omega + sigma) / qq + e * e) / (8.0 * (root + 4.0));
    let m = m.max(0.0); // it is never negative; a rounding may not make it so
    let w = libm::sqrt(1.0 + m) + libm::sqrt(m);
    let k = 1.0 / quality;
    let c = libm::sqrt(1.0 + 4.0 * quality * quality * m);
    [Shape { g: omega0 / w, k, c }, Shape { g: omega0 * w, k, c }]
}
