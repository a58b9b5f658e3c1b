//! One bit of a spindle's state flips, in each of its five states, in the histories of the golden cases: outputs stay finite and within their
//! ranges, every id is one of the list. The rest is counted: `AXGEN_EVERY_LEVEL=1` prints the table of docs/spindle.md.

use super::campaign::flips;
use super::every;
use axgen_tests::cases;
use axgen_tests::random::overwritten::flipped;
use compiler::interp::Machine;
use generator::error_ids;
use golden::case::{self, VECTOR_SAMPLES};
use portable::Literal;
use rayon::prelude::*;
use std::collections::BTreeMap;

/// Cycles after a flip.
const RUN: usize = 4_000;

/// What became of the flips of one variable: reported, harmless, neither.
type Counts = [usize; 3];

/// What is known of the cycle before which a bit flips.
struct Moment {
    cycle: usize,
    state: Vec<Literal>,
}

fn integer(value: Literal) -> i64 {
    match value {
        Literal::I32(value) => value.into(),
        Literal::U32(value) => value.into(),
        Literal::Bool(value) => value.into(),
        other => panic!("{other:?}"),
    }
}

/// The largest magnitude that the documents allow.
fn bound(path: &str, found: f64) -> bool {
    match path {
        "x_spindle" => (0.0..360_000.0).contains(&found),
        "job_position" => found.abs() <= 7e14,
        "v_spindle" | "job_speed" => found.abs() <= 1e15,
        _ => found.is_finite(),
    }
}

#[test]
fn a_flipped_bit_of_a_spindle_never_leads_beyond_the_ranges() {
    let mut table: BTreeMap<String, Counts> = BTreeMap::new();
    let mut states = [0; 5];
    for case in cases::all() {
        let program = &case.block.program;
        if !["spindle", "spindle_axis"].contains(&program.block) {
            continue;
        }
        let inputs = case::inputs(&case, VECTOR_SAMPLES).unwrap_or_else(|mistake| panic!("{mistake}"));
        let row = |cycle| {
            let mut row = Vec::new();
            inputs.read(cycle, &mut row);
            row
        };
        let inputs: Vec<Vec<Literal>> = (0..inputs.len()).map(row).collect();
        let at = |path: &str| program.outputs.iter().position(|output| output.path == path).expect("a spindle has it");
        let (control, error_id, job_number) = (at("spindle_state"), at("error_id"), at("job_number"));
        let mut machine = Machine::start(program);
        let (mut outputs, mut answers, mut moments) = (Vec::new(), Vec::new(), BTreeMap::new());
        for (cycle, given) in inputs.iter().enumerate() {
            let state = machine.state().to_vec();
            machine.step(given, &mut answers);
            let calm = integer(answers[error_id]) == 0
                && cycle > 2
                && outputs.last().is_some_and(|last: &Vec<_>| last[control] == answers[control]);
            if calm {
                moments.entry(integer(answers[control])).or_insert(Moment { cycle, state });
            }
            outputs.push(answers.clone());
        }
        for (control, moment) in &moments {
            states[usize::try_from(*control).expect("0 to 4")] += 1;
            let found: Vec<(usize, usize)> = flips(&moment.state, every())
                .par_iter()
                .map(|&(at, bit)| {
                    let mut state = moment.state.clone();
                    state[at] = flipped(state[at], bit);
                    let mut machine = Machine::start(program);
                    machine.set_state(&state);
                    let (mut answers, mut reported, mut differs) = (Vec::new(), false, false);
                    let end = inputs.len().min(moment.cycle + RUN);
                    for cycle in moment.cycle..end {
                        machine.step(&inputs[cycle], &mut answers);
                        for (variable, value) in program.outputs.iter().zip(&answers) {
                            let found = match *value {
                                Literal::F64(value) => value,
                                Literal::F32(value) => value.into(),
                                _ => continue,
                            };
                            assert!(
                                bound(&variable.path, found),
                                "{} is {found}: {}, bit {bit}",
                                variable.path,
                                program.state[at].path
                            );
                        }
                        let id = u32::try_from(integer(answers[error_id])).expect("an id");
                        assert!(
                            error_ids::all().any(|known| known.id == id) || id == 0,
                            "error_id {id}: {}, bit {bit}",
                            program.state[at].path
                        );
                        reported |= answers[error_id] != outputs[cycle][error_id];
                        let mut same = answers.iter().zip(&outputs[cycle]).enumerate();
                        differs |= !same.all(|(output, (found, expected))| output == job_number || found == expected);
                    }
                    (
                        at,
                        if reported {
                            0
                        } else if differs {
                            2
                        } else {
                            1
                        },
                    )
                })
                .collect();
            for (at, kind) in found {
                let path = &program.state[at].path;
                table.entry(path.strip_prefix("spindle.").unwrap_or(path).to_owned()).or_default()[kind] += 1;
            }
        }
    }
    for (path, [reported, harmless, silent]) in &table {
        eprintln!("| `{path}` | {reported} | {harmless} | {silent} |");
    }
    assert!(states.iter().all(|count| *count > 0), "{states:?}");
}
