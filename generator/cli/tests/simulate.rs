//! `axgen simulate`: the table of the demonstration plant with the shipped example, a drive whose ripple answers as
//! its analysis says, a measured response as a machine, and loops that oscillate.

use crate::{EXAMPLES, words};
use std::{fs, path::Path};
use tempfile::TempDir;

/// The exit code and what was printed.
fn simulate(at: &Path, arguments: &str) -> (i32, String) {
    simulate_set(at, &format!("example.lis --cycle-time 1ms {arguments}"))
}

fn simulate_set(at: &Path, arguments: &str) -> (i32, String) {
    let (code, out, _) = words(at, &format!("simulate {arguments}"));
    (code, out)
}

/// The shipped example, with another damping of its INDIRECT stage.
pub fn with_damping(damping: &str) -> String {
    let text = fs::read_to_string(Path::new(EXAMPLES).join("rack-and-pinion.lis")).unwrap();
    let line = |value: &str| format!("stage[1].filter.damping    {value}\n");
    assert_eq!(text.matches(&line("0.8")).count(), 1);
    text.replace(&line("0.8"), &line(damping))
}

fn example(damping: &str) -> TempDir {
    let folder = tempfile::tempdir().unwrap();
    fs::write(folder.path().join("example.lis"), with_damping(damping)).unwrap();
    folder
}

pub fn row(text: &str, name: &str) -> Vec<f64> {
    let row = text.lines().find_map(|line| line.trim_start().strip_prefix(name).filter(|rest| rest.starts_with(' ')));
    let row = row.unwrap_or_else(|| panic!("no row {name}: {text}"));
    row.split_whitespace().map(|cell| cell.parse().unwrap_or_else(|_| panic!("{name}: {cell}"))).collect()
}

fn assert_near(what: &str, found: f64, expected: f64, tolerance: f64) {
    assert!((found / expected - 1.0).abs() <= tolerance, "{what}: {found}, {expected} expected");
}

#[test]
fn the_demonstration_plant_gives_its_table() {
    let folder = example("0.8");
    let (code, text) = simulate(folder.path(), "--plant demonstration");
    assert_eq!(code, 0, "{text}");
    // 53 Hz, 11 Hz, ring-down, Ms
    let rows = [
        ("off", [0.810, 0.518, 0.869, 1.11]),
        ("stage 0 alone", [0.361, 0.514, 0.879, 1.50]),
        ("stage 1 alone", [0.833, 0.166, 0.325, 1.99]),
        ("all", [0.366, 0.168, 0.334, 1.95]),
    ];
    for (name, expected) in rows {
        let found = row(&text, name);
        for (column, expected) in [0, 1, 2, 5].into_iter().zip(expected) {
            assert_near(&format!("{name}, column {column}"), found[column], expected, 0.02);
        }
    }
    // The definition's following errors, 0.70 and 2.31 mm, are of a command that is not ahead by a cycle, its table is not
    // (tests/tests/plant.rs).
    assert_near("following error off", row(&text, "off")[3], 0.70, 0.12);
    assert_near("following error", row(&text, "stage 1 alone")[3], 2.31, 0.06);
}

#[test]
fn little_damping_is_unstable() {
    let (code, text) = simulate(example("0.2").path(), "--plant demonstration");
    assert_eq!(code, 1, "{text}");
    assert!(text.contains("the loop is unstable") && text.contains("unstable\n"), "{text}");
}

/// A stage with the input `v_direct` closes the loop, too: a drive without mechanics has one velocity. Of the plant it is not
/// known whether it is stable.
#[test]
fn a_stage_at_the_load_is_judged() {
    let folder = tempfile::tempdir().unwrap();
    let set = |weight: u32| {
        format!(
            "cycle_time = \"1ms\"\n[axis.X]\nkopf.achs_nr = 1\ngetriebe = [{{ dynamik.vb_max = 530000, kv = 2000 }}]\n\
             [axis.X.lr_param.improved_position_control]\nenable = \"ON\"\nv_add_max_fact = 100\n\
             stage = [{{ mode = \"DIRECT\", direct_source = \"v_direct\", weight_fact_num = {weight}, weight_fact_denom = 100, \
             filter = [{{ fg_f0 = 60, q_factor = 1, order = 3 }}] }}]\n"
        )
    };
    for (weight, options, expected) in [
        (300, "--delay 1.5", "all: v_add at its limit for 2.5 s: the loop is unstable"),
        (30, "--delay 1.5", ""),
        (300, "--plant demonstration", "all: whether the loop is stable is not known: a stage has the input v_direct"),
    ] {
        fs::write(folder.path().join("set.toml"), set(weight)).unwrap();
        let (code, text) = simulate_set(folder.path(), &format!("set.toml {options}"));
        let remark = text.lines().skip(1).find(|line| line.starts_with("all:")).unwrap_or_default();
        assert_eq!((code, remark), (i32::from(!expected.is_empty()), expected), "{text}");
    }
    fs::write(folder.path().join("set.toml"), set(300)).unwrap();
    fs::write(folder.path().join("p.nc"), "N10 G01 X500 F20000\nN20 G04 X2\nM30\n").unwrap();
    let (code, out, _) = words(folder.path(), "scenario set.toml p.nc --stimulus s.csv --delay 1.5");
    assert!(code == 1 && out.contains("the loop is unstable"), "{out}");
}

/// A ripple that no command asked for becomes |S| times as large.
#[test]
fn a_drive_answers_a_ripple_as_its_sensitivity_says() {
    let folder = example("0.8");
    let (code, text) = simulate(folder.path(), "--delay 2");
    assert_eq!(code, 0, "{text}");
    let [off, all] = ["off", "all"].map(|name| row(&text, name));
    assert_near("11 Hz off", off[1], off_at(11.0), 0.02);
    assert_near("53 Hz off", off[0], off_at(53.0), 0.02);
    assert!(all[0] < 0.5 * off[0] && all[1] < 0.5 * off[1], "{text}");
}

/// |S| of the position loop alone: Kv 20/s, two cycles of delay at 1 ms.
fn off_at(hz: f64) -> f64 {
    let w = std::f64::consts::TAU * hz * 1e-3;
    // L = Kv T / (1 - z^-1) z^-2: the position is the sum of the velocities up to the same cycle.
    let gain = 20.0 * 1e-3 / (2.0 * (w / 2.0).sin());
    let angle = -2.0 * w + w / 2.0 - std::f64::consts::FRAC_PI_2;
    1.0 / (1.0 + gain * angle.cos()).hypot(gain * angle.sin())
}

/// A response that is a delay of two cycles and a time constant of 3 ms: the same as the drive with these numbers.
#[test]
fn a_response_drives_as_what_it_was_measured_on() {
    let folder = example("0.8");
    let e = (-1.0_f64 / 3.0).exp();
    let line = |k: u32, cycles: f64| {
        let hz = f64::from(k) * 0.25;
        let w = std::f64::consts::TAU * hz * 1e-3;
        let (re, im) = (1.0 - e * w.cos(), e * w.sin());
        format!("{hz},{},{}\n", (1.0 - e) / re.hypot(im), (-cycles * w - im.atan2(re)).to_degrees())
    };
    for (file, cycles) in [("p.csv", 2.0), ("without_bus.csv", 0.0)] {
        let lines: String = (1..2000).map(|k| line(k, cycles)).collect();
        fs::write(folder.path().join(file), format!("f [Hz],magnitude,phase [deg]\n{lines}")).unwrap();
    }
    let (code, measured) = simulate(folder.path(), "--response p.csv");
    assert_eq!(code, 0, "{measured}");
    let deviation = measured.lines().find_map(|line| line.strip_prefix("its filter differs from the response by "));
    assert!(deviation.unwrap().split(' ').next().unwrap().parse::<f64>().unwrap() < 1.0, "{measured}");
    // The plant takes the place of the drive that a set states: nothing is said of its response.
    let set = "cycle_time = \"1ms\"\n[axis.X]\nlist = \"example.lis\"\ndrive.response = \"p.csv\"\n";
    fs::write(folder.path().join("set.toml"), set).unwrap();
    let (code, plant) = simulate_set(folder.path(), "set.toml --plant demonstration");
    assert!(code == 0 && !plant.contains("its filter differs"), "{plant}");
    // Kv is not given: it is assumed in the drive too, whose position loop does not contain the delay.
    let in_drive = |of: &str| {
        let keys =
            format!("kenngr.antr_typ = 2\nprocess_data.additive_velocity = 'INT32'\ndrive = {{ delay = 2, {of} }}");
        fs::write(folder.path().join("set.toml"), set.replace("drive.response = \"p.csv\"", &keys)).unwrap();
        simulate_set(folder.path(), "set.toml").1
    };
    let own = ["response = 'without_bus.csv'", "time_constant = '3ms'"].map(in_drive);
    let stated = simulate(folder.path(), "--delay 2 --time-constant 3ms").1;
    // The two models of its loop differ by a part of a cycle in how long they hold the command.
    for ([measured, stated], part) in [([measured, stated], 0.01), (own, 0.02)] {
        for name in ["off", "stage 0 alone", "stage 1 alone", "all"] {
            for (found, expected) in row(&measured, name).into_iter().zip(row(&stated, name)) {
                assert!((found - expected).abs() <= part * expected + 0.02, "{name}: {measured}{stated}");
            }
        }
    }
}

#[test]
fn files_are_written_and_kept() {
    let folder = example("0.8");
    let at = folder.path();
    for _ in 0..2 {
        assert_eq!(simulate(at, "--csv s.csv --picture s.svg").0, 0);
    }
    let csv = fs::read_to_string(at.join("s.csv")).unwrap();
    assert!(csv.lines().count() > 4000 && csv.lines().all(|line| line.split(',').count() == 9));
    roxmltree::Document::parse(&fs::read_to_string(at.join("s.svg")).unwrap()).unwrap();
    assert_eq!(simulate(at, "--csv s.svg").0, 2, "a picture is no earlier CSV file");
    assert_eq!(simulate(at, "--dwell 0.1s").0, 2);
}
