//! Values as text that every implementation of Structured Text reads as the same bits.

use crate::print::language::Level;
use crate::print::number::decimal;
use portable::Literal;

/// The smallest magnitude that one compiler accepts as a real literal, although its LREAL has the range of a double.
const SMALLEST: f64 = 1.18e-38;
/// The largest magnitude that this compiler accepts as a real literal.
const LARGEST: f64 = 3.4e38;
/// 2^120, within these limits.
const UP: f64 = f64::from_bits((1023 + 120) << 52);
/// 2^-120, within these limits.
const DOWN: f64 = f64::from_bits((1023 - 120) << 52);

/// The text of a literal. A real has digits on both sides of the point and a signed exponent; a magnitude that some compiler
/// rejects becomes a product of powers of two and a number, exact in every step.
///
/// # Panics
/// If the literal does not exist at run time: the passes have excluded that.
pub fn literal(value: Literal) -> String {
    match value {
        Literal::Bool(true) => "TRUE".to_owned(),
        Literal::Bool(false) => "FALSE".to_owned(),
        // Some compilers read -2147483648 as minus a number that is not a DINT.
        Literal::I32(i32::MIN) => "-2147483647 - 1".to_owned(),
        Literal::I32(value) => value.to_string(),
        Literal::U32(value) => value.to_string(),
        Literal::F64(wide) => real(wide, digits(value)),
        Literal::F32(narrow) => real(f64::from(narrow), single(narrow)),
        Literal::Usize(_) | Literal::Variant(_) => panic!("st: {value:?} has no counterpart"),
    }
}

/// The text of a literal in a statement, and how tightly it binds: it may be a product, or begin with a sign.
pub(super) fn operand(value: Literal) -> (String, Level) {
    let text = literal(value);
    let level = match text.as_bytes() {
        _ if text.contains(" * ") => Level::Product,
        [b'-', ..] => Level::Any,
        _ => Level::Primary,
    };
    (text, level)
}

/// The digits of a number within the limits; a product for one beyond them.
fn real(value: f64, text: String) -> String {
    let magnitude = value.abs();
    if magnitude == 0.0 && value.is_sign_negative() {
        // Some compilers read a sign before 0 as a subtraction from 0.
        return "-1.0 * 0.0".to_owned();
    }
    if magnitude == 0.0 || (SMALLEST..=LARGEST).contains(&magnitude) {
        return text;
    }
    // The first factor has the digits: each product after it is exact, even if it is subnormal.
    let (factor, reciprocal) = if magnitude < SMALLEST { (DOWN, UP) } else { (UP, DOWN) };
    let (mut rest, mut factors) = (value, String::new());
    while !(SMALLEST..=LARGEST).contains(&rest.abs()) {
        rest *= reciprocal;
        factors.push_str(" * ");
        factors.push_str(&digits(Literal::F64(factor)));
    }
    digits(Literal::F64(rest)) + &factors
}

/// The shortest digits that give this REAL whether they are read as a REAL or as an LREAL that is then rounded.
fn single(value: f32) -> String {
    let shortest = digits(Literal::F32(value));
    let wide: f64 = shortest.parse().expect("st: a number's digits are a number");
    #[expect(clippy::cast_possible_truncation, reason = "what a compiler does that reads an LREAL first")]
    let rounded = wide as f32;
    if rounded.to_bits() == value.to_bits() { shortest } else { digits(Literal::F64(f64::from(value))) }
}

/// The shortest digits that read back to the same bits, in the notation of the standard: `0.1`, `1.0E-30`.
fn digits(value: Literal) -> String {
    let mut text = decimal(value);
    if let Some(exponent) = text.find('e') {
        let mark = if text[exponent..].starts_with("e-") { "E" } else { "E+" };
        text.replace_range(exponent..=exponent, mark);
    }
    text
}
