//! Scenarios on the command line: what is printed and written, what is said of an NC program that cannot be run, and
//! that the pictures of the documents are those of the command.

use crate::simulate::with_damping as example;
use crate::{ROOT, words as axgen};
use std::{fs, path::Path};
use tempfile::TempDir;

const SETS: &str = include_str!("scenario.toml");

const TURN: &str = "M3 S300\nM19 S.POS=90\nM30\n";

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

/// What is said of programs, in `scenario.txt`.
#[test]
fn what_is_said_of_a_program() {
    transcript::compare(concat!(env!("CARGO_MANIFEST_DIR"), "/tests/scenario.txt"), |form, program| {
        let (what, options) = form.split_once(' ').unwrap();
        let (axis, options) = options.split_once(' ').unwrap_or((options, ""));
        match what {
            "refused" => said(axis, &format!("{program}\n")),
            "warned" => warned(axis, &format!("{program}\n"), options).0.join("\n"),
            other => panic!("no such form: {other}"),
        }
    });
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
    if crate::is_exhaustive() {
        let run = format!("run sets.toml --axis {axis} --block {block} --stimulus p.csv");
        assert_eq!(by_program.1, axgen(folder.path(), &run).1, "{program}");
    }
    let heads = err.lines().filter(|line| line.contains(": warning["));
    (heads.map(|line| line.replace("p.nc:", "").replace("warning", "")).collect(), out)
}

#[test]
fn the_lines_of_a_program_are_those_of_its_file() {
    let (_, out) = warned("X", "%\n\nN40 G0 X20 (a)\nM30\n", "");
    assert!(out.contains("    3  N40 "), "{out}");
}

/// A scenario is a whole stimulus up to where it stops, and the message says where that is.
#[test]
fn a_long_program_stops_with_a_warning() {
    let (_, out) = warned("X", "G04 X401\nG0 X1\nM30\n", "");
    assert!(out.starts_with("axis X, block axis: 200000 samples, 400.000 s\n"), "{out}");
    let moves = "G91 G1 X1 F1000\nX-1\n".repeat(300) + "M30\n";
    let (warnings, out) = warned("X", &moves, "--cycles 1000");
    assert!(warnings.len() == 1 && warnings[0].contains("[AX476]"), "{warnings:?}");
    assert!(out.starts_with("axis X, block axis: 1000 samples, 2.000 s\n"), "{out}");
    let whole = axgen(folder("G04 X401\nG0 X1\nM30\n").path(), "scenario sets.toml p.nc --axis X --cycles 300000");
    assert!(whole.0 == 0 && whole.1.starts_with("axis X, block axis: 2") && whole.2.is_empty(), "{whole:?}");
    for cycles in ["0", "5000001", "x"] {
        let (code, _, err) = axgen(folder(TURN).path(), &format!("scenario sets.toml p.nc --axis S --cycles {cycles}"));
        assert!(code == 2 && err.contains("1 to 5000000 is allowed"), "{err}");
    }
}

#[test]
fn a_program_axis_is_one_of_the_program() {
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
    let folder = tempfile::tempdir().unwrap();
    fs::write(folder.path().join("x.lis"), example(damping)).unwrap();
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
    let mut commands = Vec::new();
    for (case, set, name, block) in pictures {
        let [case, set] = [case, set].map(|folder| cases.join(folder).to_string_lossy().into_owned());
        commands.push((format!("scenario {set}/set.toml {case}/{name}.nc --block {block}"), name));
    }
    let example = format!("{ROOT}/examples/rack-and-pinion.lis --cycle-time 1ms");
    commands.push((format!("simulate {example} --plant demonstration"), "rack-and-pinion"));
    commands.push((format!("analyze {example}"), "margins"));
    let folder = tempfile::tempdir().unwrap();
    for (command, name) in commands {
        let file = format!("{name}.svg");
        let command = format!("{command} --picture {file}");
        assert_eq!(axgen(folder.path(), &command).0, 0, "{command}");
        let drawn = fs::read(folder.path().join(&file)).unwrap();
        let kept = fs::read(Path::new(ROOT).join("docs/pictures").join(&file)).unwrap();
        assert!(drawn == kept, "{file}: `axgen {command}` draws another picture");
        assert!(kept.len() < 100_000, "{file}");
    }
}
