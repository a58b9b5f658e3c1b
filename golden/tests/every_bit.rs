//! Every bit counts: a comparison finds each of them, in every type and at every place, and so does a digest.

use compiler::program::Type;
use golden::compare::compare;
use golden::samples::{Samples, Shape, Signal};
use portable::{Literal, RealKind};

/// Two samples of a signal of each type, with bits of both kinds in every byte.
fn samples(real: RealKind) -> Samples {
    let signal = |(name, ty, start): (&str, Type, Literal)| Signal { name: name.to_owned(), ty, start };
    let zero = match real {
        RealKind::F64 => Literal::F64(0.0),
        RealKind::F32 => Literal::F32(0.0),
    };
    let signals = [
        ("first", Type::Real, zero),
        ("flag", Type::Bool, Literal::Bool(false)),
        ("signed", Type::I32, Literal::I32(0)),
        ("unsigned", Type::U32, Literal::U32(0)),
        ("last", Type::Real, zero),
    ];
    let shape = Shape { real, signals: signals.map(signal).to_vec() };
    let reals = match real {
        RealKind::F64 => [Literal::F64(-1.234_567_890_123e-200), Literal::F64(9.876_543_210_987e99)],
        RealKind::F32 => [Literal::F32(-1.234_567e-20), Literal::F32(9.876_543e9)],
    };
    let mut samples = Samples::with_capacity(shape, 2);
    for flag in [true, false] {
        let integers = [Literal::I32(0x5a5a_a5a5), Literal::U32(0xa5a5_5a5a)];
        samples.push(&[reals[0], Literal::Bool(flag), integers[0], integers[1], reals[1]]);
    }
    samples
}

/// Each bit of a run, and the byte that it is in.
fn bits(of: &Samples) -> impl Iterator<Item = (usize, u8)> {
    (0..of.bytes.len()).flat_map(|byte| (0..8).map(move |bit| (byte, 1 << bit)))
}

fn flipped(of: &Samples, byte: usize, mask: u8) -> Samples {
    let mut other = of.clone();
    other.bytes[byte] ^= mask;
    other
}

#[test]
fn each_flipped_bit_is_one_differing_bit_at_its_place() {
    for real in [RealKind::F64, RealKind::F32] {
        let right = samples(real);
        let ranges = right.shape.ranges();
        let frame = right.shape.frame();
        assert_eq!(compare(&right, &right).bits, 0);
        for (byte, mask) in bits(&right) {
            let other = flipped(&right, byte, mask);
            for (expected, found) in [(&right, &other), (&other, &right)] {
                let difference = compare(expected, found);
                assert_eq!(difference.bits, 1, "{real:?}: byte {byte}, mask {mask:#x}");
                let first = difference.first.unwrap();
                assert_eq!(first.sample, byte / frame);
                let index = ranges.iter().position(|range| range.contains(&(byte % frame))).unwrap();
                assert_eq!(first.signal, right.shape.signals[index].name);
            }
        }
    }
}

#[test]
fn all_flipped_bits_are_counted() {
    let right = samples(RealKind::F64);
    let mut other = right.clone();
    other.bytes.iter_mut().for_each(|byte| *byte = !*byte);
    assert_eq!(compare(&right, &other).bits, 8 * right.bytes.len() as u64);
    let shorter = right.first(1);
    assert_eq!(compare(&right, &shorter).bits, 8 * right.shape.frame() as u64);
    assert_eq!(compare(&shorter, &right).bits, 8 * right.shape.frame() as u64);
}

/// A golden case keeps a million samples as a digest alone.
#[test]
fn each_flipped_bit_makes_another_digest() {
    let right = samples(RealKind::F64);
    let expected = generator::digest::digest(&right.bytes);
    for (byte, mask) in bits(&right) {
        let found = generator::digest::digest(&flipped(&right, byte, mask).bytes);
        assert_ne!(found, expected, "byte {byte}, mask {mask:#x}");
    }
}

/// The text of a vector says every bit of a real.
#[test]
fn each_flipped_bit_of_a_real_makes_another_line() {
    use golden::csv::{Reals, write};
    let right = samples(RealKind::F64).only(&[0, 2, 3, 4]);
    let expected = write(&[&right], Reals::Hexadecimal);
    for (byte, mask) in bits(&right) {
        assert_ne!(write(&[&flipped(&right, byte, mask)], Reals::Hexadecimal), expected, "byte {byte}, mask {mask:#x}");
    }
}
