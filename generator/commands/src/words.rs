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

/// The units of a time, each with its size [s].
pub const TIMES: [(&str, f64); 4] = [("ms", 1e-3), ("us", 1e-6), ("ns", 1e-9), ("s", 1.0)];

/// A time of an option [s]: a number and one of these units, each with its size [s]. A unit that ends like another one comes
/// first.
pub fn seconds(text: &str, units: &[(&str, f64)]) -> Option<f64> {
    let (number, size) = units.iter().find_map(|(unit, size)| Some((text.strip_suffix(unit)?, size)))?;
    number.trim().parse::<f64>().ok().map(|number| number * size)
}
