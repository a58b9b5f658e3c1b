//! The inputs that a program runs on: ordinary numbers first, then those at the edges of arithmetic, then no numbers.

use super::rng::Rng;
use super::subject::{Instance, scalars};
use portable::{Literal, Real, RealKind, Ty, Variant};

/// Samples of a run, which begins anew after each.
pub const SAMPLES: usize = 16;
/// Runs of a program: two with ordinary numbers, one with those at the edges, one with NaN and infinities too.
pub const RUNS: usize = 4;

/// The inputs of all runs of a program. They depend on its name, not on its place among others.
#[must_use]
pub fn runs(instance: &Instance) -> Vec<Vec<Vec<Literal>>> {
    let seed = instance.name.bytes().fold(17, |seed: u64, byte| seed.wrapping_mul(257).wrapping_add(u64::from(byte)));
    let mut rng = Rng::new(seed);
    (0..RUNS).map(|run| (0..SAMPLES).map(|_| sample(instance.inputs, run, &mut rng)).collect()).collect()
}

fn sample(ty: Ty, run: usize, rng: &mut Rng) -> Vec<Literal> {
    let mut values = Vec::new();
    scalars(ty, &mut |scalar| values.push(value(scalar, run, rng)));
    values
}

fn value(ty: Ty, run: usize, rng: &mut Rng) -> Literal {
    let edge = run >= 2 && rng.chance(40);
    match ty {
        Ty::Bool => Literal::Bool(rng.chance(50)),
        Ty::I32 if edge => Literal::I32(*rng.pick(&[i32::MIN, i32::MAX, -1, 65_535, 0x4000_0000])),
        Ty::I32 => Literal::I32(*rng.pick(&[0, 1, -1, 2, 3, 7, -100])),
        Ty::U32 if edge => Literal::U32(*rng.pick(&[u32::MAX, 0x8000_0000, 0x0100_0001, 65_536])),
        Ty::U32 => Literal::U32(*rng.pick(&[0, 1, 2, 3, 5, 1_000])),
        Ty::Enum { def: of } => {
            let index = u32::try_from(rng.below(of.variants.len())).unwrap_or_default();
            Literal::Variant(Variant { of, index })
        }
        Ty::Real(RealKind::F64) => Literal::F64(if edge { edge_of_f64(run, rng) } else { ordinary(rng) }),
        Ty::Real(RealKind::F32) => {
            Literal::F32(if edge { edge_of_f32(run, rng) } else { <f32 as Real>::lit(ordinary(rng)) })
        }
        Ty::Usize | Ty::Array { .. } | Ty::Struct { .. } => unreachable!("stimulus: no scalar of an input"),
    }
}

/// A number of ordinary size; one in four with few digits, so that operands are sometimes equal.
#[expect(clippy::cast_precision_loss, reason = "53 bits")]
fn ordinary(rng: &mut Rng) -> f64 {
    if rng.chance(25) {
        return *rng.pick(&[0.0, 1.0, -1.0, 0.5, 2.0, -3.0]);
    }
    (rng.word() >> 11) as f64 / (1u64 << 53) as f64 * 20.0 - 10.0
}

fn edge_of_f64(run: usize, rng: &mut Rng) -> f64 {
    if run == 3 && rng.chance(50) {
        return *rng.pick(&[f64::NAN, f64::INFINITY, f64::NEG_INFINITY]);
    }
    let subnormal = f64::from_bits(rng.word() >> 13);
    *rng.pick(&[-0.0, 0.0, subnormal, -subnormal, f64::MIN_POSITIVE, f64::MAX, f64::MIN, 1.0e200, f64::EPSILON])
}

fn edge_of_f32(run: usize, rng: &mut Rng) -> f32 {
    if run == 3 && rng.chance(50) {
        return *rng.pick(&[f32::NAN, f32::INFINITY, f32::NEG_INFINITY]);
    }
    let subnormal = f32::from_bits((rng.word() >> 42) as u32);
    *rng.pick(&[-0.0, 0.0, subnormal, -subnormal, f32::MIN_POSITIVE, f32::MAX, f32::MIN, 1.0e30, f32::EPSILON])
}
