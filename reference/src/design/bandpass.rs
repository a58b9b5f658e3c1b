//! A band-pass of order 1 to 3: its second-order sections. No coefficient.

use super::band::Band;
use super::poles::{Prototype, has_pair, pair_omega, pair_sigma, real_poles, real_sigma};
use super::sections::Shapes;
use super::square_root::square_root;
use crate::filter::MAX_ORDER;
use portable::{Real, portable};

/// The sections of a band-pass, in the order of their execution (P-AXIS-00848, P-AXIS-00750).
///
/// The low-pass prototype is transformed by s_LP = (s^2 + Omega0^2) / (B s). With q = Omega0 / B
///
/// - a real pole sigma gives one section g = Omega0, k = sigma / q, c = 1;
/// - a pair sigma, omega gives two sections: [`pair`].
///
/// Sections are in the order of rising quality factor, equal ones with the lower centre first: the real pole has the largest
/// k in every prototype of order 3. |H| = 1 and phase 0 at the centre hold for each order; each section has |H| = 1 there, so
/// that no overall gain is needed.
#[portable]
pub fn sections<R: Real>(shapes: &mut Shapes<R>, prototype: Prototype, order: usize, band: &Band<R>) {
    let q = band.omega0 / band.bandwidth;
    let real = real_poles(prototype, order);
    for i in 0..MAX_ORDER {
        if i < real {
            shapes.section[i].g = band.omega0;
            shapes.section[i].k = real_sigma::<R>(prototype, order) / q;
            shapes.section[i].c = R::ONE;
        }
    }
    if has_pair(prototype, order) {
        pair(shapes, real, pair_sigma(prototype, order), pair_omega(prototype, order), q, band.omega0);
    }
}

/// The two sections of a pair sigma, omega, from `at`: g = Omega0 / W and g = Omega0 W with k = 1 / Qs and the same c, where
///
/// ```text
/// e  = (sigma^2 + omega^2) / q^2          G  = sqrt((4 + e)^2 - 16 sigma^2 / q^2)
/// Qs = sqrt((4 + e + G) / 2) q / (2 sigma)
/// m  = (e (G + 4) + 8 (omega^2 - sigma^2) / q^2 + e^2) / (8 (G + 4))
/// W  = sqrt(1 + m) + sqrt(m)              c  = sqrt(1 + 4 Qs^2 m)
/// ```
///
/// This form is free of the cancellation in W + 1/W = sqrt((4 + e + G) / 2): m = (W - 1/W)^2 / 4 is small in a narrow band.
#[portable]
pub fn pair<R: Real>(shapes: &mut Shapes<R>, at: usize, sigma: R, omega: R, q: R, omega0: R) {
    let qq = q * q;
    let e = (sigma * sigma + omega * omega) / qq;
    let root = square_root((R::lit(4.0) + e) * (R::lit(4.0) + e) - R::lit(16.0) * sigma * sigma / qq);
    let quality = square_root((R::lit(4.0) + e + root) / R::lit(2.0)) * q / (R::lit(2.0) * sigma);
    let sum = e * (root + R::lit(4.0)) + R::lit(8.0) * (omega - sigma) * (omega + sigma) / qq + e * e;
    let mut m = sum / (R::lit(8.0) * (root + R::lit(4.0)));
    if m < R::ZERO {
        // by rounding only
        m = R::ZERO;
    }
    let w = square_root(R::ONE + m) + square_root(m);
    let k = R::ONE / quality;
    let c = square_root(R::ONE + R::lit(4.0) * quality * quality * m);
    shapes.section[at].g = omega0 / w;
    shapes.section[at].k = k;
    shapes.section[at].c = c;
    shapes.section[at + 1].g = omega0 * w;
    shapes.section[at + 1].k = k;
    shapes.section[at + 1].c = c;
}
