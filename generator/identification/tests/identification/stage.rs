//! Stages as the tests know them: by the formulas of their definition, in the frequency domain and sample by sample.
//! No assertion.

use identification::Complex64;
use identification::shape::{Mode, Shape};
use std::f64::consts::PI;

/// `b0 + b1 s + b2 s^2 / (a0 + a1 s + a2 s^2)`, s = (1 - z^-1)/(1 + z^-1).
#[derive(Clone, Copy)]
struct Section {
    b: [f64; 3],
    a: [f64; 3],
}

impl Section {
    fn at(&self, t: f64) -> Complex64 {
        let polynomial = |c: &[f64; 3]| Complex64::new(c[0] - c[2] * t * t, c[1] * t);
        polynomial(&self.b) / polynomial(&self.a)
    }
}

/// The chain of a stage without its sign.
fn sections(shape: &Shape, cycle: f64) -> Vec<Section> {
    let band = |f0: f64, q: f64| {
        let centre = (PI * f0 * cycle).tan();
        (centre * centre, (1.0 + centre * centre) * (PI * f0 * cycle / q).tan())
    };
    let mut chain = Vec::new();
    let (square, width) = band(shape.f0, shape.q);
    if shape.mode == Mode::Indirect {
        let damped = 2.0 * shape.damping * square.sqrt();
        chain.push(Section { b: [square, damped, 0.0], a: [square, damped, 1.0] });
    }
    chain.push(Section { b: [0.0, width, 0.0], a: [square, width, 1.0] });
    if let Some(allpass) = shape.allpass {
        let (square, width) = band(allpass.f0, allpass.q);
        chain.push(Section { b: [square, -width, 1.0], a: [square, width, 1.0] });
    }
    chain
}

/// The response of a stage with weight 1, its sign in it.
pub fn response(shape: &Shape, cycle: f64) -> Box<dyn Fn(f64) -> Complex64> {
    let chain = sections(shape, cycle);
    Box::new(move |t| chain.iter().fold(Complex64::from(-1.0), |h, section| h * section.at(t)))
}

/// A section in operation: direct form II, transposed.
struct Filter {
    b: [f64; 3],
    a: [f64; 2],
    state: [f64; 2],
}

impl Filter {
    fn of(section: &Section) -> Self {
        // (1 + z^-1)^2 times a polynomial in s.
        let digital = |c: &[f64; 3]| [c[0] + c[1] + c[2], 2.0 * (c[0] - c[2]), c[0] - c[1] + c[2]];
        let (b, a) = (digital(&section.b), digital(&section.a));
        Self { b: b.map(|b| b / a[0]), a: [a[1] / a[0], a[2] / a[0]], state: [0.0; 2] }
    }

    fn next(&mut self, x: f64) -> f64 {
        let y = self.b[0] * x + self.state[0];
        self.state = [self.b[1] * x - self.a[0] * y + self.state[1], self.b[2] * x - self.a[1] * y];
        y
    }
}

/// What stages with weights add, sample by sample.
pub fn running(of: &[(Shape, f64)], cycle: f64) -> impl FnMut(f64) -> f64 + use<> {
    let chain = |(shape, weight): &(Shape, f64)| {
        (sections(shape, cycle).iter().map(Filter::of).collect::<Vec<Filter>>(), *weight)
    };
    let mut stages: Vec<(Vec<Filter>, f64)> = of.iter().map(chain).collect();
    move |v_motor| {
        let of = |(chain, weight): &mut (Vec<Filter>, f64)| {
            -*weight * chain.iter_mut().fold(v_motor, |x, filter| filter.next(x))
        };
        stages.iter_mut().map(of).sum()
    }
}

/// The stages of the application example of the manual.
pub fn manual() -> [(Shape, f64); 2] {
    let direct = Shape { mode: Mode::Direct, f0: 53.0, q: 10.0, damping: 0.8, allpass: None };
    let indirect = Shape { mode: Mode::Indirect, f0: 11.0, q: 2.0, damping: 0.8, allpass: None };
    [(direct, 3.0), (indirect, 1.9)]
}
