//! Numbers -> complex values with their relative standard errors. A stated unit is checked against the numbers; a missing
//! unit is inferred if only one fits.

use super::columns::Unit;
use super::numbers::{Columns, Line, Used, Value};
use super::phase::Dead;
use super::{From, Point, Said, turned};
use crate::codes;
use crate::number::significant;
use portable::Extreme;
use stability::Complex64;

/// The relative error for a coherence of 0: no margin survives it.
const NOTHING_KNOWN: f64 = 1000.0;
/// dB per relative change of a factor: 20/ln 10.
const DECIBEL: f64 = 20.0 / std::f64::consts::LN_10;
/// Range of the magnitude of a response near 1.
pub(super) const NEAR_ONE: [f64; 2] = [0.7, 1.4];

pub(super) fn points(
    lines: &[Line],
    columns: &Columns<'_>,
    from: From,
    cycle_time: f64,
    said: &mut Said<'_>,
) -> Vec<Point> {
    let sizes = sizes(lines, &columns.value, from, said);
    if said.report.has_errors() {
        return Vec::new();
    }
    let errors = lines.iter().zip(&sizes).map(|(line, size)| relative_error(line, *size, columns.error.as_ref()));
    let errors: Vec<f64> = errors.collect();
    let dead = Dead::new(lines.iter().map(|line| line.hz).zip(sizes.iter().copied()), &errors, from, cycle_time);
    let phases = phases(lines, &columns.value, &dead, from, said);
    lines
        .iter()
        .zip(&phases)
        .zip(sizes.iter().zip(errors))
        .map(|((line, phase), (size, error))| {
            let response = match columns.value {
                Value::Parts(_) => Complex64::new(line.value[0], line.value[1]),
                Value::Polar { .. } => turned(*phase) * *size,
            };
            Point { line: line.line, hz: line.hz, response, error }
        })
        .collect()
}

/// The magnitudes as factors; an error if one is not above 0, or not finite.
fn sizes(lines: &[Line], value: &Value<'_>, from: From, said: &mut Said<'_>) -> Vec<f64> {
    let is_decibel = match value {
        Value::Parts(_) => false,
        Value::Polar { magnitude, .. } => is_decibel(lines, magnitude, from, said),
    };
    if said.report.has_errors() {
        return Vec::new();
    }
    let sizes: Vec<f64> = lines.iter().map(|line| size(line, value, is_decibel)).collect();
    for (line, _) in lines.iter().zip(&sizes).filter(|(_, size)| **size <= 0.0 || !size.is_finite()) {
        said.push(
            said.error(codes::RESPONSE_CELL, [line.line, line.columns[1]], "a magnitude that no measurement gives")
                .allowed("above 0")
                .instead("the measured value, finite and above 0"),
        );
    }
    sizes
}

fn size(line: &Line, value: &Value<'_>, is_decibel: bool) -> f64 {
    let [first, second] = line.value;
    match value {
        Value::Parts(_) => (first * first + second * second).sqrt(),
        Value::Polar { .. } if is_decibel => libm::pow(10.0, first / 20.0),
        Value::Polar { .. } => first,
    }
}

/// The relative error of one line: from its column, else from coherence k and n averages, sqrt((1 - k)/(2 n k)), else 0.
fn relative_error(line: &Line, size: f64, column: Option<&Used<'_>>) -> f64 {
    let relative = match (line.error, line.coherence, line.averages) {
        (Some(error), _, _) => match column.and_then(|used| used.unit) {
            Some(Unit::Decibel) => error / DECIBEL,
            Some(Unit::Percent) => error / 100.0,
            _ => error / size,
        },
        (None, Some(k), Some(n)) => ((1.0 - k) / (2.0 * n * k)).sqrt(),
        _ => 0.0,
    };
    relative.smaller(NOTHING_KNOWN)
}

/// Whether the magnitude is in dB: from its name, else because a value is negative, which a factor cannot be.
fn is_decibel(lines: &[Line], magnitude: &Used<'_>, from: From, said: &mut Said<'_>) -> bool {
    let negative = lines.iter().find(|line| line.value[0] < 0.0);
    let lowest = lowest(lines);
    let is_one = (NEAR_ONE[0]..=NEAR_ONE[1]).contains(&lowest);
    match (magnitude.unit, negative) {
        (Some(Unit::Decibel), None) if is_one && matches!(from, From::Command { .. }) => {
            let (name, lowest) = (magnitude.name, four(lowest));
            let found = format!("`{name}` is {lowest} at the lowest lines and never below 0: that is a factor");
            said.push(
                said.error(codes::MAGNITUDE_UNIT, magnitude.place, found)
                    .allowed("dB: near 0 at the lowest lines, below 0 above the bandwidth")
                    .instead("magnitude [1]"),
            );
            true
        }
        (Some(Unit::Decibel), _) => true,
        (Some(_), Some(line)) => {
            let found = format!("{} for `{}`, which is a factor", four(line.value[0]), magnitude.name);
            said.push(
                said.error(codes::MAGNITUDE_UNIT, [line.line, line.columns[1]], found)
                    .allowed("above 0")
                    .instead(format!("magnitude [dB] in line {}, if it is in dB", magnitude.place[0])),
            );
            false
        }
        (None, Some(_)) => {
            let found = format!("`{}` has no unit and values below 0: it is read as dB", magnitude.name);
            said.push(said.warning(codes::UNIT_TAKEN, magnitude.place, found).instead("magnitude [dB]"));
            true
        }
        (_, None) => false,
    }
}

/// The median of the three lowest magnitudes, as written.
fn lowest(lines: &[Line]) -> f64 {
    let mut first: Vec<f64> = lines.iter().take(3).map(|line| line.value[0]).collect();
    first.sort_by(f64::total_cmp);
    first.get(first.len() / 2).copied().unwrap_or(0.0)
}

/// An interpretation of a phase: radians per unit, and whether its sign is inverted.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Reading {
    unit: Unit,
    is_inverted: bool,
}

impl Reading {
    fn radians(self, written: f64) -> f64 {
        let phase = if self.unit == Unit::Radians { written } else { written.to_radians() };
        if self.is_inverted { -phase } else { phase }
    }

    fn name(self) -> &'static str {
        if self.unit == Unit::Radians { "radians" } else { "degrees" }
    }
}

/// The phases [rad] as the file states them. If only another unit or the other sign fits, it is an error.
fn phases(lines: &[Line], value: &Value<'_>, dead: &Dead, from: From, said: &mut Said<'_>) -> Vec<f64> {
    let written: Vec<f64> = match value {
        Value::Parts(_) => lines.iter().map(|line| libm::atan2(line.value[1], line.value[0])).collect(),
        Value::Polar { .. } => lines.iter().map(|line| line.value[1]).collect(),
    };
    let read = |reading: Reading| written.iter().map(|phase| reading.radians(*phase)).collect::<Vec<_>>();
    let of = |unit, is_inverted| Reading { unit, is_inverted };
    let fits = |reading: &Reading| dead.fits(&read(*reading), from);
    let (stated, others) = match value {
        Value::Parts(_) => (of(Unit::Radians, false), vec![of(Unit::Radians, true)]),
        Value::Polar { phase, .. } => {
            let unit = phase.unit.unwrap_or_else(|| taken(phase, |unit| fits(&of(unit, false)), said));
            let other = if unit == Unit::Radians { Unit::Degrees } else { Unit::Radians };
            (of(unit, false), vec![of(other, false), of(unit, true), of(other, true)])
        }
    };
    if dead.is_known()
        && !fits(&stated)
        && let Some(other) = others.into_iter().find(fits)
    {
        mistaken(stated, other, value.columns()[1], [dead.words(&read(stated)), dead.words(&read(other))], said);
    }
    read(stated)
}

/// The unit of a phase without a stated unit: the one with a possible dead time.
fn taken(phase: &Used<'_>, fits: impl Fn(Unit) -> bool, said: &mut Said<'_>) -> Unit {
    let [degrees, radians] = [Unit::Degrees, Unit::Radians].map(fits);
    let unit = if radians && !degrees { Unit::Radians } else { Unit::Degrees };
    if degrees == radians {
        let found = format!("`{}` has no unit, and its values do not show which it is", phase.name);
        said.push(said.error(codes::PHASE_UNIT, phase.place, found).allowed("deg or rad").instead("phase [deg]"));
    } else {
        let (name, write) = if radians { ("radians", "phase [rad]") } else { ("degrees", "phase [deg]") };
        let found = format!("`{}` has no unit: read as {name}, the only unit with a possible dead time", phase.name);
        said.push(said.warning(codes::UNIT_TAKEN, phase.place, found).instead(write));
    }
    unit
}

/// Reports that the numbers contradict the statement of the file.
fn mistaken(stated: Reading, other: Reading, column: &Used<'_>, [is, would]: [String; 2], said: &mut Said<'_>) {
    if other.unit != stated.unit {
        let sign = if other.is_inverted { " with the other sign" } else { "" };
        let found = format!("`{}` in {} gives {is}, in {}{sign} {would}", column.name, stated.name(), other.name());
        let write = if other.unit == Unit::Radians { "phase [rad]" } else { "phase [deg]" };
        let write = if other.is_inverted { format!("{write}, with the other sign") } else { write.to_owned() };
        said.push(
            said.error(codes::PHASE_UNIT, column.place, found)
                .allowed("a phase that falls by one cycle of delay at least")
                .instead(write),
        );
    } else {
        let found = format!("`{}` rises with the frequency: it gives {is}, with the other sign {would}", column.name);
        said.push(
            said.error(codes::PHASE_SIGN, column.place, found)
                .allowed("a phase that falls: the motor answers after the command")
                .instead("the other sign, or output and input the other way round"),
        );
    }
}

fn four(value: f64) -> String {
    significant(value, 4)
}
