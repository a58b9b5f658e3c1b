//! A measured frequency response in many spellings, what is said about defective ones, and what its uncertainty is; files are in memory.

mod defects;
mod doubtful;
mod errors;
mod hostile;
mod names;
mod plant;
mod sinumerik;
mod spellings;

use generator::diagnostics::Report;
pub(crate) use spellings::DEMONSTRATION as DEMONSTRATION_PLANT;

use generator::response_file::{Band, From, Measured, read};

const CYCLE_TIME: f64 = 1e-3;
const COMMAND: From = From::Command { delay: 0.0 };
/// Two stages as they are usual.
const BANDS: [Band; 2] = [Band { stage: 0, f0: 53.0, width: 5.3 }, Band { stage: 1, f0: 11.0, width: 5.5 }];

fn read_text(text: &str) -> Result<Measured, Report> {
    read("p.csv", text.as_bytes(), COMMAND, CYCLE_TIME, &BANDS)
}

/// What is said about a file that may be used or not.
fn said(text: &str, from: From) -> String {
    match read("p.csv", text.as_bytes(), from, CYCLE_TIME, &BANDS) {
        Ok(measured) => measured.said.to_string(),
        Err(report) => {
            assert!(report.has_errors(), "refused without an error: {report}");
            report.to_string()
        }
    }
}

/// A table with `;` of these names; each line is made of a frequency.
fn table(names: &str, hz: &[f64], line: impl Fn(f64) -> String) -> String {
    let lines = hz.iter().map(|hz| format!("{hz};{}\n", line(*hz)));
    format!("{names}\n{}", lines.collect::<String>())
}
