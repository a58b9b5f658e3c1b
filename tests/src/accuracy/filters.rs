//! The filters of a stage with 31 digits, as polynomials in z^-1 of their whole transfer function. No section, no parameter.
//!
//! s = (1 - z^-1) / (1 + z^-1), Omega0 = tan(pi f0 Ts), B = (1 + Omega0^2) tan(pi f0 Ts / Q). A band-pass is its low-pass prototype
//! with s_LP = (s^2 + Omega0^2) / (B s): a real pole becomes a polynomial of degree 2, a pair one of degree 4. Nothing is factored, so
//! that no formula of the generator for sections is used.

use super::double_double::Wide;

/// sum of b[i] x[n-i] - sum of a[i] y[n-i], from i = 1 on in the second.
#[derive(Clone, Debug)]
pub struct Polynomials {
    b: Vec<Wide>,
    a: Vec<Wide>,
    x: Vec<Wide>,
    y: Vec<Wide>,
}

fn wide(x: f64) -> Wide {
    x.into()
}

/// Product of two polynomials.
fn product(left: &[Wide], right: &[Wide]) -> Vec<Wide> {
    let mut product = vec![wide(0.0); left.len() + right.len() - 1];
    for (i, a) in left.iter().enumerate() {
        for (j, b) in right.iter().enumerate() {
            product[i + j] = product[i + j] + *a * *b;
        }
    }
    product
}

fn scaled(polynomial: &[Wide], by: Wide) -> Vec<Wide> {
    polynomial.iter().map(|c| *c * by).collect()
}

fn sum(left: &[Wide], right: &[Wide]) -> Vec<Wide> {
    left.iter().zip(right).map(|(a, b)| *a + *b).collect()
}

impl Polynomials {
    fn new(numerator: &[Wide], denominator: &[Wide]) -> Self {
        let by = wide(1.0) / denominator[0];
        let past = vec![wide(0.0); denominator.len() - 1];
        Self { b: scaled(numerator, by), a: scaled(denominator, by), x: past.clone(), y: past }
    }

    /// One cycle; it starts at rest.
    pub fn step(&mut self, x: Wide) -> Wide {
        let mut y = self.b[0] * x;
        for i in 0..self.x.len() {
            y = y + (self.b[i + 1] * self.x[i] - self.a[i + 1] * self.y[i]);
        }
        self.x.rotate_right(1);
        self.y.rotate_right(1);
        (self.x[0], self.y[0]) = (x, y);
        y
    }
}

/// Low-pass prototypes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Prototype {
    /// n real poles in one place
    CritDamping,
    /// on the unit circle
    Butterworth,
    /// flattest delay, -3 dB at 1
    Bessel,
}

/// Constants of a low-pass prototype of order 1 to 3: real poles sigma, and quadratics s^2 + l s + m.
fn poles(prototype: Prototype, order: usize) -> (Vec<Wide>, Vec<[Wide; 2]>) {
    let one = wide(1.0);
    match (prototype, order) {
        (_, 1) => (vec![one], vec![]),
        (Prototype::CritDamping, 2) => (vec![one / (wide(2.0).sqrt() - one).sqrt(); 2], vec![]),
        (Prototype::CritDamping, _) => (vec![one / (cube_root(wide(2.0)) - one).sqrt(); 3], vec![]),
        (Prototype::Butterworth, 2) => (vec![], vec![[wide(2.0).sqrt(), one]]),
        (Prototype::Butterworth, _) => (vec![one], vec![[one, one]]),
        // s^2 + 3 s + 3, -3 dB at w^2 = (sqrt 45 - 3) / 2
        (Prototype::Bessel, 2) => {
            let square = (wide(45.0).sqrt() - wide(3.0)) / wide(2.0);
            let w = square.sqrt();
            (vec![], vec![[wide(3.0) / w, wide(3.0) / square]])
        }
        // s^3 + 6 s^2 + 15 s + 15 = (s + r)(s^2 + (6 - r) s + 15 / r)
        (Prototype::Bessel, _) => {
            let cubic = |r: Wide| ((r - wide(6.0)) * r + wide(15.0)) * r - wide(15.0);
            let slope = |r: Wide| (wide(3.0) * r - wide(12.0)) * r + wide(15.0);
            let r = newton(2.322, cubic, slope);
            // -3 dB at v = w^2: (15 - 6 v)^2 + v (15 - v)^2 = 450
            let power = |v: Wide| ((v + wide(6.0)) * v + wide(45.0)) * v - wide(225.0);
            let slope = |v: Wide| (wide(3.0) * v + wide(12.0)) * v + wide(45.0);
            let square = newton(3.08, power, slope);
            let w = square.sqrt();
            (vec![r / w], vec![[(wide(6.0) - r) / w, wide(15.0) / r / square]])
        }
    }
}

fn newton(start: f64, value: impl Fn(Wide) -> Wide, slope: impl Fn(Wide) -> Wide) -> Wide {
    (0..8).fold(wide(start), |x, _| x - value(x) / slope(x))
}

fn cube_root(x: Wide) -> Wide {
    newton(x.to_f64().cbrt(), |y| y * y * y - x, |y| wide(3.0) * y * y)
}

/// A filter on the warped axis.
struct Band {
    /// s^2 + Omega0^2, times (1 + z^-1)^2
    resonance: Vec<Wide>,
    /// B s, times (1 + z^-1)^2
    width: Vec<Wide>,
}

fn band(f0_ts: Wide, q: f64) -> Band {
    let omega = (Wide::PI * f0_ts).tan();
    let square = omega * omega;
    let b = (wide(1.0) + square) * (Wide::PI * f0_ts / wide(q)).tan();
    Band { resonance: resonance(square), width: scaled(&[wide(1.0), wide(0.0), wide(-1.0)], b) }
}

/// (1 - z^-1)^2 + square (1 + z^-1)^2
fn resonance(square: Wide) -> Vec<Wide> {
    let (outer, inner) = (wide(1.0) + square, wide(2.0) * (square - wide(1.0)));
    vec![outer, inner, outer]
}

/// A band-pass: its real poles and its pairs.
#[must_use]
pub fn bandpass(prototype: Prototype, order: usize, f0_ts: Wide, q: f64) -> Vec<Polynomials> {
    let Band { resonance, width } = band(f0_ts, q);
    let (real, pairs) = poles(prototype, order);
    let of_real = real.iter().map(|sigma| {
        let numerator = scaled(&width, *sigma);
        Polynomials::new(&numerator, &sum(&resonance, &numerator))
    });
    let of_pairs = pairs.iter().map(|[l, m]| {
        let numerator = scaled(&product(&width, &width), *m);
        let middle = scaled(&product(&resonance, &width), *l);
        let denominator = sum(&sum(&product(&resonance, &resonance), &middle), &numerator);
        Polynomials::new(&numerator, &denominator)
    });
    of_real.chain(of_pairs).collect()
}

/// (s^2 - B s + Omega0^2) / (s^2 + B s + Omega0^2)
#[must_use]
pub fn allpass(f0_ts: Wide, q: f64) -> Polynomials {
    let Band { resonance, width } = band(f0_ts, q);
    Polynomials::new(&sum(&resonance, &scaled(&width, wide(-1.0))), &sum(&resonance, &width))
}

/// (2 D w0 s + w0^2) / (s^2 + 2 D w0 s + w0^2), w0 = tan(pi f0 Ts)
#[must_use]
pub fn oscillation(f0_ts: Wide, damping: f64) -> Polynomials {
    let omega = (Wide::PI * f0_ts).tan();
    let square = omega * omega;
    let friction = scaled(&[wide(1.0), wide(0.0), wide(-1.0)], wide(2.0 * damping) * omega);
    let spring = scaled(&[wide(1.0), wide(2.0), wide(1.0)], square);
    Polynomials::new(&sum(&friction, &spring), &sum(&resonance(square), &friction))
}
