//! SCL in which one zero has the other sign: the engine `scl` sees it in an output. That the emitted text is right is for the
//! golden cases.

use axgen_tests::cases::{all, title};
use compiler::print::signals;
use compiler::print::st::SCL;
use generator::generate::header;
use generator::target::{block_name, named};
use golden::case::{self, Case, VECTOR_SAMPLES};
use golden::engine::{self, Engine};
use golden::samples::{Samples, Shape};
use rayon::prelude::*;
use st::{Block, Dialect, Signal};
use std::collections::BTreeSet;

/// What a text of a case's block answers.
fn answers(case: &Case, text: &str, inputs: &Samples, outputs: &Shape) -> Samples {
    let program = &case.block.program;
    let name = format!("FB_{}", block_name(&case.axis.axis.name, program.block));
    let block = Block::read(Dialect::Scl, text, &name, program.real).unwrap_or_else(|mistakes| panic!("{mistakes:?}"));
    let names = signals(program, &SCL);
    let [inputs_of, outputs_of] = [(&inputs.shape, &names[0]), (outputs, &names[1])].map(|(shape, names)| {
        let signals = shape.signals.iter().zip(names).map(|(signal, name)| (name.as_str(), signal.start));
        signals.collect::<Vec<Signal<'_>>>()
    });
    let mut instance = block.start(&inputs_of, &outputs_of, &[]).unwrap_or_else(|mistakes| panic!("{mistakes:?}"));
    let mut answers = Samples::with_capacity(outputs.clone(), inputs.len());
    let (mut values, mut results) = (Vec::new(), Vec::new());
    for sample in 0..inputs.len() {
        inputs.read(sample, &mut values);
        instance.cycle(&values, &mut results);
        answers.push(&results);
    }
    answers
}

/// The lines of a text that assign a zero to an output.
fn zeros<'t>(text: &'t str, outputs: &[String]) -> Vec<(usize, &'t str)> {
    let is_zero = |line: &&str| {
        let assigned = line.trim().strip_prefix('#').and_then(|line| line.split_once(" := "));
        assigned.is_some_and(|(name, value)| outputs.iter().any(|known| known == name) && value == "0.0;")
    };
    let mut at = 0;
    let mut lines = Vec::new();
    for line in text.split_inclusive('\n') {
        if is_zero(&line) {
            lines.push((at, line));
        }
        at += line.len();
    }
    lines
}

#[test]
fn a_zero_of_the_other_sign_is_seen_in_the_outputs() {
    let (planted, seen): (BTreeSet<String>, BTreeSet<String>) = all()
        .par_iter()
        .map(|case| {
            let inputs = case::inputs(case, VECTOR_SAMPLES).unwrap_or_else(|mistake| panic!("{mistake}"));
            let expected = engine::run(Engine::Reference, &case.axis, &case.block, &inputs)
                .unwrap_or_else(|failure| panic!("{}: {failure}", title(case)));
            let scl = named("scl").unwrap();
            let text = scl.files(&header(&case.axis.axis), std::slice::from_ref(&case.block)).unwrap().remove(0).text;
            assert!(answers(case, &text, &inputs, &expected.shape) == expected, "{}", title(case));
            let [_, outputs] = signals(&case.block.program, &SCL);
            let (mut planted, mut seen) = (BTreeSet::new(), BTreeSet::new());
            for (at, line) in zeros(&text, &outputs) {
                let mut changed = text.clone();
                changed.replace_range(at..at + line.len(), &line.replace("0.0", "-0.0"));
                let place = format!("{}: {}", case.block.program.block, line.trim_end());
                if answers(case, &changed, &inputs, &expected.shape) != expected {
                    seen.insert(place.clone());
                }
                planted.insert(place);
            }
            (planted, seen)
        })
        .reduce(Default::default, |(mut planted, mut seen), (more, others)| {
            planted.extend(more);
            seen.extend(others);
            (planted, seen)
        });
    assert!(planted.len() > 8, "{planted:?}");
    assert_eq!(planted.difference(&seen).collect::<Vec<_>>(), [""; 0], "no case sees it");
}
