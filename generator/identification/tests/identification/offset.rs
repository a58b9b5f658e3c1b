//! Known shifts of two channels; the dead time of the demonstration plant and of random axes.

use crate::by_depth;
use crate::plant::{CYCLE, Impulse, Noise, excited, random_axis};
use identification::Complex64;
use identification::dead_time::{self, Channels};
use identification::excitation::{Excitation, Sequence};
use identification::offset::between;
use identification::response::Lines;
use machine::closed_loop::{self, Position};
use machine::plant::{DEMONSTRATION, Plant};
use machine::sequence;
use std::f64::consts::TAU;

fn one(_: f64) -> Complex64 {
    Complex64::from(1.0)
}

/// Samples of a signal and of the same some cycles later.
fn shifted(signal: &[f64], cycles: usize) -> (&[f64], &[f64]) {
    (&signal[cycles..], &signal[..signal.len() - cycles])
}

#[test]
fn shifts_of_an_excited_axis() {
    let sequence = Sequence::for_cycle(CYCLE);
    let excitation = Excitation { sequence, cycle_time: CYCLE, amplitude: 5e-3, periods: 4 };
    let record = excited(&DEMONSTRATION, &excitation, 0.02);
    for (seed, cycles) in [(1, 0), (2, 1), (3, 4)] {
        let (x, y) = shifted(&record.v_motor, cycles);
        let mut noise = Noise::new(seed, 0.3e-3);
        let (x, y) = (noise.on(x), noise.on(y));
        let found = between(&x, &y, CYCLE, one).unwrap();
        let back = between(&y, &x, CYCLE, one).unwrap();
        assert!((found.seconds - cycles as f64 * CYCLE).abs() < 0.04e-3, "{cycles}: {found:?}");
        assert!((back.seconds + cycles as f64 * CYCLE).abs() < 0.04e-3, "{cycles}: {back:?}");
    }
}

#[test]
fn shifts_of_a_move() {
    let record =
        closed_loop::run(DEMONSTRATION.at_rest(), &Position::DEMONSTRATION, &sequence::Sequence::DEMONSTRATION, |_| {
            0.0
        });
    let v_motor: Vec<f64> = record.signals.iter().map(|signals| signals.v_motor / closed_loop::UM).collect();
    for (part, is_known) in [(0.001, true), (0.01, false)] {
        for cycles in [0, 2, 5] {
            let (x, y) = shifted(&v_motor, cycles);
            let mut noise = Noise::new(cycles as u64, part * 0.53);
            let found = between(&noise.on(x), &noise.on(y), CYCLE, one);
            if is_known {
                let found = found.unwrap();
                assert!((found.seconds - cycles as f64 * CYCLE).abs() < 0.2e-3, "{cycles}: {found:?}");
            } else {
                assert!(found.is_none(), "{cycles}: {found:?}");
            }
        }
    }
}

/// Sines that do not repeat, at a time [s], and their derivative.
fn sines(time: f64) -> [f64; 2] {
    (1..60_u32).fold([0.0; 2], |sum, k| {
        let (omega, phase) = (TAU * 1.37 * f64::from(k), f64::from(k * k));
        let (sin, cos) = libm::sincos(omega * time + phase);
        [sum[0] + sin, sum[1] + omega * cos]
    })
}

#[test]
fn a_position_and_a_velocity_between_cycles() {
    for tau in [-2.6e-3, 0.31e-3, 1.87e-3] {
        let at = |n: u32, tau: f64| sines(f64::from(n) * CYCLE - tau);
        let position: Vec<f64> = (0..12_000).map(|n| at(n, 0.0)[0]).collect();
        let velocity: Vec<f64> = (0..12_000).map(|n| at(n, tau)[1]).collect();
        let found = between(&position, &velocity, CYCLE, |hz| Complex64::new(0.0, TAU * hz)).unwrap();
        assert!((found.seconds - tau).abs() < 0.01e-3, "{tau}: {found:?}");
    }
    // Ten sines about 250 Hz: each period of 4 ms is nearly as good.
    let band =
        |n: u32| (0..10).map(|k| libm::sin(TAU * (248.0 + 0.5 * f64::from(k)) * f64::from(n) * CYCLE)).sum::<f64>();
    let band: Vec<f64> = (0..12_000).map(band).collect();
    let mut noise = Noise::new(3, 0.05);
    assert_eq!(between(&noise.on(&band), &noise.on(&band), CYCLE, one), None, "two places are as good");
    assert_eq!(between(&band[..2000], &band, CYCLE, one), None, "shorter than a segment");
}

/// Lines to half the sampling frequency from an impulse response: what an excitation without noise gives.
fn exact_lines(plant: &Plant) -> Lines {
    let impulse = Impulse::of_cycles(plant, 8192);
    let period = 2047;
    let mut lines = Lines::default();
    for k in 1..=period / 2 {
        lines.hz.push(f64::from(k) / (f64::from(period) * CYCLE));
    }
    lines.response = impulse.lines(period);
    lines.error = vec![0.0; lines.hz.len()];
    lines.coherence = vec![1.0; lines.hz.len()];
    lines
}

#[test]
fn the_dead_time_of_the_demonstration_plant() {
    let exact = dead_time::of(&exact_lines(&DEMONSTRATION), CYCLE).unwrap();
    assert!((exact.seconds - 3e-3).abs() < 0.003e-3, "{exact:?}");
    assert_eq!(Channels::of(exact.seconds, CYCLE), Channels::Whole(3));

    let excitation =
        Excitation { sequence: Sequence::new(11, 1).unwrap(), cycle_time: CYCLE, amplitude: 5e-3, periods: 8 };
    let mut record = excited(&DEMONSTRATION, &excitation, 0.02);
    record.v_motor = Noise::new(5, 0.3e-3).on(&record.v_motor);
    let lines = Lines::measured(&excitation.sequence, CYCLE, &record.v_cmd, &record.v_motor).unwrap();
    let noisy = dead_time::of(&lines, CYCLE).unwrap();
    assert!((noisy.seconds - 3e-3).abs() < 0.05e-3, "{noisy:?}");
    assert_eq!(dead_time::of(&lines.up_to(250.0), CYCLE), None, "the minimum phase needs all of |P|");
}

#[test]
fn dead_times_of_random_axes() {
    for seed in 0..by_depth(40, 100, 400) {
        let plant = random_axis(1000 + seed);
        let cycles = plant.command_delay + plant.actual_delay + 1;
        let found = dead_time::of(&exact_lines(&plant), CYCLE).unwrap_or_else(|| panic!("axis {seed}: unknown"));
        let apart = found.seconds - cycles as f64 * CYCLE;
        assert!(apart.abs() < 0.003e-3, "axis {seed}: {found:?}, {cycles} cycles");
    }
}

#[test]
fn a_channel_that_is_sampled_between_cycles() {
    let e = libm::exp(-CYCLE / 4e-3);
    for cycles in [0.4, 2.5, 3.25] {
        let p = |hz: f64| {
            let z = |cycles: f64| Complex64::from_polar(1.0, -TAU * hz * CYCLE * cycles);
            z(cycles) * (1.0 - e) / (1.0 - z(1.0) * e)
        };
        let mut lines = Lines { hz: (1..1024).map(|k| f64::from(k) / (2047.0 * CYCLE)).collect(), ..Lines::default() };
        lines.response = lines.hz.iter().map(|hz| p(*hz)).collect();
        lines.error = vec![0.0; lines.hz.len()];
        let found = dead_time::of(&lines, CYCLE).unwrap().seconds;
        assert!((found - cycles * CYCLE).abs() < 0.1e-3, "{cycles}: {found}");
        let expected = if cycles < 1.0 { Channels::TooShort } else { Channels::NotWhole };
        assert_eq!(Channels::of(found, CYCLE), expected, "{cycles}: {found}");
    }
}

#[test]
fn what_a_dead_time_says_of_the_channels() {
    for (seconds, channels) in [
        (3.0e-3, Channels::Whole(3)),
        (3.14e-3, Channels::Whole(3)),
        (3.4e-3, Channels::NotWhole),
        (0.9e-3, Channels::Whole(1)),
        (0.2e-3, Channels::TooShort),
        (-2e-3, Channels::TooShort),
    ] {
        assert_eq!(Channels::of(seconds, CYCLE), channels, "{seconds}");
    }
}
