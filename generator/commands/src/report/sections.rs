//! The sections of an axis: words, tables and pictures. How they look is not known here.

use super::tables::{self, Table};
use crate::measure::{self, Recordings};
use crate::trace::trace;
use crate::verify::Verification;
use crate::words::made;
use generator::analysis;
use generator::blocks::{self, Designed};
use generator::config::{ListOptions, Load};
use generator::diagnostics::Report;
use generator::summary;
use generator::target::Target;
use golden::engine::Engine;
use golden::measure::picture;
use golden::svg::Picture;
use golden::tune::{self, Prefer, Stages, signals};
use serde::Serialize;
use std::path::Path;

/// What a report contains.
pub struct Request<'a> {
    /// how the set was read
    pub source: (&'a Path, &'a ListOptions, Load<'a>),
    /// the targets whose files are traced
    pub targets: &'a [Target],
    /// the engines that are verified, the reference first, and the number of samples
    pub engines: &'a [Engine],
    pub samples: usize,
    /// recordings of the only axis
    pub recordings: Option<&'a Recordings>,
}

/// An axis.
#[derive(Clone, Debug, Serialize)]
pub struct AxisSections {
    pub name: String,
    pub sections: Vec<Section>,
}

/// A section.
#[derive(Clone, Debug, Serialize)]
pub struct Section {
    pub id: &'static str,
    pub title: &'static str,
    pub lines: Vec<String>,
    pub tables: Vec<Table>,
    pub pictures: Vec<Picture>,
}

/// All sections of an axis.
///
/// # Errors
/// The set cannot be read again.
pub fn sections(of: &Request<'_>, designed: &Designed) -> Result<AxisSections, Report> {
    let blocks = made(blocks::blocks(designed));
    let trace = trace(of.source, designed, &blocks, of.targets)?;
    let tables = |tables: [Option<Table>; 2]| tables.into_iter().flatten().collect();
    let section = |id, title, tables| Section { id, title, lines: Vec::new(), tables, pictures: Vec::new() };
    let mut sections = vec![
        effect(designed),
        section("parameters", "Parameters", tables([tables::parameters(&trace), None])),
        in_loop(designed),
    ];
    sections.extend(of.recordings.map(|recordings| recorded(designed, recordings)));
    let (verified, _) = Verification::new(of.engines, &|_, _| None).blocks(designed, &blocks, of.samples);
    sections.extend([
        section("coefficients", "Coefficients", tables([tables::coefficients(&trace), None])),
        section("verification", "Verification", tables([tables::verification(&verified), tables::files(&trace.files)])),
    ]);
    Ok(AxisSections { name: designed.axis.name.clone(), sections })
}

/// The stages, and what the blocks mean for the machine: as `check` prints it.
fn effect(designed: &Designed) -> Section {
    let row = summary::details(designed);
    let tables = tables::stages(&row.stages).into_iter().collect();
    let text = row.text();
    // The table is in these lines, too.
    let table = if row.stages.is_empty() { 0 } else { row.stages.len() + 1 };
    let lines = text.lines().enumerate().filter(|(at, _)| !(1..=table).contains(at));
    let lines = lines.map(|(_, line)| line.trim_start().to_owned()).collect();
    Section { id: "effect", title: "Effect on the machine", lines, tables, pictures: Vec::new() }
}

/// The loop: as `analyze` prints and draws it.
fn in_loop(designed: &Designed) -> Section {
    let analysis = analysis::analyze(designed, &designed.axis.drive);
    let lines = analysis::outside(designed, analysis.drives.is_empty()).into_iter().collect();
    let pictures = golden::analysis::picture(designed, &analysis).into_iter().collect();
    Section { id: "loop", title: "Loop and margins", lines, tables: tables::margins(&analysis), pictures }
}

/// The recording, and what the stages of the axis leave of its vibrations.
fn recorded(designed: &Designed, recordings: &Recordings) -> Section {
    let own = &recordings.own.1;
    let tuning = tune::tune(designed, own, recordings.second(), Prefer::Excited, Stages::Given);
    let stages = tuning.proposals.first().map(|of| of.stages.clone()).unwrap_or_default();
    let with = own.record.as_ref().and_then(|record| signals::with_stages(&tuning, record, &stages));
    let predicted = with.and_then(|with| signals::picture(own, &with, Vec::new()));
    let verdicts = recordings.measured().flat_map(|of| &of.verdicts).chain(&tuning.verdicts);
    Section {
        id: "recording",
        title: "Recording",
        lines: verdicts.map(|of| format!("{}: {}; {}", of.code, of.found, of.instead)).collect(),
        tables: tables::vibrations(&measure::results(recordings), &tuning),
        pictures: predicted.or_else(|| picture::of(own, recordings.response())).into_iter().collect(),
    }
}
