//! Names of columns, each read as its quantity in its unit.

use super::plant::{decibels, degrees, lines, velocity_loop};
use super::{read_text, table};
use stability::Complex64;
use std::f64::consts::TAU;

fn is_response(text: &str, what: &str) {
    let measured = read_text(text).unwrap_or_else(|report| panic!("{what}: {report}"));
    for hz in [0.25, 11.0, 53.0, 249.75] {
        assert!((measured.response.value(hz) - velocity_loop(hz)).norm() < 1e-6, "{what} at {hz} Hz");
    }
}

#[test]
fn names_of_frequencies() {
    let of = |names: &str, factor: f64| {
        for name in names.split(", ") {
            let text = table(&format!("n;{name};re;im"), &lines(), |hz| {
                format!("{:.12};{:.9};{:.9}", factor * hz, velocity_loop(hz).re, velocity_loop(hz).im)
            });
            is_response(&text, name);
        }
    };
    of("f, F [Hz], freq, Freq (Hz), Frequency/Hz, frequency in Hz, Frequenz, Frequenz_Hz, Hz, \"Frequency [Hz]\"", 1.0);
    of("w, omega, ω [rad/s], w (rad/s), omega_rad_s, Kreisfrequenz, angular frequency, Frequency [rad/s]", TAU);
    of("f [kHz], freq_khz", 1e-3);
}

/// Names of two columns, and what is written into them.
type Case = (&'static str, fn(Complex64) -> [f64; 2]);

#[test]
fn names_of_values() {
    let parts = "re;im, Real;Imag, Re(P);Im(P), Real part;Imaginary part, Realteil;Imaginärteil, P_re;P_im";
    let polar = "dB;deg, Magnitude [dB];Phase [°], gain_db;phase_deg, Betrag in dB;Winkel in Grad, Mag (dB);Arg (deg), \
        Trace 1: Gain: Magnitude (dB);Trace 2: Gain: Phase (°), Gain (dB);Gain (deg), \
        Frequency response magnitude (dB);Frequency response phase (deg), \
        Gain: Mag (dB);Gain: Phase (deg);Magnitude-squared coherence";
    let cases: [Case; 4] = [
        (parts, |p| [p.re, p.im]),
        (polar, |p| [decibels(p), degrees(p)]),
        ("Amplitude;Phase [rad], abs;angle (rad), |H|;∠H [rad], magnitude [1];phase_rad", |p| [p.norm(), p.arg()]),
        ("Verstärkung [lin];Phasengang [Grad], Amplitude [(1/min)/(1/min)];Phase / deg", |p| [p.norm(), degrees(p)]),
    ];
    for (names, written) in cases {
        for name in names.split(", ") {
            let text = table(&format!("f;{name}"), &lines(), |hz| {
                let [first, second] = written(velocity_loop(hz));
                format!("{first:.12};{second:.12}{}", if name.matches(';').count() > 1 { ";1" } else { "" })
            });
            is_response(&text, name);
        }
    }
}
