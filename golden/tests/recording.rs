//! How far a recording agrees: what the digits that were written explain, and what they do not.

#![expect(clippy::unwrap_used, reason = "a test that cannot go on fails")]

use compiler::program::Type;
use golden::recording::{self, Error, Recording};
use golden::samples::{Samples, Shape, Signal};
use golden::table::Table;
use portable::{Literal, RealKind};

fn shape(names: &[&str]) -> Shape {
    let signal = |name: &&str| Signal { name: (*name).to_owned(), ty: Type::Real, start: Literal::F64(0.0) };
    Shape { real: RealKind::F64, signals: names.iter().map(signal).collect() }
}

/// Two samples of an input and two outputs: `y` with three digits after the point, `bits` in all its bits.
fn recorded() -> Recording {
    let one = 1f64.to_bits();
    let text = format!("x,y,bits\n1.125,2.125,0x{one:016x}\n1.250,2.250,0x{one:016x}\n");
    let table = Table::read(&text, &[]);
    recording::read(&table, [&shape(&["x"]), &shape(&["y", "bits"])], true, &[], 1_000_000).unwrap()
}

/// Answers with these errors in the last sample.
fn answers(y: f64, bits: f64) -> Samples {
    let mut samples = Samples::with_capacity(shape(&["y", "bits"]), 2);
    samples.push(&[Literal::F64(2.125), Literal::F64(1.0)]);
    samples.push(&[Literal::F64(2.250 + y), Literal::F64(1.0 + bits)]);
    samples
}

/// The errors of answers, where other inputs that would have been written the same change both outputs by so much.
fn errors(y: f64, bits: f64, change: f64) -> Vec<Error> {
    let (found, moved) = (answers(y, bits), answers(y + change, bits + change));
    recorded().errors(&found, Some(&moved))
}

/// Half of the last digit, and twice what the inputs' rounding changes: not three times, not twenty times.
#[test]
fn the_allowance_is_twice_the_change_and_half_a_digit() {
    for (error, is_explained) in
        [(0.0204, true), (0.0206, false), (0.031, false), (0.2, false), (-0.0204, true), (-0.0206, false)]
    {
        let [y, _] = &errors(error, 0.0, 0.01)[..] else { panic!() };
        assert_eq!(y.is_explained(), is_explained, "{error}");
        assert_eq!(y.unexplained, (!is_explained).then_some([1, 1]), "{error}");
    }
    // Without a change half of the digit is all.
    for (error, is_explained) in [(0.0004, true), (0.0006, false)] {
        assert_eq!(recorded().errors(&answers(error, 0.0), None)[0].is_explained(), is_explained, "{error}");
    }
}

/// Of an output in all its bits nothing explains a difference, not the last bit, whatever the inputs' rounding changes.
#[test]
fn an_output_in_all_its_bits_must_agree_in_all_of_them() {
    for change in [0.0, 0.01, 1e6] {
        let [_, bits] = &errors(0.0, f64::EPSILON, change)[..] else { panic!() };
        assert_eq!(bits.unexplained, Some([1, 1]), "{change}");
        assert!(errors(0.0, 0.0, change)[1].is_explained(), "{change}");
    }
}

/// The inputs that would have been written the same are half of the last digit away, up or down, and in no other place.
#[test]
fn moved_inputs_are_half_a_digit_away() {
    let recording = recorded();
    let (moved, mut values) = (recording.moved_inputs().unwrap(), Vec::new());
    for (sample, x) in [1.125, 1.250].into_iter().enumerate() {
        moved.read(sample, &mut values);
        let Literal::F64(value) = values[0] else { panic!("{values:?}") };
        assert!(((value - x).abs() - 0.0005).abs() < 1e-12, "{value}");
    }
}
