//! Data as JSON, with the keys in alphabetical order.

use serde::Serialize;

/// The text, in several lines. A number that is not finite is `null`.
///
/// # Panics
/// If the data are not JSON, which no data of this crate are.
pub fn text(data: &impl Serialize) -> String {
    let value = serde_json::to_value(data).expect("json: keys are texts");
    format!("{value:#}")
}

/// The same on one line, with its end.
///
/// # Panics
/// As [`text`].
pub fn line(data: &impl Serialize) -> String {
    let value = serde_json::to_value(data).expect("json: keys are texts");
    format!("{value}\n")
}
