//! Numbers with 80 digits after the point, of whole numbers of any length; pi, square and cube root, sine and cosine. No filter.

use dashu_int::ops::{Abs, BitTest, SquareRoot};
use dashu_int::{IBig, UBig};
use std::borrow::Borrow;
use std::ops::{Add, Div, Mul, Neg, Sub};
use std::sync::OnceLock;

/// Bits after the point.
const BITS: usize = 272;
/// Halvings of an angle before its series.
const HALVINGS: usize = 8;

/// A multiple of 2^-272.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Fixed(IBig);

impl From<i32> for Fixed {
    fn from(whole: i32) -> Self {
        Self(IBig::from(whole) << BITS)
    }
}

impl From<f64> for Fixed {
    /// Exact from 2^-219 on.
    fn from(x: f64) -> Self {
        let bits = x.to_bits();
        let exponent = usize::try_from((bits >> 52) & 0x7ff).expect("11 bits");
        let magnitude = IBig::from((bits & ((1 << 52) - 1)) | (u64::from(exponent > 0) << 52));
        // magnitude 2^(exponent - 1075)
        let scaled = (magnitude << (BITS + exponent.max(1))) >> 1075;
        Self(if x.is_sign_negative() { -scaled } else { scaled })
    }
}

impl<T: Borrow<Fixed>> Add<T> for Fixed {
    type Output = Self;
    fn add(self, other: T) -> Self {
        Self(self.0 + &other.borrow().0)
    }
}

impl<T: Borrow<Fixed>> Sub<T> for Fixed {
    type Output = Self;
    fn sub(self, other: T) -> Self {
        Self(self.0 - &other.borrow().0)
    }
}

impl<T: Borrow<Fixed>> Mul<T> for Fixed {
    type Output = Self;
    fn mul(self, other: T) -> Self {
        Self((self.0 * &other.borrow().0) >> BITS)
    }
}

impl<T: Borrow<Fixed>> Div<T> for Fixed {
    type Output = Self;
    fn div(self, other: T) -> Self {
        Self((self.0 << BITS) / &other.borrow().0)
    }
}

impl Neg for Fixed {
    type Output = Self;
    fn neg(self) -> Self {
        Self(-self.0)
    }
}

impl Fixed {
    /// The magnitude.
    #[must_use]
    pub fn abs(self) -> Self {
        Self(self.0.abs())
    }

    /// The sum of the products of two rows.
    #[must_use]
    pub fn dot(left: &[Self], right: &[Self]) -> Self {
        Self(left.iter().zip(right).map(|(a, b)| &a.0 * &b.0).sum::<IBig>() >> BITS)
    }

    /// 1 + 2^-bits
    #[must_use]
    pub fn above_one(bits: usize) -> Self {
        Self((IBig::ONE << BITS) + (IBig::ONE << (BITS - bits)))
    }

    /// Times 2^bits.
    #[must_use]
    pub fn shifted(self, bits: usize) -> Self {
        Self(self.0 << bits)
    }

    /// Its first 60 digits after the point, and those before it.
    #[must_use]
    pub fn digits(&self) -> String {
        ((self.0.clone() * IBig::from(10).pow(60)) >> BITS).to_string()
    }

    /// The nearest double.
    #[must_use]
    pub fn to_f64(&self) -> f64 {
        libm::ldexp(self.0.to_f64().value(), -272)
    }

    /// Whether it has digits enough for an error relative to it: 2^-66 and more.
    #[must_use]
    pub fn is_precise(&self) -> bool {
        self.0.bit_len() > BITS - 66
    }

    /// The root with this index of a positive number.
    fn root(&self, index: usize) -> Self {
        let scaled = UBig::try_from(&self.0 << ((index - 1) * BITS)).expect("the number is not negative");
        Self(if index == 2 { scaled.sqrt() } else { scaled.nth_root(index) }.into())
    }

    /// The square root.
    #[must_use]
    pub fn sqrt(&self) -> Self {
        self.root(2)
    }

    /// The cube root.
    #[must_use]
    pub fn cbrt(&self) -> Self {
        self.root(3)
    }

    /// 16 arctan(1/5) - 4 arctan(1/239)
    #[must_use]
    pub fn pi() -> &'static Self {
        static PI: OnceLock<Fixed> = OnceLock::new();
        PI.get_or_init(|| Self::from(16) * arctan_of_part(5) - Self::from(4) * arctan_of_part(239))
    }

    /// tan x = sin x / cos x for 0 <= x < 2: the series of x / 256, then eight doublings.
    #[must_use]
    pub fn tan(&self) -> Self {
        let x = Self(&self.0 >> HALVINGS);
        let mut term = x.clone();
        let mut sin = x.clone();
        let mut cos = Self::from(1);
        for n in 2.. {
            term = term * &x / Self::from(n);
            if term.0 == IBig::ZERO {
                break;
            }
            let signed = if n / 2 % 2 == 1 { -term.clone() } else { term.clone() };
            if n % 2 == 0 { cos = cos + signed } else { sin = sin + signed }
        }
        for _ in 0..HALVINGS {
            let doubled = sin.clone() * &cos * Self::from(2);
            cos = Self::from(1) - sin.clone() * &sin * Self::from(2);
            sin = doubled;
        }
        sin / cos
    }
}

/// arctan(1 / n) = 1/n - 1/(3 n^3) + 1/(5 n^5) - ...
fn arctan_of_part(n: i32) -> Fixed {
    let mut power = Fixed::from(1) / Fixed::from(n);
    let mut sum = Fixed::from(0);
    for k in 0.. {
        let term = power.clone() / Fixed::from(2 * k + 1);
        if term.0 == IBig::ZERO {
            break;
        }
        sum = if k % 2 == 0 { sum + term } else { sum - term };
        power = power / Fixed::from(n * n);
    }
    sum
}
