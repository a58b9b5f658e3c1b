//! What the standard errors are: of coherence and averages against simulated measurements, of columns by their units, of the closed speed loop.

use super::plant::{complex, delay, lines, open_plant, velocity_loop};
use super::{BANDS, CYCLE_TIME, read_text, table};
use generator::response_file::{From, read};
use stability::Complex64;
use std::f64::consts::TAU;

/// Numbers of a normal distribution with variance 1, the same on every run.
struct Noise(u64);

impl Noise {
    fn uniform(&mut self) -> f64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        f64::from(u32::try_from(self.0 >> 33).unwrap()) / f64::from(1u32 << 31)
    }

    fn complex(&mut self) -> Complex64 {
        let size = (-(1.0 - self.uniform()).ln()).sqrt();
        Complex64::from_polar(size, TAU * self.uniform())
    }
}

/// A measurement with noise on the output: H1 of n averages and its coherence.
fn measured(p: Complex64, noise: f64, averages: u32, random: &mut Noise) -> (Complex64, f64) {
    let (mut xy, mut xx, mut yy) = (complex(0.0, 0.0), 0.0, 0.0);
    for _ in 0..averages {
        let x = random.complex();
        let y = p * x + random.complex() * noise;
        (xy, xx, yy) = (xy + x.conj() * y, xx + x.norm_sqr(), yy + y.norm_sqr());
    }
    (xy / xx, xy.norm_sqr() / (xx * yy))
}

/// sqrt((1 - k)/(2 n k)) is the standard error of the magnitude and of the phase: of a thousand lines as many lie within one, two and three of it
/// as of a normal distribution.
#[test]
fn coherence_and_averages_give_the_standard_error() {
    let random = Noise(1);
    let mut outside = [0.0; 3];
    let text = table("f [Hz];re;im;coherence;averages", &lines(), |hz| {
        let (found, coherence) =
            measured(velocity_loop(hz), 0.2 * velocity_loop(hz).norm(), 50, &mut random.clone_for(hz));
        format!("{:.12};{:.12};{coherence:.12};50", found.re, found.im)
    });
    let measured = read_text(&text).unwrap_or_else(|report| panic!("{report}"));
    assert!(measured.has_errors);
    for hz in lines() {
        let error = measured.response.value(hz).norm() / velocity_loop(hz).norm() - 1.0;
        let ratio = error.abs() / measured.response.relative_error(hz);
        for (sigma, count) in [1.0, 2.0, 3.0].iter().zip(&mut outside) {
            *count += if ratio > *sigma { 1.0 / 1000.0 } else { 0.0 };
        }
    }
    // A binomial of 1000 lines is within four of its standard deviations.
    for (found, expected) in outside.iter().zip([0.3173, 0.0455, 0.0027]) {
        let deviation = (expected * (1.0 - expected) / 1000.0_f64).sqrt();
        assert!((found - expected).abs() < 4.0 * deviation + 0.004, "{outside:?}");
    }
}

impl Noise {
    /// Its own numbers for each line.
    fn clone_for(&self, hz: f64) -> Self {
        let mut own = Self(self.0 ^ hz.to_bits());
        (0..8).for_each(|_| {
            own.uniform();
        });
        own
    }
}

/// What stands above the table, the name of the column, what is written at a frequency, the relative error that is read.
type Case<'a> = (&'a str, &'a str, &'a dyn Fn(f64) -> f64, f64);

/// The same error in the units that a column may have, and from a comment.
#[test]
fn units_of_the_standard_error() {
    let relative = 0.02;
    let size = |hz: f64| velocity_loop(hz).norm();
    let (k, n) = (0.9, 20.0);
    let of_coherence = ((1.0_f64 - k) / (2.0 * n * k)).sqrt();
    let cases: [Case<'_>; 6] = [
        ("", "se", &|hz| relative * size(hz), relative),
        ("", "Standardfehler [dB]", &|_| relative * 20.0 / 10.0_f64.ln(), relative),
        ("", "stderr (%)", &|_| 100.0 * relative, relative),
        ("# 20 averages\n", "coherence", &|_| k, of_coherence),
        ("Mittelungen;20\n", "Kohärenz [%]", &|_| 100.0 * k, of_coherence),
        ("", "gamma^2", &|_| k, 0.0),
    ];
    for (before, name, written, expected) in cases {
        let text = table(&format!("f [Hz];re;im;{name}"), &lines(), |hz| {
            format!("{:.12};{:.12};{:.12}", velocity_loop(hz).re, velocity_loop(hz).im, written(hz))
        });
        let measured = read_text(&(before.to_owned() + &text)).unwrap_or_else(|report| panic!("{name}: {report}"));
        assert_eq!(measured.has_errors, expected > 0.0, "{name}");
        for hz in [0.5, 11.0, 53.0, 250.0] {
            let found = measured.response.relative_error(hz);
            assert!((found - expected).abs() < 1e-9, "{name}: {found} at {hz} Hz, expected {expected}");
        }
    }
}

/// The closed speed loop and its error, against the loop closed with a plant that is moved by a small part.
#[test]
fn the_speed_loop_is_closed() {
    let (kp, tn, wait) = (2.0, 0.02, 2e-3);
    let closed = |hz: f64, factor: f64| {
        let open = open_plant(hz) * factor * kp * (1.0 + 1.0 / complex(0.0, TAU * hz * tn));
        open / (1.0 + open) * delay(hz, wait)
    };
    let text = table("f [Hz];magnitude;phase [rad];se [%]", &lines(), |hz| {
        format!("{:.12};{:.12};1", open_plant(hz).norm(), open_plant(hz).arg())
    });
    let from = From::Current { kp, tn, delay: wait };
    let measured = read("p.csv", text.as_bytes(), from, CYCLE_TIME, &BANDS).unwrap_or_else(|report| panic!("{report}"));
    assert!(measured.said.diagnostics.is_empty(), "{}", measured.said);
    for hz in lines() {
        let expected = closed(hz, 1.0);
        assert!((measured.response.value(hz) - expected).norm() < 1e-6, "{hz} Hz");
        let moved = 1e4 * (closed(hz, 1.0 + 1e-6) - expected).norm() / expected.norm();
        assert!((measured.response.relative_error(hz) / moved - 1.0).abs() < 1e-3, "{hz} Hz");
    }
    // Two cycles were added; the current loop has 0.3 ms.
    let dead_time = measured.dead_time.unwrap();
    assert!((2e-3..3e-3).contains(&dead_time), "{dead_time}");
}

/// A delay that a measurement in the drive does not contain is added.
#[test]
fn the_missing_delay_is_added() {
    let in_the_drive = |hz: f64| velocity_loop(hz) / delay(hz, 1.25e-3);
    let text = table("f [Hz];re;im;se", &lines(), |hz| {
        format!("{:.12};{:.12};0.001", in_the_drive(hz).re, in_the_drive(hz).im)
    });
    let from = From::Command { delay: 1.25e-3 };
    let measured = read("p.csv", text.as_bytes(), from, CYCLE_TIME, &BANDS).unwrap_or_else(|report| panic!("{report}"));
    for hz in lines() {
        assert!((measured.response.value(hz) - velocity_loop(hz)).norm() < 1e-6, "{hz} Hz");
    }
}
