//! The G words of a block with their axes and feed: what they may be beside each other, and the commands that they are. Nothing of spindles.

use super::mistake::{Mistakes, shown};
use super::number::{INTEGER, decimal, integer};
use super::program::{Axis, Command, Target};
use super::word::{Function, Placed, Word};

/// An axis word: where it stands, its axis, its number.
struct Position<'w, 't> {
    placed: &'w Placed<'t>,
    axis: Axis,
    number: &'t str,
}

/// The commands of the G words; keeps the feed in force.
pub(crate) fn commands(words: &[Placed<'_>], force: &mut Option<f64>, mistakes: &mut Mistakes) -> Vec<Command> {
    let axes: Vec<Position<'_, '_>> = words.iter().filter_map(position).collect();
    for placed in words {
        if let Word::Feed(feed) = placed.word {
            *force = Some(feed);
        }
    }
    let Some(functions) = functions(words, mistakes) else { return Vec::new() };
    feed(words, &functions, mistakes);
    if functions.iter().all(|(_, function)| matches!(function, Function::FeedforwardOn | Function::FeedforwardOff)) {
        needless(&axes, mistakes);
    }
    functions.iter().flat_map(|(placed, function)| one(placed, *function, &axes, *force, mistakes)).collect()
}

/// The commands of a G word.
fn one(
    placed: &Placed<'_>,
    function: Function,
    axes: &[Position<'_, '_>],
    feed: Option<f64>,
    mistakes: &mut Mistakes,
) -> Vec<Command> {
    let target = Target::Axes;
    let (commands, example) = match function {
        Function::FeedforwardOn => return vec![Command::Feedforward { target, on: true }],
        Function::FeedforwardOff => return vec![Command::Feedforward { target, on: false }],
        Function::Dwell => return dwell(placed, axes, mistakes),
        Function::Percentage => (percentages(axes, mistakes), "`G136 X80`"),
        Function::Home => (homes(axes, mistakes), "`G74 X1`, or `S[G74]` for a spindle"),
        Function::Rapid => (vec![Command::Move { rapid: true, axes: positions(axes), feed_mm_min: None }], "`G00 X10`"),
        Function::Linear => {
            if feed.is_none() {
                let allowed = "F in this block or in one before it";
                mistakes.push(placed.column, "`G01` without a feed", allowed, "`F` and a feed in mm/min");
            }
            (vec![Command::Move { rapid: false, axes: positions(axes), feed_mm_min: feed }], "`G01 X10 F600`")
        }
    };
    if axes.is_empty() {
        let found = format!("{} without an axis", shown(placed.text));
        mistakes.push(placed.column, found, "a word X, Y or Z beside it", format!("a block like {example}"));
    }
    commands
}

fn position<'w, 't>(placed: &'w Placed<'t>) -> Option<Position<'w, 't>> {
    if let Word::Axis(axis, number) = placed.word { Some(Position { placed, axis, number }) } else { None }
}

/// The G words that go together: one, or G135 and G136, in this order; `None`: others are there, which is said.
fn functions<'w, 't>(words: &'w [Placed<'t>], mistakes: &mut Mistakes) -> Option<Vec<(&'w Placed<'t>, Function)>> {
    let function = |placed: &'w Placed<'t>| match placed.word {
        Word::Function(function) => Some((placed, function)),
        _ => None,
    };
    let mut all: Vec<(&Placed<'t>, Function)> = words.iter().filter_map(function).collect();
    let pair = [Function::FeedforwardOn, Function::Percentage];
    let mut good = true;
    for (at, (placed, function)) in all.iter().enumerate() {
        let apart = |(_, other): &&(&Placed<'t>, Function)| !(pair.contains(other) && pair.contains(function));
        if let Some((other, _)) = all[..at].iter().find(apart) {
            let found = format!("{} beside {}", shown(placed.text), shown(other.text));
            let allowed = "one G word in a block, or `G135` with `G136`";
            mistakes.push(placed.column, found, allowed, format!("{} in a block of its own", shown(placed.text)));
            good = false;
        }
    }
    all.sort_by_key(|(_, function)| *function == Function::Percentage);
    good.then_some(all)
}

/// F belongs to G01. Beside G04, which stands alone, it is a mistake already.
fn feed(words: &[Placed<'_>], functions: &[(&Placed<'_>, Function)], mistakes: &mut Mistakes) {
    let taken = |(_, function): &(&Placed<'_>, Function)| matches!(function, Function::Linear | Function::Dwell);
    let feed = words.iter().find(|placed| matches!(placed.word, Word::Feed(_)));
    if let Some(feed) = feed.filter(|_| !functions.iter().any(taken)) {
        let found = format!("{} without `G01`", shown(feed.text));
        mistakes.push(feed.column, found, "F beside `G01`", "`G01` and axes, or no F");
    }
}

/// Axis words that belong to no G word: one message for the block.
fn needless(axes: &[Position<'_, '_>], mistakes: &mut Mistakes) {
    if let Some(Position { placed, .. }) = axes.first() {
        let found = format!("{} without its G word", shown(placed.text));
        let allowed = "axes beside `G00`, `G01`, `G04`, `G74` or `G136` of the same block";
        mistakes.push(placed.column, found, allowed, format!("the G word before it, as in `G00 {}`", placed.text));
    }
}

fn percentages(axes: &[Position<'_, '_>], mistakes: &mut Mistakes) -> Vec<Command> {
    let mut commands = Vec::new();
    for Position { placed, axis, number } in axes {
        match integer(number) {
            Some(percent) => commands.push(Command::Percentage { target: Target::Axis(*axis), percent }),
            None => {
                let found = format!("{} beside `G136`", shown(placed.text));
                mistakes.push(placed.column, found, INTEGER, format!("`{axis}` and such a number"));
            }
        }
    }
    commands
}

fn homes(axes: &[Position<'_, '_>], mistakes: &mut Mistakes) -> Vec<Command> {
    for Position { placed, axis, number } in axes {
        if *number != "1" {
            let found = format!("{} beside `G74`", shown(placed.text));
            let allowed = "1 behind each axis of `G74`: they are homed at once";
            mistakes.push(placed.column, found, allowed, format!("`{axis}1`, in a later block if it comes later"));
        }
    }
    axes.iter().map(|position| Command::Home { target: Target::Axis(position.axis) }).collect()
}

/// Its time is written behind the first axis.
fn dwell(placed: &Placed<'_>, axes: &[Position<'_, '_>], mistakes: &mut Mistakes) -> Vec<Command> {
    const ALLOWED: &str = "`G04` with `X` and the seconds, no less than 0";
    if axes.is_empty() {
        mistakes.push(placed.column, "`G04` without its time", ALLOWED, "a block like `G04 X2.5`");
    }
    let mut commands = Vec::new();
    for (position, (axis, seconds)) in axes.iter().zip(positions(axes)) {
        if axis == Axis::X && seconds >= 0.0 {
            commands.push(Command::Dwell { seconds });
        } else {
            let found = format!("{} beside `G04`", shown(position.placed.text));
            mistakes.push(position.placed.column, found, ALLOWED, "a block like `G04 X2.5`");
        }
    }
    commands
}

/// Their numbers are decimal ones: `word` has seen to that.
fn positions(axes: &[Position<'_, '_>]) -> Vec<(Axis, f64)> {
    axes.iter().filter_map(|position| decimal(position.number).map(|number| (position.axis, number))).collect()
}
