//! Lines of the demonstration plant against its exact response; what is refused.

use crate::plant::{CYCLE, Excited, Impulse, Noise, degrees, excited};
use identification::Complex64;
use identification::excitation::{Excitation, Sequence};
use identification::response::{Lines, Refused, in_db_and_degrees, is_too_uncertain};
use machine::plant::{DEMONSTRATION, Plant};

fn excitation(amplitude: f64) -> Excitation {
    Excitation { sequence: Sequence::for_cycle(CYCLE), cycle_time: CYCLE, amplitude, periods: 8 }
}

fn measured(plant: &Plant, amplitude: f64, noise: f64, speed: f64) -> (Lines, Excited) {
    let excitation = excitation(amplitude);
    let mut record = excited(plant, &excitation, speed);
    record.v_motor = Noise::new(7, noise).on(&record.v_motor);
    let lines = Lines::measured(&excitation.sequence, CYCLE, &record.v_cmd, &record.v_motor).unwrap();
    (lines, record)
}

/// Degrees and dB from one response to the other.
fn apart(a: Complex64, b: Complex64) -> [f64; 2] {
    [20.0 * libm::log10(a.norm() / b.norm()), degrees(a / b)]
}

#[test]
fn the_exact_response_of_the_demonstration_plant() {
    let impulse = Impulse::of(&DEMONSTRATION);
    let golden = [
        (5.0, 1.0335, -5.58),
        (11.0, 0.8567, -26.54),
        (20.0, 1.0691, -29.74),
        (47.0, 0.3279, -83.21),
        (53.0, 0.4349, -33.46),
        (100.0, 0.9890, -105.07),
    ];
    for (hz, magnitude, phase) in golden {
        let p = impulse.p(hz);
        assert!((p.norm() - magnitude).abs() < 1e-3 && (degrees(p) - phase).abs() < 0.05, "{hz} Hz: {p}");
    }
}

#[test]
fn lines_from_noisy_records() {
    let impulse = Impulse::of(&DEMONSTRATION);
    for (amplitude, noise) in [(5e-3, 0.3e-3), (2e-3, 0.1e-3)] {
        let (lines, _) = measured(&DEMONSTRATION, amplitude, noise, 0.02);
        let lines = lines.up_to(250.0).smoothed(CYCLE);
        let response = lines.response(CYCLE).unwrap();
        let (mut worst, mut squares, mut count) = ([0.0_f64; 2], [0.0; 2], 0.0);
        for (k, hz) in lines.hz.iter().enumerate().filter(|(_, hz)| (5.0..200.0).contains(*hz)) {
            let apart = apart(lines.response[k], impulse.p(*hz));
            for i in 0..2 {
                worst[i] = worst[i].max(apart[i].abs());
                squares[i] += apart[i] * apart[i];
            }
            count += 1.0;
            assert!(!is_too_uncertain(&response, *hz), "{hz} Hz");
        }
        let rms = squares.map(|sum: f64| (sum / count).sqrt());
        assert!(worst[0] < 0.5 && worst[1] < 3.5, "worst {worst:?}");
        assert!(rms[0] < 0.15 && rms[1] < 0.75, "rms {rms:?}");
    }
}

#[test]
fn stated_errors_hold() {
    let plant = DEMONSTRATION.without_mesh();
    let impulse = Impulse::of(&plant);
    let (lines, _) = measured(&plant, 2e-3, 0.3e-3, 0.02);
    for (what, lines) in [("lines", lines.up_to(250.0)), ("smoothed", lines.up_to(250.0).smoothed(CYCLE))] {
        let far = |k: usize| (lines.response[k] - impulse.p(lines.hz[k])).norm() / lines.error[k];
        let within = (0..lines.hz.len()).filter(|k| far(*k) <= 2.0).count() as f64 / lines.hz.len() as f64;
        let within_half = (0..lines.hz.len()).filter(|k| far(*k) <= 0.5).count() as f64 / lines.hz.len() as f64;
        assert!(within >= 0.9 && within_half < 0.5, "{what}: {within} {within_half}");
    }
    let [db, degrees] = in_db_and_degrees(0.1);
    assert!((db - 0.87).abs() < 0.01 && (degrees - 5.73).abs() < 0.01);
}

#[test]
fn a_response_without_noise_is_the_exact_one() {
    let plant = DEMONSTRATION.without_mesh();
    let impulse = Impulse::of(&plant);
    let (lines, _) = measured(&plant, 2e-3, 0.0, 0.02);
    assert!(lines.coherence.iter().all(|coherence| *coherence > 0.9999), "{:?}", lines.coherence);
    for k in (4..lines.hz.len()).step_by(97) {
        let apart = (lines.response[k] / impulse.p(lines.hz[k]) - 1.0).norm();
        assert!(apart < 1e-6, "{} Hz: {apart}", lines.hz[k]);
    }
}

#[test]
fn what_is_no_response() {
    let sequence = Sequence::new(7, 1).unwrap();
    let ones = |periods: usize| vec![1.0; periods * sequence.period()];
    let of = |v_cmd: &[f64], v_motor: &[f64]| Lines::measured(&sequence, CYCLE, v_cmd, v_motor);
    assert_eq!(of(&ones(4), &ones(5)), Err(Refused::NotPeriods));
    assert_eq!(of(&ones(4)[1..], &ones(4)[1..]), Err(Refused::NotPeriods));
    assert_eq!(of(&ones(3), &ones(3)), Err(Refused::TooFewPeriods(3)));
    let mut reverses = ones(4);
    reverses[200] = 0.0;
    assert_eq!(of(&ones(4), &reverses), Err(Refused::Reverses(200)));
    let nothing = of(&vec![0.0; 4 * sequence.period()], &ones(4)).unwrap();
    assert!(nothing.hz.is_empty() && nothing.response(CYCLE).is_none(), "nothing is excited");
}
