//! The numbers of a band-pass, an all-pass and the simulated oscillation by the textbook: complex roots of the transformed
//! prototype, then the bilinear transform. No formula for a section's place, quality factor or gain is used.

use axgen_tests::accuracy::fixed::Fixed;
use axgen_tests::accuracy::poles::{poles, square, whole};
use reference::design::poles::Prototype;

/// What is designed.
#[derive(Clone, Debug)]
pub(crate) struct Exact {
    pub f0: Fixed,
    pub q_factor: Fixed,
    pub damping: Fixed,
    pub cycle_time: Fixed,
    pub prototype: Prototype,
    pub order: usize,
}

/// A section c k g s / (s^2 + k g s + g^2).
struct Section {
    /// g^2
    gg: Fixed,
    /// k g
    kg: Fixed,
    /// c k g
    ckg: Fixed,
}

impl Exact {
    /// Of the band-pass: b2, a1, a2, A, B, C of each section; of the all-pass: a1, a2, A, B, C; of the oscillation: b0, b1, b2,
    /// a1, a2, h, r, g, g2.
    pub(crate) fn numbers(&self) -> Vec<Fixed> {
        let angle = Fixed::pi().clone() * &self.f0 * &self.cycle_time;
        let omega0 = angle.tan();
        let bandwidth = (whole(1) + square(&omega0)) * (angle / &self.q_factor).tan();
        let mut numbers = Vec::new();
        for section in self.bandpass(&omega0, &bandwidth) {
            let ([a1, a2], d) = denominator(&section.gg, &section.kg);
            numbers.extend([-(section.ckg.clone() / &d), a1, a2]);
            numbers.extend(trapezoidal(&section, &d));
        }
        let gg = square(&omega0);
        let ([a1, a2], d) = denominator(&gg, &bandwidth);
        numbers.extend([a1, a2]);
        numbers.extend(trapezoidal(&Section { gg: gg.clone(), kg: bandwidth.clone(), ckg: bandwidth }, &d));
        let k = whole(2) * &self.damping;
        let kg = k.clone() * &omega0;
        let ([a1, a2], d) = denominator(&gg, &kg);
        numbers.extend([kg.clone() + &gg, whole(2) * &gg, gg - &kg].map(|numerator| numerator / &d));
        numbers.extend([a1, a2, whole(1) / &d, whole(2) * (omega0.clone() + k) / &d]);
        numbers.extend([omega0.clone(), whole(2) * omega0]);
        numbers
    }

    /// s_LP = (s^2 + Omega0^2) / (B s) = -sigma + j omega: s^2 + B (sigma - j omega) s + Omega0^2 = 0.
    fn bandpass(&self, omega0: &Fixed, bandwidth: &Fixed) -> Vec<Section> {
        let [real, pair] = poles(self.prototype, self.order);
        let mut sections = Vec::new();
        for sigma in real {
            let kg = sigma * bandwidth;
            sections.push(Section { gg: square(omega0), ckg: kg.clone(), kg });
        }
        if let [sigma, omega] = &pair[..] {
            // half of the linear term, p = B (sigma - j omega) / 2; s = -p +- sqrt(p^2 - Omega0^2)
            let [re, im] = [sigma, omega].map(|part| part.clone() * bandwidth / whole(2));
            let [root_re, root_im] = complex_root(square(&re) - square(&im) - square(omega0), -(whole(2) * &re * &im));
            let at = |re: Fixed, im: Fixed| {
                let (gg, kg) = (square(&re) + square(&im), -(whole(2) * re));
                // |H(j Omega0)| = 1
                let (left, right) = (gg.clone() - square(omega0), kg.clone() * omega0);
                let ckg = (square(&left) + square(&right)).sqrt() / omega0;
                Section { gg, kg, ckg }
            };
            let both = [at(root_re.clone() - &re, root_im.clone() + &im), at(-root_re - &re, im - root_im)];
            let [a, b] = both;
            sections.extend(if a.gg < b.gg { [a, b] } else { [b, a] });
        }
        sections
    }
}

/// sqrt(re + j im)
fn complex_root(re: Fixed, im: Fixed) -> [Fixed; 2] {
    let magnitude = (square(&re) + square(&im)).sqrt();
    let larger = ((magnitude + re.clone().abs()) / whole(2)).sqrt();
    let smaller = im / (whole(2) * &larger);
    if re < whole(0) { [smaller, larger] } else { [larger, smaller] }
}

/// a1 and a2, and d.
fn denominator(gg: &Fixed, kg: &Fixed) -> ([Fixed; 2], Fixed) {
    let d = whole(1) + kg + gg;
    ([whole(2) * (gg.clone() - whole(1)) / &d, (whole(1) - kg + gg) / &d], d)
}

/// A, B and C.
fn trapezoidal(Section { gg, kg, ckg }: &Section, d: &Fixed) -> [Fixed; 3] {
    [ckg.clone() / d, whole(2) * (gg.clone() + kg) / d, whole(2) * gg / ckg]
}
