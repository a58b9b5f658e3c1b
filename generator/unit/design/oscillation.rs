//! The simulated oscillation: what the coefficients of 12,000 random ones do.

use super::oscillation_of;
use super::rounding::{demanded, of_numerator, of_section};
use crate::design::band::warped;
use crate::design::response::{Complex, magnitude, of_oscillation};
use crate::unit::sets::{Random, sets};
use portable::Extreme;
use reference::oscillation;

/// H = (2 D j w + 1) / (1 - w^2 + 2 D j w), w = t / Omega0: 1 + 1 / (2 j D) at the centre.
#[test]
fn response_is_that_of_a_load_behind_a_visco_elastic_coupling() {
    let mut random = Random(0x2545_F491_4F6C_DD1D);
    let mut worst = 0.0_f64;
    for set in sets(12_000) {
        let damping = 0.001 + 0.998 * random.unit();
        let omega0 = warped(set.f0, set.cycle_time());
        let coeffs = oscillation_of(omega0, damping);
        for w in [0.0, 0.1, 0.5, 1.0, 2.0, 10.0] {
            let h = of_oscillation(&coeffs, w * omega0);
            let expected = visco_elastic(damping, w);
            let deviation = magnitude(Complex { re: h.re - expected.re, im: h.im - expected.im }) / magnitude(expected);
            let (t, oscillation::Coeffs { b0, b1, b2, a1, a2, .. }) = (w * omega0, coeffs);
            let rounding = of_section(a1, a2, t) + of_numerator(b0, b1, b2, t) + 60.0 * f64::EPSILON;
            assert!(deviation <= rounding, "{deviation:e} > {rounding:e}: D {damping}, w {w}: {set:?}");
            worst = worst.larger(deviation / rounding);
            if damping >= 0.025 {
                // No section of a band-pass is narrower; relative to the peak of the response.
                let peak = magnitude(visco_elastic(damping, 1.0));
                assert!(deviation * magnitude(expected) <= peak * demanded(&set), "D {damping}, w {w}: {set:?}");
            }
        }
    }
    assert!(worst > 0.01, "the tolerance is far too wide, worst {worst}");
}

fn visco_elastic(damping: f64, w: f64) -> Complex {
    let (re, im) = (1.0 - w * w, 2.0 * damping * w);
    let square = re * re + im * im;
    Complex { re: (re + im * im) / square, im: (im * re - im) / square }
}

#[test]
fn a_constant_input_is_preset_where_it_stays() {
    for set in sets(1_000) {
        let coeffs = oscillation_of(warped(set.f0, set.cycle_time()), 0.3);
        assert_eq!(coeffs.preset_s1.to_bits(), (1.0 - coeffs.b0).to_bits());
        assert_eq!(coeffs.preset_s2.to_bits(), (coeffs.b2 - coeffs.a2).to_bits());
    }
}
