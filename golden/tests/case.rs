//! Cases as their author meets them: recording, checking, and what is reported for a mistake.
#![forbid(unsafe_code)]

use golden::case::{self, Case};
use golden::csv::{self, Reals};
use golden::samples::{Samples, Shape};
use std::path::Path;
use tempfile::TempDir;

const SET: &str = include_str!("case/set.toml");

const CASE: &str = include_str!("case/case.toml");

/// A folder with a case.
fn folder(text: &str) -> TempDir {
    let folder = tempfile::tempdir().expect("a temporary folder");
    for (name, text) in [("set.toml", SET), ("case.toml", text)] {
        std::fs::write(folder.path().join(name), text).expect("room in it");
    }
    folder
}

/// Records a case.
fn keep(case: &Case, made: Option<Samples>) -> Result<(), String> {
    case::keep(case, &case::recorded(case, made)?)
}

fn read(folder: &TempDir) -> Case {
    case::read(folder.path()).unwrap_or_else(|mistake| panic!("{mistake}"))
}

/// What is reported for a case whose text is changed.
fn said(replaced: &str, by: &str) -> String {
    assert!(CASE.contains(replaced));
    let folder = folder(&CASE.replace(replaced, by));
    let said = case::read(folder.path()).and_then(|case| case::recorded(&case, None)).expect_err("a mistake");
    assert_eq!(std::fs::read_dir(folder.path()).expect("a folder").count(), 2, "nothing was written");
    said
}

#[test]
fn what_was_recorded_is_verified() {
    let folder = folder(CASE);
    let case = read(&folder);
    assert_eq!(
        case::verify(&case).unwrap(),
        [
            "inputs.csv",
            "outputs.csv",
            "digest",
            "emitted/axis_x_ipc.h",
            "emitted/axis_x_ipc.c",
            "emitted/axis_x_ipc.rs",
            "emitted/axis_x_ipc.st",
            "emitted/twincat/POUs/FB_axis_x_ipc.TcPOU",
            "emitted/twincat/Tests/FB_axis_x_ipc_Test.TcPOU",
            "emitted/axis_x_ipc.xml",
            "emitted/axis_x_ipc.scl",
        ],
        "nothing is recorded yet"
    );
    keep(&case, None).unwrap();
    assert_eq!(case::verify(&case).unwrap(), [""; 0]);
    assert_eq!(
        case::folders(folder.path().parent().unwrap()).unwrap().iter().filter(|f| *f == folder.path()).count(),
        1
    );
}

#[test]
fn a_changed_byte_and_a_file_of_another_time_are_named() {
    let folder = folder(CASE);
    let case = read(&folder);
    keep(&case, None).unwrap();
    let outputs = folder.path().join("outputs.csv");
    let text = std::fs::read_to_string(&outputs).unwrap();
    let (head, tail) = text.split_at(text.len() - 2);
    std::fs::write(&outputs, format!("{head}1{}", &tail[1..])).unwrap();
    let left_over = folder.path().join("emitted/axis_y.c");
    std::fs::write(&left_over, "").unwrap();
    let expected = ["outputs.csv".to_owned(), format!("{} (no such file is emitted)", left_over.display())];
    assert_eq!(case::verify(&case).unwrap(), expected);
    keep(&case, None).unwrap();
    assert!(!left_over.exists());
    assert_eq!(std::fs::read_to_string(&outputs).unwrap(), text);
}

#[test]
fn a_case_that_does_not_show_what_it_says_is_not_recorded() {
    assert!(said("\"faded in\"", "\"fault 11\"").ends_with("the case does not show fault 11"));
    let folder = folder(CASE);
    keep(&read(&folder), None).unwrap();
    let path = folder.path().join("case.toml");
    std::fs::write(&path, CASE.replace("faded in", "limited above")).unwrap();
    assert_eq!(case::verify(&read(&folder)).unwrap(), ["shows: limited above"]);
}

/// The recorded inputs hold only what changes, and reading them back gives all of it.
#[test]
fn recorded_inputs_leave_out_what_keeps_its_start() {
    let folder = folder(CASE);
    let case = read(&folder);
    keep(&case, None).unwrap();
    let text = std::fs::read_to_string(folder.path().join("inputs.csv")).unwrap();
    assert!(text.starts_with("v_command,v_motor\n0x0000000000000000,"), "the first signal stays, and what changes");
    let shape = Shape::of(&case.block.program.inputs, case.block.program.real);
    let inputs = case::inputs(&case, case::KEPT_SAMPLES).unwrap();
    assert_eq!(csv::read(&text, &shape).unwrap(), inputs);
    assert_eq!(csv::write(&[&inputs.without_constant()], Reals::Hexadecimal), text);
}

#[test]
fn mistakes_are_told_with_what_is_there() {
    let mistakes = [
        (said("axis = \"X\"", "axis = \"Y\""), "no axis `Y`"),
        (said("block = \"ipc\"", "block = \"spindle\""), "no block `spindle`; this axis has: ipc"),
        (said("purpose", "porpoise"), "unknown field `porpoise`"),
        (said("v_motor = [", "v_ist1 = ["), "the block has no input `v_ist1`"),
        (said("v_motor = [", "mode = ["), "`mode` is not a real: only an event can set it"),
        (said("noise = { seed = 1 }", "sine = { period = 0 }"), "`v_motor`: `period` is 0; allowed: a number above 0"),
        (said("noise = { seed = 1 }", "move = { phase = 0, ramp = 1 }"), "`phase` is 0; allowed: a number above 0"),
        (said("noise = { seed = 1 }", "noise = { sead = 1 }"), "unexpected keys in table: sead, available keys: seed"),
        (said("[stimulus.signal]", &event("mode", "\"ON\"")), "`ON` is not a value of `mode`"),
        (said("[stimulus.signal]", &event("reset", "2")), "`2` is not a value of `reset`"),
        (said("[stimulus.signal]", &event("v_ist2", "nan")), "the block has no input `v_ist2`"),
    ];
    for (said, expected) in mistakes {
        assert!(said.contains(expected), "{expected}: {said}");
    }
    let nowhere = case::read(Path::new("nowhere")).unwrap_err();
    assert!(nowhere.contains("nowhere") && nowhere.contains("case.toml"), "{nowhere}");
}

fn event(signal: &str, value: &str) -> String {
    format!("[[stimulus.event]]\nsignal = \"{signal}\"\nvalue = {value}\nwindow = {{}}\n\n[stimulus.signal]")
}

const SPINDLE: &str = include_str!("case/spindle.toml");

const SCENARIO: &str = include_str!("case/scenario.toml");

/// A folder with a scenario.
fn scenario() -> TempDir {
    let folder = tempfile::tempdir().expect("a temporary folder");
    for (name, text) in [("set.toml", SPINDLE), ("case.toml", SCENARIO), ("turn.nc", "M3 S60\nM3 S60\nM5\nM5\nM30\n")] {
        std::fs::write(folder.path().join(name), text).expect("room in it");
    }
    folder
}

fn record(folder: &TempDir, again: bool) -> Result<(), String> {
    let case = read(folder);
    keep(&case, case::scenario_inputs(&case, again)?)
}

/// The inputs of a scenario are made once: neither another interpolator nor another program makes them anew.
#[test]
fn recorded_inputs_of_a_scenario_stay_as_they_are() {
    let folder = scenario();
    let file = |name: &str| std::fs::read_to_string(folder.path().join(name)).unwrap();
    let write = |name: &str, text: &str| std::fs::write(folder.path().join(name), text).unwrap();
    let missing = case::verify(&read(&folder)).unwrap_err();
    assert!(missing.contains("inputs.csv"), "{missing}");
    record(&folder, false).unwrap();
    assert_eq!(case::verify(&read(&folder)).unwrap(), [""; 0]);
    let made = file("inputs.csv");
    assert!(made.lines().count() < 20_000, "a command that is given twice ends");

    // As another version of the library might have made them: they are kept, and their outputs are recorded.
    let other = made.replacen(",10000.0", ",10000.1", 1);
    assert_ne!(made, other);
    write("inputs.csv", &other);
    assert_eq!(case::verify(&read(&folder)).unwrap(), ["outputs.csv", "digest"]);
    record(&folder, false).unwrap();
    assert_eq!((file("inputs.csv"), case::verify(&read(&folder)).unwrap()), (other.clone(), vec![]));

    write("turn.nc", "M3 S90\nM5\nM30\n");
    let refused = record(&folder, false).unwrap_err();
    let place = folder.path().join("turn.nc");
    let expected = format!(
        "{}: is not the program whose inputs are recorded in inputs.csv; --again records them again",
        place.display()
    );
    assert_eq!(refused, expected);
    assert_eq!(case::verify(&read(&folder)).unwrap(), [expected, "digest".to_owned()]);
    assert_eq!(file("inputs.csv"), other);

    record(&folder, true).unwrap();
    assert_ne!(file("inputs.csv"), other);
    assert_eq!(case::verify(&read(&folder)).unwrap(), [""; 0]);
    write("turn.nc", "M3 S60\nM3 S60\nM5\nM5\nM30\n");
    record(&folder, true).unwrap();
    assert_eq!(file("inputs.csv"), made, "the same program makes the same bits");
}

#[test]
fn a_case_has_a_stimulus_or_a_scenario_and_targets_that_there_are() {
    let folder = scenario();
    let said = |text: &str| {
        std::fs::write(folder.path().join("case.toml"), text).unwrap();
        case::read(folder.path()).unwrap_err()
    };
    let neither = said(&SCENARIO.replace("scenario = \"turn.nc\"\n", ""));
    assert!(neither.ends_with("case.toml: either `stimulus` or `scenario` is needed"), "{neither}");
    let unknown = said(&SCENARIO.replace("emitted = []", "emitted = [\"pascal\"]"));
    assert!(
        unknown.ends_with("case.toml: no target `pascal`; there are: c, rust, st, twincat, codesys, scl"),
        "{unknown}"
    );
}
