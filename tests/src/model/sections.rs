//! The filters of improved position control in double precision, section by section: difference equations and coefficients as
//! docs/improved-position-control.md and section 2 of the definition give them. No fade, no limit.

use super::parameters::{Mode, Stage};
use std::f64::consts::PI;

/// A section: y = b0 x + s1, s1 = b1 x - a1 y + s2, s2 = b2 x - a2 y.
#[derive(Clone, Debug)]
struct Section {
    b: [f64; 3],
    a: [f64; 2],
    s: [f64; 2],
}

/// An active stage with its states.
#[derive(Clone, Debug)]
pub struct Filters {
    /// where it takes the vibration from
    pub mode: Mode,
    weight: f64,
    sections: Vec<Section>,
    /// bound of the stage's gain: its weight times the gain of the oscillation, and what sections overshoot
    pub gain: f64,
    /// bound of its output for |x| <= 1, as docs/improved-position-control.md gives it
    pub norm: f64,
}

impl Filters {
    /// Of a stage, at a cycle time [s].
    #[must_use]
    pub fn new(stage: &Stage, ts: f64) -> Self {
        let (order, prototype, f0, q) = stage.band_pass;
        let mut sections = Vec::new();
        let (mut gain, mut norm) = (8.0, 4.0 * if stage.all_pass.is_some() { 4.5 } else { 1.0 });
        if matches!(stage.mode, Mode::Indirect | Mode::SetPoint) {
            sections.push(oscillation(f0 * ts, stage.damping));
            gain *= (1.0 + 1.0 / (4.0 * stage.damping * stage.damping)).sqrt();
            norm *= 1.25 * (1.0 + 2.0 / (PI * stage.damping));
        }
        let all_pass = |is_first: bool| {
            stage.all_pass.filter(|_| stage.is_all_pass_first == is_first).map(|(f0, q)| all_pass(f0 * ts, q))
        };
        sections.extend(all_pass(true));
        band_pass(prototype, order, f0 * ts, q, &mut sections);
        sections.extend(all_pass(false));
        let weight = (f64::from(stage.weight[0]) / f64::from(stage.weight[1])).min(7.0);
        Self { mode: stage.mode, weight, sections, gain: gain * weight, norm: norm * weight }
    }

    /// Puts every section into the steady state of a constant input.
    pub fn preset(&mut self, x: f64) {
        let mut x = x;
        for Section { b, a, s } in &mut self.sections {
            let y = x * (b[0] + b[1] + b[2]) / (1.0 + a[0] + a[1]);
            *s = [y - b[0] * x, b[2] * x - a[1] * y];
            x = y;
        }
    }

    /// One cycle: -weight * filter(x).
    pub fn run(&mut self, x: f64) -> f64 {
        let mut x = x;
        for Section { b, a, s } in &mut self.sections {
            let y = b[0] * x + s[0];
            *s = [b[1] * x - a[0] * y + s[1], b[2] * x - a[1] * y];
            x = y;
        }
        -self.weight * x
    }
}

/// The bilinear transform of (n0 + n1 s + n2 s^2) / (d0 + d1 s + d2 s^2), s = (1 - z^-1) / (1 + z^-1).
fn bilinear(n: [f64; 3], d: [f64; 3]) -> Section {
    let digital = |[p0, p1, p2]: [f64; 3]| [p0 + p1 + p2, 2.0 * (p0 - p2), p0 - p1 + p2];
    let (b, a) = (digital(n), digital(d));
    Section { b: b.map(|b| b / a[0]), a: [a[1] / a[0], a[2] / a[0]], s: [0.0; 2] }
}

/// (2 D w0 s + w0^2) / (s^2 + 2 D w0 s + w0^2).
fn oscillation(f: f64, damping: f64) -> Section {
    let w0 = (PI * f).tan();
    let (square, twice) = (w0 * w0, 2.0 * damping * w0);
    bilinear([square, twice, 0.0], [square, twice, 1.0])
}

/// Omega0 and B.
fn band(f: f64, q: f64) -> (f64, f64) {
    let omega0 = (PI * f).tan();
    (omega0, (1.0 + omega0 * omega0) * (PI * f / q).tan())
}

/// (s^2 - B s + Omega0^2) / (s^2 + B s + Omega0^2).
fn all_pass(f: f64, q: f64) -> Section {
    let (omega0, b) = band(f, q);
    bilinear([omega0 * omega0, -b, 1.0], [omega0 * omega0, b, 1.0])
}

/// One section for a real pole, two for a pair: section 2.2.
fn band_pass(prototype: &str, order: usize, f: f64, quality: f64, sections: &mut Vec<Section>) {
    let (omega0, b) = band(f, quality);
    let q = omega0 / b;
    let mut real = |sigma: f64| sections.push(section(omega0, sigma / q, 1.0));
    let pair = match (prototype, order) {
        (_, 1) => {
            real(1.0);
            None
        }
        ("CRIT_DAMPING", _) => {
            let sigma = (2f64.powf(1.0 / if order == 2 { 2.0 } else { 3.0 }) - 1.0).powf(-0.5);
            (0..order).for_each(|_| real(sigma));
            None
        }
        ("BUTTERWORTH", 2) => Some((0.5f64.sqrt(), 0.5f64.sqrt())),
        ("BUTTERWORTH", _) => {
            real(1.0);
            Some((0.5, 0.75f64.sqrt()))
        }
        (_, 2) => Some((1.101_601_330_592_161_7, 0.636_009_824_757_034_7)),
        _ => {
            real(1.322_675_799_910_444_6);
            Some((1.047_409_161_008_936, 0.999_264_436_280_637_6))
        }
    };
    if let Some((sigma, omega)) = pair {
        let square = sigma * sigma + omega * omega;
        let e = square / (q * q);
        let g = ((4.0 + e) * (4.0 + e) - 16.0 * sigma * sigma / (q * q)).sqrt();
        let qs = ((4.0 + e + g) / 2.0).sqrt() / (2.0 * sigma / q);
        let m = (e * (g + 4.0) + 8.0 * (omega * omega - sigma * sigma) / (q * q) + e * e) / (8.0 * (g + 4.0));
        let m = m.max(0.0);
        let w = (1.0 + m).sqrt() + m.sqrt();
        let c = (1.0 + 4.0 * qs * qs * m).sqrt();
        sections.push(section(omega0 / w, 1.0 / qs, c));
        sections.push(section(omega0 * w, 1.0 / qs, c));
    }
}

/// c k g s / (s^2 + k g s + g^2).
fn section(g: f64, k: f64, c: f64) -> Section {
    bilinear([0.0, c * k * g, 0.0], [g * g, k * g, 1.0])
}
