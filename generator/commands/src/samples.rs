//! Files of samples: their mistakes as messages.

use generator::diagnostics::{Diagnostic, Place, Report};
use golden::mistake::Mistake;

/// The result of reading, or all errors, including unknown names in the map. `file`: the name in messages.
///
/// # Errors
/// The mistakes of the file.
pub fn checked<T>(read: Result<T, Vec<Mistake>>, unknown: &[Mistake], file: &str) -> Result<T, Report> {
    match read {
        Ok(read) if unknown.is_empty() => Ok(read),
        Ok(_) => Err(wrong(file, unknown)),
        Err(mistakes) => Err(wrong(file, &[&mistakes, unknown].concat())),
    }
}

/// The mistakes of a file of samples.
fn wrong(file: &str, mistakes: &[Mistake]) -> Report {
    let whole = Place::whole(file);
    let mut report = Report::default();
    for Mistake { code, line, column, found, allowed, instead } in mistakes {
        let place = Place { line: *line, column: *column, ..whole.clone() };
        let said = Diagnostic::error(code, place, found).allowed(allowed);
        report.push(if instead.is_empty() { said } else { said.instead(instead) });
    }
    report.shortened()
}
