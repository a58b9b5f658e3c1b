//! The low-pass prototypes of the band-passes as poles. No frequency, no section, no coefficient.

use crate::axis::Prototype;
use core::f64::consts::FRAC_1_SQRT_2;

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
