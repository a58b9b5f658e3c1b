//! Tangent, square root and rounding to 24 bits against `libm` and the processor.

use super::{evenly, unit};
use axgen_tests::environment::by_depth;
use axgen_tests::random::rng::Rng;
use reference::design::narrow::narrow;
use reference::design::square_root::square_root;
use reference::design::tangent::tangent;
use std::f64::consts::{FRAC_PI_4, PI};

/// The largest angle: pi 0.45, and a reserve.
const LARGEST: f64 = 1.4138;

fn count() -> usize {
    by_depth(200_000, 500_000, 3_000_000)
}

/// A number and its neighbours.
fn about(x: f64) -> impl Iterator<Item = f64> {
    (-40..=40).map(move |units| f64::from_bits(x.to_bits().wrapping_add_signed(units)))
}

fn same_tangent(angle: f64) {
    let (ours, theirs) = (tangent(angle), libm::tan(angle));
    assert_eq!(ours.to_bits(), theirs.to_bits(), "tan {angle:e}: {ours:e}, libm {theirs:e}");
}

#[test]
fn the_tangent_has_the_bits_of_libm() {
    let mut rng = Rng::new(0x7a6e);
    for _ in 0..count() / 2 {
        same_tangent(LARGEST * unit(&mut rng));
        same_tangent(evenly(&mut rng, 1e-12, LARGEST));
    }
    // the thresholds of the reduction and of the polynomial, on both sides of pi/4; octaves of the numbers that are cut
    let mut edges = vec![7.450_580_596_923_828e-9, 0.785_398_483_276_367_2, 0.674_335_479_736_328_1, FRAC_PI_4];
    edges.extend([2.0 * FRAC_PI_4 - 0.674_335_479_736_328_1, 0.45 * PI, 1.4138]);
    for octave in [0.125, 0.25, 0.5, 1.0, 2.0, 4.0] {
        edges.extend([libm::atan(octave), 2.0 * FRAC_PI_4 - libm::atan(octave)]);
    }
    edges.into_iter().flat_map(about).for_each(same_tangent);
    assert_eq!(tangent(0.0_f64).to_bits(), 0);
}

fn same_root(x: f64) {
    assert_eq!(square_root(x).to_bits(), x.sqrt().to_bits(), "sqrt {x:e}");
}

#[test]
fn the_square_root_is_correctly_rounded() {
    let (smallest, largest) = (libm::ldexp(1.0, -32), libm::ldexp(1.0, 32));
    let mut rng = Rng::new(0x0072_6f6f_7420);
    for _ in 0..count() {
        same_root(evenly(&mut rng, smallest, largest));
        // next to the square of a number between two neighbours, where the rounding of a root is hardest
        let twice = u128::from((rng.word() >> 12) | (1 << 52)) * 2 + 1;
        let square = (twice * twice) as f64;
        same_root(libm::ldexp(square, -106 + 2 * i32::try_from(rng.below(16)).expect("small")));
    }
    for exponent in -31..32 {
        about(libm::ldexp(1.0, exponent)).for_each(same_root);
    }
    [smallest, largest, 4.0 - libm::ldexp(1.0, -51)].into_iter().for_each(same_root);
    for none in [0.0_f64, -0.0, -1.0] {
        assert_eq!(square_root(none).to_bits(), 0);
    }
}

fn same_single(x: f64) {
    assert_eq!(narrow(x).to_bits(), f64::from(x as f32).to_bits(), "{x:e}");
}

/// Also for numbers exactly between two singles, where the split rounds to even as a conversion does.
#[test]
fn narrowing_gives_the_nearest_single() {
    let mut rng = Rng::new(0x6e61_7272_6f77);
    for _ in 0..count() {
        same_single(evenly(&mut rng, 1e-30, 1e30));
        same_single(-evenly(&mut rng, 1e-3, 1e12));
        let between = ((rng.word() >> 40) | (1 << 24) | 1) as f64;
        same_single(libm::ldexp(between, i32::try_from(rng.below(80)).expect("small") - 60));
    }
    [0.0, -0.0, 1.0, 16_777_217.0, 16_777_219.0].into_iter().for_each(same_single);
}
