//! The inputs of a block, sample by sample: sums of components, and events that override them.
//!
//! Everything comes from integers and `libm`, so that every host makes the same bits.

use crate::samples::{Samples, Shape};
use crate::value::parse;
use crate::waveform::{Form, Waveform};
use compiler::program::Type;
use portable::{Literal, RealKind};
use serde::{Deserialize, Deserializer};
use std::collections::BTreeMap;

/// The inputs of a run. An input that is not mentioned keeps its start value.
#[derive(Clone, Debug, Default, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Stimulus {
    /// for each real input the components to be added
    #[serde(default)]
    pub signal: BTreeMap<String, Vec<Component>>,
    /// events that override them; later ones override earlier ones
    #[serde(default)]
    pub event: Vec<Event>,
}

/// A part of a real input. Times are in cycles, so that they hold for every cycle time.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Component {
    pub form: Form,
    /// its size, in the unit of the signal
    pub amplitude: f64,
    /// the cycles in which it is active; by default always
    #[serde(default)]
    pub window: Window,
}

/// Cycles in which a component or an event is active: `length` cycles from `at` on, repeated after every `every` cycles.
#[derive(Clone, Copy, Debug, Default, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Window {
    /// the first cycle
    #[serde(default)]
    pub at: u64,
    /// number of cycles; 0: to the end
    #[serde(default)]
    pub length: u64,
    /// cycles until it begins again; 0: never
    #[serde(default)]
    pub every: u64,
}

/// A value that overrides a signal.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Event {
    pub signal: String,
    /// the value as a cell of a CSV file; a case file may also contain a number, `true` or `nan`, `inf`, `-inf`. An integer
    /// without sign may count the samples: `counts*2/3+4` is twice the number of the sample, divided by 3, plus 4
    #[serde(deserialize_with = "cell")]
    pub value: String,
    /// the cycles in which it is active
    pub window: Window,
}

impl Event {
    /// A value from `at` on, for `length` cycles, again after every `every` cycles.
    pub(crate) fn new(signal: &str, value: &str, at: u64, length: u64, every: u64) -> Self {
        Self { signal: signal.to_owned(), value: value.to_owned(), window: Window { at, length, every } }
    }
}

impl Window {
    fn contains(&self, sample: u64) -> bool {
        let Some(since) = sample.checked_sub(self.at) else { return false };
        let since = if self.every > 0 { since % self.every } else { since };
        self.length == 0 || since < self.length
    }
}

impl Component {
    /// Its value at a sample.
    fn at(&self, waveform: &mut Waveform<'_>, sample: u64) -> f64 {
        if self.window.contains(sample) { self.amplitude * waveform.at(sample) } else { 0.0 }
    }
}

/// A partner of a block: it sets inputs depending on the outputs of the block. Events override it, too.
pub trait Partner {
    /// Sets inputs of a sample.
    fn lead(&mut self, inputs: &mut [Literal]);
    /// Reads the inputs that the block gets in that sample.
    fn see(&mut self, inputs: &[Literal]);
}

/// Generates a run of a block's inputs.
///
/// # Errors
/// The stimulus contains a signal, or a value of it, that the block cannot have.
pub fn samples(stimulus: &Stimulus, shape: &Shape, count: usize) -> Result<Samples, String> {
    answered(stimulus, shape, count, None)
}

/// Generates a run of a block's inputs with a partner.
///
/// # Errors
/// The stimulus contains a signal, or a value of it, that the block cannot have.
pub fn answered(
    stimulus: &Stimulus,
    shape: &Shape,
    count: usize,
    mut partner: Option<&mut dyn Partner>,
) -> Result<Samples, String> {
    let mut signals = Vec::new();
    for (name, components) in &stimulus.signal {
        signals.push((real_signal(name, components, shape)?, with_waveforms(components)));
    }
    let events: Result<Vec<_>, String> = stimulus.event.iter().map(|event| overruling(event, shape)).collect();
    let events = events?;
    let start: Vec<Literal> = shape.signals.iter().map(|signal| signal.start).collect();
    let mut samples = Samples::with_capacity(shape.clone(), count);
    let mut values = start.clone();
    for sample in 0..count as u64 {
        values.copy_from_slice(&start);
        for (signal, components) in &mut signals {
            let parts = components.iter_mut().map(|(component, waveform)| component.at(waveform, sample));
            // Not `sum()`: the sign of its initial zero differs between versions of Rust.
            values[*signal] = real(parts.fold(0.0, |sum, part| sum + part), shape.real);
        }
        if let Some(partner) = &mut partner {
            partner.lead(&mut values);
        }
        for (signal, value, window) in &events {
            if window.contains(sample) {
                values[*signal] = value.at(sample);
            }
        }
        if let Some(partner) = &mut partner {
            partner.see(&values);
        }
        samples.push(&values);
    }
    Ok(samples)
}

/// The value that an event writes.
enum Written {
    /// one value
    Fixed(Literal),
    /// sample * times / parts + more, in 32 bits
    Counting { times: u64, parts: u64, more: u64 },
}

impl Written {
    #[expect(clippy::cast_possible_truncation, reason = "a counter wraps")]
    fn at(&self, sample: u64) -> Literal {
        match self {
            Self::Fixed(value) => *value,
            Self::Counting { times, parts, more } => Literal::U32((sample * times / parts + more) as u32),
        }
    }
}

/// The factors of `counts*2/3+4`; `None` for any other text.
fn counting(text: &str) -> Option<Written> {
    let rest = text.strip_prefix("counts")?;
    let (rest, more) = rest.split_once('+').unwrap_or((rest, "0"));
    let (rest, parts) = rest.split_once('/').unwrap_or((rest, "1"));
    let times = rest.strip_prefix('*').unwrap_or(if rest.is_empty() { "1" } else { rest });
    let number = |text: &str| text.parse::<u32>().ok().map(u64::from);
    let (times, parts, more) = (number(times)?, number(parts).filter(|parts| *parts > 0)?, number(more)?);
    Some(Written::Counting { times, parts, more })
}

/// The position of a real input with valid components.
fn real_signal(name: &str, components: &[Component], shape: &Shape) -> Result<usize, String> {
    let signal = position(name, shape)?;
    if shape.signals[signal].ty != Type::Real {
        return Err(format!("`{name}` is not a real: only an event can set it"));
    }
    match components.iter().find_map(|component| component.form.mistake()) {
        Some(mistake) => Err(format!("`{name}`: {mistake}")),
        None => Ok(signal),
    }
}

fn with_waveforms(components: &[Component]) -> Vec<(&Component, Waveform<'_>)> {
    components.iter().map(|component| (component, Waveform::new(&component.form))).collect()
}

/// The input that an event overrides, with the value and the time.
fn overruling(event: &Event, shape: &Shape) -> Result<(usize, Written, Window), String> {
    let signal = position(&event.signal, shape)?;
    let counts = shape.signals[signal].ty == Type::U32;
    let value = parse(&event.value, &shape.signals[signal], shape.real).map(Written::Fixed);
    let value = value.or_else(|| counting(&event.value).filter(|_| counts));
    let value = value.ok_or_else(|| format!("`{}` is not a value of `{}`", event.value, event.signal))?;
    Ok((signal, value, event.window))
}

fn position(name: &str, shape: &Shape) -> Result<usize, String> {
    let found = shape.place(name);
    found.ok_or_else(|| format!("the block has no input `{name}`"))
}

#[expect(clippy::cast_possible_truncation, reason = "a stimulus in single precision is rounded once, here")]
fn real(value: f64, kind: RealKind) -> Literal {
    match kind {
        RealKind::F64 => Literal::F64(value),
        RealKind::F32 => Literal::F32(value as f32),
    }
}

/// A value of a case file as a cell.
fn cell<'de, D: Deserializer<'de>>(deserializer: D) -> Result<String, D::Error> {
    #[derive(Deserialize)]
    #[serde(untagged)]
    enum Value {
        Bool(bool),
        Integer(i64),
        Real(f64),
        Text(String),
    }
    Value::deserialize(deserializer).map(|value| match value {
        Value::Bool(value) => u8::from(value).to_string(),
        Value::Integer(value) => value.to_string(),
        Value::Real(value) => format!("{value:?}"),
        Value::Text(text) => text,
    })
}
