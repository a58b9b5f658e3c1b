//! A measured frequency response as text or XML -> the response from the commanded velocity to the motor's, or its errors.
//! No parameter and no file system: the arguments are bytes, the input of the response, the cycle time and the bands of the
//! active stages.
//!
//! ```text
//! text        bytes -> lines -> cells
//! columns     the meaning of a column name: a quantity and its unit
//! table       the line of names, the first line of numbers, the text around them
//! numbers     cells -> numbers, each with its line
//! sinumerik   spectra of a measurement as XML -> numbers; elements: its elements; base85: their numbers
//! order       rising frequencies, no gap, below half the sampling frequency
//! units       numbers -> complex values with their relative standard errors
//! phase       minimum phase and dead time: unit and sign of the phase
//! low_end     checks of the lowest lines: 1, another unit, an integrator
//! speed_loop  the open speed plant -> the closed speed loop
//! reach       whether the lines cover the band of an active stage
//! ```

mod base85;
mod columns;
mod elements;
mod low_end;
mod numbers;
mod order;
mod phase;
mod reach;
mod sinumerik;
mod speed_loop;
mod table;
mod text;
mod units;

use crate::diagnostics::{Diagnostic, Place, Report};
use stability::{Complex64, Response, angle, magnitude, turned};

/// Input and output of a measured response. The delay [s] is the part that the measurement does not contain of the way from
/// the cycle that writes the commanded velocity to the cycle that reads its effect: the cycles between the CNC and the
/// drive, if the drive itself was measured.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum From {
    /// from the commanded velocity to the motor's
    Command { delay: f64 },
    /// the open speed plant, from the current (or torque) to the motor's velocity, with the speed controller `Kp (1 + 1/(s
    /// Tn))`: Kp in the unit of the current per unit of the velocity, Tn [s]; 0 for no integral part
    Current { kp: f64, tn: f64, delay: f64 },
}

/// The band of an active stage.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Band {
    /// its index, 0 to 2
    pub stage: usize,
    /// centre frequency [Hz]
    pub f0: f64,
    /// half-power width f0 / Q [Hz]
    pub width: f64,
}

/// A usable response.
#[derive(Clone, Debug)]
pub struct Measured {
    pub response: Response,
    /// warnings
    pub said: Report,
    /// number of used lines
    pub lines: usize,
    /// whether the file has standard errors, or coherence and the number of averages
    pub has_errors: bool,
    /// the dead time [s] beyond the minimum phase, if the lines reach far enough to show it
    pub dead_time: Option<f64>,
}

/// A line of a response with its place.
#[derive(Clone, Copy, Debug)]
struct Point {
    line: usize,
    hz: f64,
    response: Complex64,
    /// standard error, relative to the magnitude
    error: f64,
}

/// The contents of a file.
struct Reading<'t> {
    lines: Vec<numbers::Line>,
    columns: numbers::Columns<'t>,
    /// the reason if its standard errors count as 0
    without_errors: Option<Diagnostic>,
}

/// Collects messages about one file.
struct Said<'a> {
    file: &'a str,
    report: Report,
}

impl Said<'_> {
    fn at(&self, [line, column]: [usize; 2]) -> Place {
        Place { line, column, ..Place::whole(self.file) }
    }

    fn error(&self, code: &'static str, place: [usize; 2], found: impl Into<String>) -> Diagnostic {
        Diagnostic::error(code, self.at(place), found)
    }

    fn warning(&self, code: &'static str, place: [usize; 2], found: impl Into<String>) -> Diagnostic {
        Diagnostic::warning(code, self.at(place), found)
    }

    fn push(&mut self, diagnostic: Diagnostic) {
        self.report.push(diagnostic);
    }

    /// The result, if no error so far prevents its use.
    fn usable<T>(&self, made: T) -> Result<T, Report> {
        if self.report.has_errors() { Err(self.report.clone()) } else { Ok(made) }
    }
}

/// Whether a file is XML, whose signals have numbers instead of names: the set must state the input of the response.
#[must_use]
pub fn is_without_names(bytes: &[u8]) -> bool {
    sinumerik::is_xml(&text::decode(bytes))
}

/// Whether a file, or its beginning, has the columns of a response, or is XML.
#[must_use]
pub fn is_response(bytes: &[u8]) -> bool {
    let (text, mut said) = (text::decode(bytes), Said { file: "", report: Report::default() });
    sinumerik::is_xml(&text)
        || table::Table::read(&text).is_ok_and(|table| numbers::choose(&table, &mut said).is_some())
}

/// Reads a response for a block with this cycle time [s].
///
/// # Errors
/// The file must not be used. The report has all messages of the first step with an error, after those of the previous
/// steps.
pub fn read(file: &str, bytes: &[u8], from: From, cycle_time: f64, bands: &[Band]) -> Result<Measured, Report> {
    let mut said = Said { file, report: Report::default() };
    let text = text::decode(bytes);
    let reading = if sinumerik::is_xml(&text) { sinumerik::read(&text, &said)? } else { of_table(&text, &mut said)? };
    let Reading { lines, columns, without_errors } = reading;
    let lines = order::check(lines, columns.frequency.place, cycle_time, &mut said);
    let lines = said.usable(lines)?;
    let points = units::points(&lines, &columns, from, cycle_time, &mut said);
    let points = said.usable(points)?;
    low_end::check(&points, columns.value.place(), from, &mut said);
    said.usable(())?;
    let points = speed_loop::close(&points, from, &mut said);
    let points = said.usable(points)?;
    let dead_time = phase::dead_time(&points, columns.value.phase_place(), from, cycle_time, &mut said);
    let has_errors = without_errors.is_none();
    without_errors.into_iter().for_each(|warning| said.push(warning));
    reach::check(&points, &lines, bands, dead_time, &mut said);
    said.usable(())?;
    let points = reach::with_information(points, bands, &mut said);
    let hz: Vec<f64> = points.iter().map(|point| point.hz).collect();
    let values: Vec<Complex64> = points.iter().map(|point| point.response).collect();
    let absolute: Vec<f64> = points.iter().map(|point| point.error * magnitude(point.response)).collect();
    let response = Response::new(&hz, &values, &absolute, cycle_time);
    Ok(Measured { response, said: said.report, lines: points.len(), has_errors, dead_time })
}

/// The messages about the lowest lines of a response from the commanded velocity to the motor's that was not read from a file:
/// frequencies [Hz], values, standard errors.
#[must_use]
pub fn of_lowest_lines(hz: &[f64], response: &[Complex64], error: &[f64]) -> Vec<Diagnostic> {
    let point = |((hz, response), error): ((&f64, &Complex64), &f64)| Point {
        line: 0,
        hz: *hz,
        response: *response,
        error: error / magnitude(*response),
    };
    let points: Vec<Point> = hz.iter().zip(response).zip(error).map(point).collect();
    let mut said = Said { file: "", report: Report::default() };
    low_end::check(&points, [0, 0], From::Command { delay: 0.0 }, &mut said);
    said.report.diagnostics
}

/// The lines of a table.
fn of_table<'t>(text: &'t str, said: &mut Said<'_>) -> Result<Reading<'t>, Report> {
    let table = table::Table::read(text).map_err(|mistake| mistake.diagnostic(said))?;
    let Some(columns) = numbers::choose(&table, said) else { return Err(said.report.clone()) };
    said.usable(())?;
    let lines = numbers::lines(&table, &columns, said);
    let without_errors = numbers::without_errors(&table, &columns, said);
    said.usable(Reading { lines, columns, without_errors })
}

/// [deg]
fn degrees(value: Complex64) -> f64 {
    angle(value).to_degrees()
}
