//! The columns of a table: their names, their times. Nothing of their values.

use std::collections::BTreeSet;

/// A column that is not a time.
#[derive(Clone, Debug, Default)]
pub struct Column<'t> {
    /// its name, in an export the channel's; may be empty
    pub name: &'t str,
    /// in an export, its symbol; several channels may have the same symbol
    pub symbol: &'t str,
    /// line and column of the name, both from 1
    pub place: [usize; 2],
    /// in an export, the time between two samples [ms], with line and column
    pub sample_time: Option<(&'t str, [usize; 2])>,
    /// in an export, its unit; empty if there is none
    pub unit: &'t str,
    /// in an export, factor and offset of its scaling
    pub(crate) scaling: [&'t str; 2],
    /// in an export, whether its values are integers before they are scaled
    pub(crate) is_integer: bool,
    /// index of its cell in a row
    pub(crate) cell: usize,
    /// its column of times
    pub(crate) time: Option<TimeColumn<'t>>,
}

/// A column of times.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct TimeColumn<'t> {
    pub name: &'t str,
    pub cell: usize,
    pub unit: Unit,
    pub place: [usize; 2],
}

/// The unit of a time.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Unit {
    /// units of this number of nanoseconds
    Nanoseconds(i64),
    /// of an export: milliseconds, or for large values 100 ns since 1601
    OfExport,
    /// not stated in the name
    Unsaid,
}

impl<'t> Column<'t> {
    /// Its name for the user.
    #[must_use]
    pub fn called(&self) -> &'t str {
        if self.name.is_empty() { self.symbol } else { self.name }
    }

    /// In an export, the time between two samples [ms].
    pub(crate) fn interval_ms(&self) -> Option<f64> {
        let interval = self.sample_time.and_then(|(text, _)| text.replace(',', ".").parse::<f64>().ok());
        interval.filter(|ms| ms.is_finite() && *ms > 0.0)
    }
}

/// The unit, if the column's name is that of a time: `time`, `Time [s]`, `t`, `Zeit(ms)`.
pub(crate) fn time_unit(name: &str) -> Option<Unit> {
    let name = name.to_lowercase();
    let mut words = name.split(|letter: char| !letter.is_alphanumeric()).filter(|word| !word.is_empty());
    let word = words.next().unwrap_or_default();
    let is_time = word == "t" && (name == "t" || name.contains(['[', '('])) || TIMES.contains(&word);
    let unit = words.find_map(|word| UNITS.iter().find(|(unit, _)| *unit == word));
    is_time.then_some(unit.map_or(Unit::Unsaid, |(_, nanoseconds)| Unit::Nanoseconds(*nanoseconds)))
}

const TIMES: [&str; 4] = ["time", "timestamp", "zeit", "zeitstempel"];
const UNITS: [(&str, i64); 6] =
    [("s", 1_000_000_000), ("ms", 1_000_000), ("us", 1_000), ("\u{b5}s", 1_000), ("\u{3bc}s", 1_000), ("ns", 1)];

/// The names of columns for a message: the first 12 are shown.
pub(crate) fn listed<'t>(names: impl Iterator<Item = &'t str>) -> String {
    const MOST: usize = 12;
    let mut seen = BTreeSet::new();
    let names: Vec<&str> = names.filter(|name| seen.insert(*name)).collect();
    let shown = names[..names.len().min(MOST)].join(", ");
    if names.len() > MOST { format!("{shown} and {} more", names.len() - MOST) } else { shown }
}
