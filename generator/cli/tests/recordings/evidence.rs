//! What a recording moves is said first; one that proves nothing ends with 1.

use super::{compare, folder, good};
use crate::axgen;
use std::fs;

#[test]
fn what_moves_and_what_was_taken_is_said_first() {
    let folder = folder();
    let run = compare(folder.path(), good().only(&["v_motor", "v_add"]).csv(), &[]);
    let lines: Vec<&str> = run.out.lines().collect();
    assert!(lines[0].starts_with("moved: v_motor 0 to "), "{}", run.out);
    assert!(lines[0].contains(" um/s, v_add -"), "{}", run.out);
    assert!(lines[0].ends_with("; in 2999 of 3000 samples, 2999 of them with mode ON"), "{}", run.out);
    assert!(lines[1].starts_with("no column, taken at the start value: v_command 0, v_direct 0, "), "{}", run.out);
    assert!(lines[1].contains(", mode 1, position_controlled 1, reset 0, "), "{}", run.out);
    assert!(lines[2].starts_with("v_add against engine reference, 3000 samples: "), "{}", run.out);
}

/// What is said of recordings of `v_motor`, `mode` and `v_add` that prove nothing.
#[test]
fn recordings_that_prove_nothing() {
    let remedy = "record the outputs that the move changes: v_add, or v_add_calculated with mode DRYRUN";
    let still = ("no output that was recorded moves", remedy);
    let inputs = "record the inputs of the block, too, while the axis moves; --map NAME=SIGNAL where the names differ";
    let empty = [("there is no sample", "record a move with mode ON")];
    let off = [still, ("mode is OFF throughout", "record a move with mode ON (1)")];
    let rest = [("no input of the block moves", inputs), still];
    for (samples, speed, mode, out, expected) in [
        (0, 0, 1, "moved: nothing; in 0 of 0 samples, 0 of them with mode ON\n", &empty[..]),
        (100, 1, 0, "; in 99 of 100 samples, 0 of them with mode ON\nconstant: mode 0, v_add 0\n", &off),
        (100, 0, 1, "moved: nothing; in 0 of 100 samples", &rest),
    ] {
        let rows: String = (0..samples).map(|sample| format!("{},{mode},0\n", speed * sample)).collect();
        let run = compare(folder().path(), format!("v_motor,mode,v_add\n{rows}"), &[]);
        assert!(run.code == 1 && run.out.contains(out), "{}", run.out);
        let message = |(found, instead): &(&str, &str)| {
            format!("recorded.csv: error[AX482]: proves nothing: {found}\n    write instead: {instead}\n")
        };
        assert_eq!(run.err, expected.iter().map(message).collect::<String>());
    }
}

/// The block of an axis without improved position control has no input `mode`; a column with that name proves nothing.
#[test]
fn a_block_without_a_mode() {
    let folder = folder();
    let set = "cycle_time = '1ms'\n[axis.T]\ngetriebe = [{ kv = 2000, multi_gain_z = 10000000, multi_gain_n = 360 }]\nvorsteuer.vorsteuerung = 'VEL'\n";
    fs::write(folder.path().join("t.toml"), set).unwrap();
    let rows = (0..200).map(|sample| format!("{sample},{sample}.5,0\n")).collect::<String>();
    fs::write(folder.path().join("in.csv"), "x_command,v_interpolator,mode\n".to_owned() + &rows).unwrap();
    let run = |more: &[&str]| {
        axgen(folder.path(), &[&["run", "t.toml", "--block", "axis", "--stimulus", "in.csv"], more].concat())
    };
    assert_eq!(run(&["--out", "out.csv"]).code, 0);
    let compared = run(&["--compare", "out.csv"]);
    assert_eq!((compared.code, compared.err.as_str()), (0, ""), "{}", compared.out);
    assert!(compared.out.lines().next().is_some_and(|line| line.ends_with("of 200 samples")), "{}", compared.out);
}

/// Digits so few that any block would agree.
#[test]
fn too_few_digits() {
    let folder = folder();
    let recording = good().only(&["v_command", "v_motor", "v_add"]);
    let row = |row: &Vec<f64>| format!("{:.0}E3,{:.0}E3,{:.0}E1\n", row[0] / 1e3, row[1] / 1e3, row[2] / 10.0);
    let text = "v_command,v_motor,v_add\n".to_owned() + &recording.rows.iter().map(row).collect::<String>();
    let run = compare(folder.path(), text, &[]);
    assert_eq!(run.code, 1, "{}", run.out);
    assert!(run.out.contains("; the digits recorded would explain "), "{}", run.out);
    assert!(run.out.contains(" um/s: too few to prove anything\n"), "{}", run.out);
}
