//! What recorders write, as columns of cells: plain CSV, tables with `;` and a decimal comma, exports of TwinCAT Scope. No
//! signal and no value is known here.
//!
//! An export of TwinCAT Scope begins with `Name`. Lines about the recording and its channels follow, in each a key and a value
//! for every channel; then come the samples. What stands below a key is a time:
//!
//! ```text
//! Name            Scope Project
//!
//! SymbolName      MAIN.x.v_motor  SymbolName      MAIN.x.v_add
//! SampleTime[ms]  1               SampleTime[ms]  1
//! 0               12,25           0               0,5
//! ```

use std::borrow::Cow;

/// The keys above a channel of an export that name it; the last one that is there does.
const NAMES: [&str; 2] = ["Name", "SymbolName"];
const SAMPLE_TIME: &str = "SampleTime[ms]";

/// A table whose cells have not been read as values yet.
#[derive(Clone, Debug)]
pub struct Table<'t> {
    pub columns: Vec<Column<'t>>,
    pub rows: Vec<Row<'t>>,
    /// whether it is an export, which has columns of signals that are not the block's
    pub is_export: bool,
    separator: char,
    cells: usize,
}

/// A column that is no time.
#[derive(Clone, Debug)]
pub struct Column<'t> {
    pub name: &'t str,
    /// where the name stands: line and column, both from 1
    pub place: [usize; 2],
    /// what an export says of the time between two samples [ms], and where: line and column
    pub sample_time: Option<(&'t str, [usize; 2])>,
    cell: usize,
}

/// A line of samples.
#[derive(Clone, Copy, Debug)]
pub struct Row<'t> {
    /// the line, counted from 1
    pub line: usize,
    text: &'t str,
}

impl<'t> Table<'t> {
    #[must_use]
    pub fn read(text: &'t str) -> Self {
        let text = text.strip_prefix('\u{feff}').unwrap_or(text);
        let first = text.lines().next().unwrap_or_default();
        let separator = ['\t', ';'].into_iter().find(|separator| first.contains(*separator)).unwrap_or(',');
        let lines = text.lines().enumerate().map(|(index, text)| Row { line: index + 1, text });
        if bare(first.split(separator).next().unwrap_or_default()) == NAMES[0] {
            export(&lines.collect::<Vec<_>>(), separator)
        } else {
            plain(lines, separator)
        }
    }

    /// The cells of the columns, in their order, each with its column in the line, from 1.
    ///
    /// # Errors
    /// The line has so many cells, and another number of them is right.
    pub fn cells(&self, row: &Row<'t>) -> Result<impl Iterator<Item = (usize, Cow<'t, str>)>, [usize; 2]> {
        let mut cells = placed(row.text, self.separator);
        if cells.len() == self.cells + 1 && cells.last().is_some_and(|(_, cell)| cell.is_empty()) {
            cells.pop(); // behind a separator at the end
        }
        if cells.len() != self.cells {
            return Err([cells.len(), self.cells]);
        }
        Ok(self.columns.iter().map(move |column| {
            let (at, cell) = cells[column.cell];
            (at, self.number(bare(cell)))
        }))
    }

    /// A decimal comma as a point, where no comma separates cells.
    fn number<'c>(&self, cell: &'c str) -> Cow<'c, str> {
        let has_comma = self.separator != ',' && cell.contains(',') && !cell.contains('.');
        if has_comma { Cow::Owned(cell.replace(',', ".")) } else { Cow::Borrowed(cell) }
    }
}

/// A cell without the blanks and the quotation marks around it.
fn bare(cell: &str) -> &str {
    let cell = cell.trim();
    cell.strip_prefix('"').and_then(|cell| cell.strip_suffix('"')).unwrap_or(cell)
}

/// The cells of a line, each with the column at which it begins, from 1.
fn placed(line: &str, separator: char) -> Vec<(usize, &str)> {
    let (mut cells, mut at) = (Vec::new(), 1);
    for cell in line.split(separator) {
        cells.push((at, cell));
        at += cell.chars().count() + 1;
    }
    cells
}

/// A header, then samples.
fn plain<'t>(mut lines: impl Iterator<Item = Row<'t>>, separator: char) -> Table<'t> {
    let header = placed(lines.next().map_or("", |row| row.text), separator);
    let cells = header.len();
    let named = header.into_iter().enumerate().map(|(cell, (at, name))| (cell, at, bare(name)));
    let columns = named.filter(|(_, _, name)| !is_time(name));
    let columns = columns.map(|(cell, at, name)| Column { name, place: [1, at], sample_time: None, cell }).collect();
    Table { columns, rows: lines.collect(), is_export: false, separator, cells }
}

/// Whether a column is called a time: `time`, `Time [s]`, `t`, `Zeit(ms)`.
fn is_time(name: &str) -> bool {
    let name = name.to_ascii_lowercase();
    let word = name.split(|letter: char| !letter.is_ascii_alphanumeric()).next().unwrap_or_default();
    name == "t" || ["time", "timestamp", "zeit", "zeitstempel"].contains(&word)
}

/// The lines of an export.
fn export<'t>(lines: &[Row<'t>], separator: char) -> Table<'t> {
    let is_sample = |row: &Row<'_>| {
        let first = row.text.split(separator).next().unwrap_or_default();
        bare(first).replace(',', ".").parse::<f64>().is_ok()
    };
    let start = lines.iter().position(is_sample).unwrap_or(lines.len());
    let with_key = |key: &str| {
        let of_key = |row: &&Row<'t>| bare(row.text.split(separator).next().unwrap_or_default()) == key;
        lines[..start].iter().rfind(of_key).map(|row| (row.line, placed(row.text, separator)))
    };
    let (line, mut header) = NAMES.iter().rev().find_map(|key| with_key(key)).unwrap_or_default();
    let times = with_key(SAMPLE_TIME);
    while header.last().is_some_and(|(_, cell)| bare(cell).is_empty()) {
        header.pop();
    }
    let channels = header.iter().enumerate().filter(|(_, (_, name))| !NAMES.contains(&bare(name)));
    let columns = channels.map(|(cell, (at, name))| {
        let sample_time = times.as_ref().and_then(|(line, times)| {
            let (at, text) = times.get(cell)?;
            Some((bare(text), [*line, *at]))
        });
        Column { name: bare(name), place: [line, *at], sample_time, cell }
    });
    let is_row = |row: &&Row<'_>| !row.text.trim().is_empty() && row.text.trim() != "EOF";
    Table {
        columns: columns.collect(),
        rows: lines[start..].iter().filter(is_row).copied().collect(),
        is_export: true,
        separator,
        cells: header.len(),
    }
}
