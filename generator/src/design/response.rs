//! The frequency response of coefficients of biquads.
//!
//! Everything is evaluated at a point t = tan(pi f Ts) of the warped frequency axis, where z^-1 = (1 - j t) / (1 + j t). A
//! second-order polynomial in z^-1 becomes one in j t, whose coefficients are sums of the given ones. These sums are exact
//! where it matters, so a low frequency loses no digits: the result shows the rounding of the coefficients.

use reference::{allpass, bandpass, filter, filter::Type, oscillation, stage, stage::Mode};

pub use stability::Complex64 as Complex;

/// From the input velocity of a stage to its output.
pub fn of_stage(coeffs: &stage::Coeffs<f64>, t: f64) -> Complex {
    Stage::new(coeffs).at(t)
}

/// A stage for many frequencies: the sums of its coefficients are made once.
pub struct Stage {
    gain: f64,
    oscillation: Option<Section>,
    filters: Vec<Vec<Section>>,
}

impl Stage {
    pub fn new(coeffs: &stage::Coeffs<f64>) -> Self {
        if coeffs.mode == Mode::NotActive {
            return Self { gain: 0.0, oscillation: None, filters: Vec::new() };
        }
        let oscillation = (coeffs.mode != Mode::Direct).then(|| Section::of_oscillation(&coeffs.oscillation));
        let filters = coeffs.filter.iter().map(sections).filter(|sections| !sections.is_empty());
        Self { gain: coeffs.gain, oscillation, filters: filters.collect() }
    }

    pub fn at(&self, t: f64) -> Complex {
        let gain = Complex::from(self.gain);
        let h = self.oscillation.as_ref().map_or(gain, |oscillation| gain * oscillation.at(t));
        self.filters.iter().fold(h, |h, sections| h * product(sections, t))
    }
}

pub fn sections(coeffs: &filter::Coeffs<f64>) -> Vec<Section> {
    match coeffs.kind {
        Type::NoFilter => Vec::new(),
        Type::Bandpass => coeffs.bandpass.iter().take(coeffs.order).map(Section::of_bandpass).collect(),
        Type::Allpass => vec![Section::of_allpass(&coeffs.allpass)],
    }
}

pub fn product(sections: &[Section], t: f64) -> Complex {
    sections.iter().map(|section| section.at(t)).reduce(|h, section| h * section).unwrap_or(Complex::from(1.0))
}

/// Numerator and denominator.
pub struct Section([Polynomial; 2]);

impl Section {
    fn of_bandpass(coeffs: &bandpass::Coeffs<f64>) -> Self {
        let numerator = Polynomial { dc: 0.0, slope: -4.0 * coeffs.b2, nyquist: 0.0 };
        Self([numerator, Polynomial::new(1.0, coeffs.a1, coeffs.a2)])
    }

    pub fn of_allpass(coeffs: &allpass::Coeffs<f64>) -> Self {
        let denominator = Polynomial::new(1.0, coeffs.a1, coeffs.a2);
        Self([Polynomial { slope: -denominator.slope, ..denominator }, denominator])
    }

    pub fn of_oscillation(coeffs: &oscillation::Coeffs<f64>) -> Self {
        Self([Polynomial::new(coeffs.b0, coeffs.b1, coeffs.b2), Polynomial::new(1.0, coeffs.a1, coeffs.a2)])
    }

    pub fn at(&self, t: f64) -> Complex {
        let [numerator, denominator] = &self.0;
        numerator.at(t) / denominator.at(t)
    }
}

/// A delay of one cycle: z^-1.
pub fn delay(t: f64) -> Complex {
    Complex { re: 1.0, im: -t } / Complex { re: 1.0, im: t }
}

pub fn magnitude(h: Complex) -> f64 {
    libm::hypot(h.re, h.im)
}

/// Phase in degrees, above -180 and up to 180.
pub fn phase(h: Complex) -> f64 {
    libm::atan2(h.im, h.re).to_degrees()
}

/// Phase in degrees for display: above -179.9999999, so that a rounding does not turn 180 into -180.
pub fn angle(h: Complex) -> f64 {
    let angle = phase(h);
    if angle < -179.999_999_9 { angle + 360.0 } else { angle }
}

/// (1 + j t)^2 (c0 + c1 z^-1 + c2 z^-2) = (c0 + c1 + c2) + 2 (c0 - c2) j t - (c0 - c1 + c2) t^2.
#[derive(Clone, Copy)]
struct Polynomial {
    dc: f64,
    slope: f64,
    nyquist: f64,
}

impl Polynomial {
    fn new(c0: f64, c1: f64, c2: f64) -> Self {
        let [dc, nyquist] = at_dc_and_nyquist(c0, c1, c2);
        Self { dc, slope: 2.0 * (c0 - c2), nyquist }
    }

    fn at(&self, t: f64) -> Complex {
        Complex { re: self.dc - self.nyquist * t * t, im: self.slope * t }
    }
}

/// Value of c0 + c1 z^-1 + c2 z^-2 at DC (z = 1) and at the Nyquist frequency (z = -1).
///
/// For a denominator (c0 = 1) both are exact where they are small: the 1 is added to a1 first, because 1 + a2 would be
/// rounded. Their ratio is g^2 for any damping.
pub fn at_dc_and_nyquist(c0: f64, c1: f64, c2: f64) -> [f64; 2] {
    [(c0 + c1) + c2, (c0 - c1) + c2]
}
