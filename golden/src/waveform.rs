//! The forms of a stimulus's components, sample by sample: integers and `libm`, no operation whose bits depend on the host.

use serde::Deserialize;

/// The form of a component, with values between -1 and 1. Times are in cycles and count from the run's first sample.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields, rename_all = "snake_case")]
pub enum Form {
    /// 1; a step if limited by a window
    Constant,
    Sine {
        /// cycles of the block in one period
        period: f64,
    },
    /// a sine whose frequency rises linearly, and starts again
    Chirp {
        /// period at the beginning
        from: f64,
        /// period at the end
        to: f64,
        /// cycles from the beginning to the end
        length: f64,
    },
    /// white noise
    Noise {
        /// which one
        seed: u32,
    },
    /// forward, rest, backward, rest: a velocity with limited jerk
    Move {
        /// cycles of each of the four phases
        phase: u32,
        /// cycles of a ramp; the acceleration rises in the first quarter and falls in the last one
        ramp: u32,
    },
}

impl Form {
    /// The error in a form: a period or a length that is not above 0.
    #[must_use]
    pub fn mistake(&self) -> Option<String> {
        let times = match *self {
            Self::Constant | Self::Noise { .. } => vec![],
            Self::Sine { period } => vec![("period", period)],
            Self::Chirp { from, to, length } => vec![("from", from), ("to", to), ("length", length)],
            Self::Move { phase, ramp } => vec![("phase", f64::from(phase)), ("ramp", f64::from(ramp))],
        };
        let wrong = times.iter().find(|(_, time)| !(time.is_finite() && *time > 0.0));
        wrong.map(|(name, time)| format!("`{name}` is {time}; allowed: a number above 0"))
    }
}

/// A form in operation, evaluated sample by sample.
pub struct Waveform<'f> {
    form: &'f Form,
    random: Random,
}

impl<'f> Waveform<'f> {
    /// A form before its first sample.
    #[must_use]
    pub fn new(form: &'f Form) -> Self {
        let seed = match form {
            Form::Noise { seed } => u64::from(*seed),
            _ => 0,
        };
        Self { form, random: Random(88_172_645_463_325_252 ^ (seed << 20)) }
    }

    /// The value at a sample. Noise has another value at each call.
    pub fn at(&mut self, sample: u64) -> f64 {
        let n = exact(sample);
        let turns = match *self.form {
            Form::Constant => return 1.0,
            // Uniform between -1 and 1.
            Form::Noise { .. } => return exact(self.random.next() >> 11) / exact(1 << 52) - 1.0,
            Form::Move { phase, ramp } => return velocity(sample, phase, ramp),
            Form::Sine { period } => n / period,
            Form::Chirp { from, to, length } => {
                let n = n % length;
                n / from + (1.0 / to - 1.0 / from) * n * n / (2.0 * length)
            }
        };
        libm::sin(2.0 * std::f64::consts::PI * (turns - libm::floor(turns)))
    }
}

/// Random numbers of 64 bits: xorshift64.
pub(crate) struct Random(pub(crate) u64);

impl Random {
    pub(crate) fn next(&mut self) -> u64 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        self.0
    }
}

/// Velocity of the move, between -1 and 1.
fn velocity(sample: u64, phase: u32, ramp: u32) -> f64 {
    let (phase, ramp) = (u64::from(phase), f64::from(ramp));
    let (direction, within) = match (sample / phase) % 4 {
        0 => (1.0, sample % phase),
        2 => (-1.0, sample % phase),
        _ => return 0.0,
    };
    direction * rise(exact(within.min(phase - within)) / ramp)
}

/// From 0 to 1 while `t` goes from 0 to 1: the acceleration grows for a quarter, stays for a half, falls for a quarter.
fn rise(t: f64) -> f64 {
    let top = 4.0 / 3.0; // the acceleration in the middle half
    match t {
        t if t <= 0.0 => 0.0,
        t if t < 0.25 => top * 2.0 * t * t,
        t if t < 0.75 => top * (t - 0.125),
        t if t < 1.0 => 1.0 - top * 2.0 * (1.0 - t) * (1.0 - t),
        _ => 1.0,
    }
}

/// A whole number as a real.
fn exact(value: u64) -> f64 {
    value as f64
}
