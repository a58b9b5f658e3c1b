//! Words that several commands use.

use compiler::pass::Defect;

/// `1 file`, `2 files`.
pub fn counted(count: impl std::fmt::Display, what: &str) -> String {
    let count = count.to_string();
    let plural = if count == "1" { "" } else { "s" };
    format!("{count} {what}{plural}")
}

/// The result of a step that no input can make fail.
///
/// # Panics
/// If it has failed: that is a defect of axgen.
pub fn made<T>(result: Result<T, Defect>) -> T {
    result.unwrap_or_else(|defect| panic!("a defect of axgen: {defect}"))
}
