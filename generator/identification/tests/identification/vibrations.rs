//! Vibrations: segments and peaks of the demonstration plant's moves, decays that are synthesised, poles of responses,
//! the side of the source.

use crate::plant::{CYCLE, Impulse, Move, Noise, excited, moved};
use identification::Complex64;
use identification::decay::{self, Companions, decay};
use identification::excitation::{Excitation, Sequence};
use identification::peaks::{Spectrum, driving, is_order, stands};
use identification::resonance::pole;
use identification::response::Lines;
use identification::segments::{self, Kind};
use identification::source::{Side, ratio, side};
use machine::plant::{DEMONSTRATION, Plant};
use std::{f64::consts::TAU, ops::Range, sync::LazyLock};

static OFF: LazyLock<Move> = LazyLock::new(|| moved(&DEMONSTRATION, |_| 0.0).0);

fn peak(values: &[f64]) -> f64 {
    values.iter().fold(0.0, |peak: f64, value| peak.max(value.abs()))
}

#[test]
fn segments_of_a_move() {
    let found = segments::of(&OFF.v_command);
    let kinds: Vec<Kind> = found.iter().map(|segment| segment.kind).collect();
    use Kind::{Accelerating, Driving, Rest};
    let once = [Rest, Accelerating, Driving, Accelerating];
    assert_eq!(kinds, [&once[..], &once[..], &[Rest]].concat());
    let lengths: Vec<f64> = found.iter().map(|segment| segment.samples.len() as f64 * CYCLE).collect();
    for (length, expected) in lengths.iter().zip([0.3, 0.254, 1.5, 0.254, 0.9, 0.254, 1.5, 0.254, 1.2]) {
        assert!((length - expected).abs() < 0.005, "{lengths:?}");
    }
    assert_eq!(segments::ramps(&found).count(), 4);
    assert_eq!(
        decay::windows(&found, CYCLE).iter().map(ExactSizeIterator::len).collect::<Vec<_>>(),
        [800, 752, 800, 800]
    );
}

#[test]
fn the_line_at_constant_speed() {
    let windows = driving(&segments::of(&OFF.v_command), CYCLE);
    assert_eq!(windows.len(), 2);
    let load = Spectrum::of(&OFF.a_load, &windows, CYCLE).unwrap().peaks();
    let line = load[0];
    assert!((line.hz - 53.0).abs() < 0.05 && (line.amplitude / 0.811 - 1.0).abs() < 0.01, "{line:?}");
    assert!(!line.competes && !line.is_at_edge);
    assert!(stands(&OFF.a_load, &windows, CYCLE, line.hz), "it is forced");
    assert!(!stands(&OFF.a_load, &windows, CYCLE, 11.0), "what the ramp left decays");
    for (part, is_seen) in [(0.001, true), (0.01, false)] {
        let mut noise = Noise::new(4, part * peak(&OFF.v_motor));
        let motor = Spectrum::of(&noise.on(&OFF.v_motor), &windows, CYCLE).unwrap();
        let found = motor.strongest([52.0, 54.0]);
        assert_eq!(found.is_some(), is_seen, "{part}: {found:?}");
        if let Some(found) = found {
            assert!((found.amplitude / 0.755e-3 - 1.0).abs() < 0.15, "{found:?}");
            assert!((found.hz - 53.0).abs() < 4.0 * found.hz_error + 0.02, "{found:?}");
        }
    }
    let motor = Spectrum::of(&OFF.v_motor, &windows, CYCLE).unwrap().strongest([52.0, 54.0]).unwrap();
    assert!((motor.amplitude / 0.755e-3 - 1.0).abs() < 0.01, "{motor:?}");
}

/// A record of 1.2 s, and a window after a ramp.
const WHOLE: [Range<usize>; 1] = [0..1200; 1];
const AFTER: [Range<usize>; 1] = [0..800; 1];

/// Sines in noise, of 1.2 s.
fn sines(of: &[[f64; 2]], noise: f64) -> Vec<f64> {
    let sample = |n: u32| of.iter().map(|[hz, a]| a * libm::sin(TAU * hz * f64::from(n) * CYCLE)).sum::<f64>();
    Noise::new(9, noise).on(&(0..1200).map(sample).collect::<Vec<_>>())
}

#[test]
fn peaks_that_are_in_doubt() {
    let peaks = |of: &[[f64; 2]]| Spectrum::of(&sines(of, 0.02), &WHOLE, CYCLE).unwrap().peaks();
    let alone = peaks(&[[30.2, 1.0], [71.0, 0.4]]);
    assert!(!alone[0].competes && !alone[1].competes, "{alone:?}");
    assert!((alone[0].hz - 30.2).abs() < 0.01 && (alone[1].amplitude - 0.4).abs() < 0.02, "{alone:?}");
    let two = peaks(&[[30.0, 1.0], [71.0, 0.6]]);
    assert!(two[0].competes && two[1].competes, "{two:?}");
    assert!(peaks(&[[2.2, 1.0]])[0].is_at_edge && !peaks(&[[3.2, 1.0]])[0].is_at_edge);
    assert!(peaks(&[[498.0, 1.0]])[0].is_at_edge);
    assert!(peaks(&[]).iter().all(|peak| peak.amplitude < 0.005), "noise has chance peaks only, as weak as noise");
    // Errors hold: over some seeds the frequency lies within three of them.
    for seed in 0..20 {
        let signal = Noise::new(seed, 0.3).on(&sines(&[[41.3, 1.0]], 0.0));
        let peak = Spectrum::of(&signal, &WHOLE, CYCLE).unwrap().peaks()[0];
        assert!((peak.hz - 41.3).abs() < 4.0 * peak.hz_error && peak.hz_error < 0.1, "{peak:?}");
    }
}

#[test]
fn orders_follow_the_speed() {
    assert!(is_order([[53.0, 0.05], [35.3, 0.05]], [0.53, -0.353]));
    assert!(!is_order([[53.0, 0.05], [53.0, 0.05]], [0.53, 0.353]));
    assert!(!is_order([[53.0, 0.05], [53.0, 0.05]], [0.53, -0.53]), "one speed says nothing");
}

/// Windows of decays with a trend, in noise.
fn decaying(hz: f64, damping: f64, noise: f64, companions: &[f64], seed: u64) -> Vec<f64> {
    let omega = TAU * hz / (1.0 - damping * damping).sqrt();
    let sigma = damping * omega;
    let sample = |n: u32| {
        let (t, window) = (f64::from(n % 800) * CYCLE, f64::from(n / 800));
        let vibration = (2.0 - window) * libm::exp(-sigma * t) * libm::cos(TAU * hz * t + window);
        let forced: f64 = companions.iter().map(|hz| 0.8 * libm::sin(TAU * hz * t + 3.0 * window)).sum();
        vibration + forced + 0.5 + t * (1.0 - 0.3 * t)
    };
    Noise::new(seed, noise).on(&(0..1600).map(sample).collect::<Vec<_>>())
}

#[test]
fn decays_that_are_synthesised() {
    for (hz, damping) in [(11.0, 0.04), (11.0, 0.1), (6.5, 0.01), (34.0, 0.02), (80.0, 0.005)] {
        let windows = [0..800, 800..1600];
        let forced = [53.0];
        let companions = Companions { position_gain: None, forced: &forced };
        let exact = decay(&decaying(hz, damping, 0.0, &forced, 1), &windows, CYCLE, hz * 1.02, companions).unwrap();
        assert!((exact.hz / hz - 1.0).abs() < 1e-5 && (exact.damping / damping - 1.0).abs() < 1e-3, "{hz}: {exact:?}");
        assert!((exact.amplitude - 2.0).abs() < 0.01, "{exact:?}");
        let (mut outside, mut squares) = (0, 0.0);
        for seed in 0..20 {
            let noisy =
                decay(&decaying(hz, damping, 0.05, &forced, seed), &windows, CYCLE, hz * 0.98, companions).unwrap();
            let apart = [(noisy.hz - hz) / noisy.hz_error, (noisy.damping - damping) / noisy.damping_error];
            outside += apart.iter().filter(|apart| apart.abs() > 2.0).count();
            squares += apart.iter().map(|apart| apart * apart).sum::<f64>() / 40.0;
        }
        assert!(outside <= 6 && squares > 0.4 && squares < 2.0, "{hz} {damping}: {outside} of 40 outside, {squares}");
    }
    // The stated errors hold beside a second vibration too.
    for (other, of_other) in [(8.0, 0.03), (17.0, 0.03), (20.0, 0.05)] {
        let second = decaying(other, of_other, 0.0, &[], 1).into_iter().map(|v| 0.2 * v);
        let both: Vec<f64> = decaying(11.0, 0.04, 0.0, &[], 1).iter().zip(second).map(|(a, b)| a + b).collect();
        let found = decay(&both, &[0..800, 800..1600], CYCLE, 11.0, Companions::default()).unwrap();
        let apart = [(found.hz - 11.0) / found.hz_error, (found.damping - 0.04) / found.damping_error];
        assert!(apart.iter().all(|apart| apart.abs() < 3.0), "{other} Hz: {found:?} {apart:?}");
    }
    assert_eq!(decay(&[0.0; 800], &AFTER, CYCLE, 11.0, Companions::default()), None, "nothing vibrates");
    assert_eq!(decay(&[1.0; 400], &AFTER, CYCLE, 11.0, Companions::default()), None, "the window is not in the record");
}

#[test]
fn the_mode_of_the_demonstration_plant() {
    let windows = decay::windows(&segments::of(&OFF.v_command), CYCLE);
    let forced = [53.0];
    let companions = Companions { position_gain: None, forced: &forced };
    let load = decay(&OFF.a_load, &windows, CYCLE, 10.8, companions).unwrap();
    assert!((load.hz - 10.97).abs() < 0.02 && (load.damping / 0.0409 - 1.0).abs() < 0.02, "{load:?}");
    let of_error = Companions { position_gain: Some(20.0), forced: &forced };
    // Noise of 1 %: the golden figures are one standard error.
    let seeds = 8;
    let mut squares = [0.0; 4];
    for seed in 0..seeds {
        let noisy = |of: &[f64]| Noise::new(seed, 0.01 * peak(of)).on(of);
        let load = decay(&noisy(&OFF.a_load), &windows, CYCLE, 10.8, companions).unwrap();
        let error = decay(&noisy(&OFF.error), &windows, CYCLE, 10.8, of_error).unwrap();
        let apart = [load.hz - 10.97, load.damping / 0.0409 - 1.0, error.hz - 10.97, error.damping / 0.0409 - 1.0];
        squares = std::array::from_fn(|i| squares[i] + apart[i] * apart[i] / seeds as f64);
    }
    let rms = squares.map(|square: f64| square.sqrt());
    assert!(rms[0] < 0.02 && rms[1] < 0.02 && rms[2] < 0.06 && rms[3] < 0.12, "{rms:?}");
}

/// Evenly spaced lines of a response.
fn lines(spacing: f64, of: impl Fn(f64) -> Complex64, error: f64) -> Lines {
    let hz: Vec<f64> = (1..400).map(|k| f64::from(k) * spacing).collect();
    let mut noise = Noise::new(2, error / 2.0_f64.sqrt());
    let response = hz.iter().map(|hz| of(*hz) + Complex64::new(noise.next(), noise.next())).collect();
    Lines { error: vec![error; hz.len()], coherence: vec![1.0; hz.len()], response, hz }
}

#[test]
fn poles_of_responses() {
    // A resonance on a background.
    let (hz, damping) = (17.3, 0.03_f64);
    let omega = TAU * hz / (1.0 - damping * damping).sqrt();
    let resonance = |f: f64| {
        let s = Complex64::new(0.0, TAU * f);
        s * omega / (s * s + s * (2.0 * damping * omega) + omega * omega) + Complex64::new(0.4, -0.01 * f)
    };
    let exact = pole(&lines(0.122, resonance, 0.0), 17.0).unwrap();
    assert!((exact.hz - hz).abs() < 0.02 && (exact.damping / damping - 1.0).abs() < 0.02, "{exact:?}");
    let noisy = pole(&lines(0.122, resonance, 0.1), 17.6).unwrap();
    assert!(
        (noisy.hz - hz).abs() < 3.0 * noisy.hz_error && (noisy.damping - damping).abs() < 3.0 * noisy.damping_error,
        "{noisy:?}"
    );
    assert!(noisy.hz_error < 0.1 && noisy.damping_error < 0.01, "{noisy:?}");
    assert_eq!(pole(&lines(2.0, resonance, 0.0), 17.0), None, "too few lines");
    // The mode of the plant, open position loop, from the response of its load.
    let impulse = Impulse::of(&DEMONSTRATION);
    let mode = pole(&lines(0.122, |hz| impulse.of_load(hz), 0.0), 10.8).unwrap();
    assert!((mode.hz - 11.01).abs() < 0.02 && (mode.damping / 0.0434 - 1.0).abs() < 0.02, "{mode:?}");
}

#[test]
fn the_side_of_the_source() {
    let excitation =
        Excitation { sequence: Sequence::for_cycle(CYCLE), cycle_time: CYCLE, amplitude: 5e-3, periods: 4 };
    let record = excited(&DEMONSTRATION, &excitation, 0.02);
    let excited = Lines::of_periods(&excitation.sequence, CYCLE, &record.v_motor, &record.a_load).unwrap();
    let excited = excited.up_to(250.0).smoothed(CYCLE).response(CYCLE).unwrap().value(53.0);
    let windows = driving(&segments::of(&OFF.v_command), CYCLE);
    // The sensor of the record is not on the way that the actual values take: one cycle.
    let turn = Complex64::from_polar(1.0, -TAU * 53.0 * CYCLE);
    let moving = ratio(&OFF.a_load, &OFF.v_motor, &windows, CYCLE, 53.0).unwrap() * turn;
    let q = moving / excited;
    assert!((q - 1.0).norm() < 0.02, "the teeth act on the motor: {q}");
    assert_eq!(side(moving, excited), Side::Motor);
}

/// An error of the mesh acts between motor and load: by the equations of the plant, its velocity loop continuous.
#[test]
fn an_error_of_the_mesh_is_on_the_side_of_the_load() {
    let Plant { mechanics: m, kp, tn, drive_cycle, .. } = DEMONSTRATION;
    let s = Complex64::new(0.0, TAU * 53.0);
    let contact = m.k1 + s * m.c1;
    // Of a contact force 1: the way of the load against the bed; with the motor's way q the force is contact (q - way).
    let way = 1.0 / (s * s * m.m2) + 1.0 / (s * s * m.m3 + s * m.c2 + m.k2);
    let excited = contact / (1.0 + contact * way) / m.m2 / s;
    let held = (-s * drive_cycle / 2.0).exp() / (1.0 + s * m.current_lag);
    let drive = kp * (1.0 + 1.0 / (s * tn)) * held;
    // m1 s^2 q = -drive s q - force
    let moving = -(s * s * m.m1 + drive * s) / m.m2 / s;
    let q = moving / excited;
    assert!((q.norm() - 0.60).abs() < 0.04 && (q.arg().to_degrees() + 136.0).abs() < 5.0, "{} {}", q.norm(), q.arg());
    assert_eq!(side(moving, excited), Side::Load);
}
