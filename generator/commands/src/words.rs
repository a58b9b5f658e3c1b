//! Words that several commands use.

use std::fmt::Display;

/// `1 file`, `2 files`.
pub fn counted(count: impl Display, what: &str) -> String {
    let count = count.to_string();
    let plural = if count == "1" { "" } else { "s" };
    format!("{count} {what}{plural}")
}

/// The result of a step that no input can make fail.
///
/// # Panics
/// If it has failed: that is a defect of axgen.
pub fn made<T>(result: Result<T, impl Display>) -> T {
    result.unwrap_or_else(|defect| panic!("a defect of axgen: {defect}"))
}
