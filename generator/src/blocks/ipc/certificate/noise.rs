//! The signal-to-noise ratio of a stage: a vibration compared with the roundings of single precision, of steps and of
//! coefficients. No step is run.

use super::super::stage::StageDesign;
use super::chain::Chain;
use super::response::{Point, designed};
use super::section::Section;
use crate::design::band::warped;
use crate::design::response::{Complex, magnitude};
use crate::design::rounding::in_precision;
use crate::design::trapezoidal::{Output, Trapezoidal};
use crate::number::{decimals, digits};
use portable::Extreme;
use portable::RealKind;

/// The vibration, relative to the velocity of the axis.
pub(crate) const VIBRATION: f64 = 1.0 / 500.0;
/// Unit roundoff of single precision.
const UNIT: f64 = f32::EPSILON as f64 / 2.0;

/// Signal-to-noise ratio [dB] of the output of a stage while the axis moves and vibrates at the stage's f0; `None` in double
/// precision.
///
/// An operation with the result v errs by at most u |v|, u = 2^-24. Its error is modelled as white noise of the variance u^2
/// v^2 / 3, where v^2 is the mean square. Each error passes the rest of its section, whose gain is known in closed form, and
/// the sections after it, whose gain is at most its value at one of their centres or at f0. The change of the response at f0
/// by the rounded coefficients is added.
pub(super) fn of_chain(chain: &Chain, design: &StageDesign) -> Option<f64> {
    let sections = chain.section.iter().map(|section| match section {
        Section::Trapezoidal(section) => Some(*section),
        Section::Biquad(_) => None,
    });
    let sections: Option<Vec<_>> = sections.collect();
    Some(ratio(&sections?, design))
}

/// Signal-to-noise ratio [dB] of a stage in single precision, from its designed coefficients.
pub(crate) fn of_design(design: &StageDesign) -> f64 {
    let sections: Vec<_> = design.section.iter().map(|section| section.trapezoidal).collect();
    ratio(&sections, design)
}

/// The signal-to-noise ratios of stages, by their indices, in words.
pub(crate) fn text(stages: &[(usize, f64)], v_max: f64, unit: &str) -> String {
    let stage = |(stage, ratio): &(usize, f64)| format!("stage[{stage}] {} dB", decimals(ratio.floor(), 0));
    let ratios: Vec<_> = stages.iter().map(stage).collect();
    let (v_max, vibration) = (digits(v_max), digits(v_max * VIBRATION));
    let of = format!("of a vibration of {vibration} at f0 while the axis moves at {v_max} {unit}");
    format!("signal-to-noise ratio in single precision, {of}: {}", ratios.join(", "))
}

/// Signal-to-noise ratio [dB] of a stage with these sections.
fn ratio(sections: &[Trapezoidal], design: &StageDesign) -> f64 {
    let t = warped(design.stage.f0(), design.cycle_time);
    let (mut offset, mut vibration, mut noise) = (1.0, VIBRATION, 0.0);
    for (i, section) in sections.iter().enumerate() {
        let after = &sections[i + 1..];
        let gain = |t| after.iter().map(|section| magnitude(section.response(t))).product::<f64>();
        let largest = after.iter().map(Trapezoidal::centre).map(gain).fold(gain(t), f64::larger);
        noise += of_section(section, t, offset, vibration) * largest * largest;
        vibration *= magnitude(section.response(t));
        if section.output.loses_the_offset() {
            offset = 0.0;
        }
    }
    let signal = vibration * vibration / 2.0;
    let error = deviation(sections, design, t);
    -10.0 * libm::log10(noise / signal + error * error)
}

/// The relative change of the response at f0 by the rounded coefficients.
fn deviation(sections: &[Trapezoidal], design: &StageDesign, t: f64) -> f64 {
    let gain = Complex::from(in_precision(design.coeffs.gain, RealKind::F32));
    let measured = sections.iter().fold(gain, |h, section| h * section.response(t));
    Point { frequency: design.stage.f0(), designed: designed(design, t), measured, single: None }.deviation()
}

/// Variance of the output error of a section from its own roundings, for an input with this offset and this amplitude at t.
fn of_section(section: &Trapezoidal, t: f64, offset: f64, vibration: f64) -> f64 {
    let Trapezoidal { a, b, c, output, is_by_change } = *section;
    let [change, p, bp, u, q, s1, s1_next, next, low] = mean_squares(section, t, vibration);
    let gain = Gain::of(section);
    let noise = match output {
        Output::Oscillation => {
            let (h, g) = (2.0 * a / c, c / 2.0);
            let into_p = change + p;
            // The errors of h p, of r s1 and of their difference enter q, which is a part of the output; that of g q enters
            // only u.
            let into_q = h * h * p + b * b / g / g * s1 + q;
            into_p * gain.oscillation([a, 1.0 - a * c], -h)
                + into_q * gain.oscillation([g, -c * g], -1.0)
                + (u + s1_next) * gain.oscillation([1.0, -c], 0.0)
                + bp * gain.oscillation([0.0, -c], 0.0)
                + (c * c * bp + next) * gain.oscillation([0.0, 1.0], 0.0)
        }
        Output::Bandpass | Output::Allpass => {
            let (into_p, kept, last) = match is_by_change {
                true => (change + p, 1.0 - a * c, c * c * bp + next),
                false => (p, -a * c, 2.0 * c * c * bp + low),
            };
            let into_s1 = a * a * p + b * b * s1 + u + s1_next;
            let own = into_p * gain.bandpass([a, kept], a)
                + into_s1 * gain.bandpass([1.0, -c], 1.0)
                + bp * gain.bandpass([0.0, -c], 1.0)
                + last * gain.bandpass([0.0, 1.0], 0.0);
            let by = output.of_bandpass();
            by * by * own
        }
    };
    // A sum that contains the offset of its input has a larger rounding error.
    let sum = if output.loses_the_offset() { 0.0 } else { offset * offset + vibration * vibration / 2.0 };
    UNIT * UNIT / 3.0 * (noise + sum)
}

/// Mean squares for an input of this amplitude at t: its change, p, bp, u, q = 2 u / c, s1, and the next s1, p and low.
fn mean_squares(section: &Trapezoidal, t: f64, vibration: f64) -> [f64; 9] {
    let Trapezoidal { a, b, c, .. } = *section;
    let input = Complex::from(vibration);
    let change = input * (Complex { re: 0.0, im: 2.0 * t } / Complex { re: 1.0, im: t });
    // z = (1 + j t) / (1 - j t): u = (z - 1) / (z + 1) bp = j t bp; s1 = (bp - u) / 2, and (bp + u) / 2 after the step.
    let bp = input * section.band_pass_part(t);
    let u = bp * Complex { re: 0.0, im: t };
    let [s1, s1_next] = [bp - u, bp + u].map(|twice| twice / 2.0);
    let p = (u + s1 * b) / a;
    let next = p - bp * c;
    let signals = [change, p, bp, u, u / (c / 2.0), s1, s1_next, next, input - next];
    signals.map(|v| (v.re * v.re + v.im * v.im) / 2.0)
}

/// Sums of the squares of impulse responses, in closed form.
///
/// The trapezoidal rule keeps the Gramian of the continuous section i1' = -k g i1 - g i2, i2' = g i1, i1 = 2 s1, i2 =
/// -p: that of its band-pass part is 1 / (4 k g) times the unit matrix, that of its high-pass part, with the output k
/// i1 + i2, is 1 / (4 k g) [k^2 + 1, k; k, 1].
struct Gain {
    /// 1 / (k g)
    weight: f64,
    /// k of the oscillation
    k: f64,
    /// c k / 2: the weight of p = 1
    scale: f64,
}

impl Gain {
    fn of(section: &Trapezoidal) -> Self {
        let width = section.width();
        Self { weight: 1.0 / width, k: width / section.centre(), scale: section.scale() }
    }

    /// The gain from an error that enters s1 and p with these factors, and the band-pass part with `direct`.
    fn bandpass(&self, [s1, p]: [f64; 2], direct: f64) -> f64 {
        direct * direct + self.weight * (s1 * s1 + self.scale * self.scale * p * p)
    }

    /// The gain from an error that enters s1 and p with these factors to the output of the oscillation.
    fn oscillation(&self, [s1, p]: [f64; 2], direct: f64) -> f64 {
        let k = self.k;
        direct * direct + self.weight * ((k * k + 1.0) * s1 * s1 - k * s1 * p + p * p / 4.0)
    }
}
