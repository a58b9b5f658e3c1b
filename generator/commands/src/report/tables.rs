//! The tables of a report, cell by cell: numbers as the commands `check`, `analyze` and `verify` print them. No markup.

use crate::measure::Results;
use crate::trace::{ParameterRow, Trace};
use crate::verify::Row;
use generator::analysis::{self, Analysis, OfDrive};
use generator::blocks::StageRow;
use generator::diagnostics::{Diagnostic, Place, Report};
use generator::digest::digest;
use generator::target::File;
use golden::tune::Tuning;
use serde::Serialize;
use std::path::Path;

/// A table: rows of cells, below a head.
#[derive(Clone, Debug, Serialize)]
pub struct Table {
    pub name: &'static str,
    pub head: Vec<&'static str>,
    pub rows: Vec<Vec<String>>,
}

impl Table {
    /// A table with rows; none, if there are no rows.
    fn new(name: &'static str, head: &[&'static str], rows: Vec<Vec<String>>) -> Option<Self> {
        (!rows.is_empty()).then(|| Self { name, head: head.to_vec(), rows })
    }
}

/// The messages about a set.
pub(super) fn messages(report: &Report) -> Vec<Table> {
    let row = |of: &Diagnostic| {
        let Place { file, line, .. } = &of.place;
        let instead = of.instead.clone().unwrap_or_default();
        vec![of.code.to_owned(), place(file, *line), of.found.clone(), instead]
    };
    let rows = report.diagnostics.iter().map(row).collect();
    Table::new("Warnings", &["code", "place", "found", "write instead"], rows).into_iter().collect()
}

/// A line of a file without its folders, which differ from machine to machine.
fn place(file: &str, line: usize) -> String {
    let name = Path::new(file).file_name().map_or_else(|| file.to_owned(), |name| name.to_string_lossy().into_owned());
    if line == 0 { name } else { format!("{name}:{line}") }
}

/// The stages of improved position control.
pub(super) fn stages(stages: &[StageRow]) -> Option<Table> {
    let row = |row: &StageRow| filled(row.cells(), StageRow::COLUMNS.len());
    Table::new("Stages", &StageRow::COLUMNS, stages.iter().map(row).collect())
}

/// A row with empty cells up to a number.
fn filled(mut cells: Vec<String>, count: usize) -> Vec<String> {
    cells.resize(count, String::new());
    cells
}

/// The margins of the loop with each drive, and its stages.
pub(super) fn margins(analysis: &Analysis) -> Vec<Table> {
    let of_drive = |of: &OfDrive| [vec![of.drive.words()], analysis::margins(of).to_vec()].concat();
    let of_stages = |of: &OfDrive| -> Vec<Vec<String>> {
        let cells = |stage| [vec![of.drive.words()], analysis::stage_cells(stage).to_vec()].concat();
        of.stages.iter().map(cells).collect()
    };
    let loops = analysis.drives.iter().map(of_drive).collect();
    let stages = analysis.drives.iter().flat_map(of_stages).collect();
    let head = [&["drive"][..], &analysis::STAGE[..5], &["verdict"]].concat();
    let loops = Table::new("Margins", &["drive", "verdict", "Ms", "gain margin", "phase margin"], loops);
    loops.into_iter().chain(Table::new("Stages in the loop", &head, stages)).collect()
}

/// The parameters that the blocks use.
pub(super) fn parameters(trace: &Trace) -> Option<Table> {
    let row = |of: &ParameterRow| {
        let given = of.given.as_ref().map_or_else(|| "default".to_owned(), |of| place(&of.file, of.line));
        let coefficients = of.coefficients.iter().map(|at| trace.coefficients[*at].path.clone());
        vec![
            of.id.unwrap_or("-").to_owned(),
            of.path.clone(),
            of.value.clone(),
            of.unit.to_owned(),
            given,
            coefficients.collect::<Vec<_>>().join(", "),
        ]
    };
    let rows = trace.parameters.iter().map(row).collect();
    Table::new("Parameters", &["id", "parameter", "value", "unit", "given", "coefficients that depend on it"], rows)
}

/// The coefficients, each with what it depends on and where it is.
pub(super) fn coefficients(trace: &Trace) -> Option<Table> {
    let mut rows = Vec::new();
    for of in &trace.coefficients {
        let parameter = |at: &usize| {
            let ParameterRow { id, path, .. } = &trace.parameters[*at];
            id.map_or_else(|| path.clone(), str::to_owned)
        };
        let mut parameters: Vec<String> = of.parameters.iter().map(parameter).collect();
        parameters.dedup();
        let lines = of.lines.iter().map(|of| {
            let lines: Vec<String> = of.lines.iter().map(usize::to_string).collect();
            format!("{}: {}", of.file, lines.join(", "))
        });
        rows.push(vec![
            of.block.to_owned(),
            of.path.clone(),
            of.value.clone(),
            of.meaning.to_owned(),
            parameters.join(", "),
            lines.collect::<Vec<_>>().join("; "),
        ]);
    }
    let head = ["block", "coefficient", "value", "meaning", "depends on", "lines of the emitted files"];
    Table::new("Coefficients", &head, rows)
}

/// The runs of a verification.
pub(super) fn verification(rows: &[Row]) -> Option<Table> {
    let row = |row: &Row| {
        let digest = row.digest.clone().unwrap_or_default();
        vec![row.block.to_owned(), row.engine.clone(), row.samples.to_string(), row.bits(), digest, row.first.clone()]
    };
    let head = ["block", "engine", "samples", "differing bits", "digest of the outputs", "first difference"];
    Table::new("Verification", &head, rows.iter().map(row).collect())
}

/// The emitted files.
pub(super) fn files(files: &[File]) -> Option<Table> {
    let row = |file: &File| vec![file.name.clone(), digest(file.text.as_bytes())];
    Table::new("Files", &["file", "digest"], files.iter().map(row).collect())
}

/// The vibrations of a recording, and the part of each that the stages leave.
pub(super) fn vibrations(results: &Results, tuning: &Tuning) -> Vec<Table> {
    let number = |value: f64| format!("{value:.4}");
    let optional = |value: Option<f64>| value.map_or_else(String::new, number);
    let rows = results.vibrations.iter().map(|of| {
        let (channel, when) = (of.channel.to_owned(), of.when.to_owned());
        vec![channel, when, number(of.hz), number(of.hz_error), optional(of.damping), number(of.amplitude)]
    });
    let head = ["channel", "when", "frequency [Hz]", "error [Hz]", "damping ratio", "amplitude"];
    let measured = Table::new("Vibrations, as recorded", &head, rows.collect());
    let predicted = tuning.proposals.first().and_then(|of| of.predicted.as_ref());
    let left = predicted.iter().flat_map(|of| tuning.chosen.iter().zip(&of.left.residuals));
    let left = left.map(|(chosen, left)| vec![number(chosen.hz), number(*left)]).collect();
    let left = Table::new("Vibrations, with the stages", &["frequency [Hz]", "part that is left"], left);
    measured.into_iter().chain(left).collect()
}
