//! A text as a table: its separator, the names of its columns, the text around them.

use super::Said;
use super::columns::{self, AVERAGES, Meaning};
use super::text::{self, Cell, SEPARATORS, Separator};
use crate::codes;
use crate::diagnostics::Diagnostic;

/// A column of the table with the meaning of its name.
#[derive(Clone, Debug)]
pub(super) struct Column<'t> {
    pub name: &'t str,
    /// line and column of the name
    pub place: [usize; 2],
    pub meaning: Option<Meaning>,
}

/// A line of cells.
#[derive(Clone, Debug)]
pub(super) struct Row<'t> {
    pub line: usize,
    pub cells: Vec<Cell<'t>>,
}

#[derive(Clone, Debug)]
pub(super) struct Table<'t> {
    pub columns: Vec<Column<'t>>,
    pub rows: Vec<Row<'t>>,
    /// the number of averages, if a line outside the table states it
    pub averages: Option<f64>,
    pub separator: Separator,
}

/// The reason why a text is not a table.
#[derive(Clone, Debug)]
pub(super) struct Mistake {
    line: usize,
    found: String,
}

/// A response needs at least this number of columns.
const LEAST_CELLS: usize = 3;

/// An example of a file.
const EXAMPLE: &str =
    "a first line such as `f [Hz];magnitude [dB];phase [deg];coherence`, below it a line of numbers for each frequency";

impl Mistake {
    pub(super) fn diagnostic(self, said: &Said<'_>) -> Diagnostic {
        let place = [self.line, usize::from(self.line > 0)];
        let allowed =
            "text with a line of column names and lines of numbers, separated by tabs, semicolons, commas or blanks";
        said.error(codes::RESPONSE_TABLE, place, self.found).allowed(allowed).instead(EXAMPLE)
    }
}

impl<'t> Table<'t> {
    pub(super) fn read(text: &'t str) -> Result<Self, Mistake> {
        let mistake = |line, found: &str| Mistake { line, found: found.to_owned() };
        if text.contains('\0') {
            return Err(mistake(0, "a binary file"));
        }
        let Some((separator, start)) = separated(text) else {
            return Err(mistake(0, &format!("no line with {LEAST_CELLS} numbers or more")));
        };
        let first = cells(text.lines().nth(start).unwrap_or_default(), separator);
        let Some((line, names)) = header(text, start, separator, first.len()) else {
            return Err(mistake(start + 1, "numbers without names of their columns above them"));
        };
        let below = units(text, line, start, separator);
        let columns = names.iter().enumerate().map(|(index, cell)| Column {
            name: cell.text,
            place: [line, cell.column],
            meaning: columns::meaning(cell.text, below.get(index).map(|cell| cell.text)),
        });
        let rows = text.lines().enumerate().skip(start).filter_map(|(index, line)| {
            let line = line.trim_end();
            let is_row = !line.trim().is_empty() && comment(line, separator).is_none();
            is_row.then(|| Row { line: index + 1, cells: cells(line, separator) })
        });
        let outside =
            text.lines().enumerate().filter(|(index, line)| *index < start || comment(line, separator).is_some());
        let averages = outside.filter(|(index, _)| index + 1 != line).find_map(|(_, line)| averages(line));
        Ok(Self { columns: columns.collect(), rows: rows.collect(), averages, separator })
    }
}

/// The text of a comment, and the characters before it.
fn comment(line: &str, separator: Separator) -> Option<(usize, &str)> {
    let trimmed = line.trim_start();
    let marks = ["#", "%", "//", "!", ";"];
    let marks = if separator == Separator::Semicolon { &marks[..4] } else { &marks[..] };
    let bare = marks.iter().find_map(|mark| trimmed.strip_prefix(mark))?;
    Some((line.chars().count() - bare.chars().count(), bare))
}

/// The cells of a line; a separator at the end does not begin another cell.
fn cells(line: &str, separator: Separator) -> Vec<Cell<'_>> {
    let mut cells = text::cells(line, separator);
    if cells.len() > LEAST_CELLS && cells.last().is_some_and(|cell| cell.text.is_empty()) {
        cells.pop();
    }
    cells
}

/// The separator with the largest number of lines of numbers, and the first of these lines, from 0.
fn separated(text: &str) -> Option<(Separator, usize)> {
    let is_row = |line: &str, separator: Separator| {
        let cells = cells(line, separator);
        let numbers = cells.iter().filter(|cell| text::number(cell.text).is_some()).count();
        let missing = cells.iter().filter(|cell| text::is_missing(cell.text)).count();
        // A column of text next to three of numbers is part of the table; a sentence with a number in it is not.
        let is_full = numbers + missing == cells.len() || numbers >= LEAST_CELLS && 2 * numbers > cells.len();
        cells.len() >= LEAST_CELLS && numbers > 0 && is_full && comment(line, separator).is_none()
    };
    let mut best: Option<(usize, Separator)> = None;
    for separator in SEPARATORS {
        let rows = text.lines().filter(|line| is_row(line, separator)).count();
        if rows > best.map_or(0, |(most, _)| most) {
            best = Some((rows, separator));
        }
    }
    let (_, separator) = best?;
    Some((separator, text.lines().position(|line| is_row(line, separator))?))
}

/// The names of the columns, with their line from 1: the last line above the numbers that has the same number of cells and
/// names at least two quantities. It may be a comment, with any separator. If there is none, a line that names quantities:
/// then the lines have too many or too few cells.
fn header(text: &str, start: usize, separator: Separator, width: usize) -> Option<(usize, Vec<Cell<'_>>)> {
    let above: Vec<(usize, usize, &str)> = text
        .lines()
        .take(start)
        .enumerate()
        .map(|(index, line)| {
            let (before, bare) = comment(line, separator).unwrap_or((0, line));
            (index + 1, before, bare)
        })
        .collect();
    let find = |is_width: &dyn Fn(usize) -> bool| {
        above.iter().rev().find_map(|(line, before, bare)| {
            let tried = [separator].into_iter().chain(SEPARATORS).map(|separator| names(bare, separator));
            let names = tried.into_iter().find(|names| is_width(names.len()) && quantities(names) >= 2)?;
            let moved = names.into_iter().map(|cell| Cell { column: cell.column + before, ..cell }).collect();
            Some((*line, moved))
        })
    };
    find(&|count| count == width).or_else(|| find(&|count| count >= LEAST_CELLS))
}

fn quantities(names: &[Cell<'_>]) -> usize {
    names.iter().filter(|cell| columns::meaning(cell.text, None).is_some()).count()
}

/// The cells of a line of names. With blanks as separator, a unit in brackets belongs to the word before it.
fn names(line: &str, separator: Separator) -> Vec<Cell<'_>> {
    let cells = cells(line, separator);
    if separator != Separator::Blanks {
        return cells;
    }
    let letters: Vec<usize> = line.char_indices().map(|(at, _)| at).chain([line.len()]).collect();
    let mut names: Vec<Cell<'_>> = Vec::new();
    for cell in cells {
        match names.last_mut() {
            Some(name) if cell.text.starts_with(['[', '(']) => {
                let end = (cell.column - 1 + cell.text.chars().count()).min(letters.len() - 1);
                name.text = &line[letters[name.column - 1]..letters[end]];
            }
            _ => names.push(cell),
        }
    }
    names
}

/// A line between the names and the numbers that contains only units.
fn units(text: &str, header: usize, start: usize, separator: Separator) -> Vec<Cell<'_>> {
    let between =
        text.lines().take(start).skip(header).map(|line| comment(line, separator).map_or(line, |(_, bare)| bare));
    let is_units = |cells: &Vec<Cell<'_>>| {
        let is_unit =
            |cell: &Cell<'_>| cell.text.is_empty() || cell.text.contains('[') || columns::unit(cell.text).is_some();
        cells.len() >= LEAST_CELLS && cells.iter().all(is_unit)
    };
    between.map(|line| cells(line, separator)).find(is_units).unwrap_or_default()
}

/// The number of averages in a line such as `# averages: 20` or `Mittelungen;20`.
fn averages(line: &str) -> Option<f64> {
    let lower = line.to_lowercase();
    let words: Vec<&str> =
        lower.split(|letter: char| !letter.is_alphanumeric()).filter(|word| !word.is_empty()).collect();
    let at = words.iter().position(|word| AVERAGES.contains(word))?;
    let after = words.get(at + 1).and_then(|word| word.parse::<u32>().ok());
    let before = || at.checked_sub(1).and_then(|at| words[at].parse::<u32>().ok());
    after.or_else(before).filter(|count| *count > 0).map(f64::from)
}
