//! Messages on standard error: for readers with the line and a mark, for programs as JSON, one object per line.

use clap::ValueEnum;
use commands::messages;
use generator::config::{self, LARGEST_SAMPLES};
use generator::diagnostics::Report;

/// What messages look like.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum Format {
    /// with the line of the file and a mark
    Human,
    /// a JSON object on a line of its own
    Json,
}

/// The text of all messages.
pub fn text(report: &Report, format: Format) -> String {
    let again = |file: &str| config::load_up_to(file.as_ref(), LARGEST_SAMPLES).ok();
    match format {
        Format::Human => messages::text(report, &again),
        Format::Json => messages::data(report, &again).iter().map(commands::json::line).collect(),
    }
}
