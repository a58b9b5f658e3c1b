//! Vibrations of a recording: lines while driving, decays after ramps, poles of a response; and the side on which they
//! enter. No file.

use super::excited::Excited;
use super::record::Record;
use super::verdict::Verdict;
use generator::codes;
use identification::decay::{self, Companions, Decay, decay};
use identification::peaks::{self, Peak, Spectrum, is_order, stands};
use identification::resonance;
use identification::segments::Segment;
use identification::source::{Side, ratio, side};
use portable::Extreme;
use stability::magnitude;
use std::borrow::Cow;
use std::ops::Range;

/// The channels that are examined for vibrations.
const LOOKED_AT: [&str; 4] = ["a_load", "v_direct", "v_motor", "following_error"];
/// Peaks of a spectrum that count: their number, their amplitude relative to the strongest one, their precision in 1/(length
/// of the window).
const MOST: usize = 3;
const WEAKEST: f64 = 0.1;
const LEAST_EXACT: f64 = 0.1;
/// The largest number of ramps whose decays are used.
const RAMPS: usize = 8;
/// Limits of a valid decay: damping; relative errors of frequency and damping; distance from its peak.
const DAMPING: [f64; 2] = [5e-4, 0.4];
const ERRORS: [f64; 2] = [0.03, 0.5];
const FROM_PEAK: f64 = 0.15;
/// The largest line that the rounding to a last digit makes, as a part of its step: that of a sawtooth, 1/pi.
const OF_A_DIGIT: f64 = std::f64::consts::FRAC_1_PI;
/// Relative tolerance for equal speeds.
const SAME_SPEED: f64 = 0.05;
/// A pole is searched where a response is the largest within this part of its frequency.
const ABOUT: f64 = 0.12;

/// The time in which a vibration is visible.
#[derive(Clone, Copy, Debug, Eq, PartialEq)]
pub enum When {
    Driving,
    Ramps,
    Excited,
}

#[derive(Clone, Debug, PartialEq)]
pub struct Vibration {
    pub channel: &'static str,
    pub when: When,
    /// [Hz], and its standard error
    pub hz: f64,
    pub hz_error: f64,
    /// damping and its standard error; `None` if it is forced, or if the channel does not show it
    pub damping: Option<[f64; 2]>,
    /// in the unit of the channel
    pub amplitude: f64,
    pub is_forced: bool,
    pub competes: bool,
    pub is_at_edge: bool,
    /// frequency divided by speed, in the unit of the command, if it is equal at two speeds
    pub order: Option<f64>,
    /// `None` if unknown
    pub source: Option<Side>,
    /// the samples in which it is visible
    windows: Vec<Range<usize>>,
}

/// Windows of a move.
#[derive(Clone, Debug, Default)]
pub struct Windows {
    /// driving, by speed
    pub driving: Vec<(f64, Vec<Range<usize>>)>,
    /// after ramps
    pub ramps: Vec<Range<usize>>,
}

impl Windows {
    pub(super) fn of(segments: &[Segment], command: &[f64], cycle: f64) -> Self {
        let mut windows = Self { driving: Vec::new(), ramps: decay::windows(segments, cycle) };
        windows.ramps.truncate(RAMPS);
        for window in peaks::driving(segments, cycle) {
            let speed = libm::fabs(command[window.start.midpoint(window.end)]);
            let is_same = |known: &f64| libm::fabs(known / speed - 1.0) <= SAME_SPEED;
            match windows.driving.iter_mut().find(|(known, _)| is_same(known)) {
                Some((_, of)) => of.push(window),
                None => windows.driving.push((speed, vec![window])),
            }
        }
        windows
    }
}

/// The examined signals of a record.
pub(super) fn signals(record: &Record) -> Vec<(&'static str, Cow<'_, [f64]>)> {
    let of = |name: &'static str| match name {
        "following_error" => record.following_error().map(|error| (name, error)),
        _ => record.get(name).map(|values| (name, Cow::Borrowed(values))),
    };
    LOOKED_AT.into_iter().filter_map(of).collect()
}

/// The vibrations of moves, with the gain of the position controller Kv [1/s], if it is known.
pub(super) fn of_moves(record: &Record, windows: &Windows, kv: Option<f64>) -> Vec<Vibration> {
    let mut all = Vec::new();
    for (channel, signal) in signals(record) {
        let least = record.written(channel) * OF_A_DIGIT;
        let mut found = driving(channel, &signal, windows, record.cycle);
        let forced: Vec<f64> = found.iter().map(|vibration| vibration.hz).collect();
        // Signals of the motor contain the decay of the position loop; in the following error without Kv it hides everything
        // else.
        let companions = Companions { position_gain: kv.filter(|_| channel != "a_load"), forced: &forced };
        if channel != "following_error" || kv.is_some() {
            found.extend(ramps(channel, &signal, &windows.ramps, record.cycle, companions));
        }
        all.extend(found.into_iter().filter(|vibration| vibration.amplitude > least));
    }
    all
}

/// The peaks of a spectrum that are not noise.
fn strong(spectrum: &Spectrum, least: f64) -> Vec<Peak> {
    let peaks = spectrum.peaks();
    let first = peaks.first().map_or(0.0, |peak| peak.amplitude);
    let counts = |peak: &Peak| {
        peak.amplitude >= WEAKEST * first && peak.hz >= least && peak.hz_error <= LEAST_EXACT * spectrum.resolution
    };
    peaks.into_iter().filter(counts).take(MOST).collect()
}

/// Steady lines at constant speed.
fn driving(channel: &'static str, signal: &[f64], windows: &Windows, cycle: f64) -> Vec<Vibration> {
    let mut found: Vec<(f64, Vibration)> = Vec::new();
    for (speed, of) in &windows.driving {
        let Some(spectrum) = Spectrum::of(signal, of, cycle) else { continue };
        for peak in strong(&spectrum, 2.0 * spectrum.resolution) {
            if stands(signal, of, cycle, peak.hz) {
                found.push((*speed, of_peak(channel, &peak, of)));
            }
        }
    }
    let orders: Vec<Option<f64>> = found
        .iter()
        .map(|(speed, line)| {
            let is_same = |(other, of): &&(f64, Vibration)| {
                is_order([[line.hz, line.hz_error], [of.hz, of.hz_error]], [*speed, *other])
            };
            found.iter().find(is_same).map(|_| line.hz / speed)
        })
        .collect();
    found.into_iter().zip(orders).map(|((_, line), order)| Vibration { order, ..line }).collect()
}

fn of_peak(channel: &'static str, peak: &Peak, windows: &[Range<usize>]) -> Vibration {
    Vibration {
        channel,
        when: When::Driving,
        hz: peak.hz,
        hz_error: peak.hz_error,
        damping: None,
        amplitude: peak.amplitude,
        is_forced: true,
        competes: peak.competes,
        is_at_edge: peak.is_at_edge,
        order: None,
        source: None,
        windows: windows.to_vec(),
    }
}

/// Vibrations that decay after ramps.
fn ramps(
    channel: &'static str,
    signal: &[f64],
    windows: &[Range<usize>],
    cycle: f64,
    companions: Companions<'_>,
) -> Vec<Vibration> {
    let Some(spectrum) = Spectrum::of(signal, windows, cycle) else { return Vec::new() };
    let is_forced = |hz: f64| companions.forced.iter().any(|line| libm::fabs(line - hz) < 2.0 * spectrum.resolution);
    let peaks: Vec<Peak> = strong(&spectrum, 0.0).into_iter().filter(|peak| !is_forced(peak.hz)).collect();
    let mut found: Vec<Vibration> = Vec::new();
    for peak in peaks {
        let Some(decay) = decay(signal, windows, cycle, peak.hz, companions).filter(|of| is_believed(of, peak.hz))
        else {
            continue;
        };
        if found.iter().all(|known| libm::fabs(known.hz - decay.hz) > spectrum.resolution) {
            let line = of_peak(channel, &peak, windows);
            found.push(of_decay(line, &decay, When::Ramps));
        }
    }
    found
}

fn is_believed(decay: &Decay, near: f64) -> bool {
    (DAMPING[0]..=DAMPING[1]).contains(&decay.damping)
        && decay.hz_error <= ERRORS[0] * decay.hz
        && decay.damping_error <= ERRORS[1] * decay.damping
        && libm::fabs(decay.hz / near - 1.0) <= FROM_PEAK
}

fn of_decay(line: Vibration, decay: &Decay, when: When) -> Vibration {
    Vibration {
        when,
        hz: decay.hz,
        hz_error: decay.hz_error,
        damping: Some([decay.damping, decay.damping_error]),
        amplitude: decay.amplitude,
        is_forced: false,
        ..line
    }
}

/// The poles of the measured response.
pub(super) fn of_response(excited: &Excited) -> Vec<Vibration> {
    let lines = &excited.lines;
    let size: Vec<f64> = lines.response.iter().map(|p| magnitude(*p)).collect();
    let is_largest = |k: &usize| {
        let near = |other: &usize| libm::fabs(lines.hz[*other] / lines.hz[*k] - 1.0) <= ABOUT;
        let about: Vec<f64> = (0..size.len()).filter(near).map(|other| size[other]).collect();
        let largest = about.iter().copied().fold(0.0, f64::larger);
        let least = about.iter().copied().fold(f64::INFINITY, f64::smaller);
        about.len() > 8 && size[*k] >= largest && largest > 1.2 * least
    };
    let of = |k: usize| {
        let pole = resonance::pole(&excited.raw, lines.hz[k]).filter(|pole| is_believed(pole, lines.hz[k]))?;
        let peak = Peak {
            hz: pole.hz,
            hz_error: pole.hz_error,
            amplitude: pole.amplitude,
            competes: false,
            is_at_edge: false,
        };
        Some(of_decay(of_peak("v_motor", &peak, &[]), &pole, When::Excited))
    };
    (0..size.len()).filter(is_largest).filter_map(of).collect()
}

/// Determines the side on which vibrations of a move enter; reports vibrations for which it is unknown. A vibration that
/// decays after a ramp was excited by the command, at the motor; its ratio cannot be compared with the steady one of an
/// excitation. For the others the recording of an excitation decides.
pub(super) fn find_sides(
    vibrations: &mut [Vibration],
    record: &Record,
    excited: Option<(&Record, &Excited)>,
    verdicts: &mut Vec<Verdict>,
) {
    let mut unknown: Vec<String> = Vec::new();
    for vibration in vibrations.iter_mut().filter(|vibration| vibration.when != When::Excited) {
        vibration.source = match vibration.when {
            When::Ramps => Some(Side::Motor),
            When::Driving | When::Excited => side_of(vibration, record, excited),
        };
        let shown = format!("{:.1} Hz", vibration.hz);
        if vibration.source.is_none() && !unknown.contains(&shown) {
            unknown.push(shown);
        }
    }
    if !unknown.is_empty() {
        let found = format!("whether the motor's or the load's side makes them is not known: {}", unknown.join(", "));
        let instead =
            "record a_load and v_motor, with their units, in a move and again with an excitation (--excited FILE)";
        verdicts.push(Verdict::note(codes::SIDE_UNKNOWN, found, instead));
    }
}

fn side_of(vibration: &Vibration, record: &Record, excited: Option<(&Record, &Excited)>) -> Option<Side> {
    let (a_load, v_motor) = record.get("a_load").zip(record.get("v_motor"))?;
    let (other, excited) = excited?;
    let units = record.unit_ratio(other, "a_load")? / record.unit_ratio(other, "v_motor")?;
    let excited = excited.load_at(vibration.hz, record.cycle)?;
    // A line of the motor that is hidden by noise contains no information.
    let spectrum = Spectrum::of(v_motor, &vibration.windows, record.cycle)?;
    let near = 2.0 * spectrum.resolution;
    spectrum.strongest([vibration.hz - near, vibration.hz + near])?;
    let moving = ratio(a_load, v_motor, &vibration.windows, record.cycle, vibration.hz)?;
    Some(side(moving * units, excited))
}

/// Reports doubtful vibrations.
pub(super) fn find_doubts(vibrations: &[Vibration], verdicts: &mut Vec<Verdict>) {
    for vibration in vibrations.iter().filter(|vibration| vibration.competes || vibration.is_at_edge) {
        let why = if vibration.competes { "a second peak is nearly as strong" } else { "it is at the edge" };
        let found = format!("{:.1} Hz of {}: {why}", vibration.hz, vibration.channel);
        verdicts.push(Verdict::note(codes::DOUBTFUL_PEAK, found, "record longer, or with a sensor at the tool"));
    }
}
