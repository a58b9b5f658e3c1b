//! Band-passes: what the coefficients of 12,000 random ones do, against the closed forms of their prototypes.

use super::rounding::{demanded, of_sections};
use super::sections_of;
use crate::axis::{Filter, Prototype};
use crate::design::band::{Band, band, edges, frequency, warped};
use crate::design::response::{magnitude, of_bandpass, of_filter, phase};
use crate::unit::sets::filter as coefficients_of;
use crate::unit::sets::{Set, sets};
use portable::Extreme;
use reference::design::sections::Shape;
use reference::filter::Coeffs;

const COUNT: usize = 12_000;

fn design(set: &Set) -> (Band, Coeffs<f64>) {
    let Set { prototype, order, f0, q_factor, .. } = *set;
    let filter = Filter::Bandpass { prototype, order, f0, q_factor };
    (band(f0, q_factor, set.cycle_time()), coefficients_of(&filter, set.cycle_time()))
}

/// Over all sets: no deviation may be larger than rounding explains, nor larger than is demanded.
fn within(what: &str, deviations: impl Fn(&Set, &Band, &Coeffs<f64>) -> Vec<(f64, f64)>) {
    let mut worst = 0.0_f64;
    for set in sets(COUNT) {
        let (band, coeffs) = design(&set);
        for (deviation, rounding) in deviations(&set, &band, &coeffs) {
            assert!(deviation <= rounding, "{what}: {deviation:e} > {rounding:e}: {set:?}");
            assert!(deviation <= demanded(&set), "{what}: {deviation:e} > {:e}: {set:?}", demanded(&set));
            worst = worst.larger(deviation / rounding);
        }
    }
    assert!(worst > 0.01, "{what}: the tolerance is far too wide, worst {worst}");
}

#[test]
fn gain_is_1_and_phase_0_at_the_centre() {
    within("centre", |set, _, coeffs| {
        let t = warped(set.f0, set.cycle_time());
        let h = of_filter(coeffs, t);
        let rounding = of_sections(&coeffs.bandpass[..set.order], t);
        vec![((magnitude(h) - 1.0).abs(), rounding), (phase(h).to_radians().abs(), rounding)]
    });
}

#[test]
fn each_section_has_gain_1_at_the_centre_of_the_filter() {
    within("section", |set, _, coeffs| {
        let t = warped(set.f0, set.cycle_time());
        let one = |section| {
            ((magnitude(of_bandpass(section, t)) - 1.0).abs(), of_sections(core::slice::from_ref(section), t))
        };
        coeffs.bandpass[..set.order].iter().map(one).collect()
    });
}

#[test]
fn gain_is_3_db_less_at_both_edges() {
    within("edges", |set, band, coeffs| {
        let half = core::f64::consts::FRAC_1_SQRT_2;
        let one =
            |t| ((magnitude(of_filter(coeffs, t)) / half - 1.0).abs(), of_sections(&coeffs.bandpass[..set.order], t));
        edges(band).map(one).to_vec()
    });
}

/// The edges are looked for on the response, without the formula that predicts them.
#[test]
fn the_edges_are_f0_over_q_apart() {
    within("width", |set, band, coeffs| {
        let predicted = edges(band);
        let found = [-1.0, 1.0].map(|side| edge_beside(band.omega0, side, coeffs));
        let [lower, upper] = found.map(|t| frequency(t, set.cycle_time()));
        let rounding: f64 = predicted.map(|t| of_sections(&coeffs.bandpass[..set.order], t)).iter().sum();
        vec![(((upper - lower) * set.q_factor / set.f0 - 1.0).abs(), 2.0 * rounding)]
    });
}

/// Where |H|^2 falls through 1/2 below (-1) or above (1) the centre: bisection in ln t.
fn edge_beside(centre: f64, side: f64, coeffs: &Coeffs<f64>) -> f64 {
    let (mut inside, mut outside) = (0.0, 12.0);
    for _ in 0..60 {
        let middle = (inside + outside) / 2.0;
        let h = magnitude(of_filter(coeffs, centre * libm::exp(side * middle)));
        if h * h > 0.5 { inside = middle } else { outside = middle }
    }
    centre * libm::exp(side * inside)
}

/// Two points a decade apart, far below and far above the band: the gain changes by 20 dB for each order.
#[test]
fn skirts_fall_with_20_db_a_decade_for_each_order() {
    within("skirts", |set, band, coeffs| {
        let gain = |t| magnitude(of_filter(coeffs, t));
        let one = |near: f64, far: f64| {
            let decades = f64::from(u32::try_from(set.order).expect("1 to 3"));
            // The asymptote is reached as 1 / s_LP^2, s_LP = (Omega0^2 - t^2) / (B t), times 3 at most in these prototypes.
            let s = ((band.omega0 / near) * band.omega0 - near) / band.bandwidth;
            let rounding: f64 = [near, far].map(|t| of_sections(&coeffs.bandpass[..set.order], t)).iter().sum();
            ((gain(near) / gain(far) / libm::pow(10.0, decades) - 1.0).abs(), rounding + 3.0 / (s * s))
        };
        let far = 1e7 * (1.0 + band.bandwidth / band.omega0);
        vec![one(band.omega0 / far, band.omega0 / far / 10.0), one(band.omega0 * far, band.omega0 * far * 10.0)]
    });
}

/// At random frequencies from a hundredth of the centre to a hundred times it.
#[test]
fn gain_is_that_of_the_prototype_at_every_frequency() {
    within("prototype", |set, band, coeffs| {
        let one = |i: i32| {
            let t = band.omega0 * libm::pow(10.0, f64::from(i) / 4.0 + set.q_factor / 50.0);
            let s = ((band.omega0 / t) * band.omega0 - t) / band.bandwidth;
            let expected = prototype_gain(set.prototype, set.order, s);
            // s_LP carries the roundings of t and B, amplified where its two terms cancel.
            let steep = 8.0 * f64::EPSILON * (1.0 + (band.omega0 / t * band.omega0 + t) / band.bandwidth / s.abs());
            (
                (magnitude(of_filter(coeffs, t)) / expected - 1.0).abs(),
                of_sections(&coeffs.bandpass[..set.order], t) + steep,
            )
        };
        (-8..8).map(one).collect()
    });
}

/// |H(j w)| in closed form: no pole is used.
fn prototype_gain(prototype: Prototype, order: usize, w: f64) -> f64 {
    let ww = w * w;
    match (prototype, order) {
        (_, 1) => 1.0 / libm::sqrt(1.0 + ww),
        (Prototype::CritDamping, 2) => 1.0 / (1.0 + ww * (libm::sqrt(2.0) - 1.0)),
        (Prototype::CritDamping, _) => 1.0 / libm::pow(1.0 + ww * (libm::cbrt(2.0) - 1.0), 1.5),
        (Prototype::Butterworth, 2) => 1.0 / libm::sqrt(1.0 + ww * ww),
        (Prototype::Butterworth, _) => 1.0 / libm::sqrt(1.0 + ww * ww * ww),
        // s^2 + 3 s + 3 and s^3 + 6 s^2 + 15 s + 15, scaled to -3 dB at 1
        (Prototype::Bessel, 2) => {
            let vv = ww * 1.854_101_966_249_684_5; // 1.3616541287161305^2 = 3 (sqrt(5) - 1) / 2
            3.0 / libm::sqrt((3.0 - vv) * (3.0 - vv) + 9.0 * vv)
        }
        (Prototype::Bessel, _) => {
            let v = w * 1.755_672_368_681_210_7;
            let vv = v * v;
            15.0 / libm::hypot(15.0 - 6.0 * vv, v * (15.0 - vv))
        }
    }
}

#[test]
fn poles_lie_inside_the_unit_circle() {
    for set in sets(COUNT) {
        let (_, coeffs) = design(&set);
        for section in &coeffs.bandpass[..set.order] {
            let discriminant = section.a1 * section.a1 / 4.0 - section.a2;
            let radius = if discriminant < 0.0 {
                libm::sqrt(section.a2)
            } else {
                section.a1.abs() / 2.0 + libm::sqrt(discriminant)
            };
            assert!(radius < 1.0, "{radius}: {set:?}");
            assert!((1.0 + section.a1) + section.a2 > 0.0 && (1.0 - section.a1) + section.a2 > 0.0, "{set:?}");
        }
    }
}

/// Zeros at DC and at the Nyquist frequency are in the structure: b1 = 0 and b2 = -b0.
#[test]
fn nothing_passes_at_dc_and_at_the_nyquist_frequency() {
    for set in sets(300) {
        let (_, coeffs) = design(&set);
        assert!(magnitude(of_filter(&coeffs, 0.0)).to_bits() == 0);
        assert!(magnitude(of_filter(&coeffs, 1e15)) < 1e-12);
    }
}

#[test]
fn sections_follow_with_rising_quality_and_equal_ones_with_rising_centre() {
    for set in sets(COUNT) {
        let (band, coeffs) = design(&set);
        let sections = sections_of(set.prototype, set.order, &band);
        assert_eq!(sections.len(), set.order);
        for pair in sections.windows(2) {
            let same = pair[0].k.to_bits() == pair[1].k.to_bits();
            assert!(if same { pair[0].g <= pair[1].g } else { pair[0].k > pair[1].k }, "{set:?}: {sections:?}");
        }
        for unused in &coeffs.bandpass[set.order..] {
            assert!([unused.b2, unused.a1, unused.a2].iter().all(|c| c.to_bits() == 0));
        }
    }
}

/// The gain of a section at its own centre is -2 b2 / (1 - a2).
#[test]
fn sections_have_the_designed_gain_and_no_more_than_the_largest() {
    within("peak", |set, band, coeffs| {
        let sections = sections_of(set.prototype, set.order, band);
        let one = |(section, coeffs): (&Shape<f64>, &reference::bandpass::Coeffs<f64>)| {
            assert!(section.c <= largest_gain(set), "{}: {set:?}", section.c);
            let gain = -2.0 * coeffs.b2 / (1.0 - coeffs.a2);
            ((gain / section.c - 1.0).abs(), of_sections(core::slice::from_ref(coeffs), section.g))
        };
        sections.iter().zip(&coeffs.bandpass).map(one).collect()
    });
}

/// Up to 0.1: for each prototype; up to 0.25: 2.73; beyond, the band reaches the Nyquist frequency.
fn largest_gain(set: &Set) -> f64 {
    match (set.prototype, set.order) {
        (Prototype::CritDamping, _) | (_, 1) => 1.0,
        (Prototype::Bessel, 2) if set.product <= 0.1 => 1.25,
        (Prototype::Bessel, _) if set.product <= 0.1 => 1.64,
        (Prototype::Butterworth, 2) if set.product <= 0.1 => 1.53,
        (Prototype::Butterworth, _) if set.product <= 0.1 => 2.23,
        _ if set.product <= 0.25 => 2.73,
        _ => 41.0,
    }
}
