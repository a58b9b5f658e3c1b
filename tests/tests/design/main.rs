//! The design in portable Rust against sources that it does not share: 80-digit arithmetic, the crate `libm`, the processor's
//! square root; and its specialised program against the Rust itself.

#![expect(
    clippy::cast_possible_truncation,
    clippy::cast_precision_loss,
    clippy::cast_sign_loss,
    reason = "random bits, and small numbers of cycles"
)]

mod accuracy;
mod exact;
mod functions;
mod inputs;
mod norms;
mod specialised;

use axgen_tests::random::rng::Rng;
use reference::design::inputs::{FilterInputs, Inputs};
use std::f64::consts::LN_2;

/// Cycle times [ns].
const CYCLES: [u32; 7] = [62_500, 125_000, 250_000, 500_000, 1_000_000, 2_000_000, 4_000_000];

/// In 0..1.
fn unit(rng: &mut Rng) -> f64 {
    (rng.word() >> 11) as f64 / 9_007_199_254_740_992.0
}

/// From the lowest to the highest, evenly in the logarithm.
fn evenly(rng: &mut Rng, lowest: f64, highest: f64) -> f64 {
    let octaves = libm::log(highest / lowest) / LN_2;
    lowest * libm::exp2(octaves * unit(rng))
}

/// Inputs of a filter: f0 Ts from 6e-6 to 0.45, Q from 1 to 10; bounds and 0.25, where a coefficient is near 0, more often.
fn filter(rng: &mut Rng, cycle_time_ns: u32) -> FilterInputs<f64> {
    let share = match rng.below(16) {
        0 => 0.45,
        1 => 0.25 * (1.0 + 1e-6 * unit(rng)),
        _ => evenly(rng, 6e-6, 0.45),
    };
    let f0 = share * 1e9 / f64::from(cycle_time_ns);
    let q_factor = match rng.below(16) {
        0 => 1.0,
        1 => 10.0,
        _ => 1.0 + 9.0 * unit(rng),
    };
    FilterInputs { f0, q_factor }
}

/// Inputs of a stage, D from 0 to 1.
fn inputs(rng: &mut Rng, cycle_time_ns: u32) -> Inputs<f64> {
    let damping = if rng.chance(50) { unit(rng) } else { evenly(rng, 1e-4, 0.999) };
    Inputs { filter: [filter(rng, cycle_time_ns), filter(rng, cycle_time_ns)], damping, weight: 7.0 * unit(rng) }
}
