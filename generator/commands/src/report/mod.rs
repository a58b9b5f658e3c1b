//! The command `report`: all of an axis as one page of static HTML, to print and to archive. Nothing from a file is markup.
//!
//! ```text
//! sections  the sections of an axis: their words, tables and pictures, which a page may show, too
//! tables    the tables, cell by cell
//! ```

mod sections;
mod tables;

pub use sections::{AxisSections, Request, Section, sections};
pub use tables::Table;

use askama::Template;
use generator::diagnostics::Report;
use generator::manifest;
use generator::pipeline::Set;

/// The beginning of every report.
pub const HEAD: &str = "<!DOCTYPE html>\n<!-- axgen report -->\n";

#[derive(Template)]
#[template(path = "report/report.html")]
struct Page<'a> {
    title: String,
    head: Vec<String>,
    tables: Vec<Table>,
    axes: &'a [AxisSections],
}

/// The page of a set that was read with these messages, for its axes of some names (all, if there is none).
///
/// # Errors
/// The set cannot be read again.
pub fn html(of: &Request<'_>, set: &Set, messages: &Report, axes: &[String]) -> Result<String, Report> {
    let chosen = set.axes.iter().filter(|designed| axes.is_empty() || axes.contains(&designed.axis.name));
    let axes = chosen.map(|designed| sections(of, designed)).collect::<Result<Vec<_>, _>>()?;
    let name = manifest::set_name(of.source.0);
    let names: Vec<&str> = axes.iter().map(|axis| axis.name.as_str()).collect();
    let page = Page {
        title: format!("axgen report: {name}"),
        head: vec![format!("set {name}, axgen {}", env!("CARGO_PKG_VERSION")), format!("axes: {}", names.join(", "))],
        tables: tables::messages(messages),
        axes: &axes,
    };
    Ok(page.render().expect("report: no input can keep a template from being filled") + "\n")
}
