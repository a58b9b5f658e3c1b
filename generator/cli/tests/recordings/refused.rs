//! Recordings of other times than the block's cycle, with gaps, or that cannot be read: one message, with a remedy.

use super::{compare, folder, good};

/// The good recording with a column of times before it.
fn with_times(name: &str, time: impl Fn(f64) -> f64) -> String {
    let csv = good().only(&["v_command", "v_motor", "v_add"]).csv();
    let cell = |row: u32| if row == 0 { name.to_owned() } else { time(f64::from(row - 1)).to_string() };
    csv.lines().zip(0..).map(|(line, row)| format!("{},{line}\n", cell(row))).collect()
}

/// The messages about a text, of which there is a number, with these parts.
fn assert_refused(text: &str, count: usize, parts: &[&str]) {
    let run = compare(folder().path(), text, &[]);
    assert_eq!((run.code, run.err.matches("error[").count()), (2, count), "{}", run.err);
    parts.iter().for_each(|part| assert!(run.err.contains(part), "{part}: {}", run.err));
}

#[test]
fn times_of_the_cycle_are_taken_in_any_unit() {
    for (name, step) in
        [("time [s]", 0.001), ("t", 0.001), ("Zeit(ms)", 1.0), ("time", 1.0), ("time_us", 1000.0), ("t", 1e6)]
    {
        let text = with_times(name, |sample| 5.0 + sample * step);
        let run = compare(folder().path(), text, &[]);
        assert_eq!((run.code, run.err.as_str()), (0, ""), "{name} {step}: {}", run.out);
    }
}

#[test]
fn times_of_another_interval() {
    let head = "recorded.csv:1:10: error[AX480]: a sample every 2 ms of v_command, v_motor, v_add; the block runs every 1 ms\n";
    let remedy = "or leave them out: --map v_command=- --map v_motor=- --map v_add=-\n";
    assert_refused(&with_times("time[ms]", |sample| 2.0 * sample), 1, &[head, remedy]);
    // What the times count is not known: then it is the user who says that they are none.
    let text = with_times("time", |sample| 2.0 * sample);
    let remedy = "write instead: state the unit of the times, as in `time [us]`, or leave them out: --map time=-\n";
    assert_refused(&text, 1, &["error[AX480]: a sample every 2 (`time` has no unit) of v_command", remedy]);
    let run = compare(folder().path(), &text, &["--map", "time=-"]);
    assert_eq!((run.code, run.err.as_str()), (0, ""), "{}", run.out);
}

#[test]
fn times_with_a_gap() {
    let time = |sample| if sample < 700.0 { sample } else { sample + 4.0 };
    let said = "recorded.csv:702:1: error[AX481]: 4 samples are missing: before line 702\n";
    assert_refused(&with_times("time[ms]", time), 1, &[said, "write instead: record again"]);
    // Times with too few digits, or of a counter that wraps.
    let said = "recorded.csv:3:3: error[AX530]: other values of v_command, v_motor, v_add at the time `t[ms]` of the row before: in 1500 rows\n";
    let text = with_times("t[ms]", |sample| (sample / 2.0).floor());
    assert_refused(&text, 1, &[said, "with more digits, or leave the times out: --map \"t[ms]=-\"\n"]);
    let said = "recorded.csv:1002:1: error[AX530]: the time `t[ms]` runs backwards: it is smaller than in line 1001\n";
    assert_refused(&with_times("t[ms]", |sample| sample % 1000.0), 1, &[said, "cut the file before this line, or"]);
    // The interval changes by less than half a cycle.
    let said =
        "recorded.csv:1502:1: error[AX480]: the interval changes: a time is 149.9 cycles away from even sampling\n";
    assert_refused(&with_times("t[ms]", |sample| sample + 0.2 * (sample - 1500.0).clamp(0.0, 1e9)), 1, &[said]);
}

/// Blank lines at the end, rows that repeat a sample with its time, times that jitter: nothing is lost. An empty file is one.
#[test]
fn rows_that_are_no_mistake() {
    let text = with_times("t[ms]", |sample| if (sample % 7.0 - 4.0).abs() < 0.5 { sample + 0.6 } else { sample });
    let twice: String = text.lines().enumerate().map(|(n, line)| [line, "\n"].concat().repeat(1 + n.min(1))).collect();
    for text in [text.clone() + "\n \n,,,\n", twice] {
        let run = compare(folder().path(), text, &[]);
        assert!(run.code == 0 && run.err.is_empty() && run.out.contains(" 3000 samples: 0 differing"), "{}", run.err);
    }
    assert_refused("", 1, &["recorded.csv:1:1: error[AX015]: an empty file\n"]);
}

/// One of two decimal marks separates thousands.
#[test]
fn two_decimal_marks() {
    let said =
        "recorded.csv:3:7: error[AX015]: `1,234` with a decimal comma, after a number with a decimal point in line 2\n";
    assert_refused("v_motor;v_add\n0.5;7\n999.5;1,234\n2.5;1,235\n", 1, &[said]);
}

/// One message, not a thousand.
#[test]
fn a_column_of_text() {
    let rows = |row: &str| (0..1001).map(|sample| format!("{sample},{row}\n")).collect::<String>();
    let head = "recorded.csv:2:3: error[AX015]: `x` for v_add, and 1000 more cells of the column\n";
    assert_refused(&format!("v_motor,v_add\n{}", rows("x")), 1, &[head]);
    let head = "recorded.csv:2:1: error[AX015]: 3 cells, and 1000 more rows\n";
    let remedy = "write instead: export with a decimal point, or with semicolons or tabs";
    assert_refused(&format!("v_motor,v_add\n{}", rows("1,5")), 1, &[head, remedy]);
    assert_refused("t[ms] v_motor v_add\n0 1 2\n", 1, &["recorded.csv:1:1: error[AX015]: blanks between the cells\n"]);
}

#[test]
fn bits_of_the_other_real_type() {
    let said = "write instead: real = \"f32\" in the set: 8 digits are those of REAL\n";
    assert_refused("v_motor,v_add\n0x3f800000,0x3f800000\n", 2, &[said]);
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
