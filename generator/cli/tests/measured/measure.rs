//! `axgen measure`: recordings of the simulated demonstration plant, moved and excited, against the figures of an independent
//! simulation; and recordings with a defect each.

#![expect(
    clippy::cast_possible_truncation,
    clippy::cast_possible_wrap,
    clippy::cast_sign_loss,
    reason = "numbers of samples"
)]

use super::plant::{
    self, A_LOAD, CYCLE, Columns, Noise, OF_EXCITED, OF_MOVES, V_CMD, V_COMMAND, V_EXCITE, V_MOTOR, X_ACTUAL, excited,
    moves, number, recorded,
};
use crate::{Run, axgen};
use machine::Machine;
use machine::measure::fourier;
use machine::plant::DEMONSTRATION;
use machine::sequence::Sequence;
use serde_json::Value;
use std::f64::consts::{PI, TAU};
use std::{fmt::Write, fs, sync::LazyLock};

const NAMES: [&str; 7] = ["x_command [mm]", "x_actual [mm]", "v_command", "v_motor", "v_cmd", "v_excite", "a_load"];

static MOVES: LazyLock<Columns> = LazyLock::new(moves);
static EXCITED: LazyLock<Columns> = LazyLock::new(|| excited(4, 0.02));

fn csv(columns: &Columns, of: &[usize]) -> String {
    plant::csv(&NAMES, columns, of)
}

fn measure(text: &str, more: &[&str]) -> Run {
    let folder = tempfile::tempdir().unwrap();
    fs::write(folder.path().join("r.csv"), text).unwrap();
    axgen(&folder, &[&["measure", "r.csv"], more].concat())
}

fn vibration<'v>(json: &'v Value, channel: &str, when: &str, near: f64) -> &'v Value {
    let is_it = |of: &&Value| {
        of["channel"] == channel && of["when"] == when && (of["hz"].as_f64().unwrap() - near).abs() < 0.05 * near
    };
    let all = json["vibrations"].as_array().unwrap();
    all.iter().find(is_it).unwrap_or_else(|| panic!("no {near} Hz of {channel}, {when}: {:#}", json["vibrations"]))
}

#[test]
fn the_moves_of_the_demonstration_plant() {
    let text = csv(&MOVES, &OF_MOVES);
    let run = measure(&text, &["--json"]);
    assert_eq!(run.code, 0, "{}{}", run.out, run.err);
    assert_eq!(run.out, measure(&text, &["--json"]).out, "the same bytes twice");
    let json = run.json();
    for (at, unit) in [("x_command", "mm"), ("v_motor", "um/s"), ("a_load", "m/s^2")] {
        let channel = json["channels"].as_array().unwrap().iter().find(|channel| channel["name"] == at).unwrap();
        assert_eq!((number(channel, "interval_s"), channel["unit"].as_str().unwrap()), (1e-3, unit), "{channel}");
    }
    let kinds: Vec<&str> = json["segments"].as_array().unwrap().iter().map(|of| of["kind"].as_str().unwrap()).collect();
    let once = ["rest", "accelerating", "driving", "accelerating"];
    assert_eq!(kinds, [&once[..], &once[..], &["rest"]].concat());
    let forced = vibration(&json, "a_load", "driving", 53.0);
    assert!((number(forced, "hz") - 53.0).abs() < 0.05 && (number(forced, "amplitude") / 0.811 - 1.0).abs() < 0.02);
    assert!(forced["forced"] == true && forced["damping"].is_null() && forced["source"].is_null(), "{forced}");
    for (channel, hz, damping) in [("a_load", 0.02, 0.02), ("following_error", 0.05, 0.1)] {
        let mode = vibration(&json, channel, "ramps", 10.97);
        assert!((number(mode, "hz") - 10.97).abs() < hz && mode["forced"] == false, "{mode}");
        assert!((number(mode, "damping") / 0.0409 - 1.0).abs() < damping, "{mode}");
    }
    let offset = &json["offsets"][0];
    assert!(number(offset, "s").abs() < 0.3e-3 && offset["of"] == "x_actual", "{offset}");
    assert!(json["response"].is_null() && json["dead_time_s"].is_null());
    let report = measure(&text, &[]);
    assert!(report.out.contains("Hz  a_load after ramps") && report.err.contains("warning[AX514]"), "{}", report.out);
}

/// P of the demonstration plant from its answer to an impulse of the command, as a file without errors.
fn exact() -> String {
    let mut machine = DEMONSTRATION.without_mesh().at_rest();
    let answer = (0..8192).map(|n| machine.step(if n == 0 { 1.0 } else { 0.0 }).v_motor);
    let impulse: Vec<f64> = std::iter::once(0.0).chain(answer).collect();
    let mut text = "f [Hz],re,im\n".to_owned();
    for k in 1..1024_u32 {
        let hz = f64::from(k) * 0.2442;
        let [re, im] = fourier(&impulse, TAU * hz * CYCLE);
        writeln!(text, "{hz},{re},{im}").unwrap();
    }
    text
}

#[test]
fn the_response_of_the_demonstration_plant() {
    let folder = tempfile::tempdir().unwrap();
    let list = concat!(env!("CARGO_MANIFEST_DIR"), "/../../examples/rack-and-pinion.lis");
    let mut noisy = EXCITED.clone();
    let mut noise = Noise(7);
    noisy[V_MOTOR].iter_mut().for_each(|v| *v += 300.0 * noise.next());
    fs::write(folder.path().join("excited.csv"), csv(&noisy, &OF_EXCITED)).unwrap();
    fs::write(folder.path().join("moves.csv"), csv(&MOVES, &OF_MOVES)).unwrap();
    fs::write(folder.path().join("exact.csv"), exact()).unwrap();
    let run = axgen(&folder, &["measure", "excited.csv", "--response", "p.csv", "--picture", "p.svg", "--json"]);
    assert_eq!(run.code, 0, "{}{}", run.out, run.err);
    let json = run.json();
    assert!((number(&json, "dead_time_s") - 3e-3).abs() < 0.1e-3, "{}", json["dead_time_s"]);
    assert_eq!(json["verdicts"][0]["code"], "AX508");
    let lines = |key: &str| -> Vec<f64> {
        json["response"][key].as_array().unwrap().iter().map(|value| value.as_f64().unwrap()).collect()
    };
    let [hz, re, im, se] = ["hz", "re", "im", "se"].map(lines);
    for (at, size, degrees) in [(11.0, 0.8567, -26.54), (20.0, 1.0691, -29.74), (100.0, 0.9890, -105.07)] {
        let k = hz.iter().position(|hz| *hz >= at - 0.13).unwrap();
        assert!((re[k].hypot(im[k]) / size - 1.0).abs() < 0.05 && se[k] < 0.05, "{at} Hz: {} {}", re[k], im[k]);
        assert!((im[k].atan2(re[k]).to_degrees() - degrees).abs() < 3.0, "{at} Hz: {} {}", re[k], im[k]);
    }
    roxmltree::Document::parse(&fs::read_to_string(folder.path().join("p.svg")).unwrap()).unwrap();
    let ms = |response: &str| {
        let run = axgen(&folder, &["analyze", list, "--cycle-time", "1ms", "--response", response, "--json"]);
        assert_eq!(run.code, 0, "{}", run.err);
        let json = run.json();
        number(&json[0]["drives"][0], "ms")
    };
    let [measured, exact] = ["p.csv", "exact.csv"].map(ms);
    assert!((measured / exact - 1.0).abs() < 0.05, "{measured}, exact {exact}");
    // The second run replaces its own files, and nothing else.
    assert_eq!(axgen(&folder, &["measure", "excited.csv", "--response", "p.csv", "--picture", "p.svg"]).code, 0);
    assert_eq!(axgen(&folder, &["measure", "excited.csv", "--response", "exact.csv"]).code, 2);
    assert_eq!(axgen(&folder, &["measure", "excited.csv", "--response", "excited.csv"]).code, 2);
    // The teeth act on the motor.
    let run = axgen(&folder, &["measure", "moves.csv", "--excited", "excited.csv", "--json"]);
    assert_eq!(run.code, 0, "{}{}", run.out, run.err);
    let json = run.json();
    assert_eq!(vibration(&json, "a_load", "driving", 53.0)["source"], "motor");
    assert!(json["response"]["hz"].as_array().unwrap().len() > 900);
}

/// Without `v_excite` the command shows where the periods are.
#[test]
fn an_excitation_that_was_not_recorded() {
    let text = csv(&EXCITED, &[V_CMD, V_MOTOR]);
    let with = measure(&csv(&EXCITED, &OF_EXCITED), &["--json"]).json();
    let without = measure(&text, &["--excitation", "11x2", "--json"]).json();
    let at = |json: &Value| {
        let k = json["response"]["hz"].as_array().unwrap().iter().position(|hz| hz.as_f64().unwrap() >= 11.0).unwrap();
        ["re", "im"].map(|key| json["response"][key][k].as_f64().unwrap())
    };
    let ([a, b], [c, d]) = (at(&with), at(&without));
    assert!((a - c).hypot(b - d) < 0.01, "{a} {b}, {c} {d}");
    assert!(measure(&text, &["--excitation", "default", "--json"]).json()["response"].is_object());
    assert_eq!(measure(&text, &["--excitation", "10x2"]).code, 1);
}

/// The same column, some samples later, between two samples too.
fn later(values: &[f64], samples: f64) -> Vec<f64> {
    let at = |n: usize| {
        let place = n as f64 - samples;
        let near = place.round() as isize;
        let term = |k: isize| {
            let (x, value) = (place - k as f64, values[k.clamp(0, values.len() as isize - 1) as usize]);
            let sinc = if x == 0.0 { 1.0 } else { (PI * x).sin() / (PI * x) };
            value * sinc * (0.5 + 0.5 * (PI * x / 33.0).cos())
        };
        (near - 32..=near + 32).map(term).sum::<f64>()
    };
    (0..values.len()).map(at).collect()
}

/// A recording with one channel changed.
fn changed(columns: &Columns, at: usize, change: impl Fn(&[f64]) -> Vec<f64>) -> Columns {
    let mut columns = columns.clone();
    columns[at] = change(&columns[at]);
    columns
}

/// A command, its recording, the code that it gives, and its exit code.
fn assert_said(what: &str, text: &str, more: &[&str], expected: &str, code: i32) -> Run {
    let run = measure(text, more);
    assert!(run.err.contains(&format!("[{expected}]")), "{what}: {}{}", run.out, run.err);
    assert_eq!(run.code, code, "{what}: {}{}", run.out, run.err);
    run
}

#[test]
fn moves_with_a_defect() {
    let moves = csv(&MOVES, &OF_MOVES);
    let lines: Vec<&str> = moves.lines().collect();
    let rows = |keep: &dyn Fn(usize) -> bool| -> String {
        (0..lines.len()).filter(|n| *n == 0 || keep(*n)).map(|n| format!("{}\n", lines[n])).collect()
    };
    let of = |at, change: &dyn Fn(&[f64]) -> Vec<f64>| csv(&changed(&MOVES, at, change), &OF_MOVES);
    let scaled = |factor: f64| move |values: &[f64]| values.iter().map(|v| v * factor).collect::<Vec<f64>>();
    assert_said("at rest", &rows(&|n| n < 250), &[], "AX503", 1);
    assert_said("too short", &rows(&|n| n < 600), &[], "AX502", 1);
    let gap = assert_said("gap", &rows(&|n| !(900..910).contains(&n)), &[], "AX481", 1);
    assert!(gap.err.contains("missing: 10 of ") && gap.err.contains("the first before line 901"), "{}", gap.err);
    let timeless: String = moves.lines().map(|line| format!("{}\n", line.split_once(',').unwrap().1)).collect();
    assert_said("no time", &timeless, &[], "AX500", 1);
    assert_eq!(measure(&timeless, &["--cycle-time", "1ms", "--json"]).out, measure(&moves, &["--json"]).out);
    assert_eq!(measure(&moves, &["--cycle-time", "1ms", "--json"]).out, measure(&moves, &["--json"]).out);
    let other = assert_said("other times", &moves, &["--cycle-time", "2ms"], "AX011", 2);
    assert!(other.err.contains("2 ms contradicts the times of the recording, every 1 ms"), "{}", other.err);
    let timed = |name: &str, time: &dyn Fn(usize) -> String| -> String {
        let cell = |n| if n == 0 { name.to_owned() } else { time(n - 1) };
        lines.iter().enumerate().map(|(n, line)| format!("{},{}\n", cell(n), line.split_once(',').unwrap().1)).collect()
    };
    let uneven = |n: usize| format!("{:.4}", n as f64 + 0.4 * (n % 2) as f64);
    let said = assert_said("uneven", &timed("t [ms]", &uneven), &[], "AX501", 1);
    assert!(said.err.contains(" ms, unevenly at line 4, "), "{}", said.err);
    let jitters = |n: usize| format!("{:.1}", n as f64 + 0.6 * f64::from(u8::from(n % 7 == 4)));
    let said = assert_said("jitter", &timed("t [ms]", &jitters), &[], "AX501", 1);
    assert!(said.err.contains("if only the time stamps jitter, leave them out"), "{}", said.err);
    let clock = |n: usize| format!("00:00:{:06.3}", n as f64 * CYCLE);
    let said = assert_said("clock", &timed("time", &clock), &[], "AX500", 1);
    assert!(said.err.contains("a_load; the time `00:00:00.000` in line 2 is not a number\n"), "{}", said.err);
    assert_said("no sample", &rows(&|_| false), &[], "AX502", 1);
    let faster = |n: usize| format!("{:.1}", n as f64 + 0.2 * n.saturating_sub(3000) as f64);
    assert_said("faster", &timed("t [ms]", &faster), &[], "AX501", 1);
    // 100 ns since 1601, and since the first sample.
    let ticks = timed("time", &|n| (132_959_733_843_760_000 + 10_000 * n).to_string());
    assert_eq!(measure(&ticks, &["--json"]).out, measure(&moves, &["--json"]).out);
    assert_said("unit of the time", &timed("time", &|n| (10_000 * n).to_string()), &[], "AX528", 0);
    // A second column of times belongs to the columns on its right.
    let two = |(n, line): (usize, &&str)| {
        let (other, load) = line.rsplit_once(',').unwrap();
        if n == 0 { format!("{other},Zeit [ms],{load}\n") } else { format!("{other},{},{load}\n", 2 * n) }
    };
    let two = assert_said("two times", &lines.iter().enumerate().map(two).collect::<String>(), &[], "AX501", 1);
    assert!(two.err.contains("every 1 ms: a_load every 2 ms\n"), "{}", two.err);
    assert_said("mm/s", &of(V_MOTOR, &scaled(1e-3)), &[], "AX506", 1);
    assert_said("other sign", &of(V_MOTOR, &scaled(-1.0)), &[], "AX506", 1);
    let clipped = |values: &[f64]| values.iter().map(|v| v.clamp(-0.7, 0.7)).collect();
    assert_said("clipped", &of(A_LOAD, &clipped), &[], "AX505", 0);
    let late = assert_said("late", &of(X_ACTUAL, &|values| later(values, 3.0)), &[], "AX509", 0);
    assert!(late.out.contains("ms later than v_motor"), "{}", late.out);
    let difference = |pair: &[f64]| (pair[1] - pair[0]) * 1e6;
    let of_encoder =
        |_: &[f64]| MOVES[X_ACTUAL].windows(2).map(difference).fold(vec![0.0], |v, x| [v, vec![x]].concat());
    let encoder = measure(&of(V_MOTOR, &of_encoder), &[]);
    assert!(encoder.out.contains("-0.500 +-0.250 ms") && !encoder.err.contains("AX509"), "{}", encoder.out);
    let beat = |values: &[f64]| -> Vec<f64> {
        values.iter().enumerate().map(|(n, v)| v + 0.7 * (TAU * 71.0 * n as f64 * CYCLE).sin()).collect()
    };
    assert_said("competes", &of(A_LOAD, &beat), &[], "AX513", 0);
    let spike = |values: &[f64]| {
        let at = |n| if n == 2000 { -1000.0 } else { values[n] };
        (0..values.len()).map(at).collect::<Vec<f64>>()
    };
    let outlier = assert_said("outlier", &of(A_LOAD, &spike), &[], "AX527", 1);
    assert!(outlier.err.contains("a_load is more than 10 times all others: -1000 at 2.000 s"), "{}", outlier.err);
    assert_said("no command", &csv(&MOVES, &[V_MOTOR, A_LOAD]), &[], "AX515", 1);
    let acted = csv(&changed(&MOVES, V_EXCITE, |values| vec![5.0; values.len()]), &[V_COMMAND, V_EXCITE, V_MOTOR]);
    assert_said("stages", &acted.replace("v_excite", "v_add"), &[], "AX511", 0);
    assert_said("no excitation", &moves, &["--excitation", "default"], "AX510", 1);
    assert_said("nothing to write", &moves, &["--response", "p.csv"], "AX011", 2);
    assert_said("unknown column", &moves.replace("a_load", "sensor"), &[], "AX015", 2);
    let named = moves.replace("a_load", "sensor");
    assert_eq!(measure(&named, &["--map", "sensor=a_load", "--json"]).out, measure(&moves, &["--json"]).out);
    let german = moves.replace(',', ";").replace('.', ",");
    assert_eq!(measure(&german, &["--json"]).out, measure(&moves, &["--json"]).out);
    for wrong in [["--excitation", "6"], ["--excitation", "11x0"], ["--cycle-time", "1"]] {
        assert_eq!(measure(&moves, &wrong).code, 2, "{wrong:?}");
    }
}

#[test]
fn excitations_with_a_defect() {
    let of = |columns: &Columns| csv(columns, &OF_EXCITED);
    // A channel that is a whole cycle late cannot be seen: that is said, with its dead time.
    let late = |samples: f64| of(&changed(&EXCITED, V_MOTOR, |values| later(values, samples)));
    let whole = assert_said("a whole cycle", &late(1.0), &[], "AX508", 0);
    assert!(whole.err.contains("4 cycles") && whole.err.contains("looks the same"), "{}", whole.err);
    assert_said("between cycles", &late(0.4), &[], "AX507", 1);
    assert_said("below a cycle", &late(-2.5), &[], "AX507", 1);
    assert!(measure(&late(0.4), &["--json"]).json()["response"].is_null());
    assert_said("at rest", &of(&excited(4, 0.0)), &[], "AX504", 1);
    assert_said("three periods", &of(&excited(3, 0.02)), &[], "AX502", 1);
    let mut noise = Noise(3);
    let mut noisy = excited(4, 0.1);
    noisy[V_MOTOR].iter_mut().for_each(|v| *v += 8000.0 * noise.next());
    assert_said("noise", &of(&noisy), &[], "AX512", 0);
}

/// Two speeds: what follows the speed is an order.
#[test]
fn an_order_shows_at_two_speeds() {
    let [fast, slow] = [Sequence::DEMONSTRATION, Sequence { speed: 0.4, ..Sequence::DEMONSTRATION }]
        .map(|sequence| sequence.planned(CYCLE));
    let end = *fast.x.last().unwrap();
    let x: Vec<f64> = fast.x.iter().copied().chain(slow.x.iter().map(|x| x + end)).collect();
    let v = [fast.v, slow.v].concat();
    let json = measure(&csv(&recorded(&x, &v, &vec![0.0; x.len()]), &OF_MOVES), &["--json"]).json();
    for hz in [53.0, 40.0] {
        let line = vibration(&json, "a_load", "driving", hz);
        // One tooth of 10 mm: 100 in a metre, 0.1 in a millimetre.
        assert!((number(line, "order") - 0.1).abs() < 0.001, "{line}");
    }
}

/// Other sampling intervals: what is measured is the same.
#[test]
fn other_cycle_times() {
    let moves = csv(&MOVES, &OF_MOVES);
    let rows: Vec<&str> = moves.lines().collect();
    for step in [2, 4] {
        let text: String =
            (0..rows.len()).filter(|n| *n == 0 || (n - 1) % step == 0).map(|n| format!("{}\n", rows[n])).collect();
        let run = measure(&text, &["--json"]);
        assert_eq!(run.code, 0, "{step} ms: {}{}", run.out, run.err);
        let json = run.json();
        assert!((number(vibration(&json, "a_load", "driving", 53.0), "hz") - 53.0).abs() < 0.1, "{step} ms");
        assert!((number(vibration(&json, "a_load", "ramps", 10.97), "hz") - 10.97).abs() < 0.05, "{step} ms");
    }
    let parts = |values: &Vec<f64>| {
        let part = |n: usize, k: f64| values[n] + (values[n + 1] - values[n]) * k / 4.0;
        (0..values.len() - 1).flat_map(|n| [0.0, 1.0, 2.0, 3.0].map(|k| part(n, k))).collect::<Vec<f64>>()
    };
    let fine = MOVES.each_ref().map(parts);
    let text = csv(&fine, &OF_MOVES);
    let timeless: String = text.lines().map(|line| format!("{}\n", line.split_once(',').unwrap().1)).collect();
    let run = measure(&timeless, &["--cycle-time", "250us", "--json"]);
    assert_eq!(run.code, 0, "{}{}", run.out, run.err);
    assert!((number(vibration(&run.json(), "a_load", "ramps", 10.97), "hz") - 10.97).abs() < 0.05);
}

/// A degree of a rotary axis stands for a millimetre: all else is the same.
#[test]
fn a_rotary_axis() {
    let names =
        ["x_command [deg]", "x_actual [deg]", "v_command", "v_motor [0.001 deg/s]", "v_cmd", "v_excite", "a_load"];
    let run = measure(&plant::csv(&names, &MOVES, &OF_MOVES), &["--json"]);
    assert_eq!(run.code, 0, "{}{}", run.out, run.err);
    let json = run.json();
    let unit = |of: &str| {
        let channel = json["channels"].as_array().unwrap().iter().find(|channel| channel["name"] == of).unwrap();
        channel["unit"].as_str().unwrap().to_owned()
    };
    assert_eq!(["v_command", "v_motor", "x_actual"].map(unit), ["0.001 deg/s", "0.001 deg/s", "deg"]);
    assert!((number(vibration(&json, "following_error", "ramps", 10.97), "hz") - 10.97).abs() < 0.05);
}

/// At the speed at which the mesh rings in the band, its line repeats with the excitation.
#[test]
fn a_line_that_the_excitation_does_not_make() {
    let run = measure(&csv(&excited(8, 0.53), &OF_EXCITED), &["--json"]);
    let json = run.json();
    let has_code = json["verdicts"].as_array().unwrap().iter().any(|of| of["code"] == "AX526");
    assert!(run.code == 1 && has_code && json["response"].is_null(), "{:#}", json["verdicts"]);
    // An excitation that is not the sequence of a register, with stages on or off.
    let mut foreign = EXCITED.clone();
    let mut noise = Noise(5);
    foreign[V_CMD].iter_mut().for_each(|v| *v = 20_000.0 + 5000.0 * noise.next());
    assert_said("foreign", &csv(&foreign, &[V_CMD, V_MOTOR]), &["--excitation", "default"], "AX510", 1);
    // A peak at the edge of the spectrum.
    let edge = |values: &[f64]| -> Vec<f64> {
        values.iter().enumerate().map(|(n, v)| v + 3.0 * (TAU * 498.5 * n as f64 * CYCLE).sin()).collect()
    };
    assert_said("edge", &csv(&changed(&MOVES, A_LOAD, edge), &OF_MOVES), &[], "AX513", 0);
}
