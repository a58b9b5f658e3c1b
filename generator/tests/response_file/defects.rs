//! Defective files, each with all that is said about it; the expected text is in `defects.txt`.

use super::plant::{complex, decibels, degrees, lines, open_plant, velocity_loop};
use super::{COMMAND, said, table};
use generator::response_file::From;
use stability::Complex64;
use std::f64::consts::TAU;

const OPEN: From = From::Current { kp: 2.0, tn: 0.02, delay: 2e-3 };

fn parts(hz: &[f64], of: impl Fn(f64) -> Complex64) -> String {
    table("f [Hz];re;im", hz, |hz| format!("{:.9};{:.9}", of(hz).re, of(hz).im))
}

/// Magnitude and phase as these names say, made of a response.
fn polar(names: &str, of: impl Fn(f64) -> [f64; 2]) -> String {
    table(names, &lines(), |hz| format!("{:.9};{:.9}", of(hz)[0], of(hz)[1]))
}

/// Magnitude [dB] and phase [deg].
fn db(hz: f64) -> [f64; 2] {
    [decibels(velocity_loop(hz)), degrees(velocity_loop(hz))]
}

const DB: &str = "f [Hz];magnitude [dB];phase [deg]";

/// The response with another line instead of one.
fn with_line(line: usize, text: &str) -> String {
    let whole = parts(&lines(), velocity_loop);
    let changed = whole.lines().enumerate().map(|(index, old)| if index + 1 == line { text } else { old });
    changed.collect::<Vec<_>>().join("\n")
}

fn with_column(name: &str, of: impl Fn(f64) -> f64) -> String {
    let p = velocity_loop;
    table(&format!("f [Hz];re;im;{name}"), &lines(), |hz| format!("{:.9};{:.9};{}", p(hz).re, p(hz).im, of(hz)))
}

/// With a coherence and 20 averages.
fn with_coherence(of: impl Fn(f64) -> f64) -> String {
    format!("# averages: 20\n{}", with_column("coherence", of))
}

fn only(is_kept: impl Fn(f64) -> bool) -> String {
    let lines: Vec<f64> = lines().into_iter().filter(|hz| is_kept(*hz)).collect();
    parts(&lines, velocity_loop)
}

fn of_the_table() -> Vec<(&'static str, String)> {
    let p = velocity_loop;
    let number = |hz: f64| format!("{:.6};{:.6}", p(hz).re, p(hz).im);
    let half = |hz: f64, from: f64| if hz < from { "---;---".to_owned() } else { number(hz) };
    vec![
        ("nothing", String::new()),
        ("a binary file", "\0\u{1}PK".to_owned()),
        ("no names", only(|_| true).lines().skip(1).collect::<Vec<_>>().join("\n")),
        ("half of the lines without numbers", table("f [Hz];re;im", &lines(), |hz| half(hz, 130.0))),
        ("no phase", table("f [Hz];magnitude [dB];coherence", &lines(), |hz| format!("{:.6};1", decibels(p(hz))))),
        ("no frequency", table("time [s];re;im", &lines(), number)),
        ("two magnitudes", table("f [Hz];Amplitude Ch1;Amplitude Ch2;phase [deg]", &lines(), |_| "1;1;1".to_owned())),
        ("decimal commas between commas", "f,re,im\n1,5,0,99,-0,1\n2,5,0,98,-0,1\n3,5,0,97,-0,1\n".to_owned()),
        ("a unit that no frequency has", polar("f [rpm];magnitude [dB];phase [deg]", db)),
        ("NaN", with_line(5, "1;NaN;-0.1")),
        ("an empty cell", with_line(5, "1;;-0.1")),
        ("a magnitude of 0", with_line(5, "1;0;0")),
        ("coherence above 1", with_coherence(|hz| if hz > 249.9 { 1.2 } else { 0.99 })),
        ("negative coherence", with_coherence(|hz| if hz > 249.9 { -0.1 } else { 0.99 })),
        ("negative standard error", with_column("se", |hz| if hz > 249.9 { -1.0 } else { 0.0 })),
    ]
}

fn of_the_lines() -> Vec<(&'static str, String)> {
    let mut falling = lines();
    falling.reverse();
    let twice = [lines(), lines()].concat();
    let coarse: Vec<f64> = (1..=40).map(|line| 6.25 * f64::from(line)).collect();
    vec![
        ("falling", parts(&falling, velocity_loop)),
        ("two measurements in one file", parts(&twice, velocity_loop)),
        ("a frequency twice", with_line(5, "0.75;1;-0.1")),
        ("two-sided", with_line(2, "-0.25;1;0.1")),
        ("a gap where lines were weak", only(|hz| !(44.0..49.0).contains(&hz))),
        ("too few lines", only(|hz| hz % 50.0 < 0.1 && hz > 1.0 || (hz - 1.0).abs() < 0.1)),
        ("too short above", only(|hz| hz < 40.0)),
        ("too short below", only(|hz| hz > 20.0)),
        ("coarser than a stage", parts(&coarse, velocity_loop)),
        ("coherence low at f0", with_coherence(|hz| if (52.0..54.0).contains(&hz) { 0.2 } else { 0.99 })),
    ]
}

fn of_the_meaning() -> Vec<(&'static str, String)> {
    let p = velocity_loop;
    let short =
        table("f [Hz];magnitude [dB];phase", &lines()[..150], |hz| db(hz).map(|of| format!("{of:.6}")).join(";"));
    let turned = |by: f64| move |hz: f64| p(hz) * complex(by, 0.0);
    vec![
        ("dB given as a factor", polar("f [Hz];magnitude [1];phase [deg]", db)),
        ("a factor given as dB", polar(DB, |hz| [p(hz).norm(), degrees(p(hz))])),
        ("radians given as degrees", polar(DB, |hz| [decibels(p(hz)), p(hz).arg()])),
        ("degrees given as radians", polar("f [Hz];magnitude [dB];phase [rad]", db)),
        ("a lag counted as positive", polar(DB, |hz| [db(hz)[0], -db(hz)[1]])),
        ("the imaginary part with the other sign", parts(&lines(), |hz| p(hz).conj())),
        ("no unit, and a range too short to show it", short),
        ("a position", parts(&lines(), |hz| p(hz) / complex(0.0, TAU * hz))),
        ("the open plant without Kp and Tn", parts(&lines(), open_plant)),
        ("a control deviation", parts(&lines(), |hz| complex(1.0, 0.0) - p(hz))),
        ("rpm over rad/s", parts(&lines(), turned(60.0 / TAU))),
        ("a gear of 5", parts(&lines(), turned(0.2))),
        ("a motor that turns the other way", parts(&lines(), turned(-1.0))),
        ("measured in the drive", parts(&lines(), |hz| p(hz) / super::plant::delay(hz, 1.4e-3))),
    ]
}

fn of_the_open_plant() -> Vec<(&'static str, String)> {
    let of = |from, text: String| said(&text, from);
    let closed = parts(&lines(), velocity_loop);
    let other = From::Current { kp: 2.0 * TAU / 60.0, tn: 0.02, delay: 2e-3 };
    let ends = From::Current { kp: 60.0, tn: 0.02, delay: 2e-3 };
    let near = From::Current { kp: 4.3, tn: 0.02, delay: 2e-3 };
    let late = parts(&lines(), |hz| open_plant(hz) * super::plant::delay(hz, 2e-3));
    let without = From::Current { kp: 2.0, tn: 0.02, delay: 0.0 };
    vec![
        ("a closed loop with Kp and Tn", of(OPEN, closed)),
        ("Kp in another unit", of(other, parts(&lines()[29..], open_plant))),
        ("lines end before the crossover", of(ends, parts(&lines(), open_plant))),
        ("a speed loop that oscillates", of(near, late)),
        ("no delay between CNC and drive", of(without, parts(&lines(), open_plant))),
    ]
}

#[test]
fn each_defect_gets_its_verdict() {
    let files = [of_the_table(), of_the_lines(), of_the_meaning()].concat();
    let read = files.into_iter().map(|(name, text)| (name, said(&text, COMMAND)));
    let all: Vec<(&str, String)> = read.chain(of_the_open_plant()).collect();
    let found: String = all.iter().map(|(name, said)| format!("> {name}\n{said}\n")).collect();
    assert!(all.iter().all(|(_, said)| said.contains("error[")), "{found}");
    transcript::equals(concat!(env!("CARGO_MANIFEST_DIR"), "/tests/response_file/defects.txt"), &found);
}
