//! What others may do with a block's text: evaluate it in double precision, or look at its outputs between two statements.

use axgen_tests::cases::{in_both_real_types, title};
use axgen_tests::environment::by_depth;
use axgen_tests::random::rng::Rng;
use compiler::interp::Machine;
use generator::target::TARGETS;
use golden::case::{self, VECTOR_SAMPLES};
use golden::compare::{Difference, compare};
use golden::engine::{self, Engine, emitted};
use golden::samples::Samples;
use portable::{Literal, RealKind};
use rayon::prelude::*;
use st::Dialect;

/// Every intermediate result of a REAL block is kept in double precision, until a variable gets it.
#[test]
fn a_wider_evaluation_gives_the_same_bits() {
    let all = in_both_real_types();
    let single: Vec<_> = all.iter().filter(|case| case.axis.axis.real == RealKind::F32).collect();
    assert!(single.len() > 20, "{}", single.len());
    single.par_iter().for_each(|case| {
        let inputs = case::inputs(case, by_depth(5_000, 5_000, 200_000)).unwrap();
        let expected = engine::run(Engine::Reference, &case.axis, &case.block, &inputs).unwrap();
        for dialect in Dialect::ALL {
            // The others differ in names alone.
            let part = if dialect == Dialect::Plain { 1 } else { by_depth(10, 10, 1) };
            let (inputs, expected) = (inputs.first(inputs.len() / part), expected.first(expected.len() / part));
            let [file, _] = emitted::files(dialect, &case.axis, &case.block).unwrap();
            let wide = emitted::read(dialect, &file, &case.axis, &case.block).unwrap().wide();
            let found = emitted::run_read(dialect, &wide, &case.block, &inputs).unwrap();
            assert_eq!(compare(&expected, &found), Difference { bits: 0, first: None }, "{}: {dialect:?}", title(case));
        }
    });
}

/// A comparison with a NaN stops some runtimes, and AND evaluates both of its operands: `run_read` looks at every one.
#[test]
fn no_nan_is_compared() {
    in_both_real_types().par_iter().for_each(|case| {
        let given = case::inputs(case, by_depth(2_000, 2_000, 50_000)).unwrap();
        let (mut hostile, mut sample) = (Samples::with_capacity(given.shape.clone(), given.len()), Vec::new());
        let mut rng = Rng::new(0x6e61_6e73);
        for at in 0..given.len() {
            given.read(at, &mut sample);
            for value in &mut sample {
                match value {
                    Literal::F64(value) if rng.below(100) == 0 => *value = f64::NAN,
                    Literal::F32(value) if rng.below(100) == 0 => *value = f32::NAN,
                    _ => {}
                }
            }
            hostile.push(&sample);
        }
        for dialect in [Dialect::TwinCat, Dialect::Codesys] {
            let [file, _] = emitted::files(dialect, &case.axis, &case.block).unwrap();
            let read = emitted::read(dialect, &file, &case.axis, &case.block).unwrap();
            if let Err(failure) = emitted::run_read(dialect, &read, &case.block, &hostile) {
                panic!("{}: {dialect:?}: {failure}", title(case));
            }
        }
    });
}

/// An output is the one of the last cycle until it is written, and then the one of this cycle.
#[test]
fn an_output_never_has_a_value_between() {
    in_both_real_types().par_iter().for_each(|case| {
        let samples = case::inputs(case, VECTOR_SAMPLES).unwrap();
        for target in TARGETS {
            let program = target.program(&case.block).unwrap();
            let (mut machine, mut inputs, mut outputs) = (Machine::start(&program), Vec::new(), Vec::new());
            for sample in 0..samples.len() {
                samples.read(sample, &mut inputs);
                let mut own: Vec<Literal> = case.block.for_axis.inputs.iter().map(|input| inputs[*input]).collect();
                if program.inputs[0].path == "Enable" {
                    own.insert(0, Literal::Bool(sample % 100 < 90));
                }
                let mut written = Vec::new();
                machine.step_watched(&own, &mut outputs, &mut |output, value| written.push((output, value)));
                let place = || format!("{}: {}: sample {sample}", title(case), target.name);
                assert_eq!(written.len(), program.outputs.len(), "{}: each is written once", place());
                for (output, value) in written {
                    assert_eq!(value, outputs[output], "{}: {}", place(), program.outputs[output].path);
                }
            }
        }
    });
}
