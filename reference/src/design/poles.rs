//! The poles of the low-pass prototypes of a band-pass, in the left half plane of s, normalised to the -3 dB frequency.
//!
//! |H(0)| = 1 and |H(j)|^2 = 1/2 (P-AXIS-00848, P-AXIS-00750):
//!
//! - CRIT_DAMPING: `order` real poles in one place, sigma = (2^(1/order) - 1)^(-1/2).
//! - BUTTERWORTH: on the unit circle, |H(j w)|^2 = 1 / (1 + w^(2 order)).
//! - BESSEL: zeros of the reverse Bessel polynomials s^2 + 3 s + 3 and s^3 + 6 s^2 + 15 s + 15, divided by their -3 dB
//!   frequencies 1.3616541287161305 and 1.7556723686812107.
//!
//! A pole of order 1 is 1. The numbers are the nearest f64 to values computed with 40 digits.

use core::f64::consts::FRAC_1_SQRT_2;
use portable::{Real, portable};

/// The low-pass prototype of a band-pass (P-AXIS-00848).
#[portable]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Prototype {
    /// real poles in one place
    #[default]
    CritDamping,
    /// flattest gain
    Butterworth,
    /// flattest delay
    Bessel,
}

/// Whether two of the poles are a conjugate pair.
#[portable]
pub fn has_pair(prototype: Prototype, order: usize) -> bool {
    prototype != Prototype::CritDamping && order > 1usize
}

/// The number of real poles, which are equal.
#[portable]
pub fn real_poles(prototype: Prototype, order: usize) -> usize {
    if has_pair(prototype, order) { order - 2usize } else { order }
}

/// sigma of the real poles s = -sigma.
#[portable]
pub fn real_sigma<R: Real>(prototype: Prototype, order: usize) -> R {
    let mut sigma = R::ONE;
    if prototype == Prototype::CritDamping && order == 2usize {
        sigma = R::lit(1.553_773_974_030_037_4);
    }
    if prototype == Prototype::CritDamping && order == 3usize {
        sigma = R::lit(1.961_459_176_700_619_8);
    }
    if prototype == Prototype::Bessel && order == 3usize {
        sigma = R::lit(1.322_675_799_910_444_8);
    }
    sigma
}

/// sigma of the pair s = -sigma +- j omega of order 2 or 3.
#[portable]
pub fn pair_sigma<R: Real>(prototype: Prototype, order: usize) -> R {
    if prototype == Prototype::Butterworth {
        if order == 2usize { R::lit(FRAC_1_SQRT_2) } else { R::lit(0.5) }
    } else if order == 2usize {
        R::lit(1.101_601_330_592_161_7)
    } else {
        R::lit(1.047_409_161_008_935_3)
    }
}

/// omega of the pair s = -sigma +- j omega of order 2 or 3.
#[portable]
pub fn pair_omega<R: Real>(prototype: Prototype, order: usize) -> R {
    if prototype == Prototype::Butterworth {
        if order == 2usize { R::lit(FRAC_1_SQRT_2) } else { R::lit(0.866_025_403_784_438_6) }
    } else if order == 2usize {
        R::lit(0.636_009_824_757_034_5)
    } else {
        R::lit(0.999_264_436_280_637_5)
    }
}
