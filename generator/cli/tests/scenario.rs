//! Scenarios on the command line: what is printed and written, what is said of an NC program that cannot be run, and that the pictures
//! of the documents are those of the command.

#![expect(clippy::unwrap_used, reason = "a test that cannot go on fails")]

use std::fs;
use std::path::Path;
use std::process::{Command, Output};
use tempfile::TempDir;

const ROOT: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../..");

const SETS: &str = r#"
cycle_time = "2ms"

[axis.S]
kenngr.achs_typ = "ACHSTYP_SPINDEL"
kenngr.antr_typ = "SERCOS"
getriebe = [{ kv = 2000, dynamik.vb_max = 9000000 }]
spindle.deceleration = 12000000

[axis.S.antr]
nbr_delay_cycles = 4
v_time_base = 0
v_reso_num = 1
v_reso_denom = 36
sercos.op_mode_for_velocity_control = 1
sai_op_mode_change = { v_velocity_control_on = 1200000, v_position_control_on = 300000 }

[axis.X]
getriebe = [{ kv = 3000, dynamik.vb_max = 500000 }]
vorsteuer.vorsteuerung = "VEL"

[axis.LIFT]
getriebe = [{ kv = 3000, dynamik.vb_max = 500000 }]
vorsteuer.vorsteuerung = "VEL"
"#;

const TURN: &str = "M3 S300\nM19 S.POS=90\nM30\n";

fn axgen(folder: &Path, command: &str) -> (i32, String, String) {
    let Output { status, stdout, stderr } = Command::new(env!("CARGO_BIN_EXE_axgen"))
        .current_dir(folder)
        .args(command.split_whitespace())
        .output()
        .unwrap();
    let text = |bytes| String::from_utf8(bytes).unwrap();
    (status.code().unwrap(), text(stdout), text(stderr))
}

fn folder(program: &str) -> TempDir {
    let folder = tempfile::tempdir().unwrap();
    fs::write(folder.path().join("sets.toml"), SETS).unwrap();
    fs::write(folder.path().join("p.nc"), program).unwrap();
    folder
}

/// What is said of a program on an axis, by each of the commands that run it: the same; nothing is printed.
fn said(axis: &str, program: &str) -> String {
    let folder = folder(program);
    let run = format!("run sets.toml --axis {axis} --block feedforward --scenario p.nc");
    let run = if axis == "S" { run.replace("feedforward", "spindle") } else { run };
    let commands = [
        format!("scenario sets.toml p.nc --axis {axis} --stimulus p.csv --picture p.svg"),
        format!("verify sets.toml --axis {axis} --scenario p.nc"),
        run,
    ];
    let answers = commands.map(|command| axgen(folder.path(), &command));
    for (code, out, err) in &answers {
        assert_eq!((*code, out.as_str(), err), (2, "", &answers[0].2), "{program}");
    }
    assert_eq!(fs::read_dir(folder.path()).unwrap().count(), 2, "nothing was written");
    answers[0].2.clone()
}

#[test]
fn every_mistake_of_a_program_is_said_with_its_place() {
    assert_eq!(
        said("S", "%p\nN10 M03 S1000\nN20 M19\nM30\n"),
        "p.nc:2:5: error[AX019]: `M03`\n  2 | N10 M03 S1000\n    |     ^\n    allowed: one spelling of a word\n    \
         write instead: `M3`\n\
         p.nc:3:5: error[AX019]: `M19` without `S.POS=`\n  3 | N20 M19\n    |     ^\n    \
         allowed: `M19` with an angle\n    write instead: `M19 S.POS=180`\n"
    );
}

#[test]
fn what_the_axis_cannot_do_is_said_with_its_line() {
    assert_eq!(
        said("S", "M3 S100\nM3 S1501\nM30\n"),
        "p.nc:2:1: error[AX019]: a speed of 1501 rpm\n  2 | M3 S1501\n    | ^\n    \
         allowed: up to 1500 rpm, vb_max (P-AXIS-00212)\n    write instead: a lower speed, or another vb_max\n"
    );
    assert_eq!(
        said("S", "M19 S.POS=1 S0\nM30\n"),
        "p.nc:1:1: error[AX019]: `M19` with the speed 0\n  1 | M19 S.POS=1 S0\n    | ^\n    \
         allowed: a speed above 0\n    write instead: `M19` with another speed, or without one\n"
    );
    assert_eq!(
        said("S", "G00 X1\nM30\n"),
        "p.nc:1:1: error[AX019]: a motion of path axes in the scenario of a spindle\n  1 | G00 X1\n    | ^\n    \
         allowed: commands of spindle 1\n    write instead: a scenario of its own for the axis\n"
    );
    assert_eq!(
        said("X", "M5\nM30\n"),
        "p.nc:1:1: error[AX019]: a motion of a spindle in the scenario of an axis\n  1 | M5\n    | ^\n    \
         allowed: moves, dwell and feedforward\n    write instead: a scenario of its own for the spindle\n"
    );
    assert_eq!(
        said("X", "G01 X1 F30001\nM30\n"),
        "p.nc:1:1: error[AX019]: a feed of 30001 mm/min\n  1 | G01 X1 F30001\n    | ^\n    \
         allowed: up to 30000 mm/min, vb_max (P-AXIS-00212)\n    write instead: a lower feed, or another vb_max\n"
    );
    assert_eq!(
        said("LIFT", "G00 X1\nM30\n"),
        "p.nc:1:1: error[AX019]: axis `LIFT`, which NC programs do not have\n  1 | G00 X1\n    | ^\n    \
         allowed: an axis named X, Y or Z\n    write instead: another name for the axis in its set\n"
    );
    assert_eq!(
        said("X", "G04 X401\nM30\n"),
        "p.nc:1:1: error[AX019]: a block that is not over after 200000 cycles of the scenario\n  1 | G04 X401\n    | ^\n    \
         allowed: a scenario that ends\n    write instead: another program, or a longer cycle time\n"
    );
}

#[test]
fn a_stimulus_is_what_a_scenario_runs_with() {
    let folder = folder(TURN);
    let at = folder.path();
    let (code, out, err) = axgen(at, "scenario sets.toml p.nc --axis S --stimulus p.csv --picture p.svg");
    assert_eq!((code, err.as_str()), (0, ""), "{out}");
    assert!(out.starts_with("axis S, block spindle: "), "{out}");
    let run = "run sets.toml --axis S --block spindle --hex";
    let by_file = axgen(at, &format!("{run} --stimulus p.csv"));
    assert_eq!(by_file.0, 0);
    for engine in ["reference", "program", "c", "rust", "st", "twincat", "codesys", "scl"] {
        assert_eq!(axgen(at, &format!("{run} --scenario p.nc --engine {engine}")), by_file, "{engine}");
    }
    // Its own outputs are replaced, others are not, and an input never is.
    assert_eq!(axgen(at, "scenario sets.toml p.nc --axis S --stimulus p.csv --picture p.svg").0, 0);
    let (code, _, err) = axgen(at, "scenario sets.toml p.nc --axis S --stimulus p.svg");
    assert!(code == 2 && err.starts_with("p.svg: error[AX014]: is no earlier output of this command"), "{err}");
    let (code, _, err) = axgen(at, "scenario sets.toml p.nc --axis S --stimulus p.nc --force");
    assert_eq!((code, err.as_str()), (2, "p.nc: error[AX014]: is an input of this run; give another name\n"));
}

#[test]
fn names_and_options_that_do_not_go_together() {
    let folder = folder(TURN);
    let cases = [
        ("scenario sets.toml p.nc", "--axis: error[AX011]: the set has several axes: which one?"),
        ("scenario sets.toml p.nc --axis S --block ipc", "--block: error[AX012]: no block `ipc`"),
        ("scenario sets.toml q.nc --axis S", "q.nc: error[AX001]: "),
        (
            "run sets.toml --axis S --scenario p.nc --stimulus p.csv",
            "error: the argument '--scenario <FILE>' cannot be used",
        ),
        ("verify sets.toml --axis S", "error: the following required arguments were not provided"),
    ];
    for (command, start) in cases {
        let (code, _, err) = axgen(folder.path(), command);
        assert!(code == 2 && err.starts_with(start), "{command}: {code}, {err}");
    }
}

/// The shipped example as axis X, with another damping of its INDIRECT stage; and a program with a move and a rest.
fn with_damping(damping: &str) -> TempDir {
    let text = fs::read_to_string(Path::new(ROOT).join("examples/rack-and-pinion.lis")).unwrap();
    let line = |value: &str| format!("stage[1].filter.damping    {value}\n");
    assert_eq!(text.matches(&line("0.8")).count(), 1);
    let folder = tempfile::tempdir().unwrap();
    fs::write(folder.path().join("x.lis"), text.replace(&line("0.8"), &line(damping))).unwrap();
    fs::write(folder.path().join("p.nc"), "N10 G01 X500 F20000\nN20 G04 X2\nM30\n").unwrap();
    folder
}

/// `v_add` acts on the drive: what oscillates on the machine oscillates here. Which sets are unstable is what a program of its own found, with
/// the eigenvalues of the closed loop, in `tests/stability`.
#[test]
fn an_unstable_stage_is_seen() {
    let run = |damping: &str, options: &str| {
        let folder = with_damping(damping);
        axgen(folder.path(), &format!("scenario x.lis --cycle-time 1ms --name X p.nc --stimulus s.csv {options}"))
    };
    let (code, out, _) = run("0.8", "");
    assert_eq!((code, out.contains("unstable")), (0, false), "{out}");
    let (code, out, _) = run("0.2", "");
    assert_eq!(code, 1, "{out}");
    let time =
        out.lines().find_map(|line| line.strip_prefix("v_add at its limit for ")).unwrap_or_else(|| panic!("{out}"));
    let time: f64 = time.strip_suffix(" s: the loop is unstable").unwrap().parse().unwrap();
    assert!((1.0..5.0).contains(&time), "{out}");
    // The drive of the options is the one in the loop: three cycles more make the good set oscillate.
    let (code, out, _) = run("0.8", "--delay 12 --time-constant 5ms");
    assert_eq!((code, out.contains("the loop is unstable")), (1, true), "{out}");
}

/// What v_motor is at the end: at rest, or not.
#[test]
fn the_stimulus_shows_the_closed_loop() {
    let peak = |damping: &str| {
        let folder = with_damping(damping);
        axgen(folder.path(), "scenario x.lis --cycle-time 1ms --name X p.nc --stimulus s.csv");
        let text = fs::read_to_string(folder.path().join("s.csv")).unwrap();
        let head: Vec<&str> = text.lines().next().unwrap().split(',').collect();
        let at = head.iter().position(|name| *name == "v_motor").unwrap();
        let v = text.lines().skip(1).map(|row| row.split(',').nth(at).unwrap().parse::<f64>().unwrap().abs());
        let v: Vec<f64> = v.collect();
        v[v.len() - 500..].iter().fold(0.0, |peak: f64, v| peak.max(*v))
    };
    let [calm, unstable] = ["0.8", "0.2"].map(peak);
    assert!(calm < 1000.0, "{calm} um/s in the last half second of a stable loop");
    assert!(unstable > 100_000.0, "{unstable} um/s in the last half second of an unstable one");
}

#[test]
fn the_pictures_are_what_the_command_draws() {
    let pictures = [
        ("spindle-changeover-program", "spindle-positioning-with-reversal", "changeover", "spindle"),
        (
            "spindle-positioning-with-reversal",
            "spindle-positioning-with-reversal",
            "positioning-with-reversal",
            "spindle",
        ),
        (
            "spindle-positioning-above-the-changeover-speed",
            "spindle-positioning-above-the-changeover-speed",
            "positioning-above-the-changeover-speed",
            "spindle",
        ),
        ("spindle-in-the-cnc", "spindle-in-the-cnc", "spindle-in-the-cnc", "spindle"),
        ("feedforward-in-a-program", "feedforward-in-a-program", "feedforward", "axis"),
    ];
    let cases = Path::new(ROOT).join("golden/cases");
    let folder = tempfile::tempdir().unwrap();
    for (case, set, name, block) in pictures {
        let [case, set] = [case, set].map(|folder| cases.join(folder).to_string_lossy().into_owned());
        let command = format!("scenario {set}/set.toml {case}/{name}.nc --block {block} --picture {name}.svg");
        assert_eq!(axgen(folder.path(), &command).0, 0, "{command}");
        let file = format!("{name}.svg");
        let drawn = fs::read(folder.path().join(&file)).unwrap();
        let kept = fs::read(Path::new(ROOT).join("docs/pictures").join(&file)).unwrap();
        assert!(drawn == kept, "{file}: `axgen {command}` draws another picture");
        assert!(kept.len() < 100_000, "{file}");
    }
    let example = Path::new(ROOT).join("examples/rack-and-pinion.lis");
    for (command, name) in [("simulate --plant demonstration", "rack-and-pinion"), ("analyze", "margins")] {
        let (command, options) = command.split_once(' ').unwrap_or((command, ""));
        let set = example.to_string_lossy();
        let command = format!("{command} {set} --cycle-time 1ms {options} --picture {name}.svg");
        assert_eq!(axgen(folder.path(), command.trim()).0, 0, "{command}");
        let file = format!("{name}.svg");
        let drawn = fs::read(folder.path().join(&file)).unwrap();
        let kept = fs::read(Path::new(ROOT).join("docs/pictures").join(&file)).unwrap();
        assert!(drawn == kept, "{file}: `axgen {command}` draws another picture");
        assert!(kept.len() < 100_000, "{file}");
    }
}
