//! Runs from random states with random inputs stay within what was shown. The interpreter shares nothing with the analysis.

use super::subjects;
use axgen_tests::environment::by_depth;
use axgen_tests::random::rng::Rng;
use compiler::interp::Machine;
use compiler::program::{Program, Type, Variable};
use portable::{Literal, RealKind};
use rayon::prelude::*;

/// A value of a type: now and then any bits, now and then one at an edge.
fn any(ty: Type, real: RealKind, rng: &mut Rng) -> Literal {
    let bits = rng.word();
    let low = (bits >> 32) as u32;
    let edges = [0, 1, 2, 3, 50, 1000, u32::MAX, 0x7fff_ffff, 0x8000_0000];
    let whole = if bits.is_multiple_of(2) { edges[low as usize % edges.len()] } else { low };
    match ty {
        Type::Bool => Literal::Bool(bits.is_multiple_of(2)),
        Type::I32 => Literal::I32(whole.cast_signed()),
        Type::U32 => Literal::U32(whole),
        Type::Real => {
            let value = match bits % 5 {
                0 => f64::from_bits(rng.word()),
                1 => [0.0, -0.0, f64::NAN, f64::INFINITY, f64::NEG_INFINITY, 1e15, -1e15, f64::MAX][low as usize % 8],
                _ => (f64::from(low) / f64::from(u32::MAX) - 0.5) * 10_f64.powi(i32::try_from(bits % 12).unwrap_or(0)),
            };
            match real {
                RealKind::F64 => Literal::F64(value),
                RealKind::F32 => Literal::F32(value as f32),
            }
        }
    }
}

fn filled(variables: &[Variable], program: &Program, rng: &mut Rng) -> Vec<Literal> {
    variables.iter().map(|variable| any(variable.ty, program.real, rng)).collect()
}

#[test]
fn what_runs_from_any_state_stays_within_what_was_shown() {
    let runs = by_depth(300, 2_000, 20_000);
    subjects().into_par_iter().for_each(|(name, designed, kind)| {
        let program = kind.program(&designed, Some("verified")).expect("a program");
        let shown = kind.shown(&designed).expect("a program");
        let mut rng = Rng::new(31);
        let mut machine = Machine::start(&program);
        let mut outputs = Vec::new();
        for run in 0..runs {
            machine.set_state(&filled(&program.state, &program, &mut rng));
            let mut inputs = filled(&program.inputs, &program, &mut rng);
            for _ in 0..3 {
                // Usable samples mostly, so that what lies after the tests is reached too.
                for (value, input) in inputs.iter_mut().zip(&program.inputs) {
                    if !rng.word().is_multiple_of(4) {
                        *value = input.start;
                    }
                }
                machine.step(&inputs, &mut outputs);
                for ((value, range), output) in outputs.iter().zip(&shown.outputs).zip(&program.outputs) {
                    assert!(range.holds(*value), "{name}, run {run}: {} is {value:?}, shown {range:?}", output.path);
                }
            }
        }
    });
}
