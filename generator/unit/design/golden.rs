//! Numbers of designs that were computed elsewhere, kept to 1e-13.

use super::{oscillation_of, sections_of};
use crate::axis::{Axis, DirectSource, Filter, Ipc, Mode, Prototype, Stage};
use crate::blocks::Designed;
use crate::design;
use crate::design::band::{Band, band, warped};
use crate::design::response::{of_allpass, of_bandpass, of_oscillation, of_stage};
use crate::unit::sets::axis;
use portable::RealKind;
use reference::design::allpass as portable_allpass;
use reference::design::sections::{Shape, allpass_numbers, bandpass_numbers};
use reference::stage;

/// 1 ms
const TS: f64 = 1e-3;

fn same(actual: f64, expected: f64) {
    assert!((actual - expected).abs() <= 1e-13 * expected.abs(), "{actual:e} is not {expected:e}");
}

#[test]
fn band_pass_of_order_1() {
    let rows = [
        (
            53.0,
            10.0,
            [0.168060374918548, 0.0171223032860172, 0.101881858197184],
            [0.016379233277826, -1.85916733321835, 0.967241533444348],
        ),
        (
            11.0,
            2.0,
            [0.0345712822153897, 0.0173011325284771, 0.500448100845256],
            [0.0169869369433685, -1.9613322512435, 0.966026126113263],
        ),
    ];
    for (f0, q_factor, [omega0, bandwidth, k], [b0, a1, a2]) in rows {
        let band = band(f0, q_factor, TS);
        same(band.omega0, omega0);
        same(band.bandwidth, bandwidth);
        for prototype in [Prototype::CritDamping, Prototype::Butterworth, Prototype::Bessel] {
            let sections = sections_of(prototype, 1, &band);
            assert_eq!(sections.len(), 1);
            same(sections[0].g, omega0);
            same(sections[0].k, k);
            same(sections[0].c, 1.0);
            let coeffs = bandpass_of(&sections[0]);
            same(coeffs.b2, -b0);
            same(coeffs.a1, a1);
            same(coeffs.a2, a2);
        }
    }
}

#[test]
fn sections_of_higher_orders() {
    let band = band(53.0, 10.0, TS);
    let first = [0.168060374918548, 0.101881858197184, 1.0];
    let (k, c) = (0.0508913978394623, 2.001946547402217);
    sections(Prototype::Butterworth, &band, &[first, [0.160807367408649, k, c], [0.175640519914661, k, c]]);
    let (k, c) = (0.112174146222307, 1.1553083301297592);
    sections(Prototype::Bessel, &band, &[[0.162695274588519, k, c], [0.173602396807142, k, c]]);
    sections(Prototype::CritDamping, &band, &[[0.168060374918548, 0.199837105700178, 1.0]; 3]);
}

fn sections(prototype: Prototype, band: &Band, expected: &[[f64; 3]]) {
    let actual = sections_of(prototype, expected.len(), band);
    assert_eq!(actual.len(), expected.len());
    for (Shape { g, k, c }, expected) in actual.iter().zip(expected) {
        same(*g, expected[0]);
        same(*k, expected[1]);
        same(*c, expected[2]);
    }
}

#[test]
fn simulated_oscillation() {
    let coeffs = oscillation_of(warped(11.0, TS), 0.8);
    same(coeffs.b0, 0.053486731356618);
    same(coeffs.b1, 0.0022624952544158466);
    same(coeffs.b2, -0.051224236102202);
    same(coeffs.a1, -1.890764042032348);
    same(coeffs.a2, 0.895289032541180);
}

fn allpass(band: &Band) -> reference::allpass::Coeffs<f64> {
    let (mut shape, mut coeffs) = (Shape::default(), reference::allpass::Coeffs::default());
    portable_allpass::section(&mut shape, band);
    allpass_numbers(&mut coeffs, &shape);
    coeffs
}

fn bandpass_of(shape: &Shape<f64>) -> reference::bandpass::Coeffs<f64> {
    let mut coeffs = reference::bandpass::Coeffs::default();
    bandpass_numbers(&mut coeffs, shape);
    coeffs
}

#[test]
fn all_pass() {
    let coeffs = allpass(&band(53.0, 10.0, TS));
    same(coeffs.a1, -1.85916733321835);
    same(coeffs.a2, 0.967241533444348);
}

/// The stages of the rack-and-pinion example: 53 Hz DIRECT with weight 3, 11 Hz INDIRECT with weight 1.9.
fn rack_and_pinion() -> Axis {
    let filter = |f0, q_factor| {
        [Filter::Bandpass { prototype: Prototype::CritDamping, order: 1, f0, q_factor }, Filter::NoFilter]
    };
    let direct = Mode::Direct { source: DirectSource::Motor };
    let stage = [
        Some(Stage { mode: direct, weight_fact_num: 300, weight_fact_denom: 100, filter: filter(53.0, 10.0) }),
        Some(Stage {
            mode: Mode::Indirect { osc_damping: 0.8 },
            weight_fact_num: 190,
            weight_fact_denom: 100,
            filter: filter(11.0, 2.0),
        }),
        None,
    ];
    let of = axis(RealKind::F64, 1_000_000, stage);
    Axis { ipc: Ipc { v_max: 200_000.0, ..of.ipc }, ..of }
}

#[test]
fn stages_of_the_rack_and_pinion_example() {
    let coeffs = Designed::from(rack_and_pinion()).ipc;
    let direct = of_stage(&coeffs.stage[0], warped(53.0, TS));
    same(direct.re, -3.0);
    assert!(direct.im.abs() < 3e-13);
    let indirect = of_stage(&coeffs.stage[1], warped(11.0, TS));
    same(indirect.re, -1.9);
    same(indirect.im, 1.1875);
    step_response(
        &coeffs.stage[0],
        [0.0, -0.049137699833478, -0.140492906193369, -0.21367179760676, -0.261361052116005, -0.279241693098681],
    );
    step_response(
        &coeffs.stage[1],
        [
            0.0,
            -0.00172629389243735,
            -0.00844916663862073,
            -0.0213517607450627,
            -0.0397206010339804,
            -0.0628600052933426,
        ],
    );
}

/// Response of the reference's own `step` to 0, 1, 1, ...
fn step_response(coeffs: &stage::Coeffs<f64>, expected: [f64; 6]) {
    let mut state = stage::State::default();
    for (x, y) in [0.0, 1.0, 1.0, 1.0, 1.0, 1.0].into_iter().zip(expected) {
        same(stage::step(&mut state, coeffs, x, 0.0), y);
    }
}

/// Gains at the centre: DIRECT 1, all-pass -1, oscillation 1 + 1 / (2 j D).
#[test]
fn responses_at_the_centre() {
    let t = warped(53.0, TS);
    let section = sections_of(Prototype::CritDamping, 1, &band(53.0, 10.0, TS))[0];
    same(of_bandpass(&bandpass_of(&section), t).re, 1.0);
    same(of_allpass(&allpass(&band(53.0, 10.0, TS)), t).re, -1.0);
    for (damping, gain) in [(0.8, 1.179), (0.4, 1.601), (0.2, 2.693), (0.05, 10.05)] {
        let h = of_oscillation(&oscillation_of(t, damping), t);
        same(h.re, 1.0);
        same(h.im, -1.0 / (2.0 * damping));
        assert!((design::response::magnitude(h) - gain).abs() < 5e-4);
    }
}
