//! The shape of a stage: the values that a search changes. Its response is a closure of the caller; its weight is not part
//! of it.

use crate::{Complex64, ZERO};
use portable::Extreme;
use std::f64::consts::PI;

/// The input of a stage. Both close the loop through the velocity of the motor.
#[derive(Clone, Copy, Debug, Eq, PartialEq)]
pub enum Mode {
    /// `v_motor`
    Direct,
    /// the simulated oscillation of a load that `v_motor` drives
    Indirect,
}

/// An all-pass of second order in a stage.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Allpass {
    /// [Hz]
    pub f0: f64,
    pub q: f64,
}

/// A stage without its weight: one band-pass of order 1, for which the prototypes are equal, and optionally an all-pass.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Shape {
    pub mode: Mode,
    /// centre of the band-pass, and of the simulated oscillation [Hz]
    pub f0: f64,
    /// quality factor of the band-pass
    pub q: f64,
    /// damping of the simulated oscillation; without effect for DIRECT
    pub damping: f64,
    pub allpass: Option<Allpass>,
}

/// Returns the response of a stage with weight 1 from `v_motor` to `v_add`, including its sign: a function of t = tan(pi f
/// T).
pub type Stages<'a> = dyn Fn(&Shape) -> Box<dyn Fn(f64) -> Complex64 + 'a> + 'a;

/// The bounds of a proposed quality factor (P-AXIS-00752) and of a proposed damping.
pub const Q: [f64; 2] = [1.0, 10.0];
pub const DAMPING: [f64; 2] = [0.05, 0.99];
/// The highest f0 of a filter: in Hz (P-AXIS-00751), and as a part of the sampling frequency.
const HIGHEST: f64 = 500.0;
const HIGHEST_PART: f64 = 0.45;
/// Quality factor of a proposed all-pass: flat enough not to narrow the stage, steep enough to reach most leads.
pub const ALLPASS_Q: f64 = 2.0;
/// The lowest f0 of an all-pass, as a part of that of its stage: a lead of 20 degrees. A lower one gives less, and turns the
/// slow motion that a stage lets through: the axis then creeps to its position.
const LOWEST_PART: f64 = 0.3;
/// Halvings of the interval of the search.
const STEPS: u32 = 60;

/// The highest f0 of a filter [Hz] at a cycle time T [s].
#[must_use]
pub fn highest(cycle_time: f64) -> f64 {
    HIGHEST.smaller(HIGHEST_PART / cycle_time)
}

/// The all-pass of quality factor 2 that gives a stage a lead [degrees] at its f0 [Hz]; `None` if no f0 up to the highest
/// one reaches it.
///
/// H = (s^2 - B s + W^2)/(s^2 + B s + W^2), W = tan(pi f T), B = (1 + W^2) tan(pi f T / Q): its phase at the stage's f0
/// rises with its own f, from -360 to 0 degrees; a lead is a lag reduced by 360 degrees.
#[must_use]
pub fn allpass(f0: f64, lead: f64, cycle_time: f64) -> Option<Allpass> {
    let wanted = (lead % 360.0) - 360.0;
    let t = libm::tan(PI * f0 * cycle_time);
    let phase = |f: f64| {
        let centre = libm::tan(PI * f * cycle_time);
        let band = (1.0 + centre * centre) * libm::tan(PI * f * cycle_time / ALLPASS_Q);
        -2.0 * libm::atan2(band * t, centre * centre - t * t).to_degrees()
    };
    let (mut low, mut high) = (f0 * LOWEST_PART, highest(cycle_time));
    if phase(low) > wanted || phase(high) < wanted {
        return None;
    }
    for _ in 0..STEPS {
        let middle = (low * high).sqrt();
        if phase(middle) < wanted { low = middle } else { high = middle }
    }
    Some(Allpass { f0: low, q: ALLPASS_Q })
}

/// The responses of stages with their weights at places t = tan(pi f T), summed: C.
#[must_use]
pub fn sum(stages: &Stages<'_>, of: &[(Shape, f64)], t: &[f64]) -> Vec<Complex64> {
    let mut sum = vec![ZERO; t.len()];
    for (shape, weight) in of {
        let response = stages(shape);
        sum.iter_mut().zip(t).for_each(|(sum, t)| *sum += response(*t) * *weight);
    }
    sum
}
