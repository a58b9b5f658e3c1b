//! The responses that the tests write down: a velocity loop after a delay, and an open speed plant. Simple formulas, nothing
//! of the generator.

use super::CYCLE_TIME;
use machine::Machine;
use stability::Complex64;
use std::f64::consts::TAU;

pub(super) fn complex(re: f64, im: f64) -> Complex64 {
    Complex64::new(re, im)
}

/// exp(-j 2 pi f time).
pub(super) fn delay(hz: f64, time: f64) -> Complex64 {
    Complex64::from_polar(1.0, -TAU * hz * time)
}

/// (antiresonance)/(resonance) at these frequencies [Hz], damped by 5 %.
fn mechanics(hz: f64, antiresonance: f64, resonance: f64) -> Complex64 {
    let of = |centre: f64| complex(1.0 - (hz / centre).powi(2), 0.1 * hz / centre);
    of(antiresonance) / of(resonance)
}

/// From the commanded velocity to the motor's: 1.5 cycles, a time constant of 3 ms, a vibration.
pub(super) fn velocity_loop(hz: f64) -> Complex64 {
    delay(hz, 1.5 * CYCLE_TIME) / complex(1.0, TAU * hz * 3e-3) * mechanics(hz, 47.0, 51.0)
}

/// The demonstration plant at the lines, from its answer to an impulse of 16 s.
pub(super) fn demonstration() -> Vec<Complex64> {
    let mut plant = machine::plant::DEMONSTRATION.without_mesh().at_rest();
    // What is measured in a cycle is the answer to the commands before.
    let mut v = vec![0.0];
    v.extend((0..16_000).map(|n| plant.step(if n == 0 { 1.0 } else { 0.0 }).v_motor));
    let line = |hz: f64| machine::measure::fourier(&v, TAU * hz * plant.cycle());
    lines().into_iter().map(line).map(|[re, im]| complex(re, im)).collect()
}

/// From current [A] to velocity [rad/s]: an inertia, a vibration, a current loop of 0.3 ms.
pub(super) fn open_plant(hz: f64) -> Complex64 {
    complex(80.0, 0.0) / complex(0.0, TAU * hz) * mechanics(hz, 47.0, 60.0) * delay(hz, 0.3e-3)
}

/// Lines every 0.25 Hz up to 250 Hz.
pub(super) fn lines() -> Vec<f64> {
    (1..=1000).map(|line| 0.25 * f64::from(line)).collect()
}

pub(super) fn decibels(value: Complex64) -> f64 {
    20.0 * value.norm().log10()
}

/// In (-180, 180].
pub(super) fn degrees(value: Complex64) -> f64 {
    value.arg().to_degrees()
}

/// Phases [rad] of lines, unwrapped.
pub(super) fn unwrapped(values: &[Complex64]) -> Vec<f64> {
    let mut last = 0.0;
    let of = |value: &Complex64| {
        last += (value.arg() - last + std::f64::consts::PI).rem_euclid(TAU) - std::f64::consts::PI;
        last
    };
    values.iter().map(of).collect()
}
