//! The remaining part of a record's vibrations with stages, relative to the record without: measured in the same way.

use crate::peaks::windowed;
use crate::shape::{Shape, Stages};
use crate::what_if::{Axis, WhatIf, following_error};
use crate::{Complex64, magnitude, turned, whole};
use portable::{Extreme, peak};
use std::f64::consts::TAU;
use std::ops::Range;

/// The time in which a vibration is measured.
#[derive(Clone, Copy, Debug, Eq, PartialEq)]
pub enum When {
    /// at constant speed: from 0.4 s after a ramp's end to the next ramp
    Driving,
    /// around ramps: 1.0 s from 0.1 s before each ramp; and its ring-down, the peak from 0.08 to 0.6 s after each ramp's end
    Ramps,
}

/// A vibration to be damped by stages.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Vibration {
    /// [Hz]
    pub hz: f64,
    pub when: When,
    /// the channel of the record that shows it; `None` for the following error
    pub channel: Option<usize>,
}

/// A record with the stages off: at rest at both ends, all signals of one length, sampled at T.
#[derive(Clone, Copy, Debug)]
pub struct Record<'a> {
    /// the examined signals: of the load, or of the motor
    pub channels: &'a [&'a [f64]],
    pub v_motor: &'a [f64],
    /// acceleration of the load; `None` without a sensor there
    pub load: Option<&'a [f64]>,
    /// following error: command minus position of the motor, in the unit of the way of `v_motor`
    pub error: Option<&'a [f64]>,
    /// the ramps: the samples of each
    pub ramps: &'a [Range<usize>],
}

/// Windows [s], and bands as parts of the frequency.
const DWELL_SETTLE: f64 = 0.4;
/// No dwell is looked at for longer: the cost of its lines grows with the square of that.
const LONGEST_DWELL: f64 = 3.0;
const RAMP: [f64; 2] = [-0.1, 0.9];
const RING: [f64; 2] = [0.08, 0.6];
const STOP: [f64; 2] = [0.14, 0.94];
const OF_DWELL: [f64; 2] = [50.0 / 53.0, 56.0 / 53.0];
const OF_RAMP: [f64; 2] = [9.5 / 11.0, 12.5 / 11.0];
const OF_RING: [f64; 2] = [7.0 / 11.0, 18.0 / 11.0];
/// Lines per 1/(length of a window).
const PADDED: f64 = 8.0;
/// The highest frequency for the figures, relative to that of a vibration: an amplitude needs little above it, a peak needs
/// 16 samples per period. The motion after stops has those of amplitudes: R multiplies the noise above them.
const HIGHEST: [f64; 2] = [2.2, 8.0];

/// The signals of the record: the following error, the velocity of the motor, the acceleration of the load, and after them the
/// channels.
const ERROR: usize = 0;
const MOTOR: usize = 1;
const LOAD: usize = 2;
const BEFORE: usize = 3;

/// Stages that leave more than that of every vibration are useless.
const USELESS: f64 = 0.8;
/// Stages with which the load moves more than that after stops make it worse.
const UNSETTLED: f64 = 1.1;

/// What is left, as parts.
#[derive(Clone, Debug, PartialEq)]
pub struct Left {
    /// the remaining part of the amplitude of each vibration
    pub residuals: Vec<f64>,
    /// the remaining part of the largest ring-down; `None` if no vibration belongs to ramps
    pub ring: Option<f64>,
    /// rms of the acceleration of the load from 0.14 to 0.94 s after each ramp to standstill, at every frequency up to 2.2
    /// times the highest vibration, by that without stages: slow creeping, and the ringing of the stages themselves
    pub settled: Option<f64>,
}

impl Left {
    /// The largest of all parts, and the mean.
    #[must_use]
    pub fn worst_and_mean(&self) -> [f64; 2] {
        let all = || self.residuals.iter().copied().chain(self.ring);
        let worst = all().fold(0.0, f64::larger);
        [worst, all().sum::<f64>() / all().count().max(1) as f64]
    }

    /// Whether more than 0.8 is left of every vibration.
    #[must_use]
    pub fn is_useless(&self) -> bool {
        self.residuals.iter().all(|left| *left > USELESS)
    }

    /// By how much the load moves more after stops than 1.1 times that without stages.
    pub(crate) fn unsettled(&self) -> f64 {
        (self.settled.unwrap_or(0.0) - UNSETTLED).larger(0.0)
    }

    /// Whether the load moves more than that after stops.
    #[must_use]
    pub fn is_unsettled(&self) -> bool {
        self.unsettled() > 0.0
    }
}

/// The effect of stages on the motor in a record.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Effect {
    /// the peak of the following error divided by that without stages; `None` if it is not recorded, or always 0
    pub following_error: Option<f64>,
    /// the largest value that the stages add: C R `v_motor`
    pub peak_v_add: f64,
}

/// A record with known figures without stages.
pub struct Judge<'a> {
    vibrations: &'a [Vibration],
    record: Record<'a>,
    axis: Axis<'a>,
    what_if: WhatIf<'a>,
    /// the record of `v_motor` alone, with all frequencies
    of_motor: WhatIf<'a>,
    /// the windows of dwells, of ramps and of ring-downs, in samples of the result
    dwells: Vec<Range<usize>>,
    about_ramps: Vec<Range<usize>>,
    rings: Vec<Range<usize>>,
    stops: Vec<Range<usize>>,
    /// amplitude and ring-down of each vibration without stages, and the rms of the load after stops
    without: Vec<[f64; 2]>,
    restless: Option<f64>,
}

impl<'a> Judge<'a> {
    /// `None` if a vibration has no channel, or no window (no dwell, no ramp).
    #[must_use]
    pub fn new(axis: Axis<'a>, record: Record<'a>, vibrations: &'a [Vibration]) -> Option<Self> {
        let needed = |vibration: &Vibration| vibration.hz * HIGHEST[usize::from(vibration.when == When::Ramps)];
        let highest = vibrations.iter().map(needed).fold(0.0, f64::larger);
        let has = |channel: Option<usize>| channel.map_or(record.error.is_some(), |at| at < record.channels.len());
        vibrations.iter().all(|vibration| has(vibration.channel) && vibration.hz > 0.0).then_some(())?;
        let load = without_offset(record.load.unwrap_or_default());
        let all = [&[record.error.unwrap_or_default(), record.v_motor, &load], record.channels].concat();
        let what_if = WhatIf::new(axis, &all, Some(highest));
        let place = |seconds: f64| whole((seconds / what_if.step()).larger(0.0));
        let cycle = axis.cycle_time;
        let about = |window: [f64; 2], of: fn(&Range<usize>) -> usize| {
            let at = |ramp: &Range<usize>, time: f64| place(of(ramp) as f64 * cycle + time);
            record.ramps.iter().map(|ramp| at(ramp, window[0])..at(ramp, window[1])).collect()
        };
        let dwells = dwells(&record, cycle).map(|[from, to]| place(from)..place(to)).collect();
        let (about_ramps, rings) = (about(RAMP, |ramp| ramp.start), about(RING, |ramp| ramp.end));
        let stops = stops(&record, cycle).map(|[from, to]| place(from)..place(to)).collect();
        let of_motor = WhatIf::new(axis, &[record.v_motor], None);
        let without = Vec::new();
        let mut judge = Self {
            vibrations,
            record,
            axis,
            what_if,
            of_motor,
            dwells,
            about_ramps,
            rings,
            stops,
            without,
            restless: None,
        };
        let unchanged = vec![Complex64::from(1.0); judge.what_if.lines()];
        (judge.without, judge.restless) = (judge.amplitudes(&unchanged), judge.after_stops(&unchanged));
        judge.without.iter().all(|[amplitude, ring]| *amplitude > 0.0 && *ring > 0.0).then_some(judge)
    }

    /// The remaining parts with these stages and weights.
    #[must_use]
    pub fn left(&self, stages: &Stages<'_>, of: &[(Shape, f64)]) -> Left {
        self.left_of(&self.what_if.controller(stages, of))
    }

    /// What a controller C, given at the lines, leaves.
    fn left_of(&self, controller: &[Complex64]) -> Left {
        let left = &self.what_if.left(controller);
        let with = self.amplitudes(left);
        let is_ramp = |k: &usize| self.vibrations[*k].when == When::Ramps;
        let ring = |of: &[[f64; 2]]| (0..of.len()).filter(is_ramp).map(|k| of[k][1]).reduce(f64::larger);
        let ring = ring(&with).zip(ring(&self.without)).map(|(with, without)| with / without);
        let residuals = with.iter().zip(&self.without).map(|(with, without)| with[0] / without[0]).collect();
        let settled = self.restless.and_then(|without| Some(self.after_stops(left)? / without));
        Left { residuals, ring, settled }
    }

    /// The rms of the acceleration of the load after stops with the stages that leave R; `None` if it is 0, or not recorded.
    fn after_stops(&self, left: &[Complex64]) -> Option<f64> {
        self.record.load?;
        let highest = self.vibrations.iter().map(|vibration| vibration.hz).fold(0.0, f64::larger);
        let [_, below] = self.what_if.signal(LOAD, left, 1.0, [0.0, HIGHEST[0] * highest]);
        let squares = self.stops.iter().flat_map(|window| below.get(window.clone())).flatten().map(|a| a * a);
        Some(mean(squares).sqrt()).filter(|rms| *rms > 0.0)
    }

    /// Amplitude and ring-down of each vibration with the stages that leave R, given at the lines.
    fn amplitudes(&self, left: &[Complex64]) -> Vec<[f64; 2]> {
        let of = |vibration: &Vibration| {
            let band = OF_RING.map(|part| part * vibration.hz);
            let [signal, ringing] = match vibration.channel {
                Some(channel) => self.what_if.signal(BEFORE + channel, left, 1.0, band),
                None => self.what_if.error([ERROR, MOTOR], left, band),
            };
            match vibration.when {
                When::Driving => [self.amplitude(&signal, &self.dwells, OF_DWELL.map(|part| part * vibration.hz)), 1.0],
                When::Ramps => {
                    let peaks = self.rings.iter().filter_map(|window| Some(peak(ringing.get(window.clone())?)));
                    [self.amplitude(&signal, &self.about_ramps, OF_RAMP.map(|part| part * vibration.hz)), mean(peaks)]
                }
            }
        };
        self.vibrations.iter().map(of).collect()
    }

    /// The mean over windows of the largest amplitude within a band [Hz]: Hann window, eight lines in 1/length.
    fn amplitude(&self, signal: &[f64], windows: &[Range<usize>], band: [f64; 2]) -> f64 {
        let of = |window: &Range<usize>| {
            let windowed = windowed(signal.get(window.clone())?)?;
            let spacing = 1.0 / (PADDED * window.len() as f64 * self.what_if.step());
            let lines = whole(libm::floor((band[1] - band[0]) / spacing));
            let amplitude = |k: usize| sine(&windowed, TAU * (band[0] + k as f64 * spacing) * self.what_if.step());
            Some((0..=lines).map(amplitude).fold(0.0, f64::larger))
        };
        mean(windows.iter().filter_map(of))
    }

    /// The effect of stages and weights on the motor.
    #[must_use]
    pub fn effect(&self, stages: &Stages<'_>, of: &[(Shape, f64)]) -> Effect {
        self.effect_of(&self.of_motor.controller(stages, of))
    }

    /// What a controller C leaves, and what it does to the motor: a function of t = tan(pi f T).
    pub fn figures(&self, controller: impl Fn(f64) -> Complex64) -> (Left, Effect) {
        let left = self.left_of(&self.what_if.at_lines(&controller));
        (left, self.effect_of(&self.of_motor.at_lines(&controller)))
    }

    fn effect_of(&self, controller: &[Complex64]) -> Effect {
        let left = self.of_motor.left(controller);
        let added: Vec<Complex64> = left.iter().zip(controller).map(|(left, c)| left * c).collect();
        let following_error = self.record.error.filter(|error| peak(error) > 0.0).map(|error| {
            let left = self.of_motor.whole(0, &left, 1.0);
            peak(&following_error(error, self.record.v_motor, &left, self.axis.cycle_time)) / peak(error)
        });
        Effect {
            following_error,
            // C is 0 at 0 Hz.
            peak_v_add: peak(&self.of_motor.whole(0, &added, 0.0)),
        }
    }
}

/// The dwells [s]: from 0.4 s after each ramp to the next one, where the axis drives: between the first and the second ramp, the
/// third and the fourth; 3 s at most. An axis drives above 5 % of its largest velocity.
fn dwells(record: &Record<'_>, cycle: f64) -> impl Iterator<Item = [f64; 2]> {
    let standstill = 0.05 * peak(record.v_motor);
    let v_motor = record.v_motor;
    record.ramps.windows(2).filter_map(move |pair| {
        let from = pair[0].end as f64 * cycle + DWELL_SETTLE;
        let to = (pair[1].start as f64 * cycle).smaller(from + LONGEST_DWELL);
        let drives = libm::fabs(*v_motor.get(pair[0].end.midpoint(pair[1].start))?) > standstill;
        (from < to && drives).then_some([from, to])
    })
}

/// After stops [s]: from 0.14 to 0.94 s after each ramp at whose end the axis stands still, shorter before the next ramp, but
/// at least half as long.
fn stops(record: &Record<'_>, cycle: f64) -> impl Iterator<Item = [f64; 2]> {
    let standstill = 0.05 * peak(record.v_motor);
    let next = record.ramps.iter().skip(1).map(|ramp| ramp.start).chain([record.v_motor.len()]);
    record.ramps.iter().zip(next).filter_map(move |(ramp, next)| {
        let [from, to] = STOP.map(|time| ramp.end as f64 * cycle + time);
        let until = to.smaller(next as f64 * cycle);
        let stands = libm::fabs(*record.v_motor.get(whole(until / cycle).checked_sub(1)?)?) <= standstill;
        (stands && until - from >= (to - from) / 2.0).then_some([from, until])
    })
}

/// An acceleration without the offset of its sensor: from rest to rest its mean is 0.
fn without_offset(acceleration: &[f64]) -> Vec<f64> {
    let offset = mean(acceleration.iter().copied());
    acceleration.iter().map(|value| value - offset).collect()
}

/// The amplitude of a sine of w rad per sample in a windowed signal.
fn sine(windowed: &[f64], w: f64) -> f64 {
    let step = turned(-w);
    let mut turn = Complex64::from(1.0);
    let mut sum = Complex64::from(0.0);
    for sample in windowed {
        sum += turn * *sample;
        turn *= step;
    }
    4.0 / windowed.len() as f64 * magnitude(sum)
}

fn mean(values: impl Iterator<Item = f64>) -> f64 {
    let (sum, count) = values.fold((0.0, 0.0), |(sum, count), value| (sum + value, count + 1.0));
    if count > 0.0 { sum / count } else { 0.0 }
}
