//! A weight that is tuned while the axis moves, on the demonstration plant: raised from 0 to its design in 20 steps, no step shows in the spectrum beyond
//! what the weight itself causes. A weight that jumps does.

#![expect(clippy::unwrap_used, reason = "a test that cannot go on fails")]
#![expect(clippy::float_cmp, reason = "numbers that were written, and 0, are exact")]
#![expect(clippy::print_stdout, reason = "the documents show these figures")]

use axgen_tests::subject::Subject;
use machine::closed_loop::{self, Position, Record};
use machine::measure::{dwells, spectrum};
use machine::plant::DEMONSTRATION;
use machine::sequence::Sequence;
use std::ops::Range;
use std::path::Path;

/// Steps from 0 to the design.
const STEPS: usize = 20;
/// Cycles from one step to the next; the fade of the example takes 100.
const BETWEEN: usize = 250;
const FADE: usize = 100;
/// The first step, in a cycle of the move in which the axis has its speed for long.
const FIRST: usize = 1500;
/// Cycles in which the steps are made.
const WINDOW: Range<usize> = FIRST..FIRST + BETWEEN * STEPS;

/// Far above both stages [Hz].
const ABOVE: [f64; 2] = [200.0, 480.0];

/// Who brings the weight from step to step.
#[derive(Clone, Copy, PartialEq)]
enum Way {
    /// the input of the block, which is written in steps
    Input,
    /// a factor after the block, along straight lines that last as long as the fade: what the weight itself causes
    Lines,
    /// a factor after the block, in steps
    Jumps,
}

/// The part of the weight in a cycle of the move, and how far it is on the way to the next step.
fn part(cycle: usize, way: Way) -> f64 {
    let begun = if cycle < FIRST { 0 } else { (1 + (cycle - FIRST) / BETWEEN).min(STEPS) };
    let since = if begun == 0 { 0 } else { cycle - FIRST - (begun - 1) * BETWEEN };
    // In the cycle of a step the block moves for the first time; a step of 1/20 of the weight takes 1/20 of the fade.
    let on_the_way = ((since + 1) as f64 / (FADE as f64 / STEPS as f64)).min(1.0);
    let done = if way == Way::Lines && begun > 0 { (begun - 1) as f64 + on_the_way } else { begun as f64 };
    done / STEPS as f64
}

/// A long move at constant speed; the weight of one stage is raised, the other stage has none.
fn run(stage: usize, way: Way) -> Record {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../examples/rack-and-pinion.toml");
    let mut subject = Subject::of(&path, None);
    subject.set("mode", 1.0);
    (0..2).for_each(|i| subject.set(&format!("tuning_weight[{i}]"), 0.0));
    let sequence = Sequence { rest_before: 0.5, dwell: 6.0, ..Sequence::DEMONSTRATION };
    let mut cycle = 0;
    let record = closed_loop::run(DEMONSTRATION.at_rest(), &Position::DEMONSTRATION, &sequence, |signals| {
        let part = part(cycle, way);
        cycle += 1;
        subject.set(&format!("tuning_weight[{stage}]"), if way == Way::Input { part } else { 1.0 });
        let v_add = subject.step(signals);
        assert_eq!(subject.get("error_id"), 0.0);
        if way == Way::Input { v_add } else { v_add * part }
    });
    let at_speed = dwells(&record).next().unwrap();
    assert!(at_speed.start <= WINDOW.start && WINDOW.end <= at_speed.end, "the steps are made at constant speed");
    record
}

/// The spectrum of v_add while the steps are made [um/s].
fn above(record: &Record) -> Vec<f64> {
    let lines = spectrum(&record.v_add[WINDOW], record.cycle, ABOVE);
    lines.into_iter().map(|[_, amplitude]| amplitude).collect()
}

#[test]
fn no_step_shows_beyond_what_the_weight_causes() {
    for stage in [0, 1] {
        let [input, lines, jumps] = [Way::Input, Way::Lines, Way::Jumps].map(|way| above(&run(stage, way)));
        let largest = |lines: &[f64]| lines.iter().copied().fold(0.0, f64::max);
        let differs = input.iter().zip(&lines).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
        println!(
            "stage {stage}, above {} Hz [um/s]: by the input {:.3e}, along lines {:.3e} (largest difference {differs:.1e}), by jumps {:.3e}",
            ABOVE[0],
            largest(&input),
            largest(&lines),
            largest(&jumps)
        );
        // Each line of the spectrum, but for roundings.
        assert!(differs < 1e-6 * largest(&lines), "stage {stage}: {differs:e}");
        assert!(largest(&jumps) > 1.5 * largest(&lines), "stage {stage}: a jump would not be seen here");
    }
}
