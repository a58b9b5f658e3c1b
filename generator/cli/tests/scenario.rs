//! Scenarios on the command line: what is printed and written, what is said of an NC program that cannot be run, and
//! that the pictures of the documents are those of the command.

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

[axis.Z2]
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
        said("S", "%p\nN10 G2 X1 I5\nN20 M19\nG3 X1\nG3 X2\nM30\n"),
        "p.nc:2:5: error[AX019]: `G2`, an arc\n  2 | N10 G2 X1 I5\n    |     ^\n    \
         allowed: straight moves (`G00`, `G01`), dwell, homing, feedforward, the words of spindle 1 and words that are passed over\n    \
         write instead: straight moves, as a CAM system writes them with arcs switched off\n\
         p.nc:3:5: error[AX019]: `M19` without `S.POS=`\n  3 | N20 M19\n    |     ^\n    \
         allowed: `M19` with an angle\n    write instead: `M19 S.POS=180`\n\
         p.nc:4:1: error[AX019]: `G3`, an arc (the first of 2)\n  4 | G3 X1\n    | ^\n    \
         allowed: straight moves (`G00`, `G01`), dwell, homing, feedforward, the words of spindle 1 and words that are passed over\n    \
         write instead: straight moves, as a CAM system writes them with arcs switched off\n"
    );
}

#[test]
fn what_the_axis_cannot_do_is_said_with_its_line() {
    assert_eq!(
        said("S", "M19 S.POS=1 S0\nM30\n"),
        "p.nc:1:1: error[AX019]: `M19` with the speed 0\n  1 | M19 S.POS=1 S0\n    | ^\n    \
         allowed: a speed above 0\n    write instead: `M19` with another speed, or without one\n"
    );
    assert_eq!(
        said("LIFT", "G00 X1\nM30\n"),
        "p.nc:1:1: error[AX019]: axis `LIFT`, which NC programs do not have\n  1 | G00 X1\n    | ^\n    \
         allowed: a letter of an axis (X, Y, Z, A, B, C, U, V, W, E), or one with a number as in `X1=50`\n    \
         write instead: --program-axis X, or another name for the axis in its set\n"
    );
}

/// What a program that runs is warned of, by each of the commands that run it; and what is printed.
fn warned(axis: &str, program: &str, options: &str) -> (Vec<String>, String) {
    let folder = folder(program);
    let (code, out, err) =
        axgen(folder.path(), &format!("scenario sets.toml p.nc --axis {axis} {options} --stimulus p.csv"));
    assert_eq!(code, 0, "{program}: {err}");
    let block = if axis == "S" { "spindle" } else { "axis" };
    let run = format!("run sets.toml --axis {axis} --block {block} --scenario p.nc {options}");
    let by_program = axgen(folder.path(), &run);
    assert_eq!((by_program.0, &by_program.2), (0, &err), "{program}");
    let by_stimulus = axgen(folder.path(), &format!("run sets.toml --axis {axis} --block {block} --stimulus p.csv"));
    assert_eq!(by_program.1, by_stimulus.1, "{program}");
    let heads = err.lines().filter(|line| line.contains(": warning["));
    (heads.map(|line| line.replace("p.nc:", "").replace("warning", "")).collect(), out)
}

#[test]
fn a_program_of_a_machine_runs_with_one_warning_a_kind() {
    let program = "%\nO1000 (PART)\nN5 G21 G17 G40 G49 G80 G90 G94 ; start\nN10 G54\nN15 T1 M06\nN20 S8000 M03\n\
                   N25 G00 X0. Y0. Z50.\nN30 G43 H1 Z5. M08\nG64 P0.01\nN35 G1Z-1F300\n#COMMENT BEGIN\nG2\n#COMMENT END\n\
                   N40 X20.Y10.F60000\n/X10\nN45 G91 X-.5\nN50 G4 P500\nN55 G90 G0 Z50 M09\nN60 G28 Y0\nM05\nM30\n%\n";
    let (warnings, out) = warned("X", program, "");
    assert_eq!(
        warnings,
        [
            "2:1: [AX470]: 4 words (O, G17, G80, G94) of settings passed over: they change nothing here",
            "3:12: [AX470]: 6 words (G40, G49, T, M06, G43, H) of the tool passed over: its length and its radius are taken as 0",
            "4:5: [AX472]: 1 word (G54) of zero offsets passed over: all offsets are taken as 0",
            "6:1: [AX474]: 2 commands of a spindle passed over: this is the scenario of an axis",
            "8:16: [AX470]: 2 words (M08, M09) of the machine passed over: no time, no stop and no output of them",
            "9:1: [AX471]: 1 word (G64) of the path mode passed over: each block ends with a stop",
            "14:1: [AX475]: 3 feeds above vb_max (P-AXIS-00212), 30000 mm/min: limited to it",
            "15:1: [AX473]: 1 block with `/` run, as with the switch off",
            "17:8: [AX473]: 1 dwell (G4 P500) with a time of unknown unit: taken as ms from 100 on, below as s",
            "19:5: [AX472]: 1 move (G28) to positions of the machine not made: they are unknown",
        ]
    );
    assert!(out.contains("    14  N40 "), "{out}");
}

#[test]
fn speeds_and_motions_of_the_other_kind_are_warned_of() {
    let (warnings, out) = warned("S", "M3 S9999\nG0 X100\nG1 X0 F100\nM19 S.POS=0 S5000\nM5\nM30\n", "");
    assert_eq!(
        warnings,
        [
            "1:1: [AX475]: 2 speeds above vb_max (P-AXIS-00212), 1500 rpm: limited to it",
            "2:1: [AX474]: 2 motions of path axes passed over, which take no time: this is the scenario of a spindle",
        ]
    );
    assert!(out.lines().count() == 8, "{out}");
    // A spindle without a speed stands, as on a machine.
    assert_eq!(warned("S", "M3\nG04 X0.1\nM5\nM30", "").0, Vec::<String>::new());
}

/// A scenario is a whole stimulus up to where it stops, and the message says where that is.
#[test]
fn a_long_program_stops_with_a_warning() {
    let (warnings, out) = warned("X", "G04 X401\nG0 X1\nM30\n", "");
    assert_eq!(
        warnings,
        ["1:1: [AX476]: a program that goes on: the scenario stops after 200000 cycles, 400.000 s, in line 1 of 3",]
    );
    assert!(out.starts_with("axis X, block axis: 200000 samples, 400.000 s\n"), "{out}");
    let moves = "G91 G1 X1 F1000\nX-1\n".repeat(300) + "M30\n";
    let (warnings, out) = warned("X", &moves, "--cycles 1000");
    assert!(warnings.len() == 1 && warnings[0].contains("[AX476]"), "{warnings:?}");
    assert!(out.starts_with("axis X, block axis: 1000 samples, 2.000 s\n"), "{out}");
    let (warnings, out) = warned("X", "G04 X401\nG0 X1\nM30\n", "--cycles 300000");
    assert!(warnings.is_empty() && out.starts_with("axis X, block axis: 2"), "{warnings:?} {out}");
    let (warnings, _) = warned("S", "M3 S100\nG04 X401\nM30\n", "");
    assert!(warnings[0].contains("[AX476]") && warnings[0].contains("in line 2 of 3"), "{warnings:?}");
    for cycles in ["0", "5000001", "x"] {
        let (code, _, err) = axgen(folder(TURN).path(), &format!("scenario sets.toml p.nc --axis S --cycles {cycles}"));
        assert!(code == 2 && err.contains("1 to 5000000 is allowed"), "{err}");
    }
}

#[test]
fn an_axis_follows_that_of_its_name_or_the_one_that_is_chosen() {
    let said = |axis: &str, program: &str, options: &str| warned(axis, program, options).0;
    assert_eq!(said("X", "G0 X1 Y2\nM30\n", ""), Vec::<String>::new());
    assert_eq!(said("LIFT", "G0 X1 Z2\nM30\n", "--program-axis z"), Vec::<String>::new());
    assert_eq!(said("X", "G0 Y1\nM30\n", ""), ["1:1: [AX474]: a program that never moves axis X: it stands still"]);
    assert_eq!(said("Z2", "G0 Z1 Z2=5\nM30\n", ""), Vec::<String>::new());
    assert_eq!(said("Z2", "G0 Z1\nM30\n", ""), ["1:1: [AX477]: axis `Z2` follows axis Z of the program"]);
    // An axis that goes with the path keeps to its own vb_max.
    let along = said("LIFT", "G1 X1 A100 F20000\nG0 X0 A0\nM30\n", "--program-axis A");
    assert_eq!(along, ["1:1: [AX475]: 1 feed above vb_max (P-AXIS-00212), 30000 mm/min: limited to it"]);
    let (code, _, err) = axgen(folder("G0 X1\nM30").path(), "scenario sets.toml p.nc --axis X --program-axis Q");
    assert!(code == 2 && err.starts_with("p.nc:1:1: error[AX019]: `Q` for --program-axis\n"), "{err}");
}

/// Comments in the encodings of old systems, no end, and lines after it.
#[test]
fn a_file_of_an_old_system() {
    let folder = folder("");
    fs::write(folder.path().join("p.nc"), b"(\xe4\xf6) G0 X1 ; \xb0\r\nX2\r\n\x1a").unwrap();
    let (code, _, err) = axgen(folder.path(), "scenario sets.toml p.nc --axis X");
    let head = "p.nc:2:3: warning[AX473]: a program without `M30` or `M2`: its end is the end of the file\n";
    assert!(code == 0 && err.starts_with(head), "{err}");
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
    assert!(code == 2 && err.starts_with("p.svg: error[AX014]: is not an earlier output of this command"), "{err}");
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

/// `v_add` acts on the drive: what oscillates on the machine oscillates here. Which sets are unstable is what a
/// program of its own found, with the eigenvalues of the closed loop, in `tests/stability`.
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
