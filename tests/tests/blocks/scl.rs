//! SCL in which one zero has the other sign: the engine `scl` sees it in an output. That the emitted text is right is for the
//! golden cases.

use axgen_tests::cases::{all, title};
use compiler::print::signals;
use compiler::print::st::SCL;
use generator::target::File;
use golden::case::{self, Case, VECTOR_SAMPLES};
use golden::engine::{self, Engine, emitted};
use golden::samples::Samples;
use portable::Literal;
use rayon::prelude::*;
use st::Dialect;
use std::collections::BTreeSet;

/// What a text of a case's block answers.
fn answers(case: &Case, text: &str, inputs: &Samples) -> Samples {
    let file = File { name: "scl".to_owned(), text: text.to_owned() };
    let read = emitted::read(Dialect::Scl, &file, &case.axis, &case.block);
    let answers = read.and_then(|read| emitted::run_read(Dialect::Scl, &read, &case.block, inputs));
    answers.unwrap_or_else(|failure| panic!("{}: {failure}", title(case)))
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

/// Lines that only an overwritten position reaches: no inputs do. `flipped_bits` judges them.
const OVERWRITTEN_ALONE: [&str; 2] = ["axis:         #x_drive := 0.0;", "position_control:         #x_drive := 0.0;"];

#[test]
fn a_zero_of_the_other_sign_is_seen_in_the_outputs() {
    let (planted, seen): (BTreeSet<String>, BTreeSet<String>) = all()
        .par_iter()
        .map(|case| {
            let mut inputs = case::inputs(case, VECTOR_SAMPLES).unwrap_or_else(|mistake| panic!("{mistake}"));
            // No case of a spindle fades out in OFF: each ends so here.
            if let Some(mode) = inputs.shape.place("mode") {
                let mut values = Vec::new();
                inputs.read(inputs.len() - 1, &mut values);
                values[mode] = Literal::I32(0);
                (0..3).for_each(|_| inputs.push(&values));
            }
            case.block.trial_inputs().iter().for_each(|sample| inputs.push(sample));
            let expected = engine::run(Engine::Reference, &case.axis, &case.block, &inputs)
                .unwrap_or_else(|failure| panic!("{}: {failure}", title(case)));
            let [file, _] = emitted::files(Dialect::Scl, &case.axis, &case.block).unwrap();
            let text = file.text;
            assert!(answers(case, &text, &inputs) == expected, "{}", title(case));
            let [_, outputs] = signals(&case.block.for_axis.program, &SCL);
            let (mut planted, mut seen) = (BTreeSet::new(), BTreeSet::new());
            for (at, line) in zeros(&text, &outputs) {
                let mut changed = text.clone();
                changed.replace_range(at..at + line.len(), &line.replace("0.0", "-1.0 * 0.0"));
                let place = format!("{}: {}", case.block.program.block, line.trim_end());
                if answers(case, &changed, &inputs) != expected {
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
    assert_eq!(planted.difference(&seen).collect::<Vec<_>>(), OVERWRITTEN_ALONE, "no case sees it");
}
