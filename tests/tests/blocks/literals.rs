//! Every number that Structured Text prints reads back to the same bits, the way in which each implementation reads it.

#![expect(clippy::unwrap_used, reason = "a test that cannot go on fails")]

use compiler::print::st::literal;
use portable::Literal;
use proptest::prelude::*;
use proptest::test_runner::{Config, TestRunner};

/// Random bit patterns of each real type.
const NUMBERS: u32 = 100_000;

/// A product of literals, each as the standard writes it and of a magnitude that every compiler takes.
fn factors(text: &str) -> Vec<&str> {
    let factors: Vec<&str> = text.split(" * ").collect();
    for factor in &factors {
        let digits = factor.strip_prefix('-').unwrap_or(factor);
        let (mantissa, exponent) = digits.split_once('E').unwrap_or((digits, "+0"));
        let (whole, fraction) = mantissa.split_once('.').unwrap_or_else(|| panic!("{text}: no point"));
        let is_digits = |text: &str| !text.is_empty() && text.bytes().all(|byte| byte.is_ascii_digit());
        assert!(is_digits(whole) && is_digits(fraction), "{text}");
        assert!(exponent.starts_with(['+', '-']) && is_digits(&exponent[1..]), "{text}");
        let magnitude = digits.parse::<f64>().unwrap();
        assert!(magnitude == 0.0 || (1.18e-38..=3.4e38).contains(&magnitude), "{text}");
    }
    factors
}

/// The value as an LREAL.
fn wide(text: &str) -> f64 {
    factors(text).into_iter().map(|factor| factor.parse::<f64>().unwrap()).reduce(|a, b| a * b).unwrap()
}

/// The value as a REAL, where the digits are those of a REAL.
fn narrow(text: &str) -> f32 {
    factors(text).into_iter().map(|factor| factor.parse::<f32>().unwrap()).reduce(|a, b| a * b).unwrap()
}

fn check_f64(value: f64) {
    let text = literal(Literal::F64(value));
    assert_eq!(wide(&text).to_bits(), value.to_bits(), "{text}");
}

#[expect(clippy::cast_possible_truncation, reason = "what an implementation does that reads an LREAL first")]
fn check_f32(value: f32) {
    let text = literal(Literal::F32(value));
    assert_eq!((wide(&text) as f32).to_bits(), value.to_bits(), "{text}: read as LREAL, then rounded");
    assert_eq!(narrow(&text).to_bits(), value.to_bits(), "{text}: read as REAL");
}

#[test]
fn random_numbers_read_back_to_their_bits() {
    let mut runner = TestRunner::new(Config { cases: NUMBERS, ..Config::default() });
    let finite = any::<u64>().prop_map(f64::from_bits).prop_filter("finite", |value| value.is_finite());
    runner
        .run(&finite, |value| {
            check_f64(value);
            Ok(())
        })
        .unwrap();
    let finite = any::<u32>().prop_map(f32::from_bits).prop_filter("finite", |value| value.is_finite());
    runner
        .run(&finite, |value| {
            check_f32(value);
            Ok(())
        })
        .unwrap();
}

#[test]
fn subnormal_numbers_read_back_to_their_bits() {
    let mut runner = TestRunner::new(Config { cases: NUMBERS, ..Config::default() });
    let sign = |negative: bool| if negative { -1.0 } else { 1.0 };
    runner
        .run(&(1..1u64 << 52, any::<bool>()), |(bits, negative)| {
            check_f64(f64::from_bits(bits) * sign(negative));
            Ok(())
        })
        .unwrap();
    runner
        .run(&(1..1u32 << 23, any::<bool>()), |(bits, negative)| {
            check_f32(if negative { -f32::from_bits(bits) } else { f32::from_bits(bits) });
            Ok(())
        })
        .unwrap();
}

#[test]
fn the_ends_of_the_ranges() {
    for value in [0.0, -0.0, f64::MIN_POSITIVE, f64::MAX, f64::MIN, 5e-324, 1.18e-38, 3.4e38, 1e-30, 1e15, 0.1] {
        check_f64(value);
    }
    for value in [0.0, -0.0, f32::MIN_POSITIVE, f32::MAX, f32::MIN, 1e-45, 1.18e-38, 3.4e38, 1e-18, 1e9, 0.1] {
        check_f32(value);
    }
    assert_eq!(literal(Literal::F64(1e-30)), "1.0E-30");
    assert_eq!(literal(Literal::F64(1e15)), "1000000000000000.0");
    assert_eq!(literal(Literal::F64(1e16)), "1.0E+16");
    assert_eq!(literal(Literal::F64(1e-45)), "1.3292279957849159E-9 * 7.52316384526264E-37");
    assert_eq!(literal(Literal::F64(-0.0)), "-1.0 * 0.0");
    assert_eq!(literal(Literal::I32(i32::MIN)), "-2147483647 - 1");
}
