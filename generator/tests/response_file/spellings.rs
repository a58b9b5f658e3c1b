//! One response in the spellings of measuring programs and spreadsheets: the same lines and the same margins.

use super::plant::{complex, decibels, degrees, demonstration, lines, unwrapped, velocity_loop};
use super::{BANDS, COMMAND, CYCLE_TIME};
use generator::response_file::{Measured, read};
use stability::{Complex64, Controller, Drive, Loop, Points};
use std::f64::consts::{PI, TAU};

/// A file of lines that are written one by one.
fn written(p: &[Complex64], head: &str, end: &str, line: impl Fn(usize, f64, Complex64) -> String) -> Vec<u8> {
    let written = lines().into_iter().zip(p).enumerate().map(|(index, (hz, p))| line(index, hz, *p) + end);
    (head.to_owned() + end + &written.collect::<String>()).into_bytes()
}

fn comma(text: String) -> String {
    text.replace('.', ",")
}

fn wide(bytes: &[u8]) -> Vec<u8> {
    let text = String::from_utf8(bytes.to_vec()).unwrap();
    [0xff, 0xfe].into_iter().chain(text.encode_utf16().flat_map(u16::to_le_bytes)).collect()
}

/// ISO 8859-1.
fn narrow(bytes: &[u8]) -> Vec<u8> {
    String::from_utf8(bytes.to_vec()).unwrap().chars().map(|letter| u8::try_from(u32::from(letter)).unwrap()).collect()
}

/// The response at the lines, in each spelling.
fn spellings(p: &[Complex64]) -> Vec<(&'static str, Vec<u8>)> {
    let turns = unwrapped(p);
    let turn = |index: usize| turns[index];
    // Frequency, magnitude and phase, with the separator of the head; the third argument is the unwrapped phase.
    let polar = |head: &str, of: fn(f64, Complex64, f64) -> [f64; 3]| {
        let separator = [", ", ";", "\t"].into_iter().find(|separator| head.contains(separator)).unwrap();
        written(p, head, "\n", |index, hz, p| {
            of(hz, p, turn(index)).map(|value| format!("{value:.12}")).join(separator)
        })
    };
    macro_rules! file {
        ($($argument:expr),*) => { written(p, $($argument),*) };
    }
    let german = file!("Frequenz [Hz];Betrag [dB];Phase [°]", "\r\n", |_, hz, p| {
        comma(format!("{hz};{:.9};{:.9}", decibels(p), degrees(p)))
    });
    vec![
        ("plain", file!("f [Hz],re,im", "\n", |_, hz, p| format!("{hz},{:.12},{:.12}", p.re, p.im))),
        ("BOM, CRLF", file!("\u{feff}frequency,real,imag", "\r\n", |_, hz, p| format!("{hz:e},{:e},{:e}", p.re, p.im))),
        ("German, ISO 8859-1", narrow(&german)),
        ("German, UTF-16", wide(&german)),
        ("dB and degrees, wrapped", polar("Freq\tMag (dB)\tPhase (deg)", |hz, p, _| [hz, decibels(p), degrees(p)])),
        ("degrees, unwrapped", polar("f [Hz];gain [dB];phase [deg]", |hz, p, t| [hz, decibels(p), t.to_degrees()])),
        ("radians, unwrapped, factor", polar("\"f / Hz\", \"|P|\", \"phase / rad\"", |hz, p, t| [hz, p.norm(), t])),
        ("units not stated", polar("w_rad_s;gain;phase", |hz, p, _| [TAU * hz, decibels(p), degrees(p)])),
        (
            "rad/s, blanks",
            file!("omega [rad/s]  magnitude  phase [rad]", "\n", |_, hz, p| {
                format!("  {:.12}   {:.12}  {:.12}", TAU * hz, p.norm(), p.arg())
            }),
        ),
        (
            "kHz, other order, other columns",
            file!("Time;Realteil;Imaginärteil;Frequenz in kHz;note", "\n", |_, hz, p| {
                format!("0;{:.12};{:.12};{:.6};x", p.re, p.im, hz / 1000.0)
            }),
        ),
        (
            "a line of units, a preamble, a decimal comma",
            file!("Axis X, 2026-11-24\nAverages 20\n\nf\tAmplitude\tPhase\n[Hz]\t[dB]\t[rad]", "\n", |_, hz, p| {
                comma(format!("{hz}\t{:.9}\t{:.9}\t", decibels(p), p.arg()))
            }),
        ),
        (
            "names in a comment",
            file!("% exported by a script\n# freq_hz, mag_db, phase_deg", "\n", |_, hz, p| {
                format!("{hz} {:.9} {:.9}", decibels(p), degrees(p))
            }),
        ),
        (
            "quoted decimal commas, comments between",
            file!("// f, re, im\nf,re,im\n; lines", "\n", |index, hz, p| {
                let comment = if index == 5 { "# weak\n\n" } else { "" };
                comment.to_owned() + &comma(format!("\"{hz}\",\"{:.12}\",\"{:.12}\"", p.re, p.im))
            }),
        ),
    ]
}

/// Two band-passes, in the variable t = tan(pi f T).
fn stages(t: f64) -> [Complex64; stability::STAGES] {
    let band_pass = |f0: f64, width: f64| {
        let centre = (PI * f0 * CYCLE_TIME).tan();
        let part = complex(0.0, t * centre * width / f0);
        part / (part + complex(centre * centre - t * t, 0.0))
    };
    let [a, b] = BANDS.map(|band| band_pass(band.f0, band.width));
    [-a, b * complex(0.8, 0.0), complex(0.0, 0.0)]
}

/// Ms, gain and phase margin, largest weights.
fn margins(measured: &Measured) -> Vec<f64> {
    let bands = BANDS.map(|band| stability::Band { centre: band.f0, width: band.width });
    let controller = Controller {
        cycle_time: CYCLE_TIME,
        weight: [1.0, 0.5, 0.0],
        stage: Box::new(stages),
        bands: bands.to_vec(),
        position_gain: None,
        gain_in_drive: None,
    };
    let points = Points::new(controller, &[Drive::Measured(&measured.response)]);
    let closed = Loop::new(&points, Drive::Measured(&measured.response));
    assert!(closed.is_stable());
    let margins = closed.margins();
    // An unlimited margin must be unlimited in every spelling.
    let [gain, phase] = [margins.gain_db, margins.phase_deg].map(|margin| margin.unwrap_or(f64::MAX));
    let ms = margins.ms.unwrap()[0];
    [vec![ms, gain, phase], [0, 1].map(|stage| closed.largest_weights(stage)).concat()].concat()
}

fn is_the_same_in_every_spelling(expected: &[Complex64]) {
    let mut first: Option<Vec<f64>> = None;
    for (name, bytes) in spellings(expected) {
        let measured =
            read("p.csv", &bytes, COMMAND, CYCLE_TIME, &BANDS).unwrap_or_else(|report| panic!("{name}: {report}"));
        assert_eq!(measured.lines, expected.len(), "{name}");
        assert!(!measured.has_errors, "{name}");
        for (hz, expected) in lines().into_iter().zip(expected) {
            let error = (measured.response.value(hz) - expected).norm();
            assert!(error < 1e-6, "{name}: {error:e} at {hz} Hz");
        }
        let found = margins(&measured);
        let first = first.get_or_insert_with(|| found.clone());
        for (found, first) in found.iter().zip(&*first) {
            assert!((found / first - 1.0).abs() < 1e-3, "{name}: {found}, {first}");
        }
    }
}

#[test]
fn every_spelling_is_the_same_response() {
    is_the_same_in_every_spelling(&lines().into_iter().map(velocity_loop).collect::<Vec<_>>());
}

/// Magnitude and phase [degrees] of the demonstration plant, by an independent simulation of it.
pub(crate) const DEMONSTRATION: [(f64, f64, f64); 6] = [
    (5.0, 1.0335, -5.58),
    (11.0, 0.8567, -26.54),
    (20.0, 1.0691, -29.74),
    (47.0, 0.3279, -83.21),
    (53.0, 0.4349, -33.46),
    (100.0, 0.9890, -105.07),
];

#[test]
fn every_spelling_is_the_demonstration_plant() {
    let p = demonstration();
    for (hz, magnitude, phase) in DEMONSTRATION {
        let at = lines().iter().position(|line| (*line - hz).abs() < 1e-9).unwrap();
        let error = (p[at] / Complex64::from_polar(magnitude, phase.to_radians()) - 1.0).norm();
        assert!(error < 2e-3, "{hz} Hz: {} for {magnitude}, {} deg for {phase}", p[at].norm(), degrees(p[at]));
    }
    is_the_same_in_every_spelling(&p);
}

/// 1.5 cycles were put in. A time constant that is not sampled counts for a part of a cycle more.
#[test]
fn the_dead_time_is_found() {
    let (_, bytes) = spellings(&lines().into_iter().map(velocity_loop).collect::<Vec<_>>()).swap_remove(0);
    let measured = read("p.csv", &bytes, COMMAND, CYCLE_TIME, &BANDS).unwrap();
    let cycles = measured.dead_time.unwrap() / CYCLE_TIME;
    assert!((1.45..2.1).contains(&cycles), "{cycles}");
}
