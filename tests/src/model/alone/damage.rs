//! What becomes of parameter sets on their way: zeros, another structure, a rule that is broken with a check word that fits, damage.

use super::set::{Set, Structure};
use crate::random::rng::Rng;

/// Memory that nobody has written.
#[must_use]
pub fn zeros(of: &Structure) -> Set {
    Set { structure: 0, set_id: 0, numbers: vec![0.0; of.names.len()], of: 0 }
}

/// A set without a number.
#[must_use]
pub fn absent(whole: &Set) -> Set {
    Set { set_id: 0, ..whole.clone() }
}

/// A set that a block must not take over, or one that has become another one; its number may fit all the same.
#[must_use]
pub fn damaged(whole: &Set, other: &Set, of: &Structure, rng: &mut Rng) -> Set {
    let mut set = whole.clone();
    let any = rng.below(set.numbers.len());
    let gain = *rng.pick(of.gains());
    let (pole, values) = *rng.pick(&of.poles());
    if rng.chance(50) {
        set.set_id = number(rng);
    }
    match rng.below(16) {
        0 => return zeros(of),
        1 => return absent(whole),
        2 => set.structure ^= 1 << rng.below(32),
        3 => {
            let limit = rounded(of.limit * (1.0 + 1e-6), of);
            (set.numbers[0], set.numbers[1]) = (limit, -limit);
        }
        4 => set.numbers[1] = rounded(set.numbers[1] * 0.5, of),
        5 if set.numbers[0] == 0.0 => set.numbers[2] = -1.0,
        5 => set.numbers[2] = rounded(set.numbers[0] * (1.0 - 1e-6), of),
        6 => set.numbers[any] = *rng.pick(&[f64::NAN, f64::INFINITY, f64::NEG_INFINITY, 1e11, -1e11]),
        7 => set.numbers[gain] = *rng.pick(&[-7.001, 7.001]),
        8 => set.numbers[pole] = *rng.pick(values),
        9 => (set.numbers[0], set.numbers[1]) = (set.numbers[1], set.numbers[0]),
        10 => set.numbers[of.limits() - 1] = rounded(of.limit * 1.01, of),
        // Not sealed from here on.
        11 => {
            set.numbers[any] = flipped(set.numbers[any], of, rng);
            return set;
        }
        12 => {
            set.numbers[any] = other.numbers[any];
            return set;
        }
        13 => {
            let torn = rng.below(set.numbers.len());
            set.numbers[torn..].copy_from_slice(&other.numbers[torn..]);
            return set;
        }
        14 => {
            set.set_id ^= 1 << rng.below(32);
            return set;
        }
        // Below what the word covers.
        _ => set.numbers[gain] = if of.single { 1e-30 } else { 1e-40 },
    }
    set.sealed(of)
}

/// A number that is not 0.
#[must_use]
pub fn number(rng: &mut Rng) -> u32 {
    u32::try_from(rng.word() >> 32).expect("32 bits").max(1)
}

/// In the real type of the block.
#[expect(clippy::cast_possible_truncation, reason = "a number of the block's real type")]
fn rounded(real: f64, of: &Structure) -> f64 {
    if of.single { f64::from(real as f32) } else { real }
}

/// One bit of it.
#[expect(clippy::cast_possible_truncation, reason = "a number of the block's real type")]
fn flipped(real: f64, of: &Structure, rng: &mut Rng) -> f64 {
    if of.single {
        f64::from(f32::from_bits((real as f32).to_bits() ^ 1 << rng.below(32)))
    } else {
        f64::from_bits(real.to_bits() ^ 1 << rng.below(64))
    }
}
