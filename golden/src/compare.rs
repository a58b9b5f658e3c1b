//! Compares two runs bit by bit, without any tolerance.

use crate::samples::Samples;
use portable::Literal;

/// The difference between two runs.
#[derive(Clone, Debug, PartialEq)]
pub struct Difference {
    /// differing bits in all samples
    pub bits: u64,
    /// place of the first difference; `None` if there is no difference
    pub first: Option<FirstDifference>,
}

#[derive(Clone, Debug, PartialEq)]
pub struct FirstDifference {
    /// the sample, counted from 0
    pub sample: usize,
    pub signal: String,
    /// its value in the correct run
    pub expected: Literal,
    /// its value in the other run
    pub found: Literal,
}

/// Compares a run with the correct one. A sample that is missing in one of them counts with all its bits.
///
/// # Panics
/// If the runs have different signals.
#[must_use]
pub fn compare(expected: &Samples, found: &Samples) -> Difference {
    assert_eq!(expected.shape, found.shape, "compare: the runs are of different signals");
    if expected.bytes == found.bytes {
        return Difference { bits: 0, first: None };
    }
    let common = expected.bytes.len().min(found.bytes.len());
    let pairs = expected.bytes.iter().zip(&found.bytes);
    let bits: u64 = pairs.map(|(a, b)| u64::from((a ^ b).count_ones())).sum();
    let missing = expected.bytes.len().max(found.bytes.len()) - common;
    let bits = bits + 8 * missing as u64;
    let at = (0..common).find(|at| expected.bytes[*at] != found.bytes[*at]);
    Difference { bits, first: at.map(|at| place(expected, found, at)) }
}

fn place(expected: &Samples, found: &Samples, at: usize) -> FirstDifference {
    let frame = expected.shape.frame();
    let (sample, mut offset) = (at / frame, at % frame);
    let mut index = 0;
    for signal in &expected.shape.signals {
        let size = expected.shape.size(signal.ty);
        if offset < size {
            break;
        }
        offset -= size;
        index += 1;
    }
    let (mut a, mut b) = (Vec::new(), Vec::new());
    expected.read(sample, &mut a);
    found.read(sample, &mut b);
    FirstDifference { sample, signal: expected.shape.signals[index].name.clone(), expected: a[index], found: b[index] }
}
