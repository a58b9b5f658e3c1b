//! The frequency response that `design::response` computes, against what the reference's own `step` does to an impulse.

use crate::inside::sets::axes;
use generator::blocks::ipc::stage::stage;
use generator::design::band::warped;
use generator::design::response::{Complex, magnitude, of_stage};
use portable::{Extreme, RealKind};
use reference::stage::{Coeffs, State, step};

/// The transform of the impulse response, at five frequencies for each of some 100 stages. f0 Ts is at least 0.01, the
/// damping ratio at least 0.01: 60,000 cycles later nothing is left of the impulse, and the roundings of all cycles
/// together stay below 1e-10 of the largest possible response.
#[test]
fn it_is_what_step_does() {
    let mut compared = 0;
    for axis in axes(60, RealKind::F64) {
        for designed in axis.ipc.stage.iter().flatten() {
            let coeffs = stage(0, designed, axis.cycle_time()).coeffs;
            for part in [0.3, 0.8, 1.0, 1.1, 1.9] {
                let product = (part * designed.f0() * axis.cycle_time()).smaller(0.499); // f Ts
                let found = transform_of_impulse_response(&coeffs, product);
                let expected = of_stage(&coeffs, warped(product, 1.0));
                let deviation = magnitude(Complex { re: found.re - expected.re, im: found.im - expected.im });
                assert!(
                    deviation <= 1e-10 * magnitude(expected).larger(1.0),
                    "{deviation:e} at {product}: {designed:?}"
                );
                compared += 1;
            }
        }
    }
    assert!(compared > 400, "{compared}");
}

/// Sum of h(n) z^-n at z = exp(2 pi j f Ts), with the sine and cosine of each n of their own.
fn transform_of_impulse_response(coeffs: &Coeffs<f64>, product: f64) -> Complex {
    let mut state = State::default();
    let mut sum = Complex { re: 0.0, im: 0.0 };
    for n in 0..60_000_u32 {
        let h = step(&mut state, coeffs, if n == 0 { 1.0 } else { 0.0 }, 0.0);
        let turns = f64::from(n) * product;
        let angle = core::f64::consts::TAU * (turns - libm::floor(turns));
        sum.re += h * libm::cos(angle);
        sum.im -= h * libm::sin(angle);
    }
    sum
}
