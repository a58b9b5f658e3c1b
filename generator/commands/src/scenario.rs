//! The command `scenario`: an NC program on an axis: the block that runs it, its messages, and the table of its times.

use crate::refused;
use crate::words::counted;
use generator::blocks::{self, Block, Designed};
use generator::codes;
use generator::diagnostics::{Diagnostic, Place, Report};
use golden::scenario::{self, Mistake, Note, Options, Scenario};

/// The block of a scenario.
///
/// # Errors
/// The axis has no such block, or none that a program can run.
pub fn block(designed: &Designed, name: Option<&str>) -> Result<Block, Report> {
    let names = blocks::names(&designed.axis);
    match name.or(scenario::usual_block(&names)) {
        Some(name) => crate::block(designed, name),
        None => Err(refused::no_such("--axis", "block", &designed.axis.name, &names)),
    }
}

/// The scenario of a program on an axis, and warnings about parts of the program that do not act as written. `file`: the
/// program's name in messages.
///
/// # Errors
/// The mistakes of the program.
pub fn run(
    (file, program): (&str, Vec<u8>),
    designed: &Designed,
    block: &Block,
    options: &Options,
) -> Result<(Scenario, Report), Report> {
    // Comments of programs contain umlauts in the encodings of old systems: then each byte is a character of Latin-1.
    let text =
        String::from_utf8(program).unwrap_or_else(|error| error.as_bytes().iter().copied().map(char::from).collect());
    let place = |line, column| Place { line, column, ..Place::whole(file) };
    let scenario = scenario::run(&text, designed, block, options).map_err(|mistakes| {
        let said = mistakes.into_iter().map(|Mistake { line, column, found, allowed, instead }| {
            Diagnostic::error(codes::NC_PROGRAM, place(line, column), found).allowed(allowed).instead(instead)
        });
        Report { diagnostics: said.collect() }
    })?;
    let said = scenario.notes.iter().map(|Note { code, line, column, found, instead }| {
        let said = Diagnostic::warning(code, place(*line, *column), found.as_str());
        if instead.is_empty() { said } else { said.instead(instead.as_str()) }
    });
    let report = Report { diagnostics: said.collect() };
    Ok((scenario, report))
}

/// A table of the times of the program's blocks.
#[must_use]
pub fn table(scenario: &Scenario, designed: &Designed, block: &Block) -> String {
    let time = |sample: usize| sample as f64 * designed.axis.cycle_time();
    let samples = scenario.inputs.len();
    let mut text = format!(
        "axis {}, block {}: {}, {:.3} s\n{:>6}  {:<6} {:>10} {:>10}\n",
        designed.axis.name,
        block.program.block,
        counted(samples, "sample"),
        time(samples),
        "line",
        "block",
        "from [s]",
        "to [s]"
    );
    for step in &scenario.steps {
        let number = step.number.map_or_else(String::new, |number| format!("N{number}"));
        text += &format!("{:>6}  {number:<6} {:>10.3} {:>10.3}\n", step.line, time(step.from), time(step.to));
    }
    text
}
