//! Files that are read with a warning; the expected text is in `doubtful.txt`.

use super::plant::{complex, decibels, degrees, delay, lines, open_plant, velocity_loop};
use super::{COMMAND, CYCLE_TIME, read_text, said, table};
use generator::response_file::From;
use stability::{Band, Controller, Drive, Loop, Points};
use std::f64::consts::TAU;

fn parts(hz: &[f64], end: &str) -> String {
    let names = if end.is_empty() { "f [Hz];re;im" } else { "f [Hz];re;im;se" };
    table(names, hz, |hz| format!("{:.9};{:.9}{end}", velocity_loop(hz).re, velocity_loop(hz).im))
}

fn files() -> Vec<(&'static str, From, String)> {
    let p = velocity_loop;
    let exact = ";0.001";
    let every = |step: f64| (1..=250).map(|line| step * f64::from(line)).filter(|hz| *hz < 490.0).collect::<Vec<_>>();
    let without: Vec<f64> = lines().into_iter().filter(|hz| (*hz - 30.0).abs() > 0.1).collect();
    let from_zero = [vec![0.0], lines()].concat();
    let beyond = (1..=2000).map(|line| 0.5 * f64::from(line)).collect::<Vec<_>>();
    let slow = |hz: f64| delay(hz, 2e-3) / complex(1.0, TAU * hz / 20.0);
    let slow = table("f;re;im;se", &lines(), |hz| format!("{:.9};{:.9};0.001", slow(hz).re, slow(hz).im));
    let plant = table("f [Hz];re;im;se", &lines(), |hz| {
        let late = open_plant(hz) * delay(hz, 2e-3);
        format!("{:e};{:e};1e-5", late.re, late.im)
    });
    vec![
        ("nothing to say", COMMAND, parts(&lines(), exact)),
        ("no errors", COMMAND, parts(&lines(), "")),
        (
            "coherence without averages, low at f0",
            COMMAND,
            table("f [Hz];re;im;coherence", &lines(), |hz| {
                format!("{:.9};{:.9};{}", p(hz).re, p(hz).im, if (50.0..56.0).contains(&hz) { 0.5 } else { 0.9 })
            }),
        ),
        ("a line at 0 Hz", COMMAND, parts(&from_zero, exact)),
        ("lines beyond half the sampling frequency", COMMAND, parts(&beyond, exact)),
        ("one line missing", COMMAND, parts(&without, exact)),
        ("a coarse grid", COMMAND, parts(&every(2.0), exact)),
        ("a narrow resonance between two lines", COMMAND, resonant(1.0)),
        ("the same with lines that show it", COMMAND, resonant(0.1)),
        ("ends early", COMMAND, parts(&lines()[..300], exact)),
        (
            "units not stated",
            COMMAND,
            table("f;gain;phase;se [dB]", &lines(), |hz| format!("{:.9};{:.9};0.01", decibels(p(hz)), degrees(p(hz)))),
        ),
        (
            "slow lines that say nothing",
            COMMAND,
            table("f [Hz];re;im;se", &lines(), |hz| {
                format!("{:.9};{:.9};{}", p(hz).re, p(hz).im, if hz < 3.0 { 0.6 } else { 0.001 })
            }),
        ),
        ("as slow as a position loop", COMMAND, slow),
        ("a speed loop near -1", From::Current { kp: 3.8, tn: 0.02, delay: 2e-3 }, plant),
    ]
}

/// Lines of a drive with a resonance at 53 Hz, whose damping ratio is 0.005.
fn resonant(step: f64) -> String {
    let mode = |x: f64| complex(1.0 - x * x, 0.06 * x) / complex(1.0 - x * x, 0.01 * x);
    let hz: Vec<f64> = (1..2000).map(|line| step * f64::from(line)).filter(|hz| *hz < 490.0).collect();
    let of = |hz: f64| velocity_loop(hz) * mode(hz / 53.0);
    table("f [Hz];re;im;se", &hz, |hz| format!("{:.9};{:.9};0.001", of(hz).re, of(hz).im))
}

#[test]
fn each_doubt_is_said_once() {
    let all: Vec<(&str, String)> = files().into_iter().map(|(name, from, text)| (name, said(&text, from))).collect();
    let found: String = all.iter().map(|(name, said)| format!("> {name}\n{said}\n")).collect();
    assert!(!found.contains("error["), "{found}");
    transcript::equals(concat!(env!("CARGO_MANIFEST_DIR"), "/tests/response_file/doubtful.txt"), &found);
}

/// A loop with Kv 20/s keeps its margins if lines below 2.2 Hz are noise: a motor follows slow commands.
#[test]
fn noise_of_slow_lines_changes_no_margin() {
    let of = |noise: f64| {
        let text = table("f [Hz];re;im;se", &lines(), |hz| {
            let noise = if hz < 2.2 { noise } else { 0.0 };
            let p = velocity_loop(hz) + complex(1.5 * libm::sin(7.0 * hz), libm::cos(11.0 * hz)) * noise;
            format!("{:.9};{:.9};{}", p.re, p.im, 0.001 + noise)
        });
        let response = read_text(&text).unwrap().response;
        let stage = Box::new(|_| [complex(0.0, 0.0); 3]);
        let (bands, position_gain) = (vec![Band { centre: 53.0, width: 5.3 }], Some(20.0));
        let of =
            Controller { cycle_time: CYCLE_TIME, weight: [0.0; 3], stage, bands, position_gain, gain_in_drive: None };
        let drives = [Drive::Measured(&response)];
        Loop::new(&Points::new(of, &drives), drives[0]).margins().ms.expect("a stable loop")[0]
    };
    let [exact, noisy] = [of(0.0), of(1.0)];
    assert!(exact > 1.0 && (exact / noisy - 1.0).abs() < 0.01, "{exact} {noisy}");
}
