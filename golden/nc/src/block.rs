//! The words of one block and their commands: the common rules, and the words that stay in force. Not the rules of spindles
//! or of axes.

use super::foreign::Foreign;
use super::mistake::{Mistakes, shown};
use super::passed::PassedKind;
use super::program::Command;
use super::word::{Function, Parameters, Placed, Word};
use super::{axes, spindle};

/// The words of earlier blocks that are still in force.
#[derive(Default)]
pub(crate) struct InForce {
    pub(crate) spindle: spindle::InForce,
    pub(crate) axes: axes::InForce,
}

/// The commands of a block, without its number.
pub(crate) fn commands(words: Vec<Placed<'_>>, force: &mut InForce, mistakes: &mut Mistakes) -> Vec<Command> {
    note_passed(&words, mistakes);
    let words = once(parameters(words, mistakes), mistakes);
    let mut commands = spindle::commands(&words, &mut force.spindle, mistakes);
    commands.extend(axes::commands(&words, &mut force.axes, mistakes));
    if words.iter().any(|placed| placed.word == Word::End) {
        commands.push(Command::End);
    }
    commands
}

/// Notes the skipped words.
fn note_passed(words: &[Placed<'_>], mistakes: &mut Mistakes) {
    for Placed { column, text, word } in words {
        match word {
            Word::Passed(kind, _) => mistakes.pass(*kind, *column, &spelt(*kind, text)),
            Word::Skip => mistakes.pass(PassedKind::Skip, *column, ""),
            _ => {}
        }
    }
}

/// A word as a note has it: numbers of programs and of tools, and texts, are the word's letter.
fn spelt(kind: PassedKind, text: &str) -> String {
    let end = match (kind, text.chars().next()) {
        (_, Some('T' | 't' | 'D' | 'd' | 'H' | 'h' | 'O' | 'o' | ':')) => 1,
        (_, Some('#')) => {
            text.find(|letter: char| letter != '#' && !letter.is_ascii_alphanumeric()).unwrap_or(text.len())
        }
        _ => text.len(),
    };
    text[..end].to_ascii_uppercase()
}

/// Removes the words that belong to a skipped word. Without one, words with these letters are not read.
fn parameters<'t>(words: Vec<Placed<'t>>, mistakes: &mut Mistakes) -> Vec<Placed<'t>> {
    let has = |these: &[Parameters]| {
        words.iter().any(|placed| matches!(&placed.word, Word::Passed(_, of) if these.contains(of)))
    };
    let has_letters = has(&[Parameters::Letters, Parameters::All]);
    let is_other = |placed: &Placed<'_>| matches!(placed.word, Word::Function(_) | Word::Turn(_));
    let has_all = has(&[Parameters::All]) && !words.iter().any(is_other);
    let function = |wanted| words.iter().any(|placed| placed.word == Word::Function(wanted));
    let (is_dwell, is_machine) = (function(Function::Dwell), function(Function::MachinePosition));
    let mut keep = |placed: &Placed<'t>| match placed.word {
        Word::Parameter { letter: 'I' | 'J' | 'K', .. } => {
            mistakes.foreign(placed.column, placed.text, Foreign::Arc);
            false
        }
        Word::Parameter { letter: 'P', .. } if is_dwell => true,
        Word::Parameter { .. } if has_letters || is_machine => false,
        Word::Parameter { .. } => {
            mistakes.foreign(placed.column, placed.text, Foreign::Parameter);
            false
        }
        Word::Speed(_) | Word::Feed(_) | Word::Axis(..) => !has_all,
        Word::Passed(..) | Word::Skip => false,
        _ => true,
    };
    let kept: Vec<bool> = words.iter().map(&mut keep).collect();
    words.into_iter().zip(kept).filter(|(_, kept)| *kept).map(|(placed, _)| placed).collect()
}

/// Each word once: the second one of a letter or of a function is an error, and is left out.
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

/// Whether two words have the same meaning in different forms.
fn same(one: &Word, other: &Word) -> bool {
    match (one, other) {
        (Word::Function(one), Word::Function(other)) => one == other,
        (Word::Modal(one), Word::Modal(other)) => one == other,
        (Word::Turn(one), Word::Turn(other)) => one == other,
        (Word::Axis(one, _), Word::Axis(other, _)) => one == other,
        (Word::Bracket(one), Word::Bracket(other)) => one.spindle == other.spindle,
        _ => std::mem::discriminant(one) == std::mem::discriminant(other),
    }
}
