//! The time of a dwell: the words of its block with the time, and their units. Nothing about motion.

use super::mistake::{Mistakes, shown};
use super::passed::PassedKind;
use super::program::Command;
use super::word::{Placed, Word};

const TIME: &str = "`G04` with one time: `X` or `F` and seconds, or `P`, no less than 0";

/// The time is in X, U or F in s, or in P: in seconds if it has a point, else in milliseconds from 100 on.
pub(crate) fn commands(placed: &Placed<'_>, words: &[Placed<'_>], mistakes: &mut Mistakes) -> Option<Command> {
    let mut times = Vec::new();
    for word in words {
        match time(word, placed, mistakes) {
            Some(seconds) if seconds >= 0.0 && times.is_empty() => times.push(seconds),
            Some(_) => wrong(word, placed, mistakes),
            None if matches!(word.word, Word::Axis(..)) => wrong(word, placed, mistakes),
            None => {}
        }
    }
    if times.is_empty() && !words.iter().any(|word| matches!(word.word, Word::Axis(..))) {
        mistakes.push(
            placed.column,
            format!("{} without its time", shown(placed.text)),
            TIME,
            "a block like `G04 X2.5`",
        );
    }
    times.first().map(|seconds| Command::Dwell { seconds: *seconds })
}

fn wrong(other: &Placed<'_>, dwell: &Placed<'_>, mistakes: &mut Mistakes) {
    let found = format!("{} with {}", shown(other.text), shown(dwell.text));
    mistakes.push(other.column, found, TIME, "a block like `G04 X2.5`");
}

/// The time of a word of a dwell [s].
fn time(word: &Placed<'_>, dwell: &Placed<'_>, mistakes: &mut Mistakes) -> Option<f64> {
    /// The limit between both units: a longer time in s, or a shorter one in ms, is unusual.
    const MILLISECONDS: f64 = 100.0;
    match word.word {
        Word::Axis(axis, seconds) if ["X", "U"].contains(&axis.to_string().as_str()) => Some(seconds),
        Word::Feed(seconds) => Some(seconds),
        Word::Parameter { value, is_integer, .. } => {
            if is_integer {
                let text = format!("{} {}", dwell.text, word.text).to_ascii_uppercase();
                mistakes.pass(PassedKind::DwellUnit, word.column, &text);
            }
            Some(if is_integer && value >= MILLISECONDS { value / 1000.0 } else { value })
        }
        _ => None,
    }
}

/// `#TIME`, which stands alone.
pub(crate) fn waits(placed: &Placed<'_>, seconds: f64, words: &[Placed<'_>], mistakes: &mut Mistakes) -> Vec<Command> {
    if let Some(other) = words.iter().find(|other| !std::ptr::eq(*other, placed)) {
        let found = format!("{} with {}", shown(other.text), shown(placed.text));
        mistakes.push(other.column, found, "`#TIME` alone in its block", "`#TIME` in a block of its own");
    }
    vec![Command::Dwell { seconds }]
}
