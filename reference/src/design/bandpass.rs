//! A band-pass of order 1 to 3: its second-order sections. No coefficient.

use super::band::Band;
use super::poles::{Prototype, has_pair, pair_omega, pair_sigma, real_poles, real_sigma};
use super::sections::{Shape, Shapes};
use super::square_root::square_root;
use crate::filter::MAX_ORDER;
use portable::{Real, portable};

/// The sections of a band-pass, in the order of their execution (P-AXIS-00848, P-AXIS-00750).
///
/// The low-pass prototype is transformed by s_LP = (s^2 + Omega0^2) / (B s). With q = Omega0 / B
///
/// - a real pole sigma gives one section g = Omega0, k = sigma / q, c = 1;
/// - a pair sigma, omega gives two sections: [`Pair`].
///
/// Sections are in the order of rising quality factor, equal ones with the lower centre first: the real pole has the largest
/// k in every prototype of order 3. |H| = 1 and phase 0 at the centre hold for each order; each section has |H| = 1 there, so
/// that no overall gain is needed.
#[portable]
pub fn sections<R: Real>(shapes: &mut Shapes<R>, prototype: Prototype, order: usize, band: &Band<R>) {
    let real = real_poles(prototype, order);
    for i in 0..MAX_ORDER {
        if i < real {
            real_section(&mut shapes.section[i], real_sigma::<R>(prototype, order), band);
        }
    }
    if has_pair(prototype, order) {
        let mut of = Pair::<R>::default();
        poles(&mut of, prototype, order);
        root(&mut of, 0u32, band);
        root(&mut of, 1u32, band);
        root(&mut of, 2u32, band);
        root(&mut of, 3u32, band);
        root(&mut of, 4u32, band);
        lower_section(&mut shapes.section[real], &of, band);
        upper_section(&mut shapes.section[real + 1], &of, band);
    }
}

/// The section of a real pole.
#[portable]
pub fn real_section<R: Real>(shape: &mut Shape<R>, sigma: R, band: &Band<R>) {
    shape.g = band.omega0;
    shape.k = sigma / quality(band);
    shape.c = R::ONE;
}

/// q = Omega0 / B
#[portable]
pub fn quality<R: Real>(band: &Band<R>) -> R {
    band.omega0 / band.bandwidth
}

/// A pair of poles s = -sigma +- j omega, whose sections need five square roots, one after the other:
///
/// ```text
/// e  = (sigma^2 + omega^2) / q^2          G  = sqrt((4 + e)^2 - 16 sigma^2 / q^2)
/// Qs = sqrt((4 + e + G) / 2) q / (2 sigma)
/// m  = (e (G + 4) + 8 (omega^2 - sigma^2) / q^2 + e^2) / (8 (G + 4))
/// W  = sqrt(1 + m) + sqrt(m)              c  = sqrt(1 + 4 Qs^2 m)
/// ```
///
/// The sections are g = Omega0 / W and g = Omega0 W, with k = 1 / Qs and the same c. This form is free of the cancellation in
/// W + 1/W = sqrt((4 + e + G) / 2): m = (W - 1/W)^2 / 4 is small in a narrow band.
#[portable]
#[derive(Clone, Copy, Debug, Default)]
pub struct Pair<R> {
    /// sigma of the pair
    pub sigma: R,
    /// omega of the pair
    pub omega: R,
    /// G
    pub root: R,
    /// sqrt((4 + e + G) / 2)
    pub width: R,
    /// Qs
    pub quality: R,
    /// m
    pub m: R,
    /// sqrt(1 + m)
    pub rise: R,
    /// sqrt(m)
    pub fall: R,
    /// c
    pub c: R,
}

/// The poles of a pair of a prototype.
#[portable]
pub fn poles<R: Real>(of: &mut Pair<R>, prototype: Prototype, order: usize) {
    of.sigma = pair_sigma(prototype, order);
    of.omega = pair_omega(prototype, order);
}

/// e = (sigma^2 + omega^2) / q^2
#[portable]
pub fn spread<R: Real>(of: &Pair<R>, qq: R) -> R {
    (of.sigma * of.sigma + of.omega * of.omega) / qq
}

/// m, which only rounding makes negative.
#[portable]
pub fn distance<R: Real>(of: &Pair<R>, qq: R) -> R {
    let e = spread(of, qq);
    let sum = e * (of.root + R::lit(4.0)) + R::lit(8.0) * (of.omega - of.sigma) * (of.omega + of.sigma) / qq + e * e;
    let m = sum / (R::lit(8.0) * (of.root + R::lit(4.0)));
    if m < R::ZERO { R::ZERO } else { m }
}

/// The argument of the square root whose turn it is, from 0 to 4.
#[portable]
pub fn argument<R: Real>(of: &mut Pair<R>, turn: u32, band: &Band<R>) -> R {
    let mut x = of.m;
    if turn < 3u32 {
        let q = quality(band);
        let qq = q * q;
        let e = spread(of, qq);
        if turn == 0u32 {
            x = (R::lit(4.0) + e) * (R::lit(4.0) + e) - R::lit(16.0) * of.sigma * of.sigma / qq;
        } else if turn == 1u32 {
            x = (R::lit(4.0) + e + of.root) / R::lit(2.0);
        } else {
            of.quality = of.width * q / (R::lit(2.0) * of.sigma);
            let m = distance(of, qq);
            of.m = m;
            x = R::ONE + m;
        }
    } else if turn == 4u32 {
        x = R::ONE + R::lit(4.0) * of.quality * of.quality * of.m;
    }
    x
}

/// Keeps the square root whose turn it is.
#[portable]
pub fn keep<R: Real>(of: &mut Pair<R>, turn: u32, root: R) {
    if turn == 0u32 {
        of.root = root;
    } else if turn == 1u32 {
        of.width = root;
    } else if turn == 2u32 {
        of.rise = root;
    } else if turn == 3u32 {
        of.fall = root;
    } else {
        of.c = root;
    }
}

/// Takes a square root.
#[portable]
pub fn root<R: Real>(of: &mut Pair<R>, turn: u32, band: &Band<R>) {
    let x = argument(of, turn, band);
    let y = square_root(x);
    keep(of, turn, y);
}

/// The section with the lower centre.
#[portable]
pub fn lower_section<R: Real>(shape: &mut Shape<R>, of: &Pair<R>, band: &Band<R>) {
    shape.g = band.omega0 / (of.rise + of.fall);
    shape.k = R::ONE / of.quality;
    shape.c = of.c;
}

/// The section with the upper centre.
#[portable]
pub fn upper_section<R: Real>(shape: &mut Shape<R>, of: &Pair<R>, band: &Band<R>) {
    shape.g = band.omega0 * (of.rise + of.fall);
    shape.k = R::ONE / of.quality;
    shape.c = of.c;
}
