//! `axgen tune`: proposals from recordings of the simulated demonstration plant, tried on it; and recordings that allow none.

use super::plant::{self, A_LOAD, CYCLE, Columns, Noise, OF_EXCITED, OF_MOVES, V_MOTOR, moves, number};
use crate::simulate::row;
use crate::{Run, axgen};
use serde_json::Value;
use std::{f64::consts::TAU, fmt::Write, fs};
use tempfile::TempDir;

/// An axis whose stages are to be found.
pub const SET: &str = "cycle_time = \"1ms\"\n[axis.X]\nkopf.achs_nr = 1\nkenngr.achs_typ = \"ACHSTYP_TRANSLATOR\"\n\
    getriebe = [{ dynamik.vb_max = 530000, kv = 2000 }]\n\
    [axis.X.lr_param.improved_position_control]\nenable = \"ON\"\nv_add_max_fact = 1000\n";
/// The names of the columns, with their units.
pub const NAMES: [&str; 7] = [
    "x_command [mm]",
    "x_actual [mm]",
    "v_command [um/s]",
    "v_motor [um/s]",
    "v_cmd [um/s]",
    "v_excite [um/s]",
    "a_load",
];
/// Excited with 8 periods while it moves at 20 mm/s. The velocity of the motor has noise of 0.3 mm/s.
pub fn excited() -> Columns {
    let mut columns = plant::excited(8, 0.02);
    let mut noise = Noise(7);
    columns[V_MOTOR].iter_mut().for_each(|v| *v += 300.0 * noise.next());
    columns
}

pub fn csv(columns: &Columns, of: &[usize]) -> String {
    plant::csv(&NAMES, columns, of)
}

/// A drive with two equal time constants [s] after two cycles, as a file; its standard errors are a part of the magnitude.
pub fn drive(time_constant: f64, error: f64) -> String {
    let mut text = "# averages: 8\nf [Hz],re,im,se\n".to_owned();
    for k in 1..1024_u32 {
        let w = TAU * f64::from(k) * 0.2442;
        let (size, angle) =
            (1.0 / (1.0 + (w * time_constant).powi(2)), -2.0 * (w * time_constant).atan() - w * 2.0 * CYCLE);
        let (re, im) = (size * angle.cos(), size * angle.sin());
        writeln!(text, "{:.6},{re},{im},{}", f64::from(k) * 0.2442, error * size).unwrap();
    }
    text
}

/// A folder with the set, and recordings.
pub fn folder(files: &[(&str, &str)]) -> TempDir {
    let folder = tempfile::tempdir().unwrap();
    let write = |(name, text): &(&str, &str)| fs::write(folder.path().join(name), text).unwrap();
    files.iter().chain(&[("set.toml", SET)]).for_each(write);
    folder
}

pub fn tune(folder: &TempDir, more: &[&str]) -> Run {
    axgen(folder, &[&["tune", "set.toml", "--axis", "X", "--recording", "moves.csv"], more].concat())
}

/// The stages of a proposal as keys of a set.
fn set_with(proposal: &Value) -> String {
    let mut text = SET.to_owned();
    for stage in proposal["stages"].as_array().unwrap() {
        let allpass = match &stage["allpass"] {
            Value::Null => String::new(),
            of => format!(", {{ type = \"ALLPASS\", fg_f0 = {}, q_factor = {} }}", of["f0"], of["q"]),
        };
        let damping = stage["damping"].as_f64().map_or_else(String::new, |of| format!("osc_damping = {of}\n"));
        write!(
            text,
            "[[axis.X.lr_param.improved_position_control.stage]]\nmode = {}\nweight_fact_num = {:.0}\n\
             weight_fact_denom = 1000\nfilter = [{{ order = {}, prototype = {}, fg_f0 = {}, q_factor = {} }}{allpass}]\n{damping}",
            stage["mode"],
            number(stage, "weight") * 1000.0,
            stage["order"],
            stage["prototype"],
            stage["f0"],
            stage["q"],
        )
        .unwrap();
    }
    text
}

/// The peak of the following error that the controller sees, on by off, of a simulation as CSV.
pub fn seen_error(folder: &TempDir, file: &str) -> f64 {
    let text = fs::read_to_string(folder.path().join(file)).unwrap();
    let row = |line: &str| line.split(',').map(|cell| cell.parse().unwrap()).collect::<Vec<f64>>();
    let rows: Vec<Vec<f64>> = text.lines().skip(1).map(row).collect();
    let peak = |x: usize| rows.windows(2).map(|pair| (pair[1][1] - pair[0][x]).abs()).fold(0.0, f64::max);
    peak(3) / peak(2)
}

#[test]
fn proposals_for_the_demonstration_plant() {
    let folder = folder(&[("moves.csv", &csv(&moves(), &OF_MOVES)), ("excited.csv", &csv(&excited(), &OF_EXCITED))]);
    let run = tune(&folder, &["--excited", "excited.csv"]);
    assert_eq!(run.code, 0, "{}{}", run.out, run.err);
    for part in ["recommended\n", "strong\n", "cautious\n", "enters at the motor", "[0] DIRECT from v_motor", "Kv 20/s"]
    {
        assert!(run.out.contains(part), "{part}: {}", run.out);
    }
    let machine = tune(&folder, &["--excited", "excited.csv", "--json"]);
    assert_eq!(machine.out, tune(&folder, &["--excited", "excited.csv", "--json"]).out, "the same bytes twice");
    let found = machine.json();
    assert_eq!(found["axis"], "X");
    assert_eq!(found["refused"], Value::Array(Vec::new()));
    // What is left at most of 53 Hz, 11 Hz, the ring-down, and the largest |S|: the definition's figures and a few percent.
    let expected = [
        ("recommended", [0.41, 0.29, 0.365, 2.1], [1.76, 2.0, 2.0, 2.0]),
        ("strong", [0.37, 0.26, 0.29, 2.2], [2.0; 4]),
        ("cautious", [0.66, 0.57, 0.66, 1.5], [1.4; 4]),
    ];
    let proposals = found["proposals"].as_array().unwrap();
    assert_eq!(proposals.len(), 3, "{found:#}");
    for (proposal, (kind, left, most)) in proposals.iter().zip(expected) {
        let [line, mode] = [0, 1].map(|k| number(&proposal["residuals"][k], "ratio"));
        let [ring, error] = ["ring_down", "following_error_ratio"].map(|of| number(proposal, of));
        let predicted = [line, mode, ring, error];
        let ms = [&proposal["ms"], &proposal["ms_half_cycle"], &proposal["ms_load"][0], &proposal["ms_load"][1]];
        let ms = ms.map(|ms| ms.as_f64().unwrap());
        assert_eq!(proposal["kind"], kind);
        assert!(predicted.iter().zip(left).take(3).all(|(found, most)| *found <= most), "{kind}: {predicted:?}");
        assert!(ms.iter().zip(most).all(|(found, most)| *found <= most * 1.005), "{kind}: {ms:?}");
        assert!((1e3..1e5).contains(&number(proposal, "peak_v_add")), "{proposal:#}");
        assert!((0.1..1.0).contains(&number(proposal, "settled")), "{proposal:#}");
        fs::write(folder.path().join("with.toml"), set_with(proposal)).unwrap();
        let truth = axgen(&folder, &["simulate", "with.toml", "--plant", "demonstration", "--csv", "s.csv"]);
        assert_eq!(truth.code, 0, "{}{}{}", truth.out, truth.err, set_with(proposal));
        let [off, on] = ["off", "all"].map(|name| row(&truth.out, name));
        for (column, predicted) in predicted.iter().take(3).enumerate() {
            let truth = on[column] / off[column];
            assert!((predicted / truth - 1.0).abs() < 0.07, "{kind}, column {column}: {predicted}, in truth {truth}");
        }
        // The controller sees the position of the cycle before; the table has that of the same instant.
        let [seen, error] = [seen_error(&folder, "s.csv"), on[3] / off[3]];
        assert!((predicted[3] / seen - 1.0).abs() < 0.03 && error <= left[3], "{kind}: {predicted:?}, {seen}, {error}");
        assert!((number(proposal, "peak_v_add") / on[4] - 1.0).abs() < 0.1, "{kind}: {proposal:#}\n{}", truth.out);
        assert!(on[5] <= 2.0 && (ms[0] / on[5] - 1.0).abs() < 0.05, "{kind}: {ms:?}, in truth {}", on[5]);
    }
}

/// A code, and that no stage is proposed.
fn assert_refused(what: &str, folder: &TempDir, more: &[&str], expected: &str) {
    let run = tune(folder, more);
    assert!(run.code == 1 && run.err.contains(&format!("error[{expected}]")), "{what}: {}{}", run.out, run.err);
    let found = tune(folder, &[more, &["--json"]].concat()).json();
    assert_eq!(found["proposals"], Value::Array(Vec::new()), "{what}");
    let refused = found["refused"].as_array().unwrap();
    assert!(refused.iter().any(|of| of["code"] == expected), "{what}: {found:#}");
}

#[test]
fn first_stages_without_a_response() {
    let folder = folder(&[("moves.csv", &csv(&moves(), &OF_MOVES))]);
    let run = tune(&folder, &[]);
    assert_eq!(run.code, 0, "{}{}", run.out, run.err);
    assert!(run.err.contains("[AX521]") && run.err.contains("[AX514]"), "{}", run.err);
    let next = "measure next: an excitation 12x2 of 2 mm/s";
    assert!(run.out.contains("side unknown") && run.out.contains(next), "{}", run.out);
    let found = tune(&folder, &["--json"]).json();
    let first = &found["proposals"][0];
    assert!(first["kind"] == "first" && first["ms"].is_null() && found["proposals"].as_array().unwrap().len() == 1);
    fs::write(folder.path().join("with.toml"), set_with(first)).unwrap();
    let truth = axgen(&folder, &["simulate", "with.toml", "--plant", "demonstration"]);
    let [off, on] = ["off", "all"].map(|name| row(&truth.out, name));
    assert!(on[5] < 1.4 && on[0] < off[0] && on[1] < off[1], "{}", truth.out);
}

/// The ratio of the sensor to the motor is another one than in the excitation: the load makes the line.
#[test]
fn what_enters_at_the_load_gets_no_stage() {
    let mut at_load = moves();
    let is_driving: Vec<bool> = at_load[2].iter().map(|v| v.abs() > 1e5).collect();
    let line = |(n, drives): (usize, &bool)| if *drives { (TAU * 53.0 * n as f64 * CYCLE).sin() } else { 0.0 };
    at_load[A_LOAD] = is_driving.iter().enumerate().map(line).collect();
    let excited = csv(&excited(), &OF_EXCITED);
    let folder = folder(&[("moves.csv", &csv(&at_load, &OF_MOVES)), ("excited.csv", &excited)]);
    let run = tune(&folder, &["--excited", "excited.csv"]);
    assert!(run.err.contains("[AX516]") && run.err.contains("53.0 Hz: enters at the load"), "{}{}", run.out, run.err);
    assert_refused("load", &folder, &["--excited", "excited.csv"], "AX519");
    // A drive with hardly any response at 53 Hz: no weight helps.
    fs::write(folder.path().join("slow.csv"), drive(0.15, 1e-3)).unwrap();
    fs::write(folder.path().join("set.toml"), SET.replace(", kv = 2000", "")).unwrap();
    let run = tune(&folder, &["--response", "slow.csv"]);
    let Run { code, out, err } = &run;
    assert!(*code == 0 && err.contains("[AX520]") && out.contains("strong: hardly useful"), "{out}{err}");
    assert!(run.out.contains("Kv is not in the set: the position loop counts as open"), "{}", run.out);
    // A response of the set counts too; this one is too uncertain.
    fs::write(folder.path().join("vague.csv"), drive(0.003, 0.3)).unwrap();
    fs::write(folder.path().join("set.toml"), SET.replace("kopf", "drive.response = \"vague.csv\"\nkopf")).unwrap();
    assert_refused("uncertain", &folder, &[], "AX512");
}

#[test]
fn recordings_that_allow_no_proposal() {
    let text = csv(&moves(), &OF_MOVES);
    let lines: Vec<&str> = text.lines().collect();
    let of = |to: usize| lines[..to].join("\n");
    let mut still = moves();
    still[A_LOAD].iter_mut().for_each(|a| *a = 0.0);
    let acted = csv(&still, &[0, V_MOTOR, A_LOAD]).replace("v_motor [um/s]", "v_add [um/s]");
    let folder = folder(&[]);
    for (what, text, cycle, expected) in [
        ("at rest", of(250), "1ms", "AX503"),
        ("ends while it moves", of(1500), "1ms", "AX518"),
        ("another cycle", text.clone(), "2ms", "AX517"),
        ("stages acted", acted, "1ms", "AX511"),
        ("no v_motor", csv(&still, &[0, A_LOAD]), "1ms", "AX515"),
    ] {
        fs::write(folder.path().join("moves.csv"), text).unwrap();
        fs::write(folder.path().join("set.toml"), SET.replace("1ms", cycle)).unwrap();
        assert_refused(what, &folder, &[], expected);
    }
    let missing = axgen(&folder, &["tune", "set.toml", "--axis", "X"]);
    assert!(missing.code == 2 && missing.err.contains("--recording"), "{}", missing.err);
}
