//! A band-pass of order 1 to 3: the poles of its low-pass prototype, its second-order sections. No coefficient.

use super::{band::Band, section::Shape};
use crate::axis::Prototype;
use core::f64::consts::FRAC_1_SQRT_2;
use portable::Extreme;

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
/// Sections are in the order of rising quality factor, equal ones with the lower centre first. |H| = 1 and phase 0 at the
/// centre hold for each order; each section has |H| = 1 there, so that no overall gain is needed.
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
    let m = m.larger(0.0); // never negative, except by rounding
    let w = libm::sqrt(1.0 + m) + libm::sqrt(m);
    let k = 1.0 / quality;
    let c = libm::sqrt(1.0 + 4.0 * quality * quality * m);
    [Shape { g: omega0 / w, k, c }, Shape { g: omega0 * w, k, c }]
}

/// A real pole or a conjugate pair of a low-pass prototype, in the left half plane of s, normalised to its -3 dB
/// frequency.
#[derive(Clone, Copy)]
pub(crate) enum Pole {
    /// s = -sigma
    Real { sigma: f64 },
    /// s = -sigma +- j omega
    Pair { sigma: f64, omega: f64 },
}

/// Poles of the low-pass prototype with |H(0)| = 1 and |H(j)|^2 = 1/2 (P-AXIS-00848, P-AXIS-00750).
///
/// - CRIT_DAMPING: `order` real poles in one place, sigma = (2^(1/order) - 1)^(-1/2).
/// - BUTTERWORTH: on the unit circle, |H(j w)|^2 = 1 / (1 + w^(2 order)).
/// - BESSEL: zeros of the reverse Bessel polynomials s^2 + 3 s + 3 and s^3 + 6 s^2 + 15 s + 15, divided by their -3 dB
///   frequencies 1.3616541287161305 and 1.7556723686812107.
///
/// The numbers are the nearest f64 to values computed with 40 digits.
///
/// # Panics
/// If the order is not 1, 2 or 3, which the check excludes.
pub(crate) fn poles(prototype: Prototype, order: usize) -> &'static [Pole] {
    match (prototype, order) {
        (_, 1) => &[Pole::Real { sigma: 1.0 }],
        (Prototype::CritDamping, 2) => &[Pole::Real { sigma: 1.553_773_974_030_037_4 }; 2],
        (Prototype::CritDamping, 3) => &[Pole::Real { sigma: 1.961_459_176_700_619_8 }; 3],
        (Prototype::Butterworth, 2) => &[Pole::Pair { sigma: FRAC_1_SQRT_2, omega: FRAC_1_SQRT_2 }],
        (Prototype::Butterworth, 3) => {
            &[Pole::Real { sigma: 1.0 }, Pole::Pair { sigma: 0.5, omega: 0.866_025_403_784_438_6 }]
        }
        (Prototype::Bessel, 2) => &[Pole::Pair { sigma: 1.101_601_330_592_161_7, omega: 0.636_009_824_757_034_5 }],
        (Prototype::Bessel, 3) => &[
            Pole::Real { sigma: 1.322_675_799_910_444_8 },
            Pole::Pair { sigma: 1.047_409_161_008_935_3, omega: 0.999_264_436_280_637_5 },
        ],
        _ => panic!("design: the check lets only the orders 1, 2 and 3 through, not {order}"),
    }
}
