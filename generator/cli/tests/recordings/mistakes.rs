//! Each of the commonest mistakes, planted in a good recording, is named.

use super::{Recording, SET, axgen, compare, folder, good};
use std::{fs, ops::Range, path::Path};

/// The lines that name what explains a difference.
fn explained(folder: &Path, recording: &Recording) -> String {
    let run = compare(folder, recording.csv(), &[]);
    assert_eq!(run.code, 1, "{}{}", run.out, run.err);
    let is_verdict =
        |line: &&str| ["explained: ", "or: ", "not explained "].iter().any(|start| line.starts_with(start));
    run.out.lines().filter(is_verdict).map(|line| line.to_owned() + "\n").collect()
}

const EVERY_BIT: &str = "with that undone every bit agrees\n";
const DIGITS: &str = "with that undone every sample agrees within its digits\n";
const LATER: &str = " on every sample agrees\n";
const INPUTS: [&str; 2] = ["v_command", "v_motor"];
const OUTPUTS: [&str; 2] = ["v_add", "v_add_calculated"];

/// The same recording with one column changed in every row.
fn with(recording: &Recording, column: &str, change: impl Fn(f64) -> f64) -> Recording {
    let (mut changed, at) = (recording.clone(), recording.at(column));
    changed.rows.iter_mut().for_each(|row| row[at] = change(row[at]));
    changed
}

/// The samples that are enough to find a mistake: each explanation is a run of the block.
fn beginning(mut recording: Recording) -> Recording {
    recording.rows.truncate(1500);
    recording
}

#[test]
fn a_good_recording_needs_no_explanation() {
    let folder = folder();
    let run = compare(folder.path(), good().csv(), &[]);
    assert_eq!(run.code, 0, "{}{}", run.out, run.err);
    assert!(run.out.contains(": 0 differing bits\n") && !run.out.contains("explained"), "{}", run.out);
}

/// The recording with two columns exchanged.
fn swapped(recording: &Recording, [a, b]: [usize; 2]) -> Recording {
    let mut changed = recording.clone();
    changed.names.swap(a, b);
    changed
}

/// The recording without some of its samples.
fn without(recording: &Recording, samples: Range<usize>) -> Recording {
    let mut changed = recording.clone();
    changed.rows.drain(samples);
    changed
}

/// A column as it was a number of cycles before.
fn late(recording: &Recording, columns: &[&str], cycles: usize) -> Recording {
    let mut changed = recording.clone();
    for at in columns.iter().map(|column| recording.at(column)) {
        for row in 0..recording.rows.len() {
            changed.rows[row][at] = recording.rows[row.saturating_sub(cycles)][at];
        }
    }
    changed
}

/// Mistakes of the recording itself, and what is said of each: how it begins, and ends.
#[test]
fn mistakes_of_a_recording() {
    let good = &beginning(good());
    let both = with(&with(good, "v_motor", |v| -v), "v_command", |v| -v);
    let mut thrice = good.clone();
    thrice.rows = good.rows.iter().flat_map(|row| [row.clone(), row.clone(), row.clone()]).skip(1).collect();
    let every = "every cycle was recorded 3 times: another sampling than the block's cycle; ";
    let middle = "the recording starts in the middle, the block was not at rest at its first sample; from sample ";
    for (recording, begins, ends) in [
        (with(good, "v_motor", |v| -v), "the recording has v_motor with the other sign; ", EVERY_BIT),
        (with(good, "v_add", |v| -v), "the recording has v_add with the other sign; ", EVERY_BIT),
        (both, "the recording has v_command, v_motor with the other sign; ", EVERY_BIT),
        (with(good, "v_motor", |v| v / 1000.0), "the recording has v_motor divided by 1000; ", DIGITS),
        (with(good, "v_add", |v| v * 1000.0), "the recording has v_add times 1000; ", DIGITS),
        (with(good, "v_command", |v| v * 60.0), "the recording has v_command times 60; ", DIGITS),
        (swapped(good, [0, 1]), "the columns v_command and v_motor are swapped; ", EVERY_BIT),
        (swapped(good, [1, 2]), "the columns v_motor and v_add are swapped; ", EVERY_BIT),
        (late(good, &OUTPUTS, 1), "the outputs were recorded 1 cycle late against the inputs; ", "\n"),
        (late(good, &INPUTS, 3), "the outputs were recorded 3 cycles early against the inputs; ", "\n"),
        (late(good, &["v_motor"], 2), "v_motor was recorded 2 cycles late against the other columns; ", "\n"),
        (without(good, 200..203), "about 3 samples are lost before sample 200 (line 202); from sample ", LATER),
        (without(good, 0..150), middle, "\n"),
        (thrice, every, EVERY_BIT),
    ]
    .into_iter()
    .step_by(if crate::is_exhaustive() { 1 } else { 3 })
    {
        let said = explained(folder().path(), &recording);
        assert!(said.starts_with(&format!("explained: {begins}")) && said.ends_with(ends), "{begins}: {said}");
        assert!(ends.len() < 25 || said.len() == "explained: ".len() + begins.len() + ends.len(), "{said}");
    }
}

/// What another set, or another axis, makes of the same inputs.
fn of_another(folder: &Path, from: &str, to: &str, axis: &str) -> Recording {
    assert!(SET.contains(from));
    fs::write(folder.join("other.toml"), SET.replace(from, to)).unwrap();
    let recording = Recording::of(folder, "other.toml", axis, None);
    beginning(recording.only(&["v_command", "v_motor", "v_add", "v_add_calculated"]))
}

/// The block on the machine is another one than that of the set.
#[test]
fn another_block() {
    for (from, to, axis, expected) in [
        ("1ms", "2ms", "X", "the block was generated for a cycle time of 2 ms, the set says 1 ms"),
        (
            "[axis.X]",
            "[axis.X]\nreal = \"f32\"",
            "X",
            "the block computes in REAL (real = \"f32\"), that of the set in LREAL",
        ),
        ("1ms", "1ms", "Y", "it is the block of the axis Y"),
        ("\"SET_POINT\"", "\"NOT_ACTIVE\"", "X", "the block has other parameters: stage[1] is not active in it"),
    ] {
        let folder = folder();
        let said = explained(folder.path(), &of_another(folder.path(), from, to, axis));
        assert_eq!(said, format!("explained: {expected}; {EVERY_BIT}"));
    }
    let folder = folder();
    let said = explained(folder.path(), &of_another(folder.path(), "fg_f0 = 53.0", "fg_f0 = 54.0", "X"));
    assert!(said.starts_with("not explained by any of "), "{said}");
    assert!(said.contains("the block on the machine probably has other parameters"), "{said}");
}

#[test]
fn an_input_without_a_column() {
    let folder = folder();
    let without = good().only(&["v_motor", "v_add", "v_add_calculated"]);
    let said = explained(folder.path(), &without);
    assert!(said.starts_with("not explained by any of "), "{said}");
    // v_command was the same as v_motor.
    let text = good().only(&["v_motor"]).csv().replace("v_motor", "v_command,v_motor");
    let text: Vec<String> = text.lines().map(|line| line.to_owned()).collect();
    let doubled = text[1..].iter().map(|value| format!("{value},{value}\n")).collect::<String>();
    fs::write(folder.path().join("inputs.csv"), format!("{}\n{doubled}", text[0])).unwrap();
    let run = axgen(folder.path(), &["run", "axes.toml", "--axis", "X", "--stimulus", "inputs.csv"]);
    let rows = run.out.lines().zip(&text).map(|(outputs, motor)| {
        let motor = motor.rsplit(',').next().unwrap();
        format!("{motor},{}\n", outputs.split(',').next().unwrap())
    });
    let run = compare(folder.path(), rows.collect::<String>(), &[]);
    assert_eq!(run.code, 1, "{}{}", run.out, run.err);
    let expected = "explained: v_command, which has no column, was the same as v_motor";
    assert!(run.out.contains(&format!("{expected}; {EVERY_BIT}")), "{}", run.out);
}

/// A scope writes few digits: the same mistakes are found within them.
#[test]
fn with_the_digits_of_a_scope() {
    let folder = folder();
    let recording = Recording::of(folder.path(), "axes.toml", "X", Some(3));
    let recording = recording.only(&["v_command", "v_motor", "v_add"]);
    let run = compare(folder.path(), recording.csv(), &[]);
    assert_eq!(run.code, 0, "{}{}", run.out, run.err);
    let said = explained(folder.path(), &with(&recording, "v_motor", |v| -v));
    assert_eq!(said, format!("explained: the recording has v_motor with the other sign; {DIGITS}"));
    let mut middle = recording.clone();
    middle.rows.drain(..150);
    assert!(explained(folder.path(), &middle).contains("the recording starts in the middle"));
}
