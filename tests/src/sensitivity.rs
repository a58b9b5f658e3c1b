//! How near the loop of a plant is to instability: Ms and the gain margin, from impulse responses. The block is linear, below its limit; the
//! mesh is left out.

use machine::closed_loop::{Position, Signals, UM};
use machine::measure::fourier;
use machine::plant::Plant;
use machine::{Machine, Measured};
use std::f64::consts::TAU;

/// Cycles of an impulse response: 16 s at 1 ms, in which every vibration of the plant is gone.
const CYCLES: usize = 16_384;

/// Frequencies that are looked at, evenly up to the Nyquist frequency: steps of 0.05 Hz at 1 ms.
const FREQUENCIES: u32 = 10_000;

/// An impulse [um/s], small against every limit of a block.
const IMPULSE: f64 = 1.0;

/// The loop is cut at v_cmd: v_cmd -> plant -> position controller and block -> -L.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Margins {
    /// largest |1 / (1 + L)|
    pub ms: f64,
    /// smallest factor of L above 1 at which it reaches -1 [dB]
    pub gain_margin: f64,
}

/// Margins of a plant with improved position control, which adds to a position controller that gets no command; the closure has its fade
/// after it, and is at rest.
///
/// # Panics
/// If L never reaches a phase of -180 degrees.
#[must_use]
pub fn margins(plant: &Plant, mut ipc: impl FnMut(&Signals) -> f64) -> Margins {
    let mut machine = plant.without_mesh().at_rest();
    let mut actual = Measured::default();
    // The position ends somewhere, its change at 0: the change is transformed, and divided by 1 - z^-1.
    let (mut moved, mut added, mut before) = (Vec::new(), Vec::new(), 0.0);
    for n in 0..CYCLES {
        let signals = Position::DEMONSTRATION.signals(0.0, 0.0, &actual);
        moved.push(signals.v_command - before);
        before = signals.v_command;
        added.push(ipc(&signals));
        actual = machine.step(if n == 0 { IMPULSE / UM } else { 0.0 });
    }
    let mut found = Margins { ms: 0.0, gain_margin: f64::INFINITY };
    let mut last: Option<[f64; 2]> = None;
    for k in 1..FREQUENCIES {
        let w = TAU / 2.0 * f64::from(k) / f64::from(FREQUENCIES);
        let [of_position, of_block] = [fourier(&moved, w), fourier(&added, w)];
        let summed = divided(of_position, [1.0 - libm::cos(w), libm::sin(w)]);
        let l = [-(summed[0] + of_block[0]) / IMPULSE, -(summed[1] + of_block[1]) / IMPULSE];
        found.ms = found.ms.max(1.0 / libm::hypot(1.0 + l[0], l[1]));
        if let Some(before) = last.filter(|before| before[1].signum() != l[1].signum()) {
            // Where the imaginary part is 0, by a straight line.
            let part = before[1] / (before[1] - l[1]);
            let real = before[0] + part * (l[0] - before[0]);
            if (-1.0..0.0).contains(&real) {
                found.gain_margin = found.gain_margin.min(-20.0 * libm::log10(-real));
            }
        }
        last = Some(l);
    }
    assert!(found.gain_margin.is_finite(), "sensitivity: no gain margin");
    found
}

fn divided([a, b]: [f64; 2], [c, d]: [f64; 2]) -> [f64; 2] {
    let square = c * c + d * d;
    [(a * c + b * d) / square, (b * c - a * d) / square]
}
