//! Named values of two versions of an axis beside each other: what differs, in words.

use crate::number::{pair, significant};

/// A value with its unit, or words.
pub(crate) enum Value {
    /// a number and its unit
    Number(f64, &'static str),
    /// words
    Words(String),
}

/// Values by their names.
pub(crate) type Values = Vec<(String, Value)>;

/// A line for each value that differs.
pub(crate) fn differences(old: &Values, new: &Values) -> Vec<String> {
    let mut differences = Vec::new();
    for (what, value) in old {
        let other = new.iter().find(|(name, _)| name == what).map(|(_, value)| value);
        match other {
            Some(other) if value.is_same(other) => {}
            Some(other) => differences.push(format!("{what} {}", value.to(other))),
            None => differences.push(format!("{what} {} -> none", value.text())),
        }
    }
    for (what, value) in new.iter().filter(|(what, _)| old.iter().all(|(name, _)| name != what)) {
        differences.push(format!("{what} none -> {}", value.text()));
    }
    differences
}

/// A line for each value.
pub(crate) fn description(values: &Values) -> Vec<String> {
    values.iter().map(|(what, value)| format!("{what} {}", value.text())).collect()
}

/// Whether two values are the same but for their last digits.
pub(crate) fn is_same(old: f64, new: f64) -> bool {
    (old - new).abs() <= 1e-12 * old.abs().max(new.abs())
}

impl Value {
    fn text(&self) -> String {
        match self {
            Self::Number(value, unit) => format!("{}{unit}", significant(*value, 7)),
            Self::Words(words) => words.clone(),
        }
    }

    fn is_same(&self, other: &Self) -> bool {
        match (self, other) {
            (Self::Number(a, _), Self::Number(b, _)) => is_same(*a, *b),
            _ => self.text() == other.text(),
        }
    }

    fn to(&self, other: &Self) -> String {
        match (self, other) {
            (Self::Number(a, unit), Self::Number(b, _)) => format!("{}{unit}", pair(*a, *b, 7)),
            _ => format!("{} -> {}", self.text(), other.text()),
        }
    }
}
