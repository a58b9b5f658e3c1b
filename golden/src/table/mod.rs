//! The files of recorders as columns of cells: plain CSV, tables with `;` and a decimal comma, exports of TwinCAT Scope. No
//! signal and no value is known here.

mod cells;
mod column;
mod names;
mod scope;

pub use column::Column;
pub(crate) use column::{TimeColumn, Unit, listed};

use std::borrow::Cow;

/// A table before its cells are read as values.
#[derive(Clone, Debug)]
pub struct Table<'t> {
    pub columns: Vec<Column<'t>>,
    pub rows: Vec<Row<'t>>,
    /// whether it is an export, which may contain columns of other signals, and rows that end early
    pub is_export: bool,
    /// the columns of times of a plain table
    pub(crate) times: Vec<TimeColumn<'t>>,
    /// in an export, the time from its start to its end [ms]
    pub(crate) duration_ms: Option<f64>,
    separator: char,
    cells: usize,
}

/// A line of samples.
#[derive(Clone, Copy, Debug)]
pub struct Row<'t> {
    /// the line, counted from 1
    pub line: usize,
    text: &'t str,
}

impl<'t> Table<'t> {
    /// Reads the head; `wanted` are the columns that the user names.
    #[must_use]
    pub fn read(text: &'t str, wanted: &[&str]) -> Self {
        let text = text.strip_prefix('\u{feff}').unwrap_or(text);
        let lines: Vec<&str> = text.lines().collect();
        match scope::separator(&lines) {
            Some(separator) => export(&lines, separator, wanted),
            None => plain(&lines),
        }
    }

    /// Reads the head without the time columns that the user leaves out.
    #[must_use]
    pub fn without(mut self, map: &[(String, String)]) -> Self {
        let is_out = |time: &TimeColumn<'_>| map.iter().any(|(name, signal)| name == time.name && signal == "-");
        for column in &mut self.columns {
            column.time = column.time.filter(|time| !is_out(time));
        }
        self
    }

    /// The cells of a row.
    ///
    /// # Errors
    /// The number of cells of the row, and the correct number.
    pub(crate) fn cells(&self, row: &Row<'t>, cells: &mut Vec<&'t str>) -> Result<(), [usize; 2]> {
        match self.is_export {
            true => cells::split_samples(row.text, self.separator, cells),
            false => cells::split(row.text, self.separator, cells),
        }
        while cells.len() > self.cells && cells.last().is_some_and(|cell| cell.is_empty()) {
            cells.pop(); // empty, after a separator at the end
        }
        let is_right = cells.len() == self.cells || self.is_export && cells.len() < self.cells;
        if is_right { Ok(()) } else { Err([cells.len(), self.cells]) }
    }

    /// A cell with a decimal point.
    pub(crate) fn number<'c>(&self, cell: &'c str) -> Cow<'c, str> {
        cells::number(cell, self.separator)
    }

    /// Whether a comma separates cells, so that it is not a decimal mark.
    pub(crate) fn has_commas(&self) -> bool {
        self.separator == ','
    }

    /// Whether a plain table has not even a name.
    pub(crate) fn is_empty(&self) -> bool {
        !self.is_export && self.rows.is_empty() && self.columns.iter().all(|column| column.name.is_empty())
    }

    /// Whether a plain table has blanks between its cells, which separate the words of a name too.
    pub(crate) fn has_blanks(&self) -> bool {
        let mut words = self.rows.first().map_or("", |row| row.text).split_whitespace();
        !self.is_export && self.cells == 1 && words.clone().nth(1).is_some() && words.all(cells::is_number)
    }

    /// Whether a column of the table, or one of its times, has this name or shows this symbol.
    #[must_use]
    pub fn has(&self, name: &str) -> bool {
        let is_time = self.times.iter().any(|time| time.name == name);
        is_time || self.columns.iter().any(|column| column.name == name || column.symbol == name)
    }
}

impl Row<'_> {
    /// The place of a cell of the row.
    pub(crate) fn place(&self, cell: &str) -> [usize; 2] {
        [self.line, cells::column_of(self.text, cell)]
    }
}

/// A header, then samples.
fn plain<'t>(lines: &[&'t str]) -> Table<'t> {
    let first = lines.first().copied().unwrap_or_default();
    let separator = ['\t', ';'].into_iter().find(|separator| first.contains(*separator)).unwrap_or(',');
    let mut header = Vec::new();
    cells::split(first, separator, &mut header);
    let (mut columns, mut times, mut current) = (Vec::new(), Vec::<TimeColumn<'_>>::new(), None);
    for (cell, name) in header.iter().copied().enumerate() {
        let place = [1, cells::column_of(first, name)];
        match column::time_unit(name) {
            Some(unit) => {
                // Of times side by side, the first one counts.
                if times.last().is_none_or(|last| last.cell + 1 < cell) {
                    current = Some(TimeColumn { name, cell, unit, place });
                }
                times.push(TimeColumn { name, cell, unit, place });
            }
            None => columns.push(Column { name, place, cell, time: current, ..Column::default() }),
        }
    }
    for column in &mut columns {
        column.time = column.time.or(times.first().copied());
    }
    let is_blank = |line: &&str| line.chars().all(|letter| letter == separator || letter.is_whitespace());
    let end = lines.iter().rposition(|line| !is_blank(line)).map_or(0, |last| last + 1);
    let rows = rows(&lines[..end], 1).collect();
    Table { columns, rows, is_export: false, times, duration_ms: None, separator, cells: header.len() }
}

/// A head, then samples up to a line `EOF` or the end of the file.
fn export<'t>(lines: &[&'t str], separator: char, wanted: &[&str]) -> Table<'t> {
    let scope::Head { columns, cells, start, duration_ms } = scope::head(lines, separator, wanted);
    let is_end = |row: &Row<'_>| row.text.trim_matches(|letter| letter == '"' || letter == separator).trim() == "EOF";
    let rows = rows(lines, start).take_while(|row| !is_end(row)).filter(|row| !row.text.trim().is_empty());
    let (rows, times) = (rows.collect(), Vec::new());
    Table { columns, rows, is_export: true, times, duration_ms, separator, cells }
}

/// The lines from that index on.
fn rows<'t>(lines: &[&'t str], start: usize) -> impl Iterator<Item = Row<'t>> {
    let of = |(index, text): (usize, &&'t str)| Row { line: index + 1, text };
    lines.iter().enumerate().skip(start).map(of)
}
