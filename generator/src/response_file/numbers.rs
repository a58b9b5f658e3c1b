//! Cells -> numbers: the column of each quantity, and each line of numbers. Only the unit of the frequency is applied here.

use super::Said;
use super::columns::{Quantity, Unit};
use super::table::{Column, Row, Table};
use super::text::{self, Separator};
use crate::codes;
use crate::diagnostics::Diagnostic;
use std::f64::consts::TAU;

/// A used column.
#[derive(Clone, Debug)]
pub(super) struct Used<'t> {
    pub index: usize,
    pub name: &'t str,
    pub place: [usize; 2],
    pub unit: Option<Unit>,
}

/// The notation of the complex value.
#[derive(Clone, Debug)]
pub(super) enum Value<'t> {
    Parts([Used<'t>; 2]),
    Polar { magnitude: Used<'t>, phase: Used<'t> },
}

/// The columns of a response.
#[derive(Clone, Debug)]
pub(super) struct Columns<'t> {
    pub frequency: Used<'t>,
    pub value: Value<'t>,
    pub coherence: Option<Used<'t>>,
    pub error: Option<Used<'t>>,
    pub averages: Option<Used<'t>>,
}

/// A line of the file as numbers.
#[derive(Clone, Copy, Debug)]
pub(super) struct Line {
    pub line: usize,
    pub hz: f64,
    /// first columns of the cells of the frequency and of both parts of the value
    pub columns: [usize; 3],
    /// real and imaginary part, or magnitude and phase, as written
    pub value: [f64; 2],
    pub coherence: Option<f64>,
    /// as written
    pub error: Option<f64>,
    /// number of averages of the line, else of the file
    pub averages: Option<f64>,
}

impl<'t> Value<'t> {
    pub(super) fn columns(&self) -> [&Used<'t>; 2] {
        match self {
            Self::Parts([real, imaginary]) => [real, imaginary],
            Self::Polar { magnitude, phase } => [magnitude, phase],
        }
    }

    /// The place of the name of the first column.
    pub(super) fn place(&self) -> [usize; 2] {
        self.columns()[0].place
    }

    pub(super) fn phase_place(&self) -> [usize; 2] {
        self.columns()[1].place
    }
}

/// Possible names, for messages.
const NAMES: [(Quantity, &str); 5] = [
    (Quantity::Frequency, "f [Hz]"),
    (Quantity::Real, "re"),
    (Quantity::Imaginary, "im"),
    (Quantity::Magnitude, "magnitude [dB]"),
    (Quantity::Phase, "phase [deg]"),
];

fn written(quantity: Quantity) -> &'static str {
    NAMES.iter().find(|(known, _)| *known == quantity).map_or("", |(_, name)| name)
}

/// The column of each quantity.
pub(super) fn choose<'t>(table: &Table<'t>, said: &mut Said<'_>) -> Option<Columns<'t>> {
    let mut of = |quantity| column(table, quantity, said);
    let frequency = of(Quantity::Frequency);
    let [real, imaginary, magnitude, phase] =
        [Quantity::Real, Quantity::Imaginary, Quantity::Magnitude, Quantity::Phase].map(&mut of);
    let [coherence, error, averages] = [Quantity::Coherence, Quantity::StandardError, Quantity::Averages].map(&mut of);
    let half = match (&real, &imaginary, &magnitude, &phase) {
        (Some(_), None, _, _) => Quantity::Imaginary,
        (None, Some(_), _, _) => Quantity::Real,
        (_, _, None, Some(_)) => Quantity::Magnitude,
        _ => Quantity::Phase,
    };
    let value = match (real, imaginary, magnitude, phase) {
        (Some(real), Some(imaginary), _, _) => Some(Value::Parts([real, imaginary])),
        (_, _, Some(magnitude), Some(phase)) => Some(Value::Polar { magnitude, phase }),
        _ => None,
    };
    if said.report.has_errors() {
        return None; // two columns for one quantity
    }
    match (frequency, value) {
        (Some(frequency), Some(value)) => Some(Columns { frequency, value, coherence, error, averages }),
        (frequency, value) => {
            let missing = [frequency.is_none().then_some(Quantity::Frequency), value.is_none().then_some(half)];
            let last = table.columns.last().map_or([1, 1], |column| column.place);
            let names: Vec<&str> = table.columns.iter().map(|column| column.name).collect();
            for quantity in missing.into_iter().flatten() {
                let found = format!("no column of the {}: the columns are {}", word(quantity), names.join(", "));
                said.push(
                    said.error(codes::RESPONSE_COLUMN, [last[0], table.columns[0].place[1]], found)
                        .allowed("a frequency, and real and imaginary part or magnitude and phase")
                        .instead(format!("`{}` as the name of the column that holds it", written(quantity))),
                );
            }
            None
        }
    }
}

fn word(quantity: Quantity) -> &'static str {
    match quantity {
        Quantity::Frequency => "frequency",
        Quantity::Real => "real part",
        Quantity::Imaginary => "imaginary part",
        Quantity::Magnitude => "magnitude",
        Quantity::Phase => "phase",
        Quantity::Coherence => "coherence",
        Quantity::StandardError => "standard error",
        Quantity::Averages => "number of averages",
    }
}

/// The only column of a quantity. A second one, or a unit that the quantity does not have, is an error.
fn column<'t>(table: &Table<'t>, quantity: Quantity, said: &mut Said<'_>) -> Option<Used<'t>> {
    let is_of =
        |column: &&(usize, &Column<'t>)| column.1.meaning.as_ref().is_some_and(|known| known.quantity == quantity);
    let all: Vec<(usize, &Column<'t>)> = table.columns.iter().enumerate().collect();
    let mut of: Vec<_> = all.iter().filter(is_of).collect();
    if of.len() > 1 {
        // Both `coherence` and `coh [%]` are two columns of one quantity; so are `f [Hz]` and `omega [rad/s]`.
        let names: Vec<String> = of.iter().map(|(_, column)| format!("`{}`", column.name)).collect();
        let found = format!("{} columns of the {}: {}", of.len(), word(quantity), names.join(", "));
        let (_, second) = of[1];
        said.push(
            said.error(codes::TWO_COLUMNS, second.place, found)
                .allowed("one column of each quantity of one response")
                .instead("only the response from the commanded velocity to the motor's: remove the other columns"),
        );
    }
    let (index, column) = of.drain(..).next()?;
    let meaning = column.meaning.as_ref()?;
    let (needs, instead): (&[Unit], &str) = match quantity {
        Quantity::Frequency => (&[Unit::Hertz, Unit::Kilohertz, Unit::RadiansPerSecond], "Hz, kHz or rad/s"),
        Quantity::Phase => (&[Unit::Degrees, Unit::Radians], "deg or rad"),
        _ => (&[], ""),
    };
    let other = meaning.unit.filter(|unit| !needs.contains(unit));
    if !needs.is_empty() && (meaning.unknown.is_some() || other.is_some()) {
        let found = format!("`{}` has a unit that the {} does not have", column.name, word(quantity));
        let write = format!("{}, and the numbers in it", written(quantity));
        said.push(said.error(codes::RESPONSE_UNIT, column.place, found).allowed(instead).instead(write));
    }
    Some(Used { index: *index, name: column.name, place: column.place, unit: meaning.unit })
}

/// The numbers of all lines.
pub(super) fn lines(table: &Table<'_>, columns: &Columns<'_>, said: &mut Said<'_>) -> Vec<Line> {
    let before = said.report.diagnostics.len();
    let (others, rows): (Vec<&Row<'_>>, Vec<&Row<'_>>) =
        table.rows.iter().partition(|row| row.cells.len() != table.columns.len());
    if 2 * others.len() > table.rows.len() {
        cell_count(others[0], table, said);
        return Vec::new();
    }
    others.iter().for_each(|row| cell_count(row, table, said));
    let lines: Vec<Line> = rows.iter().filter_map(|row| line(row, table, columns, said)).collect();
    let wrong = table.rows.len() - lines.len();
    if 2 * wrong > table.rows.len() {
        said.report.diagnostics.truncate(before);
        let found = format!("{wrong} of {} lines lack a number", table.rows.len());
        said.push(
            said.error(codes::RESPONSE_TABLE, [table.rows[0].line, 1], found)
                .allowed("a number in each column that is used, in every line")
                .instead("the table as the measuring program exports it, without lines of other tables"),
        );
    }
    lines
}

/// One line; `None` if one of its cells is not a number.
fn line(row: &Row<'_>, table: &Table<'_>, columns: &Columns<'_>, said: &mut Said<'_>) -> Option<Line> {
    let mut number = |used: &Used<'_>| {
        let cell = row.cells[used.index];
        let value = text::number(cell.text);
        if value.is_none() {
            not_a_number([row.line, cell.column], cell.text, used.name, said);
        }
        value
    };
    let [first, second] = columns.value.columns();
    let values = [&columns.frequency, first, second].map(&mut number);
    let others = [&columns.coherence, &columns.error, &columns.averages].map(Option::as_ref);
    let others = others.map(|used| used.map(|used| (used, number(used))));
    if others.iter().any(|other| other.is_some_and(|(_, value)| value.is_none())) {
        return None;
    }
    let [coherence, error, averages] = others.map(|other| other.and_then(|(used, value)| Some((used, value?))));
    let [coherence, error] = [coherence, error].map(|found| bounded(found?, row, said));
    let hz = match columns.frequency.unit {
        Some(Unit::RadiansPerSecond) => values[0]? / TAU,
        Some(Unit::Kilohertz) => values[0]? * 1000.0,
        _ => values[0]?,
    };
    Some(Line {
        line: row.line,
        hz,
        columns: [&columns.frequency, first, second].map(|used| row.cells[used.index].column),
        value: [values[1]?, values[2]?],
        coherence,
        error,
        averages: averages.map(|(_, count)| count).or(table.averages),
    })
}

fn not_a_number(place: [usize; 2], cell: &str, name: &str, said: &mut Said<'_>) {
    let what = if cell.is_empty() { "an empty cell".to_owned() } else { format!("`{}`", cell.escape_default()) };
    said.push(
        said.error(codes::RESPONSE_CELL, place, format!("{what} for `{name}` is not a number"))
            .allowed("a finite number with a decimal point or a decimal comma, without a separator of thousands")
            .instead("the measured value: a weak line stays in with its coherence, it is not cut"),
    );
}

/// Reports a line with too many or too few cells. Decimal commas between separating commas have this effect.
fn cell_count(row: &Row<'_>, table: &Table<'_>, said: &mut Said<'_>) {
    let (found, right) = (row.cells.len(), table.columns.len());
    let instead = match table.separator {
        Separator::Comma if found > right => {
            "decimal points, or `;` between the cells: the decimal commas look like separators"
        }
        _ => "a cell for each name",
    };
    let text = format!("{found} cells below {right} names");
    said.push(
        said.error(codes::RESPONSE_CELLS, [row.line, 1], text).allowed(format!("{right} cells")).instead(instead),
    );
}

/// Checks that a coherence is from 0 to 1, and that a standard error is not negative.
fn bounded((used, value): (&Used<'_>, f64), row: &Row<'_>, said: &mut Said<'_>) -> Option<f64> {
    let is_coherence = used.is_coherence();
    let value = if is_coherence && used.unit == Some(Unit::Percent) { value / 100.0 } else { value };
    if value < 0.0 || is_coherence && value > 1.0 {
        let [allowed, instead] = match is_coherence {
            true => {
                ["0 to 1, the squared coherence", "the coherence, not its dB; `coherence [%]` where it is in per cent"]
            }
            false => ["0 or more", "the standard error of |P|, in the unit of |P|"],
        };
        let found = format!("{value} for `{}`", used.name);
        let place = [row.line, row.cells[used.index].column];
        said.push(said.error(codes::COHERENCE, place, found).allowed(allowed).instead(instead));
    }
    Some(value)
}

impl Used<'_> {
    fn is_coherence(&self) -> bool {
        super::columns::meaning(self.name, None).is_some_and(|known| known.quantity == Quantity::Coherence)
    }
}

/// The reason if the standard errors of a table count as 0.
pub(super) fn without_errors(table: &Table<'_>, columns: &Columns<'_>, said: &Said<'_>) -> Option<Diagnostic> {
    let has_count = columns.averages.is_some() || table.averages.is_some();
    if columns.error.is_some() || columns.coherence.is_some() && has_count {
        return None;
    }
    let (place, found, instead) = match &columns.coherence {
        Some(used) => (
            used.place,
            "a coherence without the number of averages: its standard errors count as 0",
            "a line `# averages: 20` above the names, with the number of the measurement",
        ),
        None => (
            [columns.frequency.place[0], 1],
            "neither a coherence nor a standard error: the response counts as exact",
            "a column `coherence` and a line `# averages: 20`, or a column `se`",
        ),
    };
    Some(said.warning(codes::WITHOUT_ERRORS, place, found).instead(instead))
}
