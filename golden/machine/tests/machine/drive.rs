//! The axis that is only its drive: what is measured of a sine is late by the delay and the time constant, and as large as they
//! leave it.

use machine::Machine;
use machine::drive::{Drive, Setup};
use std::f64::consts::TAU;

/// Gain and lag [cycles] from the command to the measured velocity, at a frequency in parts of the sampling frequency.
fn response(setup: Setup, frequency: f64) -> [f64; 2] {
    let mut drive = Drive::new(setup);
    let (mut sums, whole) = ([0.0; 2], 1000);
    // What arrives is read one cycle after the command was written.
    for n in 0..3 * whole {
        let v = drive.step((TAU * frequency * f64::from(n)).sin()).v_motor;
        if n >= whole {
            let w = TAU * frequency * f64::from(n + 1);
            sums = [sums[0] + v * w.sin(), sums[1] + v * w.cos()];
        }
    }
    let [re, im] = sums.map(|sum| sum / f64::from(whole));
    [re.hypot(im), -im.atan2(re) / (TAU * frequency)]
}

fn assert_response(setup: Setup, frequency: f64, [gain, lag]: [f64; 2], tolerance: f64) {
    let found = response(setup, frequency);
    let is_near = (found[0] - gain).abs() < 1e-9 && (found[1] - lag).abs() < tolerance;
    assert!(is_near, "{setup:?} at {frequency}: {found:?} instead of {gain}, {lag}");
}

#[test]
fn a_delay_leaves_the_amplitude_and_is_as_late_as_it_says() {
    for delay in [1.0, 1.5, 2.0, 2.25, 3.75, 7.0] {
        let setup = Setup { delay, ..Setup::DELAY };
        // Whole cycles are exact; a part of one is by the all-pass within 0.01 cycles at 50 Hz of 1 kHz.
        let tolerance = if delay.fract() > 0.0 { 0.01 } else { 1e-9 };
        assert_response(setup, 0.05, [1.0, delay], tolerance);
    }
}

/// `(1 - e) / (1 - e z^-1)` with e = exp(-Ts / Tc), in addition to the delay.
#[test]
fn a_time_constant_multiplies_it_after_its_hold() {
    let Setup { cycle, delay, time_constant, .. } = Setup::DELAY_AND_LAG;
    let (e, w) = ((-cycle / time_constant).exp(), TAU * 0.05);
    let [re, im] = [1.0 - e * w.cos(), e * w.sin()];
    let lag = delay + im.atan2(re) / w;
    assert_response(Setup::DELAY_AND_LAG, 0.05, [(1.0 - e) / re.hypot(im), lag], 0.01);
}

/// With the delay of 16 ms in its loop, a Kv of 100/s would be unstable.
#[test]
fn a_drive_with_its_own_position_loop_stands_at_what_is_added() {
    let mut drive = Drive::new(Setup { cycle: 4e-3, delay: 4.0, position_gain: Some(100.0), ..Setup::DELAY });
    let mut x = 0.0;
    (0..100).for_each(|_| x = drive.step(5.0 - 100.0 * x).x);
    assert!((x - 0.05).abs() < 1e-9, "{x}");
}

#[test]
fn the_position_is_the_sum_of_the_velocities() {
    let mut drive = Drive::new(Setup::DELAY_AND_LAG);
    let mut sum = 0.0;
    for n in 0..1000_u32 {
        let seen = drive.step(f64::from(n % 7));
        sum += seen.v_motor * Setup::DELAY.cycle;
        assert!((seen.x - sum).abs() < 1e-9 && (seen.v_load - seen.v_motor).abs() < 1e-9, "{seen:?}");
    }
}
