//! `axgen tune` with stages of one's own, its files, and proposals that are written into a set or a list.

use super::plant::{A_LOAD, CYCLE, Columns, OF_EXCITED, OF_MOVES, V_EXCITE, V_MOTOR, moves, number};
use super::tune::{SET, csv, drive, excited, folder, seen_error, tune};
use crate::{axgen, simulate::row};
use serde_json::Value;
use std::{f64::consts::PI, fs, sync::LazyLock};
use tempfile::TempDir;

static MOVES: LazyLock<String> = LazyLock::new(|| csv(&moves(), &OF_MOVES));
static EXCITED: LazyLock<String> = LazyLock::new(|| csv(&excited(), &OF_EXCITED));

/// The pair of the manual, as options and in a set.
const PAIR: [&str; 4] = [
    "--stage",
    "mode=DIRECT,fg_f0=53,q_factor=10,weight=3",
    "--stage",
    "mode=INDIRECT, osc_damping=0.8, filter[0].fg_f0=11, q_factor=2, weight=190/100",
];
const STAGES: &str = "[[axis.X.lr_param.improved_position_control.stage]]\nmode = \"DIRECT\"\nweight_fact_num = 3000\n\
    weight_fact_denom = 1000\nfilter = [{ order = 1, fg_f0 = 53, q_factor = 10 }]\n\
    [[axis.X.lr_param.improved_position_control.stage]]\nmode = \"INDIRECT\"\nosc_damping = 0.8\nweight_fact_num = 190\n\
    weight_fact_denom = 100\nfilter = [{ order = 1, fg_f0 = 11, q_factor = 2 }]\n";

fn recorded() -> TempDir {
    folder(&[("moves.csv", &MOVES), ("excited.csv", &EXCITED)])
}

fn write(folder: &TempDir, name: &str, text: &str) {
    fs::write(folder.path().join(name), text).unwrap();
}

fn read(folder: &TempDir, name: &str) -> String {
    fs::read_to_string(folder.path().join(name)).unwrap()
}

fn amplitude(json: &Value, when: &str, near: f64) -> f64 {
    let is_it = |of: &&Value| {
        of["channel"] == "a_load" && of["when"] == when && (of["hz"].as_f64().unwrap() / near - 1.0).abs() < 0.1
    };
    number(json["vibrations"].as_array().unwrap().iter().find(is_it).unwrap_or_else(|| panic!("{json:#}")), "amplitude")
}

#[test]
fn stages_of_ones_own() {
    let folder = recorded();
    let files = ["--excited", "excited.csv", "--signals", "s.csv", "--picture", "p.svg", "--json"];
    let given = tune(&folder, &[&files[..], &PAIR].concat());
    assert_eq!(given.code, 0, "{}{}", given.out, given.err);
    let found = given.json();
    let proposals = found["proposals"].as_array().unwrap();
    assert!(proposals.len() == 1 && proposals[0]["kind"] == "given", "{found:#}");
    let of = &proposals[0];
    // The definition's figures of the manual's pair.
    let figures = [
        (number(&of["residuals"][0], "ratio"), 0.454, 0.05),
        (number(&of["residuals"][1], "ratio"), 0.311, 0.05),
        (number(of, "ring_down"), 0.376, 0.05),
        (number(of, "ms_half_cycle"), 2.08, 0.03),
    ];
    assert!(figures.iter().all(|(found, golden, part)| (found / golden - 1.0).abs() < *part), "{figures:?}");
    // The stages of a set are the same ones; the report has them.
    write(&folder, "set.toml", &format!("{SET}{STAGES}"));
    assert_eq!(tune(&folder, &["--excited", "excited.csv", "--stage", "set", "--json"]).out, given.out);
    let report = tune(&folder, &["--excited", "excited.csv", "--stage", "set"]);
    let first = "given\n  stage[0] DIRECT from v_motor, f0 53 Hz, Q 10, weight 3000/1000\n";
    assert!(report.out.contains(first), "{}", report.out);
    // The signals, measured like a recording, show what was predicted; their columns are those of the recording.
    let signals = read(&folder, "s.csv");
    assert_eq!(signals.lines().count(), MOVES.lines().count());
    let head = "time [s],v_command [um/s],v_motor [um/s],x_command [mm],x_actual [mm],a_load [m/s^2]";
    assert_eq!(signals.lines().next(), Some(head));
    let [before, after] = ["moves.csv", "s.csv"].map(|name| axgen(&folder, &["measure", name, "--json"]).json());
    let left = amplitude(&after, "driving", 53.0) / amplitude(&before, "driving", 53.0);
    assert!((left / figures[0].0 - 1.0).abs() < 0.02, "{left} {figures:?}");
    // And the simulation with the stages, sample by sample: the load's acceleration and the following error.
    let truth = axgen(&folder, &["simulate", "set.toml", "--plant", "demonstration", "--csv", "true.csv"]);
    assert_eq!(truth.code, 0, "{}", truth.err);
    // The controller sees the position of the cycle before: the golden 3.45 is of the same instant.
    let seen = seen_error(&folder, "true.csv");
    assert!((number(of, "following_error_ratio") / seen - 1.0).abs() < 0.03, "{of:#} {seen}");
    assert!((row(&truth.out, "all")[0] / row(&truth.out, "off")[0] / left - 1.0).abs() < 0.03, "{}", truth.out);
    let picture = read(&folder, "p.svg");
    roxmltree::Document::parse(&picture).unwrap();
    assert!(picture.contains("with the stages") && picture.contains("following_error"));
    // A picture is replaced, a CSV file is not: it may be a recording.
    assert_eq!(tune(&folder, &[&files[..2], &PAIR, &["--picture", "p.svg"]].concat()).code, 0);
    assert_eq!(read(&folder, "p.svg"), picture, "the same bytes twice");
    assert_eq!(tune(&folder, &[&files[..2], &PAIR, &["--signals", "s.csv"]].concat()).code, 2);
    assert_eq!(tune(&folder, &[&files[..2], &PAIR, &["--signals", "s.csv", "--force"]].concat()).code, 0);
    assert_eq!(read(&folder, "s.csv"), signals);
    assert_eq!(tune(&folder, &[&files[..2], &PAIR, &["--signals", "moves.csv", "--force"]].concat()).code, 2);
}

/// What a command line of stages says.
fn assert_said(folder: &TempDir, stages: &[&str], code: i32, parts: &[&str]) {
    let options: Vec<&str> = stages.iter().flat_map(|stage| ["--stage", stage]).collect();
    let run = tune(folder, &[&["--response", "drive.csv"], &options[..]].concat());
    assert_eq!(run.code, code, "{stages:?}: {}{}", run.out, run.err);
    parts.iter().for_each(|part| assert!(run.err.contains(part), "{stages:?}: no {part}: {}", run.err));
}

#[test]
fn stages_that_are_none() {
    let folder = folder(&[("moves.csv", &MOVES), ("drive.csv", &drive(0.003, 1e-3))]);
    let good = "mode=DIRECT,fg_f0=53,q_factor=10,weight=0.5";
    assert_said(&folder, &[good], 0, &[]);
    let said = |spec: &str, parts: &[&str]| assert_said(&folder, &[spec], 2, parts);
    let parts = ["--stage: error[AX203]", "fg_f0` (P-AXIS-00751) is 900", "0 < fg_f0 <= 500"];
    said("mode=DIRECT,fg_f0=900,q_factor=10,weight=0.5", &parts);
    said("mode=DIRECT,fg_f0=53,q_factor=100", &["--stage: error[AX203]"]);
    said("mode=DIRECT,fgf0=53", &["--stage: error[AX104]: `fgf0` is not a key of a stage", "write instead: fg_f0"]);
    said("mode=DIRECT,fg_f0=53,q_factor=10,weight=0.12345", &["error[AX011]", "weight=0.12345", "up to 3 digits"]);
    said("mode=DIRECT,fg_f0=53,fg_f0=54", &["error[AX011]", "fg_f0` is given twice"]);
    said("mode=DIRECT,fg_f0=53,allpass=20", &["error[AX011]", "allpass=F0/Q"]);
    said("DIRECT", &["error[AX011]", "`DIRECT` has no value"]);
    said("mode=DIREKT,fg_f0=53,q_factor=10", &["error[AX"]);
    assert_said(&folder, &[good; 4], 2, &["error[AX011]", "4 stages"]);
    let restless = "mode=DIRECT,fg_f0=3,q_factor=5,weight=5";
    assert_said(
        &folder,
        &[restless],
        0,
        &["warning[AX529]", "more after stops than without stages: given x", "warning[AX548]"],
    );
    assert_said(&folder, &["set"], 1, &["error[AX522]", "no stage is active"]);
    assert_said(&folder, &["mode=SET_POINT,osc_damping=0.5,fg_f0=53,q_factor=5"], 1, &["error[AX522]", "SET_POINT"]);
    assert_said(&folder, &["mode=DIRECT,direct_source=v_direct,fg_f0=53,q_factor=5"], 1, &["error[AX522]"]);
    assert_said(&folder, &["mode=INDIRECT,osc_damping=0.05,fg_f0=30,q_factor=1,weight=7"], 1, &["error[AX524]"]);
    // Without a response of the drive.
    let run = tune(&folder, &["--stage", good]);
    assert!(run.code == 1 && run.err.contains("error[AX522]"), "{}{}", run.out, run.err);
    let run = tune(&folder, &["--signals", "s.csv"]);
    assert!(run.code == 1 && run.err.contains("error[AX522]") && !folder.path().join("s.csv").exists(), "{}", run.err);
    // A limit that the stages would reach; the number that is named is enough.
    write(&folder, "set.toml", &SET.replace("v_add_max_fact = 1000", "v_add_max_fact = 1"));
    let run = tune(&folder, &["--response", "drive.csv", "--stage", good]);
    assert!(run.code == 0 && run.err.contains("warning[AX523]"), "{}{}", run.out, run.err);
    let (_, rest) = run.err.split_once("at least needed: given ").unwrap();
    let needed: u32 = rest.split(' ').next().unwrap().parse().unwrap();
    for (limit, is_enough) in [(needed, true), (needed - 1, false)] {
        write(&folder, "set.toml", &SET.replace("v_add_max_fact = 1000", &format!("v_add_max_fact = {limit}")));
        let run = tune(&folder, &["--response", "drive.csv", "--stage", good]);
        assert_eq!(run.err.contains("AX523"), !is_enough, "{limit}: {}", run.err);
    }
}

#[test]
fn a_proposal_into_the_set() {
    let folder = recorded();
    let commented = SET.replace("enable = \"ON\"\n", "enable = \"ON\" # at start\n# the limit:\n");
    write(&folder, "set.toml", &commented);
    let run = tune(&folder, &["--excited", "excited.csv", "--apply", "recommended"]);
    assert_eq!(run.code, 0, "{}{}", run.out, run.err);
    let set = read(&folder, "set.toml");
    let (head, stages) = set.split_once("\n[[").unwrap();
    assert_eq!(head, commented.replace("\"ON\"", "\"DRYRUN\""), "all else is as it was");
    assert_eq!(stages.matches("improved_position_control.stage]]").count(), 2, "{set}");
    assert!(run.out.contains("\nset.toml: 2 stages of recommended, enable DRYRUN\naxis X: "), "{}", run.out);
    let check = axgen(&folder, &["check", "set.toml"]);
    assert_eq!(check.code, 0, "{}{}", check.out, check.err);
    // The stages of the set are the proposal: the same figures, but for the rounding of its numbers.
    let given = tune(&folder, &["--excited", "excited.csv", "--stage", "set", "--json"]).json();
    let found = tune(&folder, &["--excited", "excited.csv", "--json"]).json();
    let [given, found] = [&given["proposals"][0], &found["proposals"][0]];
    assert_eq!(given["stages"], found["stages"]);
    let left = |of: &Value| [0, 1].map(|k| number(&of["residuals"][k], "ratio"));
    let [a, b] = [left(given), left(found)];
    assert!(a.iter().zip(b).all(|(a, b)| (a / b - 1.0).abs() < 0.01), "{a:?} {b:?}");
    if !crate::is_exhaustive() {
        return;
    }
    // A second time nothing changes; another proposal replaces them.
    assert_eq!(tune(&folder, &["--excited", "excited.csv", "--apply", "recommended"]).code, 0);
    assert_eq!(read(&folder, "set.toml"), set);
    let as_json = ["--excited", "excited.csv", "--apply", "cautious", "--json", "--message-format", "json"];
    let cautious = tune(&folder, &as_json);
    let said: Vec<Value> = cautious.err.lines().map(|line| serde_json::from_str(line).unwrap()).collect();
    let head = said.iter().find_map(|line| line["applied"][0].as_str());
    assert!(cautious.code == 0 && head.is_some_and(|head| head.contains("2 stages of cautious")), "{said:?}");
    cautious.json();
    assert_ne!(read(&folder, "set.toml"), set);
    // What a killed run left is cleared; no file of a run stays.
    write(&folder, "set.toml.axgen-staged-1", "half a f");
    assert_eq!(tune(&folder, &["--excited", "excited.csv", "--apply", "strong"]).code, 0);
    let names = fs::read_dir(folder.path()).unwrap().map(|entry| entry.unwrap().file_name().into_string().unwrap());
    assert_eq!(names.filter(|name| name.contains("axgen-")).collect::<Vec<_>>(), Vec::<String>::new());
}

/// What other keys mean depends on whether the axis has a stage; a proposal changes none of them.
#[test]
fn first_stages_of_every_kind_of_axis() {
    let folder = folder(&[("moves.csv", &MOVES)]);
    let in_drive = "antr = { v_reso_num = 10000, v_reso_denom = 3333 }\nprocess_data.additive_velocity = 'INT32'\nkenngr.antr_typ = ";
    let slave =
        "[axis.S]\nkopf.achs_nr = 2\nkenngr.gantry_ax_nr = 1\ngetriebe = [{ dynamik.vb_max = 530000, kv = 2000 }]\n";
    let keys = ["tunable = 'all'\n", &format!("{in_drive}'SERCOS'\n"), &format!("{in_drive}'PROFIDRIVE'\n"), ""];
    for (keys, after) in keys.into_iter().zip(["", "", "", slave]) {
        write(&folder, "set.toml", &(SET.replace("kopf", &format!("{keys}kopf")) + after));
        let run = tune(&folder, &["--apply", "first"]);
        assert!(run.code == 0 && !run.err.contains("AX506"), "{keys}{after}: {}{}", run.out, run.err);
        assert!(read(&folder, "set.toml").contains("enable = \"DRYRUN\""), "{keys}{after}");
    }
    write(&folder, "set.toml", &SET.replace("TRANSLATOR", "ROTATOR"));
    let run = tune(&folder, &[]);
    let said = "warning[AX506]: v_command is in um/s, and the axis of the set is a rotary axis or a spindle";
    assert!(run.code == 0 && run.err.contains(said), "{}{}", run.out, run.err);
}

#[test]
fn proposals_that_are_not_written() {
    let folder = folder(&[("moves.csv", &MOVES)]);
    let assert_kept = |code: i32, more: &[&str], part: &str| {
        let before = read(&folder, "set.toml");
        let run = tune(&folder, more);
        assert!(run.code == code && run.err.contains(part), "{more:?}: {}{}", run.out, run.err);
        assert_eq!(read(&folder, "set.toml"), before);
    };
    assert_kept(1, &["--apply", "strong"], "axis X: error[AX519]: there is no proposal strong; there are: first");
    assert_kept(2, &["--apply", "best"], "possible values: recommended, strong, cautious, first");
    assert_kept(2, &["--apply", "first", "--stage", "set"], "cannot be used with");
    write(&folder, "set.toml", &SET.replace("kopf.achs_nr = 1", "kopf.achs_nr = \"one\""));
    assert_kept(2, &["--apply", "first"], "error[");
    write(&folder, "set.toml", &SET.replace("kopf", "drive.response = \"vague.csv\"\nkopf"));
    write(&folder, "vague.csv", &drive(0.003, 0.3));
    assert_kept(1, &["--apply", "recommended"], "error[AX512]");
    // A list, and a set that has values of its own over it.
    let list = "kopf.achs_nr 1\nkenngr.achs_typ ACHSTYP_TRANSLATOR\ngetriebe[0].dynamik.vb_max 530000 # um/s\n\
        lr_param.improved_position_control.v_add_max_fact 1000\n";
    write(&folder, "x.lis", list);
    write(&folder, "set.toml", "cycle_time = \"1ms\"\n[axis.X]\nlist = \"x.lis\"\n");
    let part = "set.toml:3:8: error[AX525]: the axis X takes its values from `x.lis` and from keys";
    assert_kept(2, &["--apply", "first"], part);
    let of_list = ["tune", "x.lis", "--cycle-time", "1ms", "--recording", "moves.csv", "--apply", "first"];
    let run = axgen(&folder, &of_list);
    assert_eq!(run.code, 0, "{}{}", run.out, run.err);
    let written = read(&folder, "x.lis");
    let enable = written.contains("lr_param.improved_position_control.enable") && written.contains(" DRYRUN\n");
    assert!(written.starts_with(list) && enable, "{written}");
    let check = axgen(&folder, &["check", "x.lis", "--cycle-time", "1ms"]);
    assert_eq!(check.code, 0, "{}", check.err);
}

/// A dry run shows whether v_motor is what the block took: v_add_calculated is what its stages make of that.
#[test]
fn a_dry_run_shows_a_channel_that_is_late() {
    let mut columns = moves();
    // A DIRECT stage by its differences: a band-pass of 53 Hz, Q 10, weight 0.5, with bilinear coefficients.
    let [centre, width] = [(PI * 53.0 * CYCLE).tan(), (PI * 5.3 * CYCLE).tan()];
    let (square, width) = (centre * centre, (1.0 + centre * centre) * width);
    let (a0, a1, a2) = (square + width + 1.0, 2.0 * (square - 1.0), square - width + 1.0);
    let (mut x, mut y) = ([0.0; 2], [0.0; 2]);
    let calculated = |v: &f64| {
        let out = (width * (v - x[1]) - a1 * y[0] - a2 * y[1]) / a0;
        (x, y) = ([*v, x[0]], [out, y[0]]);
        -0.5 * out
    };
    columns[V_EXCITE] = columns[V_MOTOR].iter().map(calculated).collect();
    let text =
        |columns: &Columns| csv(columns, &[0, 1, 2, V_MOTOR, V_EXCITE, A_LOAD]).replace("v_excite", "v_add_calculated");
    let folder = folder(&[("moves.csv", &text(&columns)), ("drive.csv", &drive(0.003, 1e-3))]);
    let stage = STAGES.rsplit_once("[[axis").unwrap().0.replace("weight_fact_num = 3000", "weight_fact_num = 500");
    write(&folder, "set.toml", &format!("{SET}{stage}"));
    let run = tune(&folder, &["--response", "drive.csv", "--stage", "set"]);
    assert_eq!(run.code, 0, "{}{}", run.out, run.err);
    columns[V_MOTOR].insert(0, 0.0);
    columns[V_MOTOR].pop();
    write(&folder, "moves.csv", &text(&columns));
    let run = tune(&folder, &["--response", "drive.csv", "--stage", "set"]);
    assert!(run.code == 1 && run.err.contains("error[AX509]") && run.err.contains("is -1.0"), "{}{}", run.out, run.err);
}
