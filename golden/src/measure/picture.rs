//! The picture of the results: channels over time, spectra and the response over frequency. `svg` draws it.

use super::{Excited, Measured, Record};
use crate::svg::{Across, Curve, Over, Panel, Part, Picture};
use identification::peaks::Spectrum;
use stability::magnitude;
use std::ops::Range;

/// Points of a curve, at most.
const MOST: usize = 2500;
/// Range of the spectra [Hz]; they end at half the sampling frequency at the latest.
const BAND: [f64; 2] = [2.0, 250.0];
/// A larger change of the phase between two points means that it has passed 180 degrees.
const JUMP: f64 = 180.0;

/// The picture of a recording, with the response of this one or of another one; `None` if there is no curve over time.
#[must_use]
pub fn of(measured: &Measured, excited: Option<&Excited>) -> Option<Picture> {
    let record = measured.record.as_ref()?;
    let time = Over {
        across: Across::Time { until: record.samples() as f64 * record.cycle },
        events: Vec::new(),
        panels: over_time(record),
    };
    let to = if BAND[1] < 0.5 / record.cycle { BAND[1] } else { 0.5 / record.cycle };
    let mut panels = spectra(measured, record, [BAND[0], to], "");
    panels.extend(excited.into_iter().flat_map(|excited| response(excited, [BAND[0], to])));
    let mut events: Vec<(f64, String)> = measured
        .vibrations
        .iter()
        .filter(|vibration| (BAND[0]..=to).contains(&vibration.hz))
        .map(|vibration| (vibration.hz, format!("{:.1} Hz", vibration.hz)))
        .collect();
    events.sort_by(|a, b| a.0.total_cmp(&b.0));
    events.dedup_by(|a, b| a.1 == b.1);
    let frequency = Over { across: Across::Frequency { from: BAND[0], to }, events, panels };
    let has_spectra = !frequency.panels.is_empty();
    let parts = [Some(Part::Over(time)), has_spectra.then_some(Part::Over(frequency))];
    let setup = measured.verdicts.iter().map(|verdict| format!("{}: {}", verdict.code, verdict.found)).collect();
    Some(Picture { title: "measured".to_owned(), setup, parts: parts.into_iter().flatten().collect() })
}

/// A panel for each channel; velocities with one unit share a panel.
fn over_time(record: &Record) -> Vec<Panel> {
    let mut panels: Vec<(String, Vec<Curve>)> = Vec::new();
    for channel in record.channels() {
        let unit = channel.unit.map_or("unit unknown", |unit| unit.name);
        let kind = match channel.signal {
            "following_error" | "v_add" | "v_add_calculated" | "v_excite" => channel.signal,
            _ => "",
        };
        let name = if kind.is_empty() { unit.to_owned() } else { format!("{kind} [{unit}]") };
        let curve = Curve::new(channel.signal, thinned(&channel.values, record.cycle));
        match panels.iter_mut().find(|(known, curves)| *known == name && curves.len() < 4) {
            Some((_, curves)) => curves.push(curve),
            None => panels.push((name, vec![curve])),
        }
    }
    panels.into_iter().map(|(name, curves)| Panel::curves(name, curves)).collect()
}

/// The points of a curve over time.
pub(crate) fn thinned(values: &[f64], cycle: f64) -> Vec<(f64, f64)> {
    let step = values.len().div_ceil(MOST).max(1);
    values.iter().enumerate().step_by(step).map(|(n, value)| (n as f64 * cycle, *value)).collect()
}

/// Of the channel that shows most: the load's, else the motor's. A label says which record it is.
pub(crate) fn spectra(measured: &Measured, record: &Record, band: [f64; 2], label: &str) -> Vec<Panel> {
    let channel = ["a_load", "v_direct", "v_motor"].into_iter().find_map(|name| record.channel(name));
    let Some(channel) = channel else { return Vec::new() };
    let driving: Vec<Range<usize>> = measured.windows.driving.iter().flat_map(|(_, of)| of.iter().cloned()).collect();
    let of = |name: &str, windows: &[Range<usize>]| {
        let spectrum = Spectrum::of(&channel.values, windows, record.cycle)?;
        let points = spectrum.power.iter().enumerate().map(|(k, p)| (k as f64 * spectrum.spacing, p.sqrt()));
        let points = points.filter(|(hz, _)| (band[0]..=band[1]).contains(hz)).collect();
        Some(Curve::new(name, points))
    };
    let curves: Vec<Curve> =
        [of("driving", &driving), of("after ramps", &measured.windows.ramps)].into_iter().flatten().collect();
    let unit = channel.unit.map_or("unit unknown", |unit| unit.name);
    let name = if label.is_empty() { channel.signal.to_owned() } else { format!("{}, {label}", channel.signal) };
    if curves.is_empty() { Vec::new() } else { vec![Panel::curves(format!("{name} [{unit}]"), curves)] }
}

fn response(excited: &Excited, band: [f64; 2]) -> Vec<Panel> {
    let lines = &excited.lines;
    let points = || {
        let all = lines.hz.iter().copied().zip(lines.response.iter().copied());
        all.zip(&lines.error).filter(|((hz, _), _)| (band[0]..=band[1]).contains(hz))
    };
    let size = points().map(|((hz, p), _)| (hz, magnitude(p))).collect();
    let error = points().map(|((hz, _), error)| (hz, 2.0 * error)).collect();
    let phase = points().map(|((hz, p), _)| (hz, libm::atan2(p.im, p.re).to_degrees()));
    vec![
        Panel::curves("response", vec![Curve::new("|P|", size), Curve::new("2 se", error)]),
        Panel::curves("phase [deg]", vec![Curve::broken("P", phase, JUMP)]),
    ]
}
