//! Each of the commonest mistakes, planted in a good recording, is named.

use super::{Recording, SET, axgen, compare, folder, good};
use std::fs;
use std::path::Path;

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

/// The same recording with one column changed in every row.
fn with(recording: &Recording, column: &str, change: impl Fn(f64) -> f64) -> Recording {
    let (mut changed, at) = (recording.clone(), recording.at(column));
    changed.rows.iter_mut().for_each(|row| row[at] = change(row[at]));
    changed
}

#[test]
fn a_good_recording_needs_no_explanation() {
    let folder = folder();
    let run = compare(folder.path(), good(folder.path()).csv(), &[]);
    assert_eq!(run.code, 0, "{}{}", run.out, run.err);
    assert!(run.out.contains(": 0 differing bits\n") && !run.out.contains("explained"), "{}", run.out);
}

#[test]
fn a_sign() {
    let folder = folder();
    let good = good(folder.path());
    let said = explained(folder.path(), &with(&good, "v_motor", |v| -v));
    assert_eq!(said, format!("explained: the recording has v_motor with the other sign; {EVERY_BIT}"));
    let said = explained(folder.path(), &with(&good, "v_add", |v| -v));
    assert_eq!(said, format!("explained: the recording has v_add with the other sign; {EVERY_BIT}"));
    let both = with(&with(&good, "v_motor", |v| -v), "v_command", |v| -v);
    let said = explained(folder.path(), &both);
    assert_eq!(said, format!("explained: the recording has v_command, v_motor with the other sign; {EVERY_BIT}"));
}

#[test]
fn a_factor() {
    let folder = folder();
    let good = good(folder.path());
    let said = explained(folder.path(), &with(&good, "v_motor", |v| v / 1000.0));
    assert_eq!(said, format!("explained: the recording has v_motor divided by 1000; {DIGITS}"));
    let said = explained(folder.path(), &with(&good, "v_add", |v| v * 1000.0));
    assert_eq!(said, format!("explained: the recording has v_add times 1000; {DIGITS}"));
    let said = explained(folder.path(), &with(&good, "v_command", |v| v * 60.0));
    assert_eq!(said, format!("explained: the recording has v_command times 60; {DIGITS}"));
}

#[test]
fn two_columns_swapped() {
    let folder = folder();
    let mut recording = good(folder.path());
    recording.names.swap(0, 1);
    let said = explained(folder.path(), &recording);
    assert_eq!(said, format!("explained: the columns v_command and v_motor are swapped; {EVERY_BIT}"));
    let mut recording = good(folder.path());
    recording.names.swap(1, 2);
    let said = explained(folder.path(), &recording);
    assert_eq!(said, format!("explained: the columns v_motor and v_add are swapped; {EVERY_BIT}"));
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

#[test]
fn cycles_late() {
    let folder = folder();
    let good = good(folder.path());
    let said = explained(folder.path(), &late(&good, &["v_add", "v_add_calculated"], 1));
    assert!(said.starts_with("explained: the outputs were recorded 1 cycle late against the inputs; "), "{said}");
    let said = explained(folder.path(), &late(&good, &["v_command", "v_motor"], 3));
    assert!(said.starts_with("explained: the outputs were recorded 3 cycles early against the inputs; "), "{said}");
    let said = explained(folder.path(), &late(&good, &["v_motor"], 2));
    assert!(said.starts_with("explained: v_motor was recorded 2 cycles late against the other columns; "), "{said}");
}

#[test]
fn samples_lost() {
    let folder = folder();
    let mut recording = good(folder.path());
    recording.rows.drain(200..203);
    let said = explained(folder.path(), &recording);
    assert!(
        said.starts_with("explained: about 3 samples are lost before sample 200 (line 202); from sample "),
        "{said}"
    );
    assert!(said.ends_with(" on every sample agrees\n"), "{said}");
}

#[test]
fn started_in_the_middle() {
    let folder = folder();
    let mut recording = good(folder.path());
    recording.rows.drain(..150);
    let said = explained(folder.path(), &recording);
    let start =
        "explained: the recording starts in the middle, the block was not at rest at its first sample; from sample ";
    assert!(said.starts_with(start), "{said}");
}

#[test]
fn another_sampling() {
    let folder = folder();
    let mut recording = good(folder.path());
    recording.rows = recording.rows.iter().flat_map(|row| [row.clone(), row.clone(), row.clone()]).skip(1).collect();
    let said = explained(folder.path(), &recording);
    let expected = "explained: every cycle was recorded 3 times: another sampling than the block's cycle";
    assert_eq!(said, format!("{expected}; {EVERY_BIT}"));
}

/// What another set, or another axis, makes of the same inputs.
fn of_another(folder: &Path, from: &str, to: &str, axis: &str) -> Recording {
    assert!(SET.contains(from));
    fs::write(folder.join("other.toml"), SET.replace(from, to)).unwrap();
    Recording::of(folder, "other.toml", axis, None).only(&["v_command", "v_motor", "v_add", "v_add_calculated"])
}

#[test]
fn another_cycle_time() {
    let folder = folder();
    let said = explained(folder.path(), &of_another(folder.path(), "1ms", "2ms", "X"));
    let expected = "explained: the block was generated for a cycle time of 2 ms, the set says 1 ms";
    assert_eq!(said, format!("{expected}; {EVERY_BIT}"));
}

#[test]
fn another_real_type() {
    let folder = folder();
    let said = explained(folder.path(), &of_another(folder.path(), "[axis.X]", "[axis.X]\nreal = \"f32\"", "X"));
    let expected = "explained: the block computes in REAL (real = \"f32\"), that of the set in LREAL";
    assert_eq!(said, format!("{expected}; {EVERY_BIT}"));
}

#[test]
fn another_axis() {
    let folder = folder();
    let said = explained(folder.path(), &of_another(folder.path(), "1ms", "1ms", "Y"));
    assert_eq!(said, format!("explained: it is the block of the axis Y; {EVERY_BIT}"));
}

#[test]
fn other_parameters() {
    let folder = folder();
    let said =
        explained(folder.path(), &of_another(folder.path(), "mode = \"SET_POINT\"", "mode = \"NOT_ACTIVE\"", "X"));
    let expected = "explained: the block has other parameters: stage[1] is not active in it";
    assert_eq!(said, format!("{expected}; {EVERY_BIT}"));
    let said = explained(folder.path(), &of_another(folder.path(), "fg_f0 = 53.0", "fg_f0 = 54.0", "X"));
    assert!(said.starts_with("not explained by any of "), "{said}");
    assert!(said.contains("the block on the machine probably has other parameters"), "{said}");
}

#[test]
fn an_input_without_a_column() {
    let folder = folder();
    let without = good(folder.path()).only(&["v_motor", "v_add", "v_add_calculated"]);
    let said = explained(folder.path(), &without);
    assert!(said.starts_with("not explained by any of "), "{said}");
    // v_command was the same as v_motor.
    let text = good(folder.path()).only(&["v_motor"]).csv().replace("v_motor", "v_command,v_motor");
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
