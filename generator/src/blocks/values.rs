//! The differences between named values of two versions of an axis, in words.

use crate::number::{pair, significant};
use portable::Extreme;

/// A number with its unit, or words.
pub enum Value {
    Number(f64, &'static str),
    Words(String),
}

/// Values by their names.
pub(crate) type Values = Vec<(String, Value)>;

/// The values of a part of an axis, as far as it has them.
pub(crate) fn of_part(part: &str, values: impl IntoIterator<Item = (&'static str, Option<Value>)>) -> Values {
    values.into_iter().filter_map(|(what, value)| Some((format!("{part}: {what}"), value?))).collect()
}

/// A line for each value that differs.
pub(crate) fn differences(old: &Values, new: &Values) -> Vec<String> {
    let kept = old.iter().filter_map(|(what, value)| match of_name(new, what) {
        Some(other) => value.difference(other).map(|difference| format!("{what} {difference}")),
        None => Some(format!("{what} {} -> none", value.text())),
    });
    let added = new.iter().filter(|(what, _)| of_name(old, what).is_none());
    kept.chain(added.map(|(what, value)| format!("{what} none -> {}", value.text()))).collect()
}

fn of_name<'v>(values: &'v Values, what: &str) -> Option<&'v Value> {
    values.iter().find(|(name, _)| name == what).map(|(_, value)| value)
}

/// A line for each value.
pub(crate) fn description(values: &Values) -> Vec<String> {
    values.iter().map(|(what, value)| format!("{what} {}", value.text())).collect()
}

/// Whether two values differ only in their last digits.
pub(crate) fn is_same(old: f64, new: f64) -> bool {
    (old - new).abs() <= 1e-12 * old.abs().larger(new.abs())
}

impl Value {
    fn text(&self) -> String {
        match self {
            Self::Number(value, unit) => format!("{}{unit}", significant(*value, 7)),
            Self::Words(words) => words.clone(),
        }
    }

    /// `old -> new`; `None` if they are equal.
    fn difference(&self, new: &Self) -> Option<String> {
        match (self, new) {
            (Self::Number(old, unit), Self::Number(new, _)) => {
                (!is_same(*old, *new)).then(|| format!("{}{unit}", pair(*old, *new, 7)))
            }
            _ => {
                let [old, new] = [self.text(), new.text()];
                (old != new).then(|| format!("{old} -> {new}"))
            }
        }
    }
}
