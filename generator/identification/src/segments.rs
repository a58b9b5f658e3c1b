//! The segments of a record, from its command: rest, driving, ramps. No spectrum.

use portable::peak;
use std::ops::Range;

/// An axis accelerates above the first part of its largest acceleration, and drives above the second part of its largest
/// velocity.
const ACCELERATES: f64 = 0.02;
const DRIVES: f64 = 0.05;

/// The motion that the command asks for.
#[derive(Clone, Copy, Debug, Eq, PartialEq)]
pub enum Kind {
    Rest,
    Driving,
    Accelerating,
}

/// Samples of one kind.
#[derive(Clone, Debug, Eq, PartialEq)]
pub struct Segment {
    pub kind: Kind,
    pub samples: Range<usize>,
}

/// The segments of a record by its commanded velocity: accelerating where |a| is above 2 % of its peak, else driving
/// where |v| is above 5 % of its peak, else rest.
#[must_use]
pub fn of(v_command: &[f64]) -> Vec<Segment> {
    let mut a: Vec<f64> = v_command.windows(2).map(|pair| pair[1] - pair[0]).collect();
    a.insert(0, 0.0);
    let (least_a, least_v) = (ACCELERATES * peak(&a), DRIVES * peak(v_command));
    let mut segments: Vec<Segment> = Vec::new();
    for (n, (a, v)) in a.iter().zip(v_command).enumerate() {
        let kind = match () {
            () if libm::fabs(*a) > least_a => Kind::Accelerating,
            () if libm::fabs(*v) > least_v => Kind::Driving,
            () => Kind::Rest,
        };
        match segments.last_mut() {
            Some(last) if last.kind == kind => last.samples.end = n + 1,
            _ => segments.push(Segment { kind, samples: n..n + 1 }),
        }
    }
    segments
}

/// The ramps: samples of each.
pub fn ramps(segments: &[Segment]) -> impl Iterator<Item = Range<usize>> {
    segments.iter().filter(|segment| segment.kind == Kind::Accelerating).map(|segment| segment.samples.clone())
}

/// The segments of one kind, from some time after the previous ramp to the next ramp.
pub fn settled(segments: &[Segment], kind: Kind, settle: usize) -> impl Iterator<Item = Range<usize>> {
    let of = move |segment: &Segment| segment.samples.start + settle..segment.samples.end;
    segments.iter().filter(move |segment| segment.kind == kind).map(of).filter(|window| window.start < window.end)
}

/// Windows of a length from some time after each ramp's end; shorter before the next ramp, but at least half as long.
pub fn after_ramps(segments: &[Segment], settle: usize, length: usize) -> impl Iterator<Item = Range<usize>> {
    let window = move |pair: &[Segment]| {
        let from = pair[0].samples.end + settle;
        let is_ramp = pair[0].kind == Kind::Accelerating;
        let window = from..pair[1].samples.end.min(from + length);
        (is_ramp && window.start + length / 2 <= window.end).then_some(window)
    };
    segments.windows(2).filter_map(window)
}
