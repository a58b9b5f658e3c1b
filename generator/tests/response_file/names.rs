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
    let hertz = [
        "f",
        "F [Hz]",
        "freq",
        "Freq (Hz)",
        "Frequency/Hz",
        "frequency in Hz",
        "Frequenz",
        "Frequenz_Hz",
        "Hz",
        "\"Frequency [Hz]\"",
    ];
    let radians = [
        "w",
        "omega",
        "ω [rad/s]",
        "w (rad/s)",
        "omega_rad_s",
        "Kreisfrequenz",
        "angular frequency",
        "Frequency [rad/s]",
    ];
    let of = |names: &[&str], factor: f64| {
        for name in names {
            let text = table(&format!("n;{name};re;im"), &lines(), |hz| {
                format!("{:.12};{:.9};{:.9}", factor * hz, velocity_loop(hz).re, velocity_loop(hz).im)
            });
            is_response(&text, name);
        }
    };
    of(&hertz, 1.0);
    of(&radians, TAU);
    of(&["f [kHz]", "freq_khz"], 1e-3);
}

/// Names of two columns, and what is written into them.
type Case = (&'static [&'static str], fn(Complex64) -> [f64; 2]);

#[test]
fn names_of_values() {
    let cases: [Case; 4] = [
        (
            &["re;im", "Real;Imag", "Re(P);Im(P)", "Real part;Imaginary part", "Realteil;Imaginärteil", "P_re;P_im"],
            |p| [p.re, p.im],
        ),
        (
            &[
                "dB;deg",
                "Magnitude [dB];Phase [°]",
                "gain_db;phase_deg",
                "Betrag in dB;Winkel in Grad",
                "Mag (dB);Arg (deg)",
            ],
            |p| [decibels(p), degrees(p)],
        ),
        (&["Amplitude;Phase [rad]", "abs;angle (rad)", "|H|;∠H [rad]", "magnitude [1];phase_rad"], |p| {
            [p.norm(), p.arg()]
        }),
        (&["Verstärkung [lin];Phasengang [Grad]", "Amplitude [(1/min)/(1/min)];Phase / deg"], |p| {
            [p.norm(), degrees(p)]
        }),
    ];
    for (names, written) in cases {
        for name in names {
            let text = table(&format!("f;{name}"), &lines(), |hz| {
                let [first, second] = written(velocity_loop(hz));
                format!("{first:.12};{second:.12}")
            });
            is_response(&text, name);
        }
    }
}
