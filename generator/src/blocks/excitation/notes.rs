//! What the excitation means, in words: its coefficients, and what a start of it does to the machine. No design.

use super::super::ipc::notes::{cycle_time, note};
use crate::axis::Axis;
use crate::number::{digits, rounded};

pub(super) fn notes(axis: &Axis) -> Vec<(String, String)> {
    let Some(of) = &axis.excitation else { return Vec::new() };
    let [sequence, start] = [sequence(axis), start(axis)].map(Option::unwrap_or_default);
    let period = of.sequence.period();
    vec![
        note("cycle_time_ns", cycle_time(axis)),
        note("bits", format!("keys excitation.bits, excitation.clock: {sequence}")),
        note("periods", format!("key excitation.periods: measured periods of {period} cycles, after one that settles")),
        note("amplitude", format!("key excitation.amplitude: {start}")),
        note("fade_cycles", "fade of the excitation: 0.1 s".to_owned()),
    ]
}

/// What a start of it does, for the summary.
pub(super) fn lines(axis: &Axis) -> Vec<String> {
    let (sequence, start) = (sequence(axis), start(axis));
    sequence.zip(start).map(|(sequence, start)| format!("excitation: {sequence}; {start}")).into_iter().collect()
}

fn sequence(axis: &Axis) -> Option<String> {
    let of = axis.excitation.as_ref()?;
    Some(format!(
        "{} bits, clocks of {}, period {} s, lines {} Hz apart, up to {} Hz",
        of.sequence.bits(),
        cycles(of.sequence.clock()),
        rounded(of.sequence.period() as f64 * axis.cycle_time()),
        rounded(of.sequence.spacing(axis.cycle_time())),
        rounded(of.sequence.half_clock(axis.cycle_time()))
    ))
}

fn cycles(count: u32) -> String {
    if count == 1 { "a cycle".to_owned() } else { format!("{count} cycles") }
}

/// What a start means for the machine.
fn start(axis: &Axis) -> Option<String> {
    let of = axis.excitation.as_ref()?;
    let start = of.at(axis.cycle_time());
    let (path, speed) = if axis.control.is_rotary { ("deg", "deg/s") } else { ("mm", "mm/s") };
    Some(format!(
        "command steps of {} {speed}; move at {} {speed} or faster in one direction: {} {path} at this speed; {} periods \
         measured after one that settles, {} s in all",
        digits(start.step() / 1e3),
        digits(start.least_speed() / 1e3),
        rounded(start.duration() * start.least_speed() / 1e3),
        of.periods,
        rounded(start.duration())
    ))
}
