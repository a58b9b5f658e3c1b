//! Recordings of other times than the block's cycle, with gaps, or that cannot be read: one message, with a remedy.

use super::{compare, folder, good};
use std::fmt::Write;

/// The good recording with a column of times before it.
fn with_times(name: &str, time: impl Fn(usize) -> f64) -> (tempfile::TempDir, String) {
    let folder = folder();
    let recording = good().only(&["v_command", "v_motor", "v_add"]);
    let csv = recording.csv();
    let mut text = String::new();
    for (row, line) in csv.lines().enumerate() {
        let _ = match row {
            0 => writeln!(text, "{name},{line}"),
            _ => writeln!(text, "{},{line}", time(row - 1)),
        };
    }
    (folder, text)
}

#[expect(clippy::cast_precision_loss, reason = "a few thousand")]
fn number(sample: usize) -> f64 {
    sample as f64
}

#[test]
fn times_of_the_cycle_are_taken_in_any_unit() {
    for (name, step) in
        [("time [s]", 0.001), ("t", 0.001), ("Zeit(ms)", 1.0), ("time", 1.0), ("time_us", 1000.0), ("t", 1e6)]
    {
        let (folder, text) = with_times(name, |sample| 5.0 + number(sample) * step);
        let run = compare(folder.path(), text, &[]);
        assert_eq!((run.code, run.err.as_str()), (0, ""), "{name} {step}: {}", run.out);
    }
}

#[test]
fn times_of_another_interval() {
    let (folder, text) = with_times("time[ms]", |sample| 2.0 * number(sample));
    let run = compare(folder.path(), &text, &[]);
    assert_eq!(run.code, 2);
    let head = "recorded.csv:1:10: error[AX480]: a sample every 2 ms of v_command, v_motor, v_add; the block runs every 1 ms\n";
    assert!(run.err.starts_with(head), "{}", run.err);
    assert!(run.err.ends_with("or leave them out: --map v_command=- --map v_motor=- --map v_add=-\n"), "{}", run.err);
    assert_eq!(run.err.matches("error[").count(), 1, "{}", run.err);
    // What the times count is not known: then it is the user who says that they are none.
    let (folder, text) = with_times("time", |sample| 2.0 * number(sample));
    let run = compare(folder.path(), &text, &[]);
    assert!(
        run.err.contains("error[AX480]: a sample every 2 of `time`, which has no unit, of v_command"),
        "{}",
        run.err
    );
    let run = compare(folder.path(), &text, &["--map", "time=-"]);
    assert_eq!((run.code, run.err.as_str()), (0, ""), "{}", run.out);
}

#[test]
fn times_with_a_gap() {
    let time = |sample: usize| number(if sample < 700 { sample } else { sample + 4 });
    let (folder, text) = with_times("time[ms]", time);
    let run = compare(folder.path(), &text, &[]);
    assert_eq!(run.code, 2);
    assert!(
        run.err.starts_with("recorded.csv:702:1: error[AX481]: 4 samples are missing: before line 702\n"),
        "{}",
        run.err
    );
    assert!(run.err.contains("write instead: record again"), "{}", run.err);
    // A scope that fills gaps with the previous value.
    let (folder, text) = with_times("time[ms]", |sample| number(sample / 2));
    let run = compare(folder.path(), &text, &[]);
    let said = "error[AX481]: the time does not go on: before line 3, 5, 7, 9, 11, ...\n";
    assert!(run.err.contains(said), "{}", run.err);
}

/// One message, not a thousand.
#[test]
fn a_column_of_text() {
    let folder = folder();
    let rows: String = (0..1001).map(|sample| format!("{sample},x\n")).collect();
    let run = compare(folder.path(), format!("v_motor,v_add\n{rows}"), &[]);
    assert_eq!((run.code, run.err.matches("error[").count()), (2, 1), "{}", run.err);
    let head = "recorded.csv:2:3: error[AX015]: `x` for v_add, and 1000 more cells of the column\n";
    assert!(run.err.starts_with(head), "{}", run.err);
    let rows: String = (0..1001).map(|sample| format!("{sample},1,5\n")).collect();
    let run = compare(folder.path(), format!("v_motor,v_add\n{rows}"), &[]);
    assert_eq!((run.code, run.err.matches("error[").count()), (2, 1), "{}", run.err);
    assert!(run.err.starts_with("recorded.csv:2:1: error[AX015]: 3 cells, and 1000 more rows\n"), "{}", run.err);
    assert!(run.err.contains("write instead: export with a decimal point, or with semicolons or tabs"), "{}", run.err);
}

#[test]
fn bits_of_the_other_real_type() {
    let folder = folder();
    let run = compare(folder.path(), "v_motor,v_add\n0x3f800000,0x3f800000\n", &[]);
    assert_eq!((run.code, run.err.matches("error[").count()), (2, 2), "{}", run.err);
    assert!(run.err.contains("write instead: real = \"f32\" in the set: 8 digits are those of REAL\n"), "{}", run.err);
}

/// A map needs a file whose columns it names.
#[test]
fn a_map_without_a_file() {
    let folder = folder();
    std::fs::write(folder.path().join("move.nc"), "X1\n").unwrap();
    let command = ["run", "axes.toml", "--axis", "X", "--scenario", "move.nc", "--map", "a=v_motor"];
    let run = super::axgen(folder.path(), &command);
    assert_eq!(run.code, 2);
    let said = "--map: error[AX011]: names columns of a CSV file: give --stimulus or --compare with it\n";
    assert_eq!(run.err, said);
}
