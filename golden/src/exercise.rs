//! A stimulus for any axis: what `verify` runs a user's own blocks with.

use crate::stimulus::{Component, Event, Stimulus, Window};
use crate::waveform::Form;
use generator::axis::{Axis, Filter};

/// Everything that can happen to a block: moves, vibrations at its own frequencies, noise, steps to the limit, mode
/// changes, resets, loss of position control, bad samples, wrong cycle times, and rest.
#[must_use]
pub fn stimulus(axis: &Axis) -> Stimulus {
    let v_max = axis.ipc.v_max;
    let signal = ["v_command", "v_motor", "v_direct"].into_iter().zip(1..);
    let signal = signal.map(|(name, seed)| (name.to_owned(), components(axis, seed, v_max))).collect();
    Stimulus { signal, event: events() }
}

fn components(axis: &Axis, seed: u32, v_max: f64) -> Vec<Component> {
    let moving = Window { at: 0, length: 60_000, every: 80_000 };
    let part = |form, share: f64, window| Component { form, amplitude: share * v_max, window };
    let mut components = vec![
        part(Form::Move { phase: 5_000, ramp: 500 }, 1.0, moving),
        part(Form::Noise { seed }, 0.01, moving),
        part(Form::Chirp { from: 2_000.0, to: 2.5, length: 20_000.0 }, 0.05, moving),
        part(Form::Constant, 0.5, Window { at: 31_000, length: 2_000, every: 40_000 }),
    ];
    let filters = axis.ipc.stage.iter().flatten().flat_map(|stage| stage.filter);
    components.extend(filters.filter_map(|filter| match filter {
        Filter::Bandpass { f0, .. } => Some(part(Form::Sine { period: 1.0 / (f0 * axis.cycle_time()) }, 0.1, moving)),
        _ => None,
    }));
    components
}

fn events() -> Vec<Event> {
    let event = |signal: &str, value: &str, at, length, every| Event {
        signal: signal.to_owned(),
        value: value.to_owned(),
        window: Window { at, length, every },
    };
    vec![
        event("mode", "1", 50, 0, 0),
        event("mode", "2", 12_000, 3_000, 25_000),
        event("mode", "0", 18_000, 1_000, 23_000),
        event("mode", "3", 27_000, 2, 29_000),
        event("position_controlled", "0", 21_000, 40, 31_000),
        event("reset", "1", 9_000, 30, 37_000),
        event("task_cycle_ns", "1", 33_000, 3, 41_000),
        event("v_command", "nan", 14_000, 1, 43_000),
        event("v_motor", "inf", 16_000, 2, 47_000),
        event("v_motor", "-1.5e15", 24_500, 1, 53_000),
        event("v_direct", "nan", 26_000, 1, 59_000),
    ]
}
