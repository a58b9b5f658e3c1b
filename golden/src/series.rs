//! The values of a table's columns, column by column, and their written precision. The sampling times are in `instants.rs`.
//! Comparisons read them, and so do measurements.

use crate::instants::{self, Instants};
use crate::mistake::Mistake;
use crate::samples::{Samples, Shape, Signal};
use crate::table::{Column, Row, Table, listed};
use crate::value::{allowed, instead, parse};
use crate::written::Precision;
use generator::codes;
use portable::{Extreme, Literal, RealKind};

/// Rows that are that much longer than the recording repeat samples.
const LONGER: f64 = 1.2;

/// The values of a table's columns.
pub(crate) struct Columns {
    /// all signals of the shape; signals without a column keep their start value
    pub samples: Samples,
    /// the written precision of each signal
    pub precision: Vec<Precision>,
    /// the line of each sample, counted from 1
    pub lines: Vec<usize>,
    /// the signals whose first samples were left out, because another channel begins later, and their number
    pub skipped: Vec<(usize, usize)>,
}

/// The values of one column, from its first one on.
pub(crate) struct Series<'t> {
    pub signal: usize,
    pub column: &'t Column<'t>,
    pub values: Samples,
    /// the time of the first value [ns]; `None` if only rows are known
    pub begins: Option<i128>,
    lines: Vec<usize>,
    written: Precision,
    /// the cell of the last value
    last: &'t str,
    /// values that differ from the previous one at the same time: place of the first one, and their number
    differs: Option<([usize; 2], usize)>,
    wrong: Wrong,
    /// cells without a value since the last value: place of the first one, and their number
    blank: Option<([usize; 2], usize)>,
    /// empty cells before the first value
    late: Option<([usize; 2], usize)>,
    /// empty cells that are followed by a value
    missing: Option<([usize; 2], usize)>,
}

/// Errors of one kind: place of the first one, and their number.
#[derive(Default)]
struct Wrong {
    first: Option<Mistake>,
    count: usize,
}

impl Wrong {
    fn add(&mut self, mistake: impl FnOnce() -> Mistake) {
        self.count += 1;
        self.first.get_or_insert_with(mistake);
    }

    /// One message for any number of errors.
    fn said(self, what: &str) -> Option<Mistake> {
        let mut first = self.first?;
        if self.count > 1 {
            first.found += &format!(", and {} more {what}", self.count - 1);
        }
        Some(first)
    }
}

/// Reads the columns that are signals, from the first cycle on that all of them have. Without a cycle time the times are not
/// checked.
///
/// # Errors
/// All errors, in the order of the lines: those of the columns, wrong times.
pub(crate) fn read(
    table: &Table<'_>,
    signals: &[Option<usize>],
    shape: &Shape,
    cycle_time_ns: Option<u32>,
) -> Result<Columns, Vec<Mistake>> {
    let (series, times) = columns(table, signals, shape, |_| true)?;
    let offsets = match cycle_time_ns {
        Some(cycle_time_ns) => {
            let columns: Vec<&Column<'_>> = series.iter().map(|series| series.column).collect();
            none(instants::mistakes(&columns, &times, cycle_time_ns))?;
            offsets(&series, cycle_time_ns).map_err(|mistake| vec![mistake])?
        }
        None => vec![0; series.len()],
    };
    Ok(together(&series, &offsets, shape, table.rows.iter().map(|row| row.line).collect()))
}

/// Reads the columns that are signals, each with its own first value, and the columns of their times; `is_allowed` excludes
/// values.
///
/// # Errors
/// All errors, in the order of the lines: short or long rows, bad cells, missing values.
pub(crate) fn columns<'t>(
    table: &'t Table<'t>,
    signals: &[Option<usize>],
    shape: &Shape,
    is_allowed: fn(&Literal) -> bool,
) -> Result<(Vec<Series<'t>>, Vec<Instants<'t>>), Vec<Mistake>> {
    let columns = table.columns.iter().zip(signals).filter_map(|(column, signal)| Some((column, (*signal)?)));
    let mut series: Vec<Series<'_>> = columns.map(|(column, signal)| Series::new(column, signal, shape)).collect();
    let mut times: Vec<Instants<'_>> = Vec::new();
    for time in series.iter().filter_map(|series| series.column.time) {
        if times.iter().all(|known| known.column != time) {
            times.push(Instants::of(time));
        }
    }
    let mut mistakes: Vec<Mistake> = read_rows(table, &mut series, &mut times, is_allowed);
    for times in &times {
        let at_one_time = || series.iter().filter(|of| of.column.time == Some(times.column) && of.differs.is_some());
        let names = listed(at_one_time().map(|of| of.column.called()));
        let first = at_one_time().filter_map(|of| of.differs).min();
        mistakes.extend(first.map(|(place, count)| times.several(place, &names, count)).or_else(|| times.backwards()));
    }
    mistakes.extend(repeated_rows(table, &series));
    for series in &mut series {
        let times = times.iter().find(|times| Some(times.column) == series.column.time);
        series.begins = times.zip(series.lines.first()).and_then(|(times, line)| times.at(*line));
        let late = series.late.filter(|_| series.begins.is_none()).map(|late| ("at the start", late));
        let missing = series.missing.map(|missing| ("in the middle", missing)).or(late);
        mistakes.extend(std::mem::take(&mut series.wrong).said("cells of the column"));
        mistakes.extend(missing.map(|(part, (place, count))| self::missing(place, series.column, part, count)));
    }
    none(mistakes).map(|()| (series, times))
}

/// An error if there are mistakes: all of them, in the order of the lines.
fn none(mut mistakes: Vec<Mistake>) -> Result<(), Vec<Mistake>> {
    mistakes.sort_by_key(|mistake| (mistake.line, mistake.column));
    if mistakes.is_empty() { Ok(()) } else { Err(mistakes) }
}

/// Reads all rows once; returns the errors in their lengths.
fn read_rows<'t>(
    table: &Table<'t>,
    series: &mut [Series<'t>],
    times: &mut [Instants<'t>],
    is_allowed: fn(&Literal) -> bool,
) -> Vec<Mistake> {
    let (mut cells, mut rows, mut marks) = (Vec::new(), Wrong::default(), Marks::default());
    for row in &table.rows {
        if let Err([found, right]) = table.cells(row, &mut cells) {
            rows.add(|| wrong_row(table, row, found, right));
            continue;
        }
        for times in &mut *times {
            let cell = cells.get(times.column.cell).copied().unwrap_or_default();
            times.read(table.number(cell).as_ref(), row.line);
            marks.read(table, row, cell);
        }
        for series in &mut *series {
            marks.read(table, row, cells.get(series.column.cell).copied().unwrap_or_default());
            let repeats = times.iter().any(|times| times.repeats && Some(times.column) == series.column.time);
            series.read(table, row, &cells, repeats, is_allowed);
        }
    }
    rows.said("rows").into_iter().chain(marks.both).collect()
}

/// Channels without times that have a value in each row of an export although they were sampled less often: a scope fills
/// rows with the previous value. The rows of such an export are those of its fastest channel; if the head states its length,
/// it shows that too.
fn repeated_rows(table: &Table<'_>, series: &[Series<'_>]) -> Option<Mistake> {
    let fastest = table.columns.iter().filter_map(Column::interval_ms).reduce(f64::smaller)?;
    let is_repeated = |of: &&Series<'_>| {
        let longest = table.duration_ms.unwrap_or(f64::INFINITY).smaller(table.rows.len() as f64 * fastest);
        let recorded = of.column.interval_ms().map(|interval| (of.values.len().saturating_sub(1)) as f64 * interval);
        of.column.time.is_none() && recorded.is_some_and(|recorded| recorded > LONGER * longest)
    };
    let repeated: Vec<&Series<'_>> = series.iter().filter(is_repeated).collect();
    let names = listed(repeated.iter().map(|of| of.column.called()));
    let interval = repeated.first()?.column.interval_ms()?;
    let found = format!("more rows than samples, one every {interval} ms, of {names}: their samples are repeated");
    let mistake = Mistake::new(repeated[0].column.place, found, "one row for each sample");
    let remedy = "export with columns of times, or only channels that have one sampling time";
    Some(mistake.coded(codes::UNUSABLE_TIMES).instead(remedy))
}

/// The decimal marks of a table: with two of them, one separates thousands.
#[derive(Default)]
struct Marks {
    /// the first one, with its line
    first: Option<(u8, usize)>,
    both: Option<Mistake>,
}

impl Marks {
    fn read(&mut self, table: &Table<'_>, row: &Row<'_>, cell: &str) {
        let mark = cell.bytes().find(|letter| matches!(letter, b'.' | b',')).filter(|_| !table.has_commas());
        let Some(mark) = mark.filter(|mark| self.first.is_none_or(|(first, _)| first != *mark)) else { return };
        if self.both.is_some() || table.number(cell).parse::<f64>().is_err() {
            return;
        }
        let Some((_, line)) = self.first else { return self.first = Some((mark, row.line)) };
        let [own, other] = if mark == b',' { ["comma", "point"] } else { ["point", "comma"] };
        let found = format!("`{cell}` with a decimal {own}, after a number with a decimal {other} in line {line}");
        let mistake = Mistake::new(row.place(cell), found, "one decimal mark");
        self.both = Some(mistake.instead("export without separators of thousands"));
    }
}

fn wrong_row(table: &Table<'_>, row: &Row<'_>, found: usize, right: usize) -> Mistake {
    let right_cells = format!("{right} cells, as many as the header has columns");
    let mistake = Mistake::new([row.line, 1], format!("{found} cells"), right_cells);
    let is_of_commas = table.has_commas() && found > right;
    let remedy = "export with a decimal point, or with semicolons or tabs between the cells";
    if is_of_commas { mistake.instead(remedy) } else { mistake }
}

fn missing(place: [usize; 2], column: &Column<'_>, part: &str, count: usize) -> Mistake {
    let values = if count == 1 { "a value is".to_owned() } else { format!("{count} values are") };
    Mistake::new(
        place,
        format!("{values} missing {part} of the column `{}`", column.called().escape_default()),
        "a value in every cycle",
    )
    .instead("record it with the cycle of the block, or leave the column out")
}

impl<'t> Series<'t> {
    fn new(column: &'t Column<'t>, signal: usize, shape: &Shape) -> Self {
        let own = Shape { real: shape.real, signals: vec![shape.signals[signal].clone()] };
        let values = Samples::with_capacity(own, 0);
        let (written, wrong) = (Precision::default(), Wrong::default());
        Self {
            signal,
            column,
            values,
            lines: Vec::new(),
            last: "",
            differs: None,
            written,
            wrong,
            begins: None,
            blank: None,
            late: None,
            missing: None,
        }
    }

    /// Reads its cell in a row. In an export the cell is missing if the channel has no sample, or it repeats the sample together
    /// with its time.
    fn read(
        &mut self,
        table: &Table<'t>,
        row: &Row<'t>,
        cells: &[&'t str],
        repeats: bool,
        is_allowed: fn(&Literal) -> bool,
    ) {
        let cell = cells.get(self.column.cell).copied().unwrap_or_default();
        if repeats {
            if cell != self.last && !cell.is_empty() {
                self.differs.get_or_insert((row.place(cell), 0)).1 += 1;
            }
            return;
        }
        let has_time = self.column.time.is_none_or(|time| cells.get(time.cell).is_some_and(|time| !time.is_empty()));
        if cell.is_empty() && table.is_export {
            if has_time {
                self.blank.get_or_insert_with(|| (row.place(cell), 0)).1 += 1;
            }
            return;
        }
        if let Some((place, count)) = self.blank.take() {
            let gap = if self.lines.is_empty() { &mut self.late } else { &mut self.missing };
            gap.get_or_insert((place, 0)).1 += count;
        }
        let content = table.number(cell);
        let Shape { real, signals } = &self.values.shape;
        let Some(value) = parse(&content, &signals[0], *real).filter(is_allowed) else {
            self.wrong.add(|| wrong_cell(row.place(cell), &content, &signals[0], *real));
            return;
        };
        self.last = cell;
        self.written.add(&content, value);
        self.values.push(&[value]);
        self.lines.push(row.line);
    }
}

fn wrong_cell(place: [usize; 2], content: &str, signal: &Signal, real: RealKind) -> Mistake {
    let found = format!("`{}` for {}", content.escape_default(), signal.name);
    Mistake::new(place, found, allowed(signal.ty, real)).instead(instead(content, signal.ty, real))
}

/// The number of samples of each column before the first common one.
fn offsets(series: &[Series<'_>], cycle_time_ns: u32) -> Result<Vec<usize>, Mistake> {
    let Some(latest) = series.iter().filter_map(|series| series.begins).max() else { return Ok(vec![0; series.len()]) };
    let first = |series: &Series<'_>| series.begins.unwrap_or(latest);
    series.iter().map(|of| instants::cycles_between(of.column, first(of), latest, cycle_time_ns)).collect()
}

/// The samples that all columns have; without columns each row is a sample.
fn together(series: &[Series<'_>], offsets: &[usize], shape: &Shape, rows: Vec<usize>) -> Columns {
    let with = || series.iter().zip(offsets);
    let count = with().map(|(series, offset)| series.values.len().saturating_sub(*offset)).min().unwrap_or(rows.len());
    let mut start = Samples::with_capacity(shape.clone(), 1);
    start.push(&shape.signals.iter().map(|signal| signal.start).collect::<Vec<Literal>>());
    let mut bytes = start.bytes.repeat(count);
    let (frame, ranges) = (shape.frame(), shape.ranges());
    let mut precision = vec![Precision::default(); shape.signals.len()];
    for (series, offset) in with() {
        let range = &ranges[series.signal];
        let values = series.values.bytes.chunks_exact(range.len().max(1)).skip(*offset);
        for (sample, value) in bytes.chunks_exact_mut(frame).zip(values) {
            sample[range.clone()].copy_from_slice(value);
        }
        precision[series.signal] = series.written.of_column(shape.real);
    }
    let lines = with().next().map_or(rows, |(series, offset)| series.lines[*offset..].to_vec());
    let skipped = with().filter(|(_, offset)| **offset > 0).map(|(series, offset)| (series.signal, *offset));
    Columns { samples: Samples { shape: shape.clone(), bytes }, precision, lines, skipped: skipped.collect() }
}
