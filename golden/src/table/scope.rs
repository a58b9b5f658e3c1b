//! The head of an export of TwinCAT Scope: its channels, their names, the first line of samples.
//!
//! It begins with lines about the recording, of which the first one is usually its `Name`. A block of rows about the channels
//! follows, each with a key and then a value for every channel. The key is repeated before each channel with its own column of times: the cell below a key is
//! a time. The rows have the same number of cells as the samples, except two kinds:
//!
//! ```text
//! Name func_a Name test space func_b        between blanks, of names with blanks
//! SampleTime[ms],0,2,SampleTime[ms],1,1     between commas, with the decimal comma of the PC
//! Data-Type REAL64 Data-Type REAL64 BIT     the row that determines the columns
//! Unit (None) Unit mm/s (Velocity) (None)   between blanks, of units that end with a quantity
//! ```

use super::cells;
use super::column::{Column, TimeColumn, Unit};
use super::names;

const NAME: &str = "Name";
const SYMBOL: &str = "SymbolName";
const DATA_TYPE: &str = "Data-Type";
const SAMPLE_TIME: &str = "SampleTime[ms]";
const UNIT: &str = "Unit";
/// The unit of each channel if the row of units has another number of cells.
const FOREIGN: &str = "row Unit does not fit the channels";
const SCALING: [&str; 2] = ["ScaleFactor", "Offset"];
/// Lines about the recording: its start and its end, in 100 ns.
const ENDS: [&str; 2] = ["Starttime of export", "Endtime of export"];
const SEPARATORS: [char; 5] = ['\t', ';', ' ', ':', ','];

/// The contents above the samples.
pub(super) struct Head<'t> {
    pub columns: Vec<Column<'t>>,
    /// number of cells in a row
    pub cells: usize,
    /// the index of the first line of samples
    pub start: usize,
    /// the time from the start to the end [ms]
    pub duration_ms: Option<f64>,
}

/// The separator of the cells, if the file is an export: a line above its samples begins with `Name`.
pub(super) fn separator(lines: &[&str]) -> Option<char> {
    let is_sample = |line: &str| line.starts_with(|letter: char| letter.is_ascii_digit() || "+-. ".contains(letter));
    lines.iter().take_while(|line| !is_sample(line)).find_map(|line| {
        let rest = line.strip_prefix(NAME).or_else(|| line.strip_prefix("\"Name\""))?;
        rest.chars().next().filter(|letter| SEPARATORS.contains(letter))
    })
}

/// A row about all channels.
struct Row<'t> {
    line: usize,
    text: &'t str,
    cells: Vec<&'t str>,
}

/// The rows about the channels.
struct Rows<'t> {
    names: Option<Row<'t>>,
    symbols: Option<Row<'t>>,
    types: Option<Row<'t>>,
    sample_times: Option<Row<'t>>,
    scaling: [Option<Row<'t>>; 2],
    /// the unit of each channel
    units: Vec<&'t str>,
}

/// The row that distinguishes cells of channels from cells of times.
struct Layout<'r, 't> {
    row: &'r Row<'t>,
    /// whether samples have times
    has_times: bool,
}

/// Reads the head; `wanted` are the channels named by the user.
pub(super) fn head<'t>(lines: &[&'t str], separator: char, wanted: &[&str]) -> Head<'t> {
    let mut cells = Vec::new();
    let is_sample = |line: &&'t str| {
        cells::split_samples(line, separator, &mut cells);
        cells.iter().find(|cell| !cell.is_empty()).is_some_and(|cell| cells::is_number(cell))
    };
    let start = lines.iter().position(is_sample).unwrap_or(lines.len());
    let row = |key: &str| row(&lines[..start], separator, key);
    let rows = Rows {
        names: row(NAME),
        symbols: row(SYMBOL),
        types: row(DATA_TYPE),
        sample_times: row(SAMPLE_TIME),
        scaling: SCALING.map(row),
        units: units(&lines[..start], separator),
    };
    let [from, to] = ENDS.map(|key| row(key)?.cells.get(1)?.parse::<i64>().ok());
    #[expect(clippy::cast_precision_loss, reason = "compared with a tolerance")]
    let duration_ms = from.zip(to).map(|(from, to)| to.saturating_sub(from) as f64 / 1e4).filter(|ms| *ms > 0.0);
    let samples = lines.get(start).map(|line| {
        cells::split_samples(line, separator, &mut cells);
        cells.iter().rposition(|cell| !cell.is_empty()).map_or(0, |last| last + 1)
    });
    let first_cells = lines[start..].iter().filter_map(|line| {
        cells::split_samples(line, separator, &mut cells);
        cells::number(cells[0], separator).parse().ok()
    });
    let (columns, cells) = rows.layout(samples, first_cells).map_or((Vec::new(), 0), |layout| {
        (rows.columns(&layout, wanted), layout.row.cells.len() - usize::from(!layout.has_times))
    });
    Head { columns, cells, start, duration_ms }
}

impl<'t> Rows<'t> {
    /// The first line of samples decides: a row about the channels has the same number of cells, or one more without times. If
    /// the last channels have no sample there, it has more cells too; then the first cells tell whether they are times.
    fn layout(&self, samples: Option<usize>, first_cells: impl Iterator<Item = f64>) -> Option<Layout<'_, 't>> {
        let rows: Vec<&Row<'_>> = [&self.symbols, &self.types, &self.names].into_iter().flatten().collect();
        let of = |count: usize| rows.iter().find(|row| row.cells.len() == count).copied();
        let row = samples.and_then(|count| of(count).or_else(|| of(count + 1))).or(rows.first().copied())?;
        let is_longer = samples.is_some_and(|count| count < row.cells.len());
        let may_lack_times = is_longer && !row.cells[1..].contains(&row.cells[0]);
        Some(Layout { row, has_times: !may_lack_times || self.are_times(first_cells, row.cells.len()) })
    }

    /// Whether most steps of these numbers are the sampling time of the first channel, in ms or in 100 ns.
    fn are_times(&self, numbers: impl Iterator<Item = f64>, cells: usize) -> bool {
        // All channels have one; between commas, a decimal comma separates it into two cells.
        let step = self.sample_times.as_ref().and_then(|row| {
            let parts = (row.cells.len() - 1) / (cells - 1).max(1);
            row.cells[1..=parts].join(".").replace(',', ".").parse::<f64>().ok()
        });
        let Some(step) = step else { return false };
        let numbers: Vec<f64> = numbers.collect();
        let is_step = |found: f64| [step, step * 1e4].iter().any(|step| libm::fabs(found - step) < 0.03 * step);
        2 * numbers.windows(2).filter(|pair| is_step(pair[1] - pair[0])).count() > numbers.len()
    }

    /// The channels.
    fn columns(&self, layout: &Layout<'_, 't>, wanted: &[&str]) -> Vec<Column<'t>> {
        let Layout { row: Row { line, cells, .. }, has_times } = *layout;
        let (key, names) = (cells[0], self.split_names(layout.row, wanted));
        let same = |row: &Option<Row<'t>>, cell: usize| {
            let row = row.as_ref().filter(|row| row.cells.len() == cells.len())?;
            Some((row.cells[cell], place(row, row.cells[cell])))
        };
        let (mut columns, mut time) = (Vec::new(), None);
        for (cell, text) in cells.iter().enumerate() {
            if *text == key {
                let place = place(layout.row, text);
                time = has_times.then_some(TimeColumn { name: "", cell, unit: Unit::OfExport, place });
                continue;
            }
            let of_names = names.get(columns.len()).zip(self.names.as_ref());
            let name = same(&self.names, cell).or(of_names.map(|(name, row)| (*name, place(row, name))));
            let symbol = same(&self.symbols, cell);
            columns.push(Column {
                name: name.map_or("", |(name, _)| name),
                symbol: symbol.map_or("", |(symbol, _)| symbol),
                place: name.or(symbol).map_or([*line, 1], |(_, place)| place),
                sample_time: same(&self.sample_times, cell),
                unit: "",
                scaling: self.scaling.each_ref().map(|row| same(row, cell).map_or("", |(text, _)| text)),
                is_integer: same(&self.types, cell).is_some_and(|(ty, _)| ty.contains("INT")),
                cell: if has_times { cell } else { cell - 1 },
                time,
            });
        }
        // Separators at the end of the row add empty units.
        let fits = self.units.get(columns.len()..).is_some_and(|rest| rest.iter().all(|unit| unit.is_empty()));
        for (at, column) in columns.iter_mut().enumerate().filter(|_| !self.units.is_empty()) {
            column.unit = if fits { self.units[at] } else { FOREIGN };
        }
        columns
    }

    /// The names if their row has another number of cells, as far as they can be separated.
    fn split_names(&self, layout: &Row<'t>, wanted: &[&str]) -> Vec<&'t str> {
        let names = self.names.as_ref().filter(|row| row.cells.len() != layout.cells.len());
        let counts: Vec<usize> =
            layout.cells.split(|cell| *cell == layout.cells[0]).skip(1).map(|group: &[&str]| group.len()).collect();
        names.and_then(|row| names::of_groups(row.text, NAME, &counts, wanted)).unwrap_or_default()
    }
}

/// The row of a key; the first line of the file is about the recording.
fn row<'t>(lines: &[&'t str], separator: char, key: &str) -> Option<Row<'t>> {
    let mut cells = Vec::new();
    let found = lines.iter().enumerate().skip(1).rfind(|(_, line)| {
        cells::split(line, separator, &mut cells);
        cells[0] == key
    });
    let (index, text) = found?;
    cells::split(text, separator, &mut cells);
    while cells.len() > 1 && cells.last().is_some_and(|cell| cell.is_empty()) {
        cells.pop();
    }
    Some(Row { line: index + 1, text, cells })
}

/// The units of the channels, without their quantities: of `mm/s (Velocity)` the velocity, of `(None)` nothing.
fn units<'t>(lines: &[&'t str], separator: char) -> Vec<&'t str> {
    let mut cells = Vec::new();
    let is_row = |line: &&&'t str| {
        cells::split(line, separator, &mut cells);
        cells[0] == UNIT && !cells.get(1).is_some_and(|next| SCALING.contains(next))
    };
    let Some(line) = lines.iter().skip(1).rfind(is_row) else { return Vec::new() };
    if separator == ' ' {
        cells = line.split_terminator(')').map(|unit| unit.trim().trim_start_matches(UNIT)).collect();
    }
    cells.retain(|cell| *cell != UNIT);
    cells.iter().map(|cell| cell.split('(').next().unwrap_or_default().trim()).collect()
}

fn place(row: &Row<'_>, cell: &str) -> [usize; 2] {
    [row.line, cells::column_of(row.text, cell)]
}
