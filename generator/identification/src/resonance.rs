//! Frequency and damping of a vibration from a measured response. No decay.

use crate::decay::Decay;
use crate::least_squares::fit;
use crate::response::Lines;
use crate::{Complex64, magnitude};
use portable::Extreme;

/// The band around the vibration, as a part of its frequency; and the one that shows what the choice of the band does.
const BAND: f64 = 0.12;
const OTHER_BAND: f64 = 0.08;
/// Iterations with weights from the previous pole.
const STEPS: u32 = 8;
/// The damping with which the weights start.
const START: f64 = 0.03;
/// Lower limit of a standard error, as a part of the magnitude.
const LEAST_ERROR: f64 = 1e-6;

/// The vibration near a frequency f0 [Hz] in a response H: one pole and a smooth part.
///
/// ```text
/// H (s - p) = b0 + b1 s + b2 s^2        s = j (f - f0)/f0 within f0 +-12 %, weights 1/(se |s - p|), 8 times
/// (Sanathanan, Koerner 1963)
/// ```
///
/// The pole is at 2 pi f0 (j + p). `None` if there are fewer lines than unknowns, or no pole that decays within the band.
/// The amplitude is the largest |H|. The standard errors contain how much a fit within f0 +-8 % differs: a pole whose neighbour
/// is near, or whose width is that of the band, depends on the band by more than the noise says.
#[must_use]
pub fn pole(lines: &Lines, f0: f64) -> Option<Decay> {
    let of = pole_within(lines, f0, BAND)?;
    let other = pole_within(lines, f0, OTHER_BAND);
    Some(other.map_or(of, |other| of.compared_with(&other)))
}

/// The fit within a band.
fn pole_within(lines: &Lines, f0: f64, band: f64) -> Option<Decay> {
    let inside = |k: &usize| libm::fabs(lines.hz[*k] / f0 - 1.0) <= band;
    let inside: Vec<usize> = (0..lines.hz.len()).filter(inside).collect();
    let mut pole = Complex64::new(-START, 0.0);
    let mut variances = [0.0; 2];
    for _ in 0..STEPS {
        let mut columns = vec![Vec::new(); 8];
        let mut values = Vec::new();
        for k in &inside {
            let (s, h) = (Complex64::new(0.0, lines.hz[*k] / f0 - 1.0), lines.response[*k]);
            let weight = 1.0 / (lines.error[*k].larger(LEAST_ERROR * magnitude(h)) * magnitude(s - pole));
            // H s = b0 + b1 s + b2 s^2 + p H, in real and imaginary parts.
            let factors = [Complex64::from(1.0), s, s * s, h].map(|factor| factor * weight);
            for (pair, factor) in columns.chunks_exact_mut(2).zip(factors) {
                pair[0].extend([factor.re, factor.im]);
                pair[1].extend([-factor.im, factor.re]);
            }
            let value = h * s * weight;
            values.extend([value.re, value.im]);
        }
        let fit = fit(&columns, &values)?;
        let free = (values.len() - columns.len()).max(1) as f64;
        let scale = fit.residual.iter().map(|left| left * left).sum::<f64>() / free;
        pole = Complex64::new(fit.coefficients[6], fit.coefficients[7]);
        variances = [scale * fit.variances[6], scale * fit.variances[7]];
    }
    let is_inside = pole.re < 0.0 && libm::fabs(pole.im) <= band;
    let size = magnitude(Complex64::new(pole.re, 1.0 + pole.im));
    let peak = inside.iter().fold(0.0, |peak: f64, k| peak.larger(magnitude(lines.response[*k])));
    is_inside.then(|| Decay {
        hz: f0 * (1.0 + pole.im),
        hz_error: f0 * variances[1].sqrt(),
        damping: -pole.re / size,
        damping_error: variances[0].sqrt() / size,
        amplitude: peak,
    })
}
