//! Which inputs of a stage are refused.

use reference::design::inputs::{Wrong, check_filter, highest_f0, is_damping, is_weight, share};

/// The lowest and the highest f0 of a structure at 1 ms [Hz].
const LOWEST: f64 = 0.5;
const HIGHEST: f64 = 450.0;

/// The smallest weight and damping ratio, 2^-50.
const SMALLEST: f64 = 1.0 / (1_u64 << 50) as f64;

/// A table: the input, its numbers that are accepted, and those that are refused.
#[test]
fn each_input_has_its_range() {
    let none = [f64::NAN, f64::INFINITY, f64::NEG_INFINITY, -1.0, -0.0, 0.0];
    type Row<'n> = (fn(f64) -> bool, &'n [f64], &'n [f64]);
    let rows: [Row<'_>; 4] = [
        (
            |f0| check_filter(f0, 10.0, LOWEST, HIGHEST) == Wrong::Frequency,
            &[LOWEST, 449.0, 450.0],
            &[450.0_f64.next_up(), 451.0, 500.0, 501.0, 1e300],
        ),
        (|q| check_filter(53.0, q, LOWEST, HIGHEST) == Wrong::QualityFactor, &[1.0, 10.0], &[0.999, 10.001, 1e300]),
        (|d| !is_damping(d), &[SMALLEST, 0.999], &[SMALLEST.next_down(), 5e-324, 1.0, 1.5]),
        (|weight| !is_weight(weight), &[SMALLEST, 7.0], &[SMALLEST.next_down(), 5e-324, 7.0_f64.next_up(), 8.0]),
    ];
    for (i, (is_refused, accepted, refused)) in rows.into_iter().enumerate() {
        for x in accepted {
            assert!(!is_refused(*x), "row {i}: {x}");
        }
        for x in refused.iter().chain(&none) {
            assert!(is_refused(*x), "row {i}: {x}");
        }
    }
    assert_eq!(check_filter(HIGHEST, 1.0, LOWEST, HIGHEST), Wrong::Nothing);
}

#[test]
fn a_frequency_below_that_of_the_structure_has_its_own_answer() {
    assert_eq!(check_filter(LOWEST.next_down(), 10.0, LOWEST, HIGHEST), Wrong::LowFrequency);
}

/// At a short cycle 500 Hz is the bound, at a long one 0.45 of the sampling frequency: the last number that is not above it.
#[test]
fn the_highest_frequency_depends_on_the_cycle() {
    for (ns, highest) in [(62_500, 500.0), (900_000, 500.0), (1_000_000, 450.0), (2_000_000, 225.0), (4_000_000, 112.5)]
    {
        assert_eq!(highest_f0(ns).to_bits(), f64::to_bits(highest), "{ns} ns");
    }
    for ns in (900_001..20_000_000).step_by(9_973) {
        let highest = highest_f0(ns);
        assert!(share(highest, ns) <= 0.45 && share(highest.next_up(), ns) > 0.45, "{highest} Hz, {ns} ns");
    }
}
