//! What the coefficients of 12,000 random filters do at the centre and at the edges of the band, and what they begin with. Every number
//! of a design is compared with 80 digits in `tests/tests/design`.

use super::oscillation_of;
use super::rounding::{demanded, of_section, of_sections};
use crate::inside::sets::filter as coefficients_of;
use crate::inside::sets::{Set, sets};
use generator::axis::Filter;
use generator::design::band::{Band, band, edges, frequency, warped};
use generator::design::response::{Complex, Section, magnitude, product, sections};
use portable::Extreme;
use reference::filter::Coeffs;

const COUNT: usize = 12_000;

fn bandpass(set: &Set) -> Coeffs<f64> {
    let Set { prototype, order, f0, q_factor, .. } = *set;
    coefficients_of(&Filter::Bandpass { prototype, order, f0, q_factor }, set.cycle_time())
}

fn allpass(set: &Set) -> reference::allpass::Coeffs<f64> {
    coefficients_of(&Filter::Allpass { f0: set.f0, q_factor: set.q_factor }, set.cycle_time()).allpass
}

/// Over all sets: no deviation may be larger than rounding explains, nor larger than is demanded.
fn within(what: &str, deviations: impl Fn(&Set, &Band) -> Vec<(f64, f64)>) {
    let mut worst = 0.0_f64;
    for set in sets(COUNT) {
        for (deviation, rounding) in deviations(&set, &band(set.f0, set.q_factor, set.cycle_time())) {
            assert!(deviation <= rounding, "{what}: {deviation:e} > {rounding:e}: {set:?}");
            assert!(deviation <= demanded(&set), "{what}: {deviation:e} > {:e}: {set:?}", demanded(&set));
            worst = worst.larger(deviation / rounding);
        }
    }
    assert!(worst > 0.01, "{what}: the tolerance is far too wide, worst {worst}");
}

fn distance(h: Complex, re: f64, im: f64) -> f64 {
    magnitude(Complex { re: h.re - re, im: h.im - im })
}

#[test]
fn a_band_pass_is_1_at_the_centre_and_3_db_less_at_edges_that_are_f0_over_q_apart() {
    within("band-pass", |set, band| {
        let coeffs = bandpass(set);
        let rounding = |t| of_sections(&coeffs.bandpass[..set.order], t);
        let centre = warped(set.f0, set.cycle_time());
        let edge =
            |t| ((magnitude(product(&sections(&coeffs), t)) * core::f64::consts::SQRT_2 - 1.0).abs(), rounding(t));
        let [lower, upper] = edges(band);
        let apart = frequency(upper, set.cycle_time()) - frequency(lower, set.cycle_time());
        vec![
            (distance(product(&sections(&coeffs), centre), 1.0, 0.0), 2.0 * rounding(centre)),
            edge(lower),
            edge(upper),
            ((apart * set.q_factor / set.f0 - 1.0).abs(), 1e-13),
        ]
    });
}

/// -90 degrees at the lower edge, -180 at the centre, -270 at the upper edge. The tolerance is twice that of a section, for its
/// numerator turns as its denominator does.
#[test]
fn an_all_pass_turns_by_a_quarter_at_each_edge_and_by_a_half_at_the_centre() {
    within("all-pass", |set, band| {
        let coeffs = allpass(set);
        let [lower, upper] = edges(band);
        let at = |t, re, im| {
            let rounding = 2.0 * of_section(coeffs.a1, coeffs.a2, t) + 60.0 * f64::EPSILON;
            (distance(Section::of_allpass(&coeffs).at(t), re, im), rounding)
        };
        vec![at(lower, 0.0, -1.0), at(warped(set.f0, set.cycle_time()), -1.0, 0.0), at(upper, 0.0, 1.0)]
    });
}

/// A constant input is preset where it stays.
#[test]
fn presets_are_those_of_a_constant_input() {
    for set in sets(1_000) {
        let all = allpass(&set);
        assert_eq!(all.preset.to_bits(), (1.0 - all.a2).to_bits());
        let oscillation = oscillation_of(warped(set.f0, set.cycle_time()), 0.3);
        assert_eq!(oscillation.preset_s1.to_bits(), (1.0 - oscillation.b0).to_bits());
        assert_eq!(oscillation.preset_s2.to_bits(), (oscillation.b2 - oscillation.a2).to_bits());
    }
}
