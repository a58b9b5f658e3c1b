//! The sequence by its first signs, its period, its spectrum; defaults; what a start means for the machine.

use crate::plant::CYCLE;
use identification::excitation::{Excitation, Sequence};
use machine::measure::fourier;
use std::f64::consts::{PI, TAU};

fn signs(bits: u32, clocks: usize) -> String {
    let of = |sign: f64| if sign > 0.0 { '1' } else { '0' };
    Sequence::new(bits, 1).unwrap().signs().take(clocks).map(of).collect()
}

/// A register as a row of bits, its front first: by the words of the definition.
fn by_hand(bits: usize, taps: &[usize], clocks: usize) -> String {
    let mut register = vec![true; bits];
    let mut signs = String::new();
    for _ in 0..clocks {
        let last = register[bits - 1];
        signs.push(if last { '1' } else { '0' });
        let fed = taps.iter().fold(false, |sum, tap| sum != register[tap - 1]);
        register.rotate_right(1);
        register[0] = fed;
    }
    signs
}

#[test]
fn sequences_begin_as_defined() {
    assert_eq!(signs(11, 24), "111111111110000000001100");
    assert_eq!(signs(7, 23), "11111110000001000001100");
    assert_eq!(signs(7, 200), by_hand(7, &[7, 6], 200));
    assert_eq!(signs(12, 5000), by_hand(12, &[12, 11, 10, 4], 5000));
    assert_eq!(signs(14, 20_000), by_hand(14, &[14, 13, 12, 2], 20_000));
}

#[test]
fn every_register_has_the_longest_period() {
    for bits in 7..=15 {
        let length = (1_usize << bits) - 1;
        let twice: Vec<f64> = Sequence::new(bits, 1).unwrap().signs().take(2 * length).collect();
        let (first, second) = twice.split_at(length);
        assert_eq!(first, second, "{bits} bits: the period");
        assert!((first.iter().sum::<f64>() - 1.0).abs() < 1e-9, "{bits} bits: the sum is one clock");
        // Only a sequence of the longest period has the same autocorrelation at every shift.
        for shift in [1, 2, 5, length / 3, length - 1] {
            let sum: f64 = (0..length).map(|n| first[n] * twice[n + shift]).sum();
            assert!((sum + 1.0).abs() < 1e-9, "{bits} bits, shift {shift}: {sum}");
        }
    }
    assert!([(6, 1), (16, 1), (7, 0)].iter().all(|(bits, clock)| Sequence::new(*bits, *clock).is_none()));
}

#[test]
fn lines_are_those_of_the_signs() {
    let sequence = Sequence::new(9, 3).unwrap();
    let period: Vec<f64> = sequence.signs().take(sequence.period()).collect();
    for k in [1, 2, 40, 255, 511, 700] {
        let [re, im] = fourier(&period, TAU * k as f64 / period.len() as f64);
        let line = 2.0 * libm::hypot(re, im) / period.len() as f64;
        assert!((line - sequence.line(k)).abs() < 1e-9, "line {k}: {line} {}", sequence.line(k));
    }
    // Held clocks: -2.4 dB at 0.4 of their frequency.
    let long = Sequence::new(15, 2).unwrap();
    let at = (0.4 * f64::from((1_u32 << 15) - 1)) as usize;
    let hold = libm::sin(0.4 * PI) / (0.4 * PI);
    let db = 20.0 * libm::log10(long.line(at) / long.line(1));
    assert!((20.0 * libm::log10(hold) + 2.4).abs() < 0.05 && db > -2.45 && db < -0.9, "{db}");
}

#[test]
fn defaults_of_usual_cycles() {
    // T [us], bits, clock, period [s]
    for (us, bits, clock, period) in [
        (62.5, 11, 32, 4.094),
        (500.0, 11, 4, 4.094),
        (1000.0, 11, 2, 4.094),
        (2000.0, 11, 1, 4.094),
        (4000.0, 10, 1, 4.092),
    ] {
        let sequence = Sequence::for_cycle(us * 1e-6);
        let found = 1.0 / sequence.spacing(us * 1e-6);
        assert_eq!((sequence.bits(), sequence.clock()), (bits, clock), "{us} us");
        assert!((found - period).abs() < 1e-9, "{us} us: {found}");
    }
    let excitation =
        Excitation { sequence: Sequence::for_cycle(CYCLE), cycle_time: CYCLE, amplitude: 2e-3, periods: 8 };
    assert!((excitation.sequence.spacing(CYCLE) - 0.244).abs() < 5e-4);
    assert!((excitation.duration() - 37.0).abs() < 0.1, "{}", excitation.duration());
    // 11 Hz with a damping of 0.04: 0.88 Hz wide, 0.22 Hz between lines ask for a bit more.
    assert_eq!(Sequence::for_vibration(CYCLE, 11.0, 0.04).bits(), 12);
    assert_eq!(Sequence::for_vibration(CYCLE, 11.0, 0.05).bits(), 11);
}

#[test]
fn it_fades_in_and_out() {
    let sequence = Sequence::new(7, 2).unwrap();
    let excitation = Excitation { sequence, cycle_time: CYCLE, amplitude: 3.0, periods: 4 };
    let samples: Vec<f64> = excitation.samples().collect();
    assert_eq!(samples.len(), 5 * 254 + 100);
    assert!(samples[0] == 0.0 && (samples[50].abs() - 1.5).abs() < 1e-12 && (samples[100].abs() - 3.0).abs() < 1e-12);
    let measured = excitation.measured();
    assert!(samples[measured.clone()].iter().all(|v| (v.abs() - 3.0).abs() < 1e-12));
    assert!((samples[measured.end + 50].abs() - 1.5).abs() < 1e-12 && samples.last().unwrap().abs() < 0.04);
    let period = sequence.period();
    assert_eq!(samples[measured.start..measured.start + period], samples[measured.end - period..measured.end]);
}

#[test]
fn facts_before_a_start() {
    let with =
        |amplitude| Excitation { sequence: Sequence::for_cycle(CYCLE), cycle_time: CYCLE, amplitude, periods: 8 };
    assert!((with(2e-3).step() - 4e-3).abs() < 1e-15);
    assert!((with(2e-3).path(0.02) - (9.0 * 4.094 + 0.1) * 0.02).abs() < 1e-9);
    assert!((with(2e-3).least_speed() - 5e-3).abs() < 1e-15);
}
