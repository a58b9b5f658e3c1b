//! The number of written digits of a column's values, and the unit of the last digit.

use portable::{Extreme, Literal, RealKind};

/// The number of written digits of a column's values.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Precision {
    /// the largest number of significant digits; 0 if all are written, or if the signal has no column
    pub digits: usize,
    /// the largest number of decimals
    decimals: i32,
}

/// Significant digits and decimals of a number as written; all digits if it is written in bits.
fn written(cell: &str) -> (usize, i32) {
    if cell.starts_with("0x") {
        return (usize::MAX, 0);
    }
    let (mantissa, exponent) = cell.split_once(['e', 'E']).unwrap_or((cell, "0"));
    let digits = mantissa.bytes().filter(u8::is_ascii_digit).skip_while(|digit| *digit == b'0').count();
    let after = mantissa.split_once('.').map_or(0, |(_, after)| after.len());
    (digits, i32::try_from(after).unwrap_or(0) - exponent.parse::<i32>().unwrap_or(0))
}

impl Precision {
    /// Includes another value; only reals have digits.
    pub(crate) fn add(&mut self, cell: &str, value: Literal) {
        if matches!(value, Literal::F64(_) | Literal::F32(_)) {
            let (digits, decimals) = written(cell);
            self.digits = self.digits.max(digits);
            self.decimals = self.decimals.max(decimals);
        }
    }

    /// The precision of a whole column: all digits are written if a value has more than the type.
    pub(crate) fn of_column(self, real: RealKind) -> Self {
        let full = match real {
            RealKind::F64 => 16,
            RealKind::F32 => 8,
        };
        if self.digits > full { Self::default() } else { self }
    }

    /// The precision of values that were rounded once more when they were multiplied by a factor.
    pub(crate) fn inexact(self, real: RealKind, factor: f64) -> Self {
        let full = match real {
            RealKind::F64 => 15,
            RealKind::F32 => 7,
        };
        #[expect(clippy::cast_possible_truncation, reason = "a few decades")]
        let decades = libm::floor(-libm::log10(factor)) as i32;
        match self.digits {
            0 => Self { digits: full, decimals: 320 },
            _ => Self { digits: self.digits.min(full), decimals: self.decimals - decades },
        }
    }

    /// The unit of the last written digit of a value.
    pub(crate) fn unit(self, value: f64) -> f64 {
        let digits = i32::try_from(self.digits).unwrap_or(0);
        match self.digits {
            0 => 0.0,
            _ if value == 0.0 || !value.is_finite() => libm::pow(10.0, f64::from(-self.decimals)),
            _ => {
                let first = libm::floor(libm::log10(value.abs()));
                libm::pow(10.0, (first + f64::from(1 - digits)).larger(f64::from(-self.decimals)))
            }
        }
    }
}
