//! A recording as it would have been with stages: as CSV with the columns of the recording, and as a picture. Nothing
//! is measured here.

use super::Tuning;
use super::stage::controller;
use crate::measure::picture::{spectra, thinned};
use crate::measure::{Channel, Measured, Record};
use crate::svg::{Across, Curve, Over, Panel, Part, Picture};
use generator::axis::Stage;
use identification::Complex64;
use identification::what_if::{Axis, WhatIf, following_error};
use std::fmt::Write;

/// The lines of a response above that part of half the sampling frequency are not used.
const USED: f64 = 0.999;
/// The spectra of the picture [Hz].
const BAND: [f64; 2] = [2.0, 250.0];

/// The record of moves with stages: what acts on the motor is left by R = S/S0. `v_motor`, `v_direct` and `a_load`
/// times R; `v_add` is C R `v_motor`; the following error grows by T sum(v - R v), `v_command` by Kv times that.
/// `x_command` and `v_excite` stay. A channel whose unit is not known, and is needed, is left out. None: no response
/// is known, or no velocity of the motor.
#[must_use]
pub fn with_stages(tuning: &Tuning, record: &Record, stages: &[Stage]) -> Option<Record> {
    let cycle = tuning.cycle_time;
    let response = tuning.lines.as_ref()?.up_to(USED * 0.5 / cycle).response(cycle)?;
    let [position_gain, _] = tuning.gains;
    let axis = Axis { cycle_time: cycle, position_gain, response: &response };
    let channels = record.channels();
    let signals: Vec<&[f64]> = channels.iter().map(|channel| channel.values.as_slice()).collect();
    let motor = channels.iter().position(|channel| channel.signal == "v_motor")?;
    let what_if = WhatIf::new(axis, &signals, None);
    let of = controller(stages, cycle, position_gain);
    let c = what_if.at_lines(|t| (of.stage)(t).iter().sum::<Complex64>());
    let left = what_if.left(&c);
    let added: Vec<Complex64> = left.iter().zip(&c).map(|(left, c)| left * c).collect();
    let (v_motor, v_add) = (what_if.whole(motor, &left, 1.0), what_if.whole(motor, &added, 0.0));
    // By how much the way of the motor lags, in the unit of its velocity times s.
    let lag = following_error(&vec![0.0; v_motor.len()], signals[motor], &v_motor, cycle);
    let gain = position_gain.unwrap_or(0.0);
    let size = |channel: &Channel| channel.unit.map(|unit| unit.size);
    let scale = |channel: &Channel| Some(size(&channels[motor])? / size(channel)?);
    let plus = |channel: &Channel, change: &dyn Fn(usize) -> f64| {
        let scale = scale(channel)?;
        Some(channel.values.iter().enumerate().map(|(n, value)| value + scale * change(n)).collect::<Vec<f64>>())
    };
    Some(record.with(|k, channel| match channel.signal {
        "v_motor" => Some(v_motor.clone()),
        "a_load" | "v_direct" => Some(what_if.whole(k, &left, 1.0)),
        "v_add" => plus(channel, &|n| v_add[n]),
        "following_error" => plus(channel, &|n| lag[n]),
        "x_actual" => plus(channel, &|n| -lag[n]),
        "v_command" => plus(channel, &|n| gain * lag[n]),
        "v_cmd" => plus(channel, &|n| gain * lag[n] + v_add[n]),
        _ => Some(channel.values.clone()),
    }))
}

/// A record as CSV that `axgen measure` reads.
#[must_use]
pub fn csv(record: &Record) -> String {
    let names = record.channels().iter().map(|channel| match channel.unit {
        Some(unit) => format!("{} [{}]", channel.signal, unit.name),
        None => channel.signal.to_owned(),
    });
    let mut text = std::iter::once("time [s]".to_owned()).chain(names).collect::<Vec<_>>().join(",");
    text.push('\n');
    for n in 0..record.samples() {
        let _ = write!(text, "{}", libm::round(n as f64 * record.cycle * 1e9) / 1e9);
        record.channels().iter().for_each(|channel| {
            let _ = write!(text, ",{}", with_digits(channel.values[n]));
        });
        text.push('\n');
    }
    text
}

/// Nine significant digits, without an exponent.
fn with_digits(value: f64) -> f64 {
    let size = libm::fabs(value);
    if size == 0.0 || !size.is_finite() {
        return value;
    }
    let scale = libm::pow(10.0, 8.0 - libm::floor(libm::log10(size)));
    libm::round(value * scale) / scale
}

/// The picture: as recorded, and with the stages.
#[must_use]
pub fn picture(moves: &Measured, with: &Record, setup: Vec<String>) -> Option<Picture> {
    let record = moves.record.as_ref()?;
    let both = [("as recorded", record), ("with the stages", with)];
    let mut panels = Vec::new();
    for name in ["a_load", "v_direct", "v_motor", "following_error", "v_add"] {
        let curve = |(label, of): (&str, &Record)| {
            let values =
                if name == "following_error" { of.following_error()?.into_owned() } else { of.get(name)?.to_vec() };
            Some(Curve::new(label, thinned(&values, of.cycle)))
        };
        let curves: Vec<Curve> = both.into_iter().filter_map(curve).collect();
        let unit = record.unit(name).map_or("unit unknown", |unit| unit.name);
        if !curves.is_empty() {
            panels.push(Panel::curves(format!("{name} [{unit}]"), curves));
        }
    }
    let until = record.samples() as f64 * record.cycle;
    let time = Over { across: Across::Time { until }, events: Vec::new(), panels };
    let to = if BAND[1] < 0.5 / record.cycle { BAND[1] } else { 0.5 / record.cycle };
    let panels = both.into_iter().flat_map(|(label, of)| spectra(moves, of, [BAND[0], to], label)).collect();
    let frequency = Over { across: Across::Frequency { from: BAND[0], to }, events: Vec::new(), panels };
    let parts = vec![Part::Over(time), Part::Over(frequency)];
    Some(Picture { title: "moves with stages, predicted".to_owned(), setup, parts })
}
