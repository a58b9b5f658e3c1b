//! The frequency response of coefficients of biquads.
//!
//! Everything is evaluated at a point t = tan(pi f Ts) of the warped frequency axis, where z^-1 = (1 - j t) / (1 + j t). A
//! second-order polynomial in z^-1 becomes one in j t, whose coefficients are sums of the given ones. These sums are exact
//! where it matters, so a low frequency loses no digits: the result shows the rounding of the coefficients.

use reference::{allpass, bandpass, filter, filter::Type, oscillation, stage, stage::Mode};

pub(crate) use stability::Complex64 as Complex;

/// From the input velocity of a stage to its output.
pub(crate) fn of_stage(coeffs: &stage::Coeffs<f64>, t: f64) -> Complex {
    if coeffs.mode == Mode::NotActive {
        return Complex::from(0.0);
    }
    let mut h = Complex::from(coeffs.gain);
    if coeffs.mode != Mode::Direct {
        h *= of_oscillation(&coeffs.oscillation, t);
    }
    coeffs.filter.iter().fold(h, |h, filter| h * of_filter(filter, t))
}

pub(crate) fn of_filter(coeffs: &filter::Coeffs<f64>, t: f64) -> Complex {
    match coeffs.kind {
        Type::NoFilter => Complex::from(1.0),
        Type::Bandpass => {
            coeffs.bandpass.iter().take(coeffs.order).fold(Complex::from(1.0), |h, section| h * of_bandpass(section, t))
        }
        Type::Allpass => of_allpass(&coeffs.allpass, t),
    }
}

pub(crate) fn of_bandpass(coeffs: &bandpass::Coeffs<f64>, t: f64) -> Complex {
    let numerator = Complex { re: 0.0, im: -4.0 * coeffs.b2 * t };
    numerator / polynomial(1.0, coeffs.a1, coeffs.a2, t)
}

pub(crate) fn of_allpass(coeffs: &allpass::Coeffs<f64>, t: f64) -> Complex {
    let denominator = polynomial(1.0, coeffs.a1, coeffs.a2, t);
    Complex { re: denominator.re, im: -denominator.im } / denominator
}

pub(crate) fn of_oscillation(coeffs: &oscillation::Coeffs<f64>, t: f64) -> Complex {
    let numerator = polynomial(coeffs.b0, coeffs.b1, coeffs.b2, t);
    numerator / polynomial(1.0, coeffs.a1, coeffs.a2, t)
}

/// A delay of one cycle: z^-1.
pub(crate) fn delay(t: f64) -> Complex {
    Complex { re: 1.0, im: -t } / Complex { re: 1.0, im: t }
}

pub(crate) fn magnitude(h: Complex) -> f64 {
    libm::hypot(h.re, h.im)
}

/// Phase in degrees, above -180 and up to 180.
pub(crate) fn phase(h: Complex) -> f64 {
    libm::atan2(h.im, h.re).to_degrees()
}

/// Phase in degrees for display: above -179.9999999, so that a rounding does not turn 180 into -180.
pub(crate) fn angle(h: Complex) -> f64 {
    let angle = phase(h);
    if angle < -179.999_999_9 { angle + 360.0 } else { angle }
}

/// (1 + j t)^2 (c0 + c1 z^-1 + c2 z^-2) = (c0 + c1 + c2) + 2 (c0 - c2) j t - (c0 - c1 + c2) t^2.
fn polynomial(c0: f64, c1: f64, c2: f64, t: f64) -> Complex {
    let [dc, nyquist] = at_dc_and_nyquist(c0, c1, c2);
    Complex { re: dc - nyquist * t * t, im: 2.0 * (c0 - c2) * t }
}

/// Value of c0 + c1 z^-1 + c2 z^-2 at DC (z = 1) and at the Nyquist frequency (z = -1).
///
/// For a denominator (c0 = 1) both are exact where they are small: the 1 is added to a1 first, because 1 + a2 would be
/// rounded. Their ratio is g^2 for any damping.
pub(crate) fn at_dc_and_nyquist(c0: f64, c1: f64, c2: f64) -> [f64; 2] {
    [(c0 + c1) + c2, (c0 - c1) + c2]
}
