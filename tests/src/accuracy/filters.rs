//! The filters of a stage with 80 digits, as polynomials in z^-1 of their whole transfer function. No section, no parameter.
//!
//! s = (1 - z^-1) / (1 + z^-1), Omega0 = tan(pi f0 Ts), B = (1 + Omega0^2) tan(pi f0 Ts / Q). A band-pass is its low-pass prototype
//! with s_LP = (s^2 + Omega0^2) / (B s): a real pole becomes a polynomial of degree 2, a pair one of degree 4. Nothing is factored, so
//! that no formula of the generator for sections is used.

use super::fixed::Fixed;
use super::poles::{poles, square, whole};
use reference::design::poles::Prototype;

/// sum of b[i] x[n-i] - sum of a[i] y[n-i], from i = 1 on in the second.
#[derive(Clone, Debug)]
pub struct Polynomials {
    b: Vec<Fixed>,
    a: Vec<Fixed>,
    x: Vec<Fixed>,
    y: Vec<Fixed>,
}

/// Product of two polynomials.
fn product(left: &[Fixed], right: &[Fixed]) -> Vec<Fixed> {
    let mut product = vec![whole(0); left.len() + right.len() - 1];
    for (i, a) in left.iter().enumerate() {
        for (j, b) in right.iter().enumerate() {
            product[i + j] = product[i + j].clone() + a.clone() * b;
        }
    }
    product
}

fn scaled(polynomial: &[Fixed], by: &Fixed) -> Vec<Fixed> {
    polynomial.iter().map(|c| c.clone() * by).collect()
}

fn sum(left: &[Fixed], right: &[Fixed]) -> Vec<Fixed> {
    left.iter().zip(right).map(|(a, b)| a.clone() + b).collect()
}

impl Polynomials {
    fn new(numerator: &[Fixed], denominator: &[Fixed]) -> Self {
        let by = whole(1) / &denominator[0];
        let past = vec![whole(0); denominator.len() - 1];
        Self {
            b: scaled(numerator, &by),
            a: scaled(&denominator[1..], &by),
            x: [past.clone(), vec![whole(0)]].concat(),
            y: past,
        }
    }

    /// One cycle; it starts at rest.
    pub fn step(&mut self, x: Fixed) -> Fixed {
        self.x.rotate_right(1);
        self.x[0] = x;
        let y = Fixed::dot(&self.b, &self.x) - Fixed::dot(&self.a, &self.y);
        self.y.rotate_right(1);
        self.y[0] = y.clone();
        y
    }
}

/// A filter on the warped axis.
struct Band {
    /// s^2 + Omega0^2, times (1 + z^-1)^2
    resonance: Vec<Fixed>,
    /// B s, times (1 + z^-1)^2
    width: Vec<Fixed>,
}

fn band(f0_ts: Fixed, q: f64) -> Band {
    let angle = Fixed::pi().clone() * f0_ts;
    let omega = square(&angle.tan());
    let b = (whole(1) + &omega) * (angle / Fixed::from(q)).tan();
    Band { resonance: resonance(&omega), width: scaled(&[whole(1), whole(0), whole(-1)], &b) }
}

/// (1 - z^-1)^2 + square (1 + z^-1)^2
fn resonance(square: &Fixed) -> Vec<Fixed> {
    let outer = whole(1) + square;
    vec![outer.clone(), whole(2) * (square.clone() - whole(1)), outer]
}

/// A band-pass: its real poles and its pairs, (s + sigma)^2 + omega^2.
#[must_use]
pub fn bandpass(prototype: Prototype, order: usize, f0_ts: Fixed, q: f64) -> Vec<Polynomials> {
    let Band { resonance, width } = band(f0_ts, q);
    let [real, pair] = poles(prototype, order);
    let of_real = real.iter().map(|sigma| {
        let numerator = scaled(&width, sigma);
        Polynomials::new(&numerator, &sum(&resonance, &numerator))
    });
    let of_pair = pair.chunks(2).map(|pair| {
        let numerator = scaled(&product(&width, &width), &Fixed::dot(pair, pair));
        let middle = scaled(&product(&resonance, &width), &(whole(2) * &pair[0]));
        let denominator = sum(&sum(&product(&resonance, &resonance), &middle), &numerator);
        Polynomials::new(&numerator, &denominator)
    });
    of_real.chain(of_pair).collect()
}

/// (s^2 - B s + Omega0^2) / (s^2 + B s + Omega0^2)
#[must_use]
pub fn allpass(f0_ts: Fixed, q: f64) -> Polynomials {
    let Band { resonance, width } = band(f0_ts, q);
    Polynomials::new(&sum(&resonance, &scaled(&width, &whole(-1))), &sum(&resonance, &width))
}

/// (2 D w0 s + w0^2) / (s^2 + 2 D w0 s + w0^2), w0 = tan(pi f0 Ts)
#[must_use]
pub fn oscillation(f0_ts: Fixed, damping: f64) -> Polynomials {
    let omega = (Fixed::pi().clone() * f0_ts).tan();
    let friction = scaled(&[whole(1), whole(0), whole(-1)], &(Fixed::from(2.0 * damping) * &omega));
    let omega = square(&omega);
    let spring = scaled(&[whole(1), whole(2), whole(1)], &omega);
    Polynomials::new(&sum(&friction, &spring), &sum(&resonance(&omega), &friction))
}
