//! The forms of numbers that every compiler accepts, and their values.

use portable::{Real, RealKind};

/// Magnitudes that some compiler accepts as a literal, although its LREAL is a double.
const SMALLEST: f64 = 1.18e-38;
const LARGEST: f64 = 3.4e38;

/// The notation of -0.0: some compilers drop the sign of the literal.
pub(crate) const MINUS_ZERO: &str = "-1.0 * 0.0";

/// The error in an unsigned number, and what to write instead.
pub(crate) fn mistake(text: &str) -> Option<(String, String)> {
    let found = format!("`{text}`");
    if let Some((base, digits)) = text.split_once('#') {
        let good = base == "16" && !digits.is_empty() && digits.bytes().all(|byte| byte.is_ascii_hexdigit());
        return (!good).then(|| (found, "the number in decimal, or `16#` and its digits without `_`".to_owned()));
    }
    if text.bytes().all(|byte| byte.is_ascii_digit()) {
        return None;
    }
    let Some(value) = real_form(text).then(|| text.parse::<f64>().ok()).flatten() else {
        return Some((found, "a number like `15`, `1.5`, `1.5E+3` or `1.5E-3`".to_owned()));
    };
    let taken = value == 0.0 || (SMALLEST..=LARGEST).contains(&value);
    (!taken).then(|| {
        (format!("{found}, a magnitude outside 1.18E-38 .. 3.4E38"), "a product of numbers inside it".to_owned())
    })
}

/// `d.d`, `d.dE+d`, `d.dE-d`
fn real_form(text: &str) -> bool {
    let digits = |text: &str| !text.is_empty() && text.bytes().all(|byte| byte.is_ascii_digit());
    let (mantissa, exponent) = text.split_once('E').map_or((text, None), |(left, right)| (left, Some(right)));
    let whole = mantissa.split_once('.').is_some_and(|(left, right)| digits(left) && digits(right));
    whole && exponent.is_none_or(|text| text.strip_prefix(['+', '-']).is_some_and(digits))
}

/// The integer of a literal, if it fits into any integer type.
pub(crate) fn integer(text: &str) -> Option<i64> {
    let (negative, digits) = text.strip_prefix('-').map_or((false, text), |rest| (true, rest));
    let value = match digits.split_once('#') {
        Some((_, digits)) => i64::from_str_radix(digits, 16),
        None => digits.parse(),
    };
    value.ok().map(|value: i64| if negative { -value } else { value })
}

/// A real number that stands alone, as read by a compiler in either of two ways if it is assigned to a REAL.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Constant {
    double: f64,
    single: f32,
    /// whether every part of it is equal in both ways
    same: bool,
}

impl Constant {
    pub(crate) fn literal(text: &str) -> Option<Self> {
        Some(Self { double: text.parse().ok()?, single: text.parse().ok()?, same: true }.checked())
    }

    /// `-x`
    pub(crate) fn negated(self) -> Self {
        Self { double: -self.double, single: -self.single, ..self }
    }

    /// `x * y`
    pub(crate) fn times(self, other: Self) -> Self {
        let (double, single) = (self.double * other.double, self.single * other.single);
        Self { double, single, same: self.same && other.same }.checked()
    }

    fn checked(self) -> Self {
        Self { same: self.same && self.single.to_bits() == f32::lit(self.double).to_bits(), ..self }
    }

    /// Its value in a real type, as a double; `None`: it depends on the compiler, or it is not finite.
    pub(crate) fn value(self, real: RealKind) -> Option<f64> {
        match real {
            RealKind::F64 => self.double.is_finite().then_some(self.double),
            RealKind::F32 => (self.same && self.single.is_finite()).then(|| f64::from(self.single)),
        }
    }
}
