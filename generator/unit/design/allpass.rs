//! All-passes: what the coefficients of 12,000 random ones do.

use super::rounding::{demanded, of_section};
use crate::axis::{Filter, Prototype};
use crate::design::band::{band, edges, warped};
use crate::design::response::{Complex, magnitude, of_allpass, of_oscillation};
use crate::unit::sets::filter as coefficients_of;
use crate::unit::sets::sets;
use portable::Extreme;
use reference::oscillation;

/// -90 degrees at the lower edge, -180 at the centre, -270 at the upper edge; the phase is seen as H itself, which
/// must be -j, -1 and j. The tolerance is twice that of a section, for its numerator turns as its denominator does.
#[test]
fn phase_is_a_quarter_turn_at_each_edge_and_a_half_at_the_centre() {
    let mut worst = 0.0_f64;
    for set in sets(12_000) {
        let band = band(set.f0, set.q_factor, set.cycle_time());
        let filter = Filter::Allpass { f0: set.f0, q_factor: set.q_factor };
        let coeffs = coefficients_of(&filter, set.cycle_time()).allpass;
        let [lower, upper] = edges(&band);
        for (t, re, im) in [(lower, 0.0, -1.0), (warped(set.f0, set.cycle_time()), -1.0, 0.0), (upper, 0.0, 1.0)] {
            let h = of_allpass(&coeffs, t);
            let deviation = magnitude(Complex { re: h.re - re, im: h.im - im });
            let rounding = 2.0 * of_section(coeffs.a1, coeffs.a2, t) + 60.0 * f64::EPSILON;
            assert!(deviation <= rounding.smaller(demanded(&set)), "{deviation:e} > {rounding:e}: {set:?}");
            worst = worst.larger(deviation / rounding);
        }
    }
    assert!(worst > 0.01, "the tolerance is far too wide, worst {worst}");
}

/// Evaluated as a general section, b0 = a2, b1 = a1 and b2 = 1: only the evaluation can be off.
#[test]
fn gain_is_1_at_every_frequency() {
    for set in sets(12_000) {
        let filter = Filter::Allpass { f0: set.f0, q_factor: set.q_factor };
        let coeffs = coefficients_of(&filter, set.cycle_time()).allpass;
        let (a1, a2) = (coeffs.a1, coeffs.a2);
        let general = oscillation::Coeffs { b0: a2, b1: a1, b2: 1.0, a1, a2, ..oscillation::Coeffs::default() };
        for i in -8..=8 {
            let t = warped(set.f0, set.cycle_time()) * libm::pow(10.0, f64::from(i) / 2.0);
            let rounding = of_section(a1, a2, t) + 8.0 * f64::EPSILON;
            assert!((magnitude(of_oscillation(&general, t)) - 1.0).abs() <= rounding, "{set:?}");
            assert!((magnitude(of_allpass(&coeffs, t)) - 1.0).abs() <= 8.0 * f64::EPSILON, "{set:?}");
        }
    }
}

#[test]
fn it_has_the_poles_of_the_first_order_band_pass() {
    for set in sets(1_000) {
        let all = Filter::Allpass { f0: set.f0, q_factor: set.q_factor };
        let band = Filter::Bandpass { prototype: Prototype::Bessel, order: 1, f0: set.f0, q_factor: set.q_factor };
        let all = coefficients_of(&all, set.cycle_time()).allpass;
        let band = coefficients_of(&band, set.cycle_time()).bandpass[0];
        assert!((all.a1 - band.a1).abs() <= 2.0 * f64::EPSILON);
        assert!((all.a2 - band.a2).abs() <= f64::EPSILON);
        assert_eq!(all.preset.to_bits(), (1.0 - all.a2).to_bits());
    }
}
