//! Which inputs of a stage are refused.

use reference::design::inputs::{FilterInputs, Finding, Inputs, Wrong, check};
use reference::filter::{Coeffs as Filter, Type};
use reference::stage::{Coeffs, Mode};

const NS: u32 = 1_000_000;
/// The lowest f0 of the structure [Hz].
const LOWEST: f64 = 0.5;

/// The smallest weight and damping ratio, 2^-50.
const SMALLEST: f64 = 1.0 / (1_u64 << 50) as f64;

fn stage(mode: Mode, kinds: [Type; 2]) -> Coeffs<f64> {
    let filter = kinds.map(|kind| Filter { kind, order: 1, ..Filter::default() });
    Coeffs { mode, filter, ..Coeffs::default() }
}

fn sound() -> Inputs<f64> {
    Inputs { filter: [FilterInputs { f0: 53.0, q_factor: 10.0 }; 2], damping: 0.8, weight: 3.0 }
}

fn found(structure: &Coeffs<f64>, inputs: &Inputs<f64>, ns: u32) -> (Wrong, u32) {
    let mut finding = Finding::default();
    check(&mut finding, structure, inputs, ns, LOWEST);
    (finding.wrong, finding.filter)
}

/// A table: the input, its numbers that are accepted, and those that are refused.
#[test]
fn each_input_has_its_range() {
    let none = [f64::NAN, f64::INFINITY, f64::NEG_INFINITY, -1.0, -0.0, 0.0];
    type Set = fn(&mut Inputs<f64>, f64);
    type Row<'n> = (Set, Wrong, u32, &'n [f64], &'n [f64]);
    let rows: [Row<'_>; 5] = [
        (|of, x| of.filter[0].f0 = x, Wrong::Frequency, 0, &[LOWEST, 450.0], &[450.0_f64.next_up(), 500.0, 1e300]),
        (|of, x| of.filter[1].f0 = x, Wrong::Frequency, 1, &[LOWEST, 449.0], &[451.0, 501.0]),
        (|of, x| of.filter[1].q_factor = x, Wrong::QualityFactor, 1, &[1.0, 10.0], &[0.999, 10.001, 1e300]),
        (|of, x| of.damping = x, Wrong::Damping, 0, &[SMALLEST, 0.999], &[SMALLEST.next_down(), 5e-324, 1.0, 1.5]),
        (
            |of, x| of.weight = x,
            Wrong::Weight,
            0,
            &[SMALLEST, 7.0],
            &[SMALLEST.next_down(), 5e-324, 7.0_f64.next_up(), 8.0],
        ),
    ];
    let structure = stage(Mode::Indirect, [Type::Allpass, Type::Bandpass]);
    for (set, wrong, filter, accepted, refused) in rows {
        for x in accepted {
            let mut inputs = sound();
            set(&mut inputs, *x);
            assert_eq!(found(&structure, &inputs, NS), (Wrong::Nothing, 0), "{x}");
        }
        for x in refused.iter().chain(&none) {
            let mut inputs = sound();
            set(&mut inputs, *x);
            assert_eq!(found(&structure, &inputs, NS), (wrong, filter), "{x}");
        }
    }
}

#[test]
fn a_frequency_below_that_of_the_structure_has_its_own_answer() {
    let structure = stage(Mode::Direct, [Type::Bandpass, Type::NoFilter]);
    let mut inputs = sound();
    inputs.filter[0].f0 = LOWEST.next_down();
    assert_eq!(found(&structure, &inputs, NS), (Wrong::LowFrequency, 0));
}

/// At a short cycle 500 Hz is the bound, at a long one 0.45 of the sampling frequency.
#[test]
fn the_highest_frequency_depends_on_the_cycle() {
    let structure = stage(Mode::Direct, [Type::Bandpass, Type::NoFilter]);
    for (ns, highest) in [(62_500, 500.0), (1_000_000, 450.0), (2_000_000, 225.0), (4_000_000, 112.5)] {
        for (f0, wrong) in [(highest, Wrong::Nothing), (f64::next_up(highest), Wrong::Frequency)] {
            let mut inputs = sound();
            inputs.filter[0].f0 = f0;
            assert_eq!(found(&structure, &inputs, ns), (wrong, 0), "{f0} Hz, {ns} ns");
        }
    }
}

#[test]
fn what_a_stage_does_not_use_is_not_looked_at() {
    let nan = FilterInputs { f0: f64::NAN, q_factor: f64::NAN };
    let inputs = Inputs { filter: [sound().filter[0], nan], damping: f64::NAN, weight: 1.0 };
    assert_eq!(found(&stage(Mode::Direct, [Type::Bandpass, Type::NoFilter]), &inputs, NS), (Wrong::Nothing, 0));
    assert_eq!(found(&stage(Mode::SetPoint, [Type::Bandpass, Type::NoFilter]), &inputs, NS), (Wrong::Damping, 0));
    let swapped = Inputs { filter: [nan, inputs.filter[0]], ..inputs };
    assert_eq!(found(&stage(Mode::Direct, [Type::NoFilter, Type::Bandpass]), &swapped, NS), (Wrong::Nothing, 0));
    assert_eq!(found(&stage(Mode::Direct, [Type::Bandpass, Type::Bandpass]), &swapped, NS), (Wrong::Frequency, 0));
}
