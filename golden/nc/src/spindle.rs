//! The spindle words of a block: what they may be beside each other, and the commands that they are. Nothing of axes.

use super::bracket::Bracket;
use super::mistake::{Mistakes, shown};
use super::program::{Command, Direction, Target};
use super::word::{Placed, Word};

/// Spindle 1, of which words without brackets are.
const MAIN: u32 = 1;

/// The commands of the spindle words; keeps the direction in force.
pub(crate) fn commands(words: &[Placed<'_>], force: &mut Option<Direction>, mistakes: &mut Mistakes) -> Vec<Command> {
    let words: Vec<&Placed<'_>> = words.iter().filter(|placed| is_spindle(&placed.word)).collect();
    if let Some(bracket) = words.iter().find_map(|placed| bracket(placed)) {
        return bracketed(&words, bracket, force, mistakes);
    }
    let spindle = MAIN;
    let Some((function, direction)) = function(&words, mistakes) else {
        return speed_alone(&words, *force, mistakes);
    };
    let speed = words.iter().find_map(|placed| if let Word::Speed(rpm) = placed.word { Some(rpm) } else { None });
    let angle =
        words.iter().find_map(|placed| if let Word::Angle(degrees) = placed.word { Some(degrees) } else { None });
    *force = if function.word == Word::Position { None } else { direction };
    match function.word {
        Word::Position => {
            if angle.is_none() {
                mistakes.push(function.column, "`M19` without `S.POS=`", "`M19` with an angle", "`M19 S.POS=180`");
            }
            angle.map(|degrees| Command::Position { spindle, direction, rpm: speed, degrees })
        }
        Word::Stop => {
            refuse(
                &words,
                |word| matches!(word, Word::Speed(_)),
                "`M5`",
                "a speed beside `M3`, `M4`, `M19`, or alone",
                mistakes,
            );
            refuse_angle(&words, "`M5`", mistakes);
            Some(Command::Stop { spindle })
        }
        _ => {
            refuse_angle(&words, &shown(function.text), mistakes);
            if speed.is_none() {
                let found = format!("{} without an S word", shown(function.text));
                mistakes.push(
                    function.column,
                    found,
                    "`M3` and `M4` with a speed",
                    format!("`{} S1000`", function.text),
                );
            }
            direction.zip(speed).map(|(direction, rpm)| Command::Turn { spindle, direction, rpm })
        }
    }
    .into_iter()
    .collect()
}

/// Whether it is one of a spindle.
fn is_spindle(word: &Word<'_>) -> bool {
    matches!(word, Word::Turn(_) | Word::Stop | Word::Position | Word::Speed(_) | Word::Angle(_) | Word::Bracket(_))
}

fn bracket<'w>(placed: &'w Placed<'_>) -> Option<&'w Bracket> {
    if let Word::Bracket(bracket) = &placed.word { Some(bracket) } else { None }
}

/// A bracket, which stands without another spindle word.
fn bracketed(
    words: &[&Placed<'_>],
    first: &Bracket,
    force: &mut Option<Direction>,
    mistakes: &mut Mistakes,
) -> Vec<Command> {
    // The place is the bracket's that has to go, or of the first one if all are brackets.
    let at = words.iter().position(|placed| bracket(placed).is_some()).unwrap_or(0);
    let other = words.iter().enumerate().find(|(other, _)| *other != at).map(|(_, placed)| placed);
    if let (Some(placed), Some(other)) = (words.get(at), other) {
        let found = format!("{} beside {}", shown(placed.text), shown(other.text));
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

/// The one word that says what the spindle does, and the direction beside it.
fn function<'w, 't>(words: &[&'w Placed<'t>], mistakes: &mut Mistakes) -> Option<(&'w Placed<'t>, Option<Direction>)> {
    let said = |placed: &&&'w Placed<'t>| matches!(placed.word, Word::Turn(_) | Word::Stop | Word::Position);
    let functions: Vec<&'w Placed<'t>> = words.iter().filter(said).copied().collect();
    // M19 with one direction is one; whatever else stands beside the first is one too many.
    let first = functions.iter().find(|placed| placed.word == Word::Position).or(functions.first()).copied()?;
    let mut direction = None;
    for placed in functions {
        match placed.word {
            Word::Turn(this) if direction.is_none() && matches!(first.word, Word::Position | Word::Turn(_)) => {
                direction = Some(this);
            }
            _ if std::ptr::eq(placed, first) => {}
            _ => {
                let found = format!("{} beside another M word of the spindle", shown(placed.text));
                let allowed = "one of `M3`, `M4`, `M5`, `M19` in a block, or `M19` with `M3` or `M4`";
                mistakes.push(placed.column, found, allowed, format!("{} in a block of its own", shown(placed.text)));
            }
        }
    }
    Some((first, direction))
}

/// An S word without an M word: another speed in the direction in force.
fn speed_alone(words: &[&Placed<'_>], force: Option<Direction>, mistakes: &mut Mistakes) -> Vec<Command> {
    refuse_angle(words, "no `M19`", mistakes);
    let mut commands = Vec::new();
    for placed in words {
        if let Word::Speed(rpm) = placed.word {
            if let Some(direction) = force {
                commands.push(Command::Turn { spindle: MAIN, direction, rpm });
            } else {
                let found = format!("{} while the spindle does not turn", shown(placed.text));
                let allowed = "an S word alone only after `M3` or `M4`";
                mistakes.push(placed.column, found, allowed, format!("`M3 {}` or `M4 {}`", placed.text, placed.text));
            }
        }
    }
    commands
}

fn refuse_angle(words: &[&Placed<'_>], beside: &str, mistakes: &mut Mistakes) {
    refuse(words, |word| matches!(word, Word::Angle(_)), beside, "`S.POS=` beside `M19`", mistakes);
}

/// Says of each such word that it stands beside the wrong one.
fn refuse(
    words: &[&Placed<'_>],
    wrong: impl Fn(&Word<'_>) -> bool,
    beside: &str,
    allowed: &str,
    mistakes: &mut Mistakes,
) {
    for placed in words.iter().filter(|placed| wrong(&placed.word)) {
        let found = format!("{} beside {beside}", shown(placed.text));
        mistakes.push(placed.column, found, allowed, format!("the block without {}", shown(placed.text)));
    }
}
