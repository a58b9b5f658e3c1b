//! What the inputs of a block do, sample by sample: sums of components, and events that overrule them.
//!
//! Everything comes from integers and `libm`, so that every host makes the same bits.

use crate::csv::parse;
use crate::samples::{Samples, Shape};
use generator::program::Type;
use portable::{Literal, RealKind};
use serde::Deserialize;
use std::collections::BTreeMap;

/// What the inputs do. An input that is not mentioned keeps its start.
#[derive(Clone, Debug, Default, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Stimulus {
    /// for each real input the components that are added up
    #[serde(default)]
    pub signal: BTreeMap<String, Vec<Component>>,
    /// what overrules them, the later the stronger
    #[serde(default)]
    pub event: Vec<Event>,
}

/// A part of a real input. Times are in cycles, so that they hold for every cycle time.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Component {
    /// its form
    pub form: Form,
    /// its size, in the unit of the signal
    pub amplitude: f64,
    /// where it is there; always, if it is not said
    #[serde(default)]
    pub window: Window,
}

/// The form of a component, with values between -1 and 1.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields, rename_all = "snake_case")]
pub enum Form {
    /// 1
    Constant,
    /// a sine
    Sine {
        /// cycles of the block in one period
        period: f64,
    },
    /// a sine whose frequency rises linearly, and begins again
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
        /// cycles of a ramp, of which a quarter each the acceleration grows and falls
        ramp: u32,
    },
}

/// Cycles in which a component or an event is there: `length` cycles from `at` on, again after every `every` cycles.
#[derive(Clone, Copy, Debug, Default, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Window {
    /// the first cycle
    #[serde(default)]
    pub at: u64,
    /// how many; 0: to the end
    #[serde(default)]
    pub length: u64,
    /// after how many it begins again; 0: never
    #[serde(default)]
    pub every: u64,
}

/// A value that overrules a signal.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Event {
    /// the signal
    pub signal: String,
    /// the value, as a cell of a CSV file has it; reals also `nan`, `inf`, `-inf`
    pub value: String,
    /// when
    pub window: Window,
}

impl Window {
    fn contains(&self, sample: u64) -> bool {
        let Some(since) = sample.checked_sub(self.at) else { return false };
        let since = if self.every > 0 { since % self.every } else { since };
        self.length == 0 || since < self.length
    }
}

/// Makes a run of a block's inputs.
///
/// # Errors
/// What the stimulus says of a signal that the block does not have, or cannot have.
pub fn samples(stimulus: &Stimulus, shape: &Shape, count: usize) -> Result<Samples, String> {
    let mut samples = Samples::with_capacity(shape.clone(), count);
    let index = |name: &str| {
        let found = shape.signals.iter().position(|signal| signal.name == name);
        found.ok_or_else(|| format!("the block has no input `{name}`"))
    };
    let mut signals = Vec::new();
    for (name, components) in &stimulus.signal {
        let signal = index(name)?;
        if shape.signals[signal].ty != Type::Real {
            return Err(format!("`{name}` is no real: only an event can set it"));
        }
        signals.push((signal, components.iter().map(Generator::new).collect::<Vec<_>>()));
    }
    let mut events = Vec::new();
    for Event { signal, value, window } in &stimulus.event {
        let signal = index(signal)?;
        let parsed = parse(value, &shape.signals[signal], shape.real);
        events.push((signal, parsed.ok_or_else(|| format!("`{value}` is no value of `{}`", shape.signals[signal].name))?, window));
    }
    let mut values: Vec<Literal> = shape.signals.iter().map(|signal| signal.start).collect();
    for sample in 0..count as u64 {
        for (value, signal) in values.iter_mut().zip(&shape.signals) {
            *value = signal.start;
        }
        for (signal, generators) in &mut signals {
            let sum: f64 = generators.iter_mut().map(|generator| generator.at(sample)).sum();
            values[*signal] = real(sum, shape.real);
        }
        for (signal, value, window) in &events {
            if window.contains(sample) {
                values[*signal] = *value;
            }
        }
        samples.push(&values);
    }
    Ok(samples)
}

#[expect(clippy::cast_possible_truncation, reason = "a stimulus in single precision is rounded once, here")]
fn real(value: f64, kind: RealKind) -> Literal {
    match kind {
        RealKind::F64 => Literal::F64(value),
        RealKind::F32 => Literal::F32(value as f32),
    }
}

/// A component in motion.
struct Generator<'c> {
    component: &'c Component,
    random: u64,
}

impl<'c> Generator<'c> {
    fn new(component: &'c Component) -> Self {
        let seed = match component.form {
            Form::Noise { seed } => u64::from(seed),
            _ => 0,
        };
        Self { component, random: 88_172_645_463_325_252 ^ (seed << 20) }
    }

    /// The value at a sample; to be asked sample by sample.
    fn at(&mut self, sample: u64) -> f64 {
        if !self.component.window.contains(sample) {
            return 0.0;
        }
        let n = sample as f64;
        let turns = match self.component.form {
            Form::Constant => return self.component.amplitude,
            Form::Noise { .. } => return self.component.amplitude * self.noise(),
            Form::Move { phase, ramp } => return self.component.amplitude * velocity(sample, phase, ramp),
            Form::Sine { period } => n / period,
            Form::Chirp { from, to, length } => {
                let n = n % length;
                n / from + (1.0 / to - 1.0 / from) * n * n / (2.0 * length)
            }
        };
        self.component.amplitude * libm::sin(2.0 * std::f64::consts::PI * (turns - libm::floor(turns)))
    }

    /// Uniform between -1 and 1, from xorshift64.
    fn noise(&mut self) -> f64 {
        self.random ^= self.random << 13;
        self.random ^= self.random >> 7;
        self.random ^= self.random << 17;
        (self.random >> 11) as f64 / (1u64 << 52) as f64 - 1.0
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
    let end = phase as f64 - within as f64;
    direction * rise((within as f64).min(end) / ramp)
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
