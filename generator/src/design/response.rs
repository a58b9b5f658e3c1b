//! The frequency response of coefficients: of what the machine will execute, not of what was designed.
//!
//! Everything is evaluated at a point t = tan(pi f Ts) of the warped frequency axis, where z^-1 = (1 - j t) / (1 + j t). A
//! second-order polynomial in z^-1 becomes one in j t whose coefficients are sums of the given ones that are exact
//! where it matters, so that a low frequency costs no digits here: what is seen is the rounding of the coefficients.

use super::denominator::at_dc_and_nyquist;
use portable::Real;
use reference::filter::Type;
use reference::stage::Mode;
use reference::{allpass, bandpass, biquad, filter, stage};

/// A complex number.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Complex {
    /// real part
    pub re: f64,
    /// imaginary part
    pub im: f64,
}

/// From the velocity that a stage looks at to what it adds.
#[must_use]
pub fn of_stage<R: Real>(coeffs: &stage::Coeffs<R>, t: f64) -> Complex {
    if coeffs.mode == Mode::NotActive {
        return Complex { re: 0.0, im: 0.0 };
    }
    let mut h = Complex { re: coeffs.gain.to_f64(), im: 0.0 };
    if coeffs.mode != Mode::Direct {
        h = product(h, of_biquad(&coeffs.oscillation, t));
    }
    coeffs.filter.iter().fold(h, |h, filter| product(h, of_filter(filter, t)))
}

/// Of one filter of a stage.
#[must_use]
pub fn of_filter<R: Real>(coeffs: &filter::Coeffs<R>, t: f64) -> Complex {
    let one = Complex { re: 1.0, im: 0.0 };
    match coeffs.kind {
        Type::NoFilter => one,
        Type::Bandpass => {
            coeffs.bandpass.iter().take(coeffs.order).fold(one, |h, section| product(h, of_bandpass(section, t)))
        }
        Type::Allpass => of_allpass(&coeffs.allpass, t),
    }
}

/// Of one band-pass section.
#[must_use]
pub fn of_bandpass<R: Real>(coeffs: &bandpass::Coeffs<R>, t: f64) -> Complex {
    let numerator = Complex { re: 0.0, im: -4.0 * coeffs.b2.to_f64() * t };
    quotient(numerator, polynomial(1.0, coeffs.a1.to_f64(), coeffs.a2.to_f64(), t))
}

/// Of an all-pass section.
#[must_use]
pub fn of_allpass<R: Real>(coeffs: &allpass::Coeffs<R>, t: f64) -> Complex {
    let denominator = polynomial(1.0, coeffs.a1.to_f64(), coeffs.a2.to_f64(), t);
    quotient(Complex { re: denominator.re, im: -denominator.im }, denominator)
}

/// Of a general second-order section.
#[must_use]
pub fn of_biquad<R: Real>(coeffs: &biquad::Coeffs<R>, t: f64) -> Complex {
    let numerator = polynomial(coeffs.b0.to_f64(), coeffs.b1.to_f64(), coeffs.b2.to_f64(), t);
    quotient(numerator, polynomial(1.0, coeffs.a1.to_f64(), coeffs.a2.to_f64(), t))
}

/// |h|
#[must_use]
pub fn magnitude(h: Complex) -> f64 {
    libm::hypot(h.re, h.im)
}

/// Phase in degrees, above -180 and up to 180.
#[must_use]
pub fn phase(h: Complex) -> f64 {
    libm::atan2(h.im, h.re).to_degrees()
}

/// (1 + j t)^2 (c0 + c1 z^-1 + c2 z^-2) = (c0 + c1 + c2) + 2 (c0 - c2) j t - (c0 - c1 + c2) t^2.
fn polynomial(c0: f64, c1: f64, c2: f64, t: f64) -> Complex {
    let [dc, nyquist] = at_dc_and_nyquist(c0, c1, c2);
    Complex { re: dc - nyquist * t * t, im: 2.0 * (c0 - c2) * t }
}

fn product(a: Complex, b: Complex) -> Complex {
    Complex { re: a.re * b.re - a.im * b.im, im: a.re * b.im + a.im * b.re }
}

/// a / b; no square overflows or underflows in the range of a coefficient and of t.
fn quotient(a: Complex, b: Complex) -> Complex {
    let square = b.re * b.re + b.im * b.im;
    Complex { re: (a.re * b.re + a.im * b.im) / square, im: (a.im * b.re - a.re * b.im) / square }
}
