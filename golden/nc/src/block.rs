//! The words of one block, which make its commands: what holds for all of them, and what stays in force behind it. Not the rules of
//! spindles or of axes alone.

use super::mistake::{Mistakes, shown};
use super::program::{Command, Direction};
use super::word::{Function, Placed, Word};
use super::{axes, spindle};

/// What words of earlier blocks still say.
#[derive(Default)]
pub(crate) struct InForce {
    /// of M3 or M4, while spindle 1 turns
    direction: Option<Direction>,
    /// of F, in mm/min
    feed: Option<f64>,
}

/// The commands of a block, whose number is taken off.
pub(crate) fn commands(words: Vec<Placed<'_>>, force: &mut InForce, mistakes: &mut Mistakes) -> Vec<Command> {
    let words = once(words, mistakes);
    alone(&words, &Word::End, |_| false, "nothing but a block number beside `M30`", mistakes);
    let dwell = Word::Function(Function::Dwell);
    let time = |word: &Word<'_>| matches!(word, Word::Axis(..) | Word::Function(_));
    alone(&words, &dwell, time, "nothing but its time and a block number beside `G04`", mistakes);
    let mut commands = spindle::commands(&words, &mut force.direction, mistakes);
    commands.extend(axes::commands(&words, &mut force.feed, mistakes));
    if words.iter().any(|placed| placed.word == Word::End) {
        commands.push(Command::End);
    }
    commands
}

/// Each word once: the second one of a letter or of a function is a mistake, and is left out.
fn once<'t>(words: Vec<Placed<'t>>, mistakes: &mut Mistakes) -> Vec<Placed<'t>> {
    let mut kept: Vec<Placed<'t>> = Vec::new();
    for placed in words {
        match kept.iter().find(|other| same(&other.word, &placed.word)) {
            Some(first) => {
                let found = format!("{} after {} in one block", shown(placed.text), shown(first.text));
                let instead = format!("one of them, or {} in a block of its own", shown(placed.text));
                mistakes.push(placed.column, found, "each word once in a block", instead);
            }
            None => kept.push(placed),
        }
    }
    kept
}

/// Whether two words say the same thing, each its own way.
fn same(one: &Word<'_>, other: &Word<'_>) -> bool {
    match (one, other) {
        (Word::Function(one), Word::Function(other)) => one == other,
        (Word::Turn(one), Word::Turn(other)) => one == other,
        (Word::Axis(one, _), Word::Axis(other, _)) => one == other,
        (Word::Bracket(one), Word::Bracket(other)) => one.spindle == other.spindle,
        _ => std::mem::discriminant(one) == std::mem::discriminant(other),
    }
}

/// Says which word stands beside one that suffers none but some, which have rules of their own.
fn alone(
    words: &[Placed<'_>],
    one: &Word<'_>,
    some: impl Fn(&Word<'_>) -> bool,
    allowed: &str,
    mistakes: &mut Mistakes,
) {
    let Some(lonely) = words.iter().find(|placed| placed.word == *one) else { return };
    if let Some(other) = words.iter().find(|placed| placed.word != *one && !some(&placed.word)) {
        let found = format!("{} beside {}", shown(other.text), shown(lonely.text));
        mistakes.push(other.column, found, allowed, format!("{} in a block of its own", shown(lonely.text)));
    }
}
