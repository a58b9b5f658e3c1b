//! The noise of an exercise: integers that every target can generate without a product above 2^31, times a power of two, so
//! that they are exact in both real types.

use compiler::leaf;
use compiler::legalise::RealInput;
use portable::{Literal, Real};

/// An integer of 22 bits from a linear congruential generator of full period.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Noise(u32);

impl Noise {
    pub(crate) const FACTOR: u32 = 509;
    /// The first number of a signal, which follows from 0, is near 0: a block that starts there has small values in its
    /// state, and the last bits of its v_add become visible.
    pub(crate) const SUMMAND: u32 = Self::HALF + 3;
    pub(crate) const BITS: u32 = 22;
    pub(crate) const RANGE: u32 = 1 << Self::BITS;
    /// Half of the range is subtracted from a signal's integer.
    pub(crate) const HALF: u32 = Self::RANGE / 2;
    /// Below it the signal is reduced: terms of a sum then have similar magnitudes for any coefficients.
    pub(crate) const SMALL_BELOW: u32 = Self::RANGE / 4;
    /// The factor of the reduction.
    pub(crate) const SMALL: f32 = 1.0 / 256.0;

    /// The factor of noise in a range above 0: a power of two within it.
    pub(super) fn scale<R: Real>(range: f64) -> Literal {
        leaf(R::lit(libm::exp2(libm::floor(libm::log2(range)) - f64::from(Self::BITS - 1))))
    }

    /// The factor of noise for a fraction from 0 to 1.
    pub(super) fn part<R: Real>() -> Literal {
        leaf(R::lit(1.0 / f64::from(Self::RANGE)))
    }

    /// The next integer.
    pub(super) fn integer(&mut self) -> u32 {
        self.0 = (self.0 * Self::FACTOR + Self::SUMMAND) % Self::RANGE;
        self.0
    }

    /// The next number for an input: times `scale` for a signal, times `part` for a fraction from 0 to 1.
    pub(super) fn next(&mut self, of: &RealInput, [scale, part]: [Literal; 2]) -> Literal {
        let integer = self.integer();
        let small = if integer < Self::SMALL_BELOW { Self::SMALL } else { 1.0 };
        match of.is_fraction {
            true => scaled(integer.cast_signed(), part, 1.0),
            false => scaled(integer.cast_signed() - Self::HALF.cast_signed(), scale, small),
        }
    }
}

/// An integer times two powers of two.
fn scaled(integer: i32, scale: Literal, small: f32) -> Literal {
    match scale {
        Literal::F64(scale) => Literal::F64(f64::from(integer) * scale * f64::from(small)),
        Literal::F32(scale) => Literal::F32(integer as f32 * scale * small),
        other => panic!("noise: {other:?} is not a factor"),
    }
}
