//! The stages of an example, computed elsewhere to 1e-13: the response at the centre, and the first samples of a step.

use crate::inside::certificate::rack_and_pinion;
use generator::blocks::Designed;
use generator::design::band::warped;
use generator::design::response::of_stage;
use portable::RealKind;
use reference::stage;

/// 1 ms
const TS: f64 = 1e-3;

fn same(actual: f64, expected: f64) {
    assert!((actual - expected).abs() <= 1e-13 * expected.abs(), "{actual:e} is not {expected:e}");
}

#[test]
fn stages_of_the_rack_and_pinion_example() {
    let coeffs = Designed::from(rack_and_pinion(RealKind::F64)).ipc;
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
