//! The columns of a table as channels: their values as numbers, and their sampling times. Nothing of an axis is computed.

use super::unit::{Quantity, Unit};
use crate::instants::Instants;
use crate::mistake::Mistake;
use crate::samples::{Shape, Signal};
use crate::series::{self, Series};
use crate::signals::{self, Map};
use crate::table::{Column, Table};
use compiler::program::Type;
use portable::{Literal, RealKind};

/// The signals that are measured.
pub const SIGNALS: [(&str, Quantity); 11] = [
    ("v_command", Quantity::Velocity),
    ("v_cmd", Quantity::Velocity),
    ("v_motor", Quantity::Velocity),
    ("v_direct", Quantity::Velocity),
    ("v_add", Quantity::Velocity),
    ("v_add_calculated", Quantity::Velocity),
    ("v_excite", Quantity::Velocity),
    ("x_command", Quantity::Position),
    ("x_actual", Quantity::Position),
    ("following_error", Quantity::Position),
    ("a_load", Quantity::Acceleration),
];
/// Signals of blocks that a recording may have too.
const OTHERS: [&str; 8] =
    ["mode", "position_controlled", "reset", "task_cycle_ns", "limited", "fault", "error_id", "x_drive"];

#[derive(Clone, Debug)]
pub struct Channel {
    pub signal: &'static str,
    pub quantity: Quantity,
    /// `None` if it is unknown
    pub unit: Option<Unit>,
    /// whether the file states the unit
    pub is_stated: bool,
    /// what it states instead, if that is no unit of the quantity
    pub other_unit: Option<String>,
    /// factor and offset by which a scope scales the values, if it states them and the values do not show that it did
    pub scaling: Option<String>,
    pub values: Vec<f64>,
    pub timing: Timing,
}

impl Channel {
    /// Its unit divided by that of another channel, if both are stated; else 1.
    pub(super) fn ratio_to(&self, other: &Self) -> f64 {
        let stated = |channel: &Self| channel.unit.filter(|_| channel.is_stated);
        stated(self).zip(stated(other)).map_or(1.0, |(own, other)| own.size / other.size)
    }
}

/// The sampling times of a channel.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Timing {
    /// the sampling interval [s]; `None` if it is unknown
    pub interval: Option<f64>,
    /// largest deviation from it of a step, except gaps, and of all times from even ones [s]
    pub jitter: f64,
    /// the line of the largest one
    pub uneven: Option<usize>,
    /// an assumed unit of the times, if another one is as plausible
    pub doubt: Option<String>,
    /// why the times show no interval, if there are times
    pub unusable: Option<String>,
    /// number of missing samples, and the line before which the first ones are missing
    pub missing: usize,
    pub first_gap: Option<usize>,
    /// time of the channel's first sample [ns]; `None` if only rows are known
    pub begins: Option<i128>,
}

/// All channels of a table. A column `NAME [UNIT]` is the signal NAME; `map` assigns signals to columns with other names.
///
/// # Errors
/// All errors: unknown and repeated columns, unknown units; those of `series::columns`, and numbers that are not finite.
pub fn read(table: &Table<'_>, map: &Map) -> Result<Vec<Channel>, Vec<Mistake>> {
    let shape = Shape { real: RealKind::F64, signals: SIGNALS.iter().map(|(name, _)| real(name)).collect() };
    let found = signals::of_columns(table, &shape, &OTHERS, &with_units(table, map))?;
    let units = units(table, &found)?;
    let is_finite = |value: &Literal| matches!(value, Literal::F64(value) if value.is_finite());
    let (series, times) = series::columns(table, &found, &shape, is_finite)?;
    let timings: Vec<Timing> = times.iter().map(timing).collect();
    let channel = |(Series { column, signal, values, begins, .. }, unit): (Series<'_>, Option<Stated>)| {
        let of = |time| times.iter().position(|known| known.column == time);
        let timing = column.time.and_then(of).map_or_else(|| stated_timing(column), |at| timings[at].clone());
        let (signal, quantity) = SIGNALS[signal];
        let values: Vec<f64> = values.bytes.as_chunks().0.iter().map(|bytes| f64::from_le_bytes(*bytes)).collect();
        let (unit, other_unit) = unit.map_or((None, None), |unit| (unit.as_ref().ok().copied(), unit.err()));
        let (timing, scaling) = (Timing { begins, ..timing }, scaling(column, &values));
        Channel { signal, quantity, unit, is_stated: unit.is_some(), other_unit, scaling, values, timing }
    };
    let mut channels: Vec<Channel> = series.into_iter().zip(units).map(channel).collect();
    channels.sort_by_key(|channel| SIGNALS.iter().position(|(name, _)| *name == channel.signal));
    Ok(channels)
}

fn real(name: &str) -> Signal {
    Signal { name: name.to_owned(), ty: Type::Real, start: Literal::F64(0.0) }
}

/// A name and the unit in brackets at its end. Brackets without a letter are an index, as in `v[3]`.
fn bracket(name: &str) -> Option<(&str, &str)> {
    let (name, unit) = name.trim_end().strip_suffix([']', ')'])?.rsplit_once(['[', '('])?;
    unit.contains(char::is_alphabetic).then(|| (name.trim(), unit.trim()))
}

/// A unit as stated; the text if it is not known.
type Stated = Result<Unit, String>;

/// The units that the columns state: in brackets after the name, else in the head of an export. A unit that is not known is an
/// error after the name of a signal; elsewhere, the brackets may be part of a name, and the unit that of a scope.
fn units(table: &Table<'_>, found: &[Option<usize>]) -> Result<Vec<Option<Stated>>, Vec<Mistake>> {
    let (mut units, mut mistakes) = (Vec::new(), Vec::new());
    for (column, signal) in table.columns.iter().zip(found).filter_map(|(column, signal)| Some((column, (*signal)?))) {
        let (signal, quantity) = SIGNALS[signal];
        let bracket = bracket(column.called());
        let stated = [column.unit, bracket.map_or("", |(_, unit)| unit)];
        let known = stated.iter().rev().find_map(|name| Unit::named(quantity, name));
        let other = stated.into_iter().find(|name| !name.is_empty()).map(|name| name.escape_default().to_string());
        match (bracket, known.map(Ok).or(other.map(Err))) {
            (Some((name, _)), Some(Err(unit))) if name == signal => {
                mistakes.push(Mistake::new(column.place, format!("the unit `{unit}` of {signal}"), quantity.names()));
            }
            (_, unit) => units.push(unit),
        }
    }
    if mistakes.is_empty() { Ok(units) } else { Err(mistakes) }
}

/// The map, extended by the columns whose names are those of signals with a unit.
fn with_units(table: &Table<'_>, map: &Map) -> Vec<(String, String)> {
    let is_mapped = |name: &str| map.iter().any(|(mapped, _)| mapped == name);
    let of = |column: &Column<'_>| {
        let (name, _) = bracket(column.name)?;
        let is_signal = SIGNALS.iter().any(|(signal, _)| *signal == name);
        (is_signal && !is_mapped(column.name)).then(|| (column.name.to_owned(), name.to_owned()))
    };
    map.iter().cloned().chain(table.columns.iter().filter_map(of)).collect()
}

/// The scaling that the head of an export states for a column; `None` if there is none, or if integers are no longer whole. The
/// head states it also if the values are exported without it.
fn scaling(column: &Column<'_>, values: &[f64]) -> Option<String> {
    let [factor, offset] = column.scaling.map(|text| text.replace(',', ".").parse::<f64>().ok());
    let (factor, offset) = (factor.unwrap_or(1.0), offset.unwrap_or(0.0));
    let is_scaled = column.is_integer && values.iter().any(|value| value.fract() != 0.0);
    let is_plain = factor.to_bits() == 1f64.to_bits() && offset == 0.0;
    (!is_plain && !is_scaled).then(|| format!("ScaleFactor {factor}, Offset {offset}"))
}

/// The timing of a column of times.
fn timing(times: &Instants<'_>) -> Timing {
    let unusable = times.unusable();
    let Some((seconds, usual)) = times.seconds() else { return Timing { unusable, ..Timing::default() } };
    let steps = || seconds.windows(2).map(|pair| pair[1] - pair[0]);
    let cycles = times.usual_cycles();
    let (sum, count): (f64, f64) = (steps().sum(), cycles.iter().sum());
    // Times are written with few digits: their mean step is more precise than any of them.
    let interval = libm::round(sum / count * 1e9) / 1e9;
    let rounded = |apart: f64| libm::round(libm::fabs(apart) * 1e9) / 1e9;
    let is_gap = |cycles: &f64| *cycles > 1.0;
    let step = |(k, (step, _)): (usize, (f64, &f64))| (rounded(step - interval), times.lines()[k + 1]);
    let all = steps().zip(&cycles).enumerate().filter(|(_, (_, cycles))| !is_gap(cycles)).map(step);
    let drift = times.drift().map(|(drift, line)| (rounded(drift * usual), line));
    let worst = all.chain(drift).reduce(|worst, other| if other.0 > worst.0 { other } else { worst });
    let (jitter, uneven) = worst.map_or((0.0, None), |(jitter, line)| (jitter, Some(line)));
    let first_gap = cycles.iter().position(is_gap).and_then(|at| times.lines().get(at + 1).copied());
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "not negative, saturates")]
    let missing = cycles.iter().filter(|cycles| is_gap(cycles)).map(|cycles| cycles - 1.0).sum::<f64>() as usize;
    Timing {
        interval: Some(interval),
        jitter,
        uneven,
        doubt: times.doubt(),
        unusable,
        missing,
        first_gap,
        begins: None,
    }
}

/// The timing of a column without times: from the head of an export.
fn stated_timing(column: &Column<'_>) -> Timing {
    Timing { interval: column.interval_ms().map(|ms| ms / 1e3), ..Timing::default() }
}
