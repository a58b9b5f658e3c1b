//! A trapezoidal section, for single precision: its rounded coefficients, one step, its response. No design.

use super::response::Complex;

/// `u = a p - b s1; s1' = s1 + u; bp = s1 + s1'; low = low + c bp`, p = x - low.
#[derive(Clone, Copy, Debug)]
pub struct Trapezoidal {
    pub a: f64,
    pub b: f64,
    pub c: f64,
    pub output: Output,
    /// whether its state is p, which is driven by the change of the input, rather than low
    pub is_by_change: bool,
}

/// The output of a trapezoidal section.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Output {
    /// y = bp
    Bandpass,
    /// y = x - 2 bp
    Allpass,
    /// y = x - u 2 / c
    Oscillation,
}

impl Output {
    /// The factor of the band-pass part. An oscillation is never the last section, so the certificate measures none there.
    pub(crate) fn of_bandpass(self) -> f64 {
        match self {
            Self::Bandpass | Self::Oscillation => 1.0,
            Self::Allpass => -2.0,
        }
    }

    /// Whether a constant input leads to an output of 0.
    pub(crate) fn loses_the_offset(self) -> bool {
        match self {
            Self::Bandpass => true,
            Self::Allpass | Self::Oscillation => false,
        }
    }
}

impl Trapezoidal {
    /// The matrix of its two states has the trace 2 - B - A C and the determinant 1 + A C - B.
    pub(crate) fn is_stable(&self) -> bool {
        let ac = self.a * self.c;
        ac > 0.0 && ac < self.b && self.b < 2.0
    }

    /// Warped centre: g^2 = A C / (2 - B).
    pub(crate) fn centre(&self) -> f64 {
        libm::sqrt(self.a * self.c / (2.0 - self.b))
    }

    /// k g, k the reciprocal quality factor.
    pub(crate) fn width(&self) -> f64 {
        (self.b - self.a * self.c) / (2.0 - self.b)
    }

    /// c k / 2: a p or low of 1 has the weight of an s1 of this value.
    pub(crate) fn scale(&self) -> f64 {
        self.centre() / self.c
    }

    /// One step, from s1 and low to the next s1 and low; returns the output.
    pub(crate) fn step(&self, s: &mut [f64; 2], x: f64) -> f64 {
        let u = self.a * (x - s[1]) - self.b * s[0];
        let s1 = s[0] + u;
        let bp = s[0] + s1;
        *s = [s1, s[1] + self.c * bp];
        match self.output {
            Output::Bandpass => bp,
            Output::Allpass => x - 2.0 * bp,
            Output::Oscillation => x - 2.0 * u / self.c,
        }
    }

    /// The response at t = tan(pi f Ts); u is j t times the band-pass part.
    pub(crate) fn response(&self, t: f64) -> Complex {
        let bp = self.band_pass_part(t);
        match self.output {
            Output::Bandpass => bp,
            Output::Allpass => Complex { re: 1.0 - 2.0 * bp.re, im: -2.0 * bp.im },
            Output::Oscillation => {
                let by = 2.0 * t / self.c;
                Complex { re: 1.0 + by * bp.im, im: -by * bp.re }
            }
        }
    }

    /// 2 A j t / (A C - (2 - B) t^2 + j t (B - A C)).
    pub(crate) fn band_pass_part(&self, t: f64) -> Complex {
        let ac = self.a * self.c;
        let denominator = Complex { re: ac - (2.0 - self.b) * t * t, im: t * (self.b - ac) };
        Complex { re: 0.0, im: 2.0 * self.a * t } / denominator
    }
}
