//! The emitted C of two spindles in a closed loop with a drive that goes off and on at any speed: position control never begins above
//! Voff + window, and never turns the spindle backwards. Without a drive: rows of docs/spindle.md, cycle by cycle.

#![expect(clippy::print_stderr, reason = "what was run is a result")]

use generator::config::ListOptions;
use generator::generate::axis_files;
use generator::target::{File, TARGETS};
use std::path::Path;
use std::process::Command;
use tempfile::TempDir;

const SET: &str = include_str!("../../bench/spindles.toml");
const DRIVE: &str = include_str!("drive.c");
const STATED: &str = include_str!("stated.c");
/// Feedforward of the velocity as an additive velocity.
const ADDED: &str = "vorsteuer.vorsteuerung = 'ADD_VEL'
antr.operation_mode = 'CNC_POSITION_CONTROL'
antr.v_time_base = 0
antr.v_reso_num = 1
antr.v_reso_denom = 36
kenngr.antr_typ = 'SERCOS'
process_data.additive_velocity = 'INT32'";
/// Feedforward of the velocity and the acceleration for a drive that controls the position.
const ADDED_IN_DRIVE: &str = "vorsteuer.vorsteuerung = 'ADD_VEL ADD_ACC'
process_data.additive_velocity = 'INT32'
process_data.additive_torque = 'INT16'
";
/// Voff and the window of both spindles [rpm], and what a drive that is late adds.
const TAKEN_UP: f64 = 50.0 + 1.0 + 0.1;

/// The program of a source, with an axis of a set, compiled.
fn built(source: &str, set: &str, axis: &str) -> (std::path::PathBuf, TempDir) {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let load = |_: &Path| Ok(set.as_bytes().to_vec());
    let (read, report) = generator::pipeline::read_with(Path::new("set.toml"), &ListOptions::default(), &load);
    let read = read.unwrap_or_else(|| panic!("{report:#?}"));
    for one in &read.axes {
        for File { name, text } in axis_files(one, &TARGETS[..1]).expect("the target prints the blocks") {
            std::fs::write(folder.path().join(&name), text).expect("room in it");
        }
    }
    std::fs::write(folder.path().join("drive.c"), source).expect("room in it");
    let header = format!("-DHEADER=\"axis_{axis}_spindle_axis.h\"");
    let block = format!("axis_{axis}_spindle_axis.c");
    let named = format!("-DAXIS=axis_{axis}");
    let mut arguments = vec!["-std=c99", "-O2", "-Wall", "-Werror", &header, &named];
    let defined =
        [(axis == "s", "-DIN_DRIVE"), (set.contains("ADD_VEL"), "-DADDITIVE"), (set.contains("18750"), "-DFAST")];
    arguments.extend(defined.iter().filter(|(is_defined, _)| *is_defined).map(|(_, name)| *name));
    arguments.extend(["drive.c", &block, "-lm", "-o", "drive"]);
    let done = Command::new("gcc").args(&arguments).current_dir(folder.path()).output().expect("gcc starts");
    assert!(done.status.success(), "{}", String::from_utf8_lossy(&done.stderr));
    (folder.path().join("drive"), folder)
}

fn said(program: &Path, arguments: &[&str]) -> String {
    let run = Command::new(program).args(arguments).output().expect("the program starts");
    String::from_utf8(run.stdout).expect("text")
}

#[test]
fn position_control_begins_slowly_and_never_turns_the_spindle_backwards() {
    for axis in ["s", "c"] {
        let (program, _folder) = built(DRIVE, SET, axis);
        let text = said(&program, &[]);
        eprintln!("{axis}: runs, highest rpm at which position control began, rpm backwards, longest s, lost\n{text}");
        assert_eq!(text.lines().count(), 3, "{text}");
        for line in text.lines() {
            let numbers: Vec<f64> = line.split(' ').skip(1).map(|text| text.parse().expect("a number")).collect();
            let [runs, began, backwards, _, lost] = numbers[..] else { panic!("{line}") };
            assert!(runs > 50.0 && began <= TAKEN_UP && backwards <= 1.0 && lost == 0.0, "{axis}: {line}");
        }
    }
}

/// Kv 10/s, Von 600 rpm, and no feedforward: 300 deg of lag at 500 rpm, which the shortest way are -60 deg.
#[test]
fn a_lag_of_half_a_turn_in_the_cnc_is_an_error_and_never_a_reversal() {
    let slow = SET.replace("kv = 2000, multi_gain_z", "kv = 1000, multi_gain_z").replace("1200000", "3600000");
    let (program, _folder) = built(DRIVE, &slow, "c");
    let text = said(&program, &["lag", "500"]);
    let numbers: Vec<f64> = text.split_whitespace().map(|text| text.parse().expect("a number")).collect();
    let [_, lowest, last, lag] = numbers[..] else { panic!("{text}") };
    assert!(text.starts_with("48 ") && lowest >= 0.0 && last.abs() < 0.1, "error, lowest command, last speed: {text}");
    // The cycle with a larger lag reports the error itself.
    assert!((160.0..=170.0).contains(&lag), "the largest lag without an error: {text}");
    let text = said(&program, &["lag", "250"]);
    assert!(text.starts_with("0 0.000 250.0"), "{text}");
}

/// The lag of a blocked spindle grows by 22.8 deg in a cycle at 1900 rpm, by 45 deg at 3750 rpm: from 120 to 300 deg while three
/// samples are missing. The last four runs are the rows of the page: their number, or each row that does not hold.
#[test]
fn neither_a_blocked_spindle_nor_a_lost_sample_nor_an_error_is_a_step_of_the_command() {
    let fast = SET.replace("kv = 2000, multi_gain_z", "kv = 8000, multi_gain_z").replace("1200000", "12000000");
    let faster = SET.replace("kv = 2000, multi_gain_z", "kv = 18750, multi_gain_z").replace("1200000", "24000000");
    let added = SET.replace("1200000", "12000000").replace("vorsteuer.vorsteuerung = \"VEL\"", ADDED);
    let both = SET.replacen("kv = 2000,", "kv = 2000, load = 0.1,", 1).replacen(
        "[axis.S.antr]",
        &format!("{ADDED_IN_DRIVE}[axis.S.antr]"),
        1,
    );
    for (source, set, axis, run, expected) in [
        (DRIVE, &*fast, "c", &["blocked", "1900"][..], "0.0 0\n"),
        (DRIVE, &faster, "c", &["blocked", "3750", "3"], "0.0 0\n"),
        (DRIVE, SET, "c", &["lost", "150"], "0 0\n"),
        (DRIVE, &added, "c", &["lost", "150"], "0 0\n"),
        (DRIVE, SET, "c", &["stopped", "150"], "0.0 0\n"),
        (DRIVE, &added, "c", &["ahead", "900"], "0.0 48\n"),
        (DRIVE, SET, "s", &["unseen", "150"], "149.9 45 0.000\n"),
        (STATED, SET, "s", &[], "4\n"),
        (STATED, SET, "c", &[], "72\n"),
        (STATED, &added, "c", &[], "36\n"),
        (STATED, &both, "s", &[], "8\n"),
    ] {
        let (program, _folder) = built(source, set, axis);
        assert_eq!(said(&program, run), expected, "{axis} {run:?}");
    }
}
