//! Noise that every target can make itself, exact in both real types. Nothing is recorded here.

use compiler::leaf;
use portable::{Literal, Real};
use std::marker::PhantomData;

/// The generator of the self-test's and the vector's noise: scale * (integer of 24 bits - 2^23).
pub(crate) struct Noise<R> {
    random: u32,
    scales: [Literal; 2],
    real: PhantomData<R>,
}

impl<R: Real> Noise<R> {
    /// Noise of two ranges, each above 0.
    pub(crate) fn within(ranges: [f64; 2]) -> Self {
        Self { random: 1, scales: ranges.map(|range| leaf(Self::scale(range))), real: PhantomData }
    }

    /// The two factors.
    pub(crate) fn scales(&self) -> [Literal; 2] {
        self.scales
    }

    /// The next number, of the first or the second range.
    pub(crate) fn next(&mut self, is_loud: bool) -> Literal {
        self.random = self.random.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
        let scale: R = portable::Portable::build(&mut || self.scales[usize::from(is_loud)]);
        leaf((R::from_u32(self.random >> 8) - R::lit(8_388_608.0)) * scale)
    }

    /// A power of two within the range.
    fn scale(range: f64) -> R {
        R::lit(libm::exp2(libm::floor(libm::log2(range)) - 23.0))
    }
}
