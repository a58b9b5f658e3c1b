//! The poles of the low-pass prototypes with 80 digits, from their definitions. No filter.

use super::fixed::Fixed;
use reference::design::poles::Prototype;

/// The real poles, and sigma and omega of the pair if there is one: from their definitions.
#[must_use]
pub fn poles(prototype: Prototype, order: usize) -> [Vec<Fixed>; 2] {
    let two = whole(2);
    match (prototype, order) {
        (_, 1) => [vec![whole(1)], vec![]],
        (Prototype::CritDamping, 2) => [vec![whole(1) / (two.sqrt() - whole(1)).sqrt(); 2], vec![]],
        (Prototype::CritDamping, _) => [vec![whole(1) / (two.cbrt() - whole(1)).sqrt(); 3], vec![]],
        (Prototype::Butterworth, 2) => [vec![], vec![whole(1) / two.sqrt(); 2]],
        (Prototype::Butterworth, _) => [vec![whole(1)], vec![whole(1) / &two, whole(3).sqrt() / &two]],
        (Prototype::Bessel, 2) => {
            // |H(j w)|^2 = 9 / (w^4 + 3 w^2 + 9) = 1/2
            let edge = ((whole(45).sqrt() - whole(3)) / &two).sqrt();
            [vec![], vec![whole(3) / &two / &edge, whole(3).sqrt() / &two / edge]]
        }
        (Prototype::Bessel, _) => {
            // |H(j w)|^2 = 225 / (u^3 + 6 u^2 + 45 u + 225) = 1/2, u = w^2
            let edge = zero_of_cubic([6, 45, -225], 3).sqrt();
            // s^3 + 6 s^2 + 15 s + 15 at s = -r
            let r = -zero_of_cubic([6, 15, 15], -2);
            // the rest: s^2 + (6 - r) s + 15 / r
            let sigma = (whole(6) - &r) / &two;
            let omega = (whole(15) / &r - square(&sigma)).sqrt();
            [vec![r / &edge], vec![sigma / &edge, omega / edge]]
        }
    }
}

/// The zero of x^3 + a x^2 + b x + c near `start`, by Newton's iteration.
fn zero_of_cubic([a, b, c]: [i32; 3], start: i32) -> Fixed {
    let mut x = whole(start);
    for _ in 0..12 {
        let value = ((x.clone() + whole(a)) * &x + whole(b)) * &x + whole(c);
        let slope = (whole(3) * &x + whole(2 * a)) * &x + whole(b);
        x = x - value / slope;
    }
    x
}

/// A whole number.
#[must_use]
pub fn whole(n: i32) -> Fixed {
    n.into()
}

/// Its square.
#[must_use]
pub fn square(x: &Fixed) -> Fixed {
    x.clone() * x
}
