//! Numbers as text for readers: short, the same on every host, and different for two different numbers.

use portable::Literal;

/// The digits of a number, which read back to the same bits.
pub fn literal(value: Literal) -> String {
    match value {
        Literal::F64(value) => format!("{value:?}"),
        Literal::F32(value) => format!("{value:?}"),
        Literal::U32(value) => value.to_string(),
        Literal::I32(value) => value.to_string(),
        Literal::Usize(value) => value.to_string(),
        Literal::Bool(value) => value.to_string(),
        Literal::Variant(variant) => variant.def().name.to_owned(),
    }
}

/// `old -> new`, both with at least `digits` significant digits and as many more as distinguish them.
pub(crate) fn pair(old: f64, new: f64, digits: u32) -> String {
    let text = |digits| [old, new].map(|value| significant(value, digits));
    let apart = (digits..17).map(text).find(|[a, b]| a != b).unwrap_or_else(|| text(digits));
    apart.join(" -> ")
}

/// As many zeros as a number without exponent may have.
const ZEROS: &str = "00000000000";

/// A number with N significant digits, no trailing zeros.
pub fn significant(value: f64, digits: u32) -> String {
    if !value.is_finite() {
        return value.to_string();
    }
    let magnitude = value.abs();
    let exactly = || Decimal::read(&format!("{magnitude:.*e}", digits.saturating_sub(1) as usize));
    let shortest = Decimal::read(zmij::Buffer::new().format_finite(magnitude));
    let Decimal { digits, power } = shortest.with(digits).unwrap_or_else(exactly);
    let power = power + digits.checked_ilog10().unwrap_or(0).cast_signed();
    let mut text = digits.to_string();
    text.truncate(text.trim_end_matches('0').len().max(1));
    match usize::try_from(power) {
        Ok(whole @ 0..12) if whole + 1 < text.len() => text.insert(whole + 1, '.'),
        Ok(whole @ 0..12) => text.push_str(&ZEROS[..whole + 1 - text.len()]),
        Err(_) if power >= -4 => text.insert_str(0, &"0.000"[..=power.unsigned_abs() as usize]),
        _ => {
            if text.len() > 1 {
                text.insert(1, '.');
            }
            text.extend(["e", &power.to_string()]);
        }
    }
    if value.is_sign_negative() {
        text.insert(0, '-');
    }
    text
}

/// The magnitude of a number: `digits` times 10^`power`.
struct Decimal {
    digits: u64,
    power: i32,
}

impl Decimal {
    /// From a text of at most 19 digits.
    fn read(text: &str) -> Self {
        let mut decimal = Self { digits: 0, power: 0 };
        let mut is_part = false;
        let text = text.strip_suffix(".0").unwrap_or(text);
        for (at, byte) in text.bytes().enumerate() {
            match byte {
                b'.' => is_part = true,
                b'e' => {
                    let exponent: i32 = text[at + 1..].parse().expect("number: an exponent is a number");
                    decimal.power += exponent;
                    break;
                }
                digit => {
                    decimal.digits = 10 * decimal.digits + u64::from(digit - b'0');
                    decimal.power -= i32::from(is_part);
                }
            }
        }
        decimal
    }

    /// The shortest decimal of a number, with N digits; `None` if what is left out is half of the last digit, because the
    /// number may be more or less. In all other cases both are on the same side of the half, which would be shorter.
    fn with(self, digits: u32) -> Option<Self> {
        let has = self.digits.checked_ilog10().map_or(1, |power| power + 1);
        let excess = has.saturating_sub(digits);
        let unit = 10_u64.pow(excess);
        let rest = self.digits % unit;
        let digits = self.digits / unit + u64::from(rest > unit / 2);
        (2 * rest != unit).then(|| Self { digits, power: self.power + excess.cast_signed() })
    }
}

/// A number with at most N decimals, no trailing zeros, no -0.
pub(crate) fn decimals(value: f64, decimals: usize) -> String {
    let mut text = format!("{value:.decimals$}");
    if text.contains('.') {
        text.truncate(text.trim_end_matches('0').trim_end_matches('.').len());
    }
    if text == "-0" { "0".to_owned() } else { text }
}

/// A change in per cent with its sign: ` (-1.9 %)`.
pub(crate) fn percent(old: f64, new: f64) -> String {
    let part = (new - old) / old * 100.0;
    let sign = if part > 0.0 { "+" } else { "" };
    let text = if part.abs() < 0.05 { significant(part, 2) } else { decimals(part, 1) };
    format!(" ({sign}{text} %)")
}

/// A factor in decibels: 20 log10(factor).
pub(crate) fn decibels(factor: f64) -> f64 {
    20.0 * libm::log10(factor)
}

/// Seven significant digits, no trailing zeros, the same on every host.
pub(crate) fn digits(value: f64) -> String {
    significant(value, 7)
}

/// Six significant digits, for a message.
pub(crate) fn rounded(x: f64) -> f64 {
    format!("{x:.5e}").parse().unwrap_or(x)
}

/// Rounded down to N significant digits, for an upper limit.
pub(crate) fn down_to(value: f64, digits: i32) -> String {
    if value <= 0.0 {
        return "0".to_owned();
    }
    let unit = libm::pow(10.0, libm::floor(libm::log10(value)) + 1.0 - f64::from(digits));
    // 0.3 is not a multiple of 0.1 in binary.
    significant(libm::floor(value / unit + 1e-9) * unit, digits.unsigned_abs())
}
