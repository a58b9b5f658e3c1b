//! The spindle words of a block: which of them may be combined, and their commands. Nothing about axes.

use super::bracket::Bracket;
use super::mistake::{Mistakes, shown};
use super::program::{Command, Direction, Target};
use super::word::{Placed, Word};

/// The words of earlier blocks that are still in force.
#[derive(Default)]
pub(crate) struct InForce {
    /// of M3 or M4, while spindle 1 turns
    direction: Option<Direction>,
    /// of S
    rpm: Option<f64>,
}

/// Spindle 1, to which words without brackets belong.
const MAIN: u32 = 1;

/// The commands of the spindle words; stores direction and speed in force.
pub(crate) fn commands(words: &[Placed<'_>], force: &mut InForce, mistakes: &mut Mistakes) -> Vec<Command> {
    let words: Vec<&Placed<'_>> = words.iter().filter(|placed| is_spindle(&placed.word)).collect();
    if let Some(bracket) = words.iter().find_map(|placed| bracket(placed)) {
        return bracketed(&words, bracket, &mut force.direction, mistakes);
    }
    let spindle = MAIN;
    let speed = words.iter().find_map(|placed| if let Word::Speed(rpm) = placed.word { Some(rpm) } else { None });
    let Some((function, direction)) = function(&words, mistakes) else {
        refuse_angle(&words, "without `M19`", mistakes);
        force.rpm = speed.or(force.rpm);
        let turn = |(rpm, direction)| Command::Turn { spindle, direction, rpm };
        return speed.zip(force.direction).map(turn).into_iter().collect();
    };
    let angle =
        words.iter().find_map(|placed| if let Word::Angle(degrees) = placed.word { Some(degrees) } else { None });
    force.direction = if function.word == Word::Position { None } else { direction };
    if function.word == Word::Position {
        if angle.is_none() {
            mistakes.push(function.column, "`M19` without `S.POS=`", "`M19` with an angle", "`M19 S.POS=180`");
        }
        let position = |degrees| Command::Position { spindle, direction, rpm: speed, degrees };
        return angle.map(position).into_iter().collect();
    }
    force.rpm = speed.or(force.rpm);
    refuse_angle(&words, &format!("with {}", shown(function.text)), mistakes);
    let turn = |direction| Command::Turn { spindle, direction, rpm: force.rpm.unwrap_or_default() };
    vec![direction.map_or(Command::Stop { spindle }, turn)]
}

/// Whether it is one of a spindle.
fn is_spindle(word: &Word) -> bool {
    matches!(word, Word::Turn(_) | Word::Stop | Word::Position | Word::Speed(_) | Word::Angle(_) | Word::Bracket(_))
}

fn bracket<'w>(placed: &'w Placed<'_>) -> Option<&'w Bracket> {
    if let Word::Bracket(bracket) = &placed.word { Some(bracket) } else { None }
}

/// A bracket, which may not be combined with another spindle word.
fn bracketed(
    words: &[&Placed<'_>],
    first: &Bracket,
    force: &mut Option<Direction>,
    mistakes: &mut Mistakes,
) -> Vec<Command> {
    // The place is that of the bracket to be removed, or of the first one if all are brackets.
    let at = words.iter().position(|placed| bracket(placed).is_some()).unwrap_or(0);
    let other = words.iter().enumerate().find(|(other, _)| *other != at).map(|(_, placed)| placed);
    if let (Some(placed), Some(other)) = (words.get(at), other) {
        let found = format!("{} with {}", shown(placed.text), shown(other.text));
        let allowed = "a bracket as the only spindle word of its block";
        mistakes.push(placed.column, found, allowed, format!("{} in a block of its own", shown(placed.text)));
    }
    let ends = |command: &Command| {
        matches!(command, Command::Release { spindle: MAIN } | Command::Home { target: Target::Spindle(MAIN) })
    };
    if first.commands.iter().any(ends) {
        *force = None;
    }
    first.commands.clone()
}

/// The only word that commands the spindle, and the direction given with it.
fn function<'w, 't>(words: &[&'w Placed<'t>], mistakes: &mut Mistakes) -> Option<(&'w Placed<'t>, Option<Direction>)> {
    let said = |placed: &&&'w Placed<'t>| matches!(placed.word, Word::Turn(_) | Word::Stop | Word::Position);
    let functions: Vec<&'w Placed<'t>> = words.iter().filter(said).copied().collect();
    // M19 with one direction counts as one; every other additional word is one too many.
    let first = functions.iter().find(|placed| placed.word == Word::Position).or(functions.first()).copied()?;
    let mut direction = None;
    for placed in functions {
        match placed.word {
            Word::Turn(this) if direction.is_none() && matches!(first.word, Word::Position | Word::Turn(_)) => {
                direction = Some(this);
            }
            _ if std::ptr::eq(placed, first) => {}
            _ => {
                let found = format!("{} with another M word of the spindle", shown(placed.text));
                let allowed = "one of `M3`, `M4`, `M5`, `M19` in a block, or `M19` with `M3` or `M4`";
                mistakes.push(placed.column, found, allowed, format!("{} in a block of its own", shown(placed.text)));
            }
        }
    }
    Some((first, direction))
}

/// Reports every angle without `M19`; `place` is the alternative in its block.
fn refuse_angle(words: &[&Placed<'_>], place: &str, mistakes: &mut Mistakes) {
    for placed in words.iter().filter(|placed| matches!(placed.word, Word::Angle(_))) {
        let found = format!("{} {place}", shown(placed.text));
        let instead = format!("the block without {}", shown(placed.text));
        mistakes.push(placed.column, found, "`S.POS=` with `M19`", instead);
    }
}
