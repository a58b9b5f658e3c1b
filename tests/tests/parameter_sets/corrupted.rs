//! Parameter sets that were changed on their way: none of them is taken over.

use axgen_tests::random::overwritten::flipped;
use axgen_tests::random::rng::Rng;
use portable::{Literal, RealKind};

/// A set, part by part.
pub type Set = Vec<(usize, Literal)>;

/// Integers before the numbers: structure and id.
const WORDS: usize = 2;

/// What became of a set: another one each time it is asked for. `others` are sets of the same structure, `foreign` is one of another.
pub fn corrupted(set: &Set, others: &[Set], foreign: &Set, rng: &mut Rng) -> Set {
    let mut changed = set.clone();
    match rng.below(7) {
        0 | 1 => flip(&mut changed, rng),
        2 => {
            flip(&mut changed, rng);
            flip(&mut changed, rng);
        }
        3 => {
            let at = rng.below(changed.len());
            let any = [f64::NAN, f64::INFINITY, f64::NEG_INFINITY, 0.0, 1.0, -1.0, 1e30];
            let value = any[rng.below(any.len())];
            changed[at].1 = match changed[at].1 {
                Literal::F64(_) => Literal::F64(value),
                Literal::F32(_) => Literal::F32(value as f32),
                Literal::I32(_) => Literal::I32(rng.below(1 << 30) as i32),
                _ => Literal::U32(rng.below(1 << 30) as u32),
            };
        }
        4 => {
            // Torn: the first parts are of one set, the others of another.
            let other = &others[rng.below(others.len())];
            let cut = rng.below(changed.len());
            changed[cut..].clone_from_slice(&other[cut..]);
        }
        5 => {
            let other = &others[rng.below(others.len())];
            for (part, from) in changed.iter_mut().zip(other) {
                if rng.below(2) == 0 {
                    *part = *from;
                }
            }
        }
        _ => {
            // Another structure's parts, as many as fit; or two parts that have changed places.
            if rng.below(2) == 0 {
                for (part, from) in changed.iter_mut().zip(foreign) {
                    if std::mem::discriminant(&part.1) == std::mem::discriminant(&from.1) {
                        part.1 = from.1;
                    }
                }
            } else {
                let [one, two] = [(); 2].map(|()| WORDS + rng.below(changed.len() - WORDS));
                (changed[one].1, changed[two].1) = (changed[two].1, changed[one].1);
            }
        }
    }
    changed
}

fn flip(set: &mut Set, rng: &mut Rng) {
    let at = rng.below(set.len());
    set[at].1 = flipped(set[at].1, rng.below(64));
}

/// Whether two sets are the same numbers: 0 and -0 are.
pub fn are_same(one: &Set, two: &Set) -> bool {
    one.iter().zip(two).all(|((_, one), (_, two))| match (one, two) {
        (Literal::F64(one), Literal::F64(two)) => one == two,
        (Literal::F32(one), Literal::F32(two)) => one == two,
        (one, two) => one == two,
    })
}

/// The real type of a set's numbers.
pub fn real(value: f64, kind: RealKind) -> Literal {
    match kind {
        RealKind::F64 => Literal::F64(value),
        RealKind::F32 => Literal::F32(value as f32),
    }
}
