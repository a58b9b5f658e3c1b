//! The effects of the parameters of an axis by their names, and the differences between those of two versions of an axis, in words.

use crate::number::{pair, significant};
use portable::Extreme;

/// A number with its unit, or words.
pub enum Effect {
    Number(f64, &'static str),
    Words(String),
}

/// Effects by their names.
pub(crate) type Effects = Vec<(String, Effect)>;

/// The effects of a part of an axis, as far as it has them.
pub(crate) fn of_part(part: &str, effects: impl IntoIterator<Item = (&'static str, Option<Effect>)>) -> Effects {
    effects.into_iter().filter_map(|(what, effect)| Some((format!("{part}: {what}"), effect?))).collect()
}

/// A line for each effect that differs.
pub(crate) fn differences(old: &Effects, new: &Effects) -> Vec<String> {
    let kept = old.iter().filter_map(|(what, effect)| match of_name(new, what) {
        Some(other) => effect.difference(other).map(|difference| format!("{what} {difference}")),
        None => Some(format!("{what} {} -> none", effect.text())),
    });
    let added = new.iter().filter(|(what, _)| of_name(old, what).is_none());
    kept.chain(added.map(|(what, effect)| format!("{what} none -> {}", effect.text()))).collect()
}

/// What differs between two axes, in words: `feedforward: weight 50 %, and 100 %`.
pub(crate) fn differing(one: &Effects, other: &Effects) -> Vec<String> {
    let text = |of: &Effects, what: &str| of_name(of, what).map_or("none".to_owned(), Effect::text);
    let of_other = other.iter().filter(|(what, _)| of_name(one, what).is_none());
    let all = one.iter().chain(of_other).map(|(what, _)| what.as_str());
    let both = all.map(|what| (what, text(one, what), text(other, what))).filter(|(_, one, other)| one != other);
    both.map(|(what, one, other)| format!("{what} {one}, and {other}")).collect()
}

fn of_name<'e>(effects: &'e Effects, what: &str) -> Option<&'e Effect> {
    effects.iter().find(|(name, _)| name == what).map(|(_, effect)| effect)
}

/// A line for each effect.
pub(crate) fn added(effects: &Effects) -> Vec<String> {
    effects.iter().map(|(what, effect)| format!("{what} {}", effect.text())).collect()
}

/// Whether two values differ only in their last digits.
pub(crate) fn is_same(old: f64, new: f64) -> bool {
    (old - new).abs() <= 1e-12 * old.abs().larger(new.abs())
}

impl Effect {
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
