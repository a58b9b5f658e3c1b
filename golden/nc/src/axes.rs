//! The G words of a block with their axes and feed: their permitted combinations and their commands. Nothing about spindles
//! or the time of a dwell.

use super::dwell;
use super::foreign::Foreign;
use super::mistake::{Mistakes, shown};
use super::number::{INTEGER, integer};
use super::passed::PassedKind;
use super::program::{Axis, Command, Target};
use super::word::{Function, Modal, Placed, Word};
use std::collections::BTreeMap;

/// mm in an inch.
const INCH: f64 = 25.4;

/// The G words and F of earlier blocks that are still in force.
#[derive(Default)]
pub(crate) struct InForce {
    /// of G00 (true) or G01
    rapid: Option<bool>,
    /// in mm/min
    feed: Option<f64>,
    is_incremental: bool,
    is_inch: bool,
    /// end positions of the moves [mm, deg]
    place: BTreeMap<Axis, f64>,
    /// from G92: added to absolute positions [mm, deg]
    shift: BTreeMap<Axis, f64>,
}

/// An axis word: its place, its axis, its number.
struct Position<'w, 't> {
    placed: &'w Placed<'t>,
    axis: Axis,
    number: f64,
}

/// The commands of the G words.
pub(crate) fn commands(words: &[Placed<'_>], force: &mut InForce, mistakes: &mut Mistakes) -> Vec<Command> {
    let Some(functions) = functions(words, mistakes) else { return Vec::new() };
    for placed in words {
        match placed.word {
            Word::Modal(modal) => force.take(modal),
            Word::Wait(seconds) => return dwell::waits(placed, seconds, words, mistakes),
            _ => {}
        }
    }
    let is = |wanted: Function| functions.iter().find(|(_, function)| *function == wanted).map(|(placed, _)| *placed);
    if let Some(placed) = is(Function::Dwell) {
        return dwell::commands(placed, words, mistakes).into_iter().collect();
    }
    force.feed(words);
    let motion = [Function::Rapid, Function::Linear].into_iter().find(|function| is(*function).is_some());
    force.rapid = motion.map(|function| function == Function::Rapid).or(force.rapid);
    if let Some(placed) = is(Function::MachinePosition) {
        mistakes.pass(PassedKind::MachinePosition, placed.column, &placed.text.to_ascii_uppercase());
        return Vec::new();
    }
    of_axes(&functions, words, force, mistakes)
}

/// The commands of G words that act on axes, or on the axes themselves.
fn of_axes(
    functions: &[(&Placed<'_>, Function)],
    words: &[Placed<'_>],
    force: &mut InForce,
    mistakes: &mut Mistakes,
) -> Vec<Command> {
    let axes: Vec<Position<'_, '_>> = words.iter().filter_map(position).collect();
    let target = Target::Axes;
    let mut commands = Vec::new();
    for (placed, function) in functions {
        match function {
            Function::FeedforwardOn => commands.push(Command::Feedforward { target, on: true }),
            Function::FeedforwardOff => commands.push(Command::Feedforward { target, on: false }),
            Function::Percentage => commands.extend(percentages(placed, &axes, mistakes)),
            Function::Home => commands.extend(homes(placed, &axes, force, mistakes)),
            Function::Preset => force.preset(placed, words, &axes, mistakes),
            Function::Rapid | Function::Linear | Function::Dwell | Function::MachinePosition => {}
        }
    }
    let takes_axes = |function: &Function| matches!(function, Function::Percentage | Function::Home | Function::Preset);
    if !functions.iter().any(|(_, function)| takes_axes(function)) && !axes.is_empty() {
        let is_motion = functions.iter().all(|(_, function)| matches!(function, Function::Rapid | Function::Linear));
        match force.rapid.filter(|_| is_motion) {
            Some(rapid) => commands.push(force.travel(rapid, &axes, mistakes)),
            None => needless(&axes, mistakes),
        }
    }
    commands
}

impl InForce {
    fn take(&mut self, modal: Modal) {
        match modal {
            Modal::Absolute => self.is_incremental = false,
            Modal::Incremental => self.is_incremental = true,
            Modal::Inches => self.is_inch = true,
            Modal::Millimetres => self.is_inch = false,
            Modal::NoPreset => self.shift.clear(),
        }
    }

    fn feed(&mut self, words: &[Placed<'_>]) {
        let feed = words.iter().find_map(|placed| if let Word::Feed(feed) = placed.word { Some(feed) } else { None });
        self.feed = feed.map(|feed| if self.is_inch { feed * INCH } else { feed }).or(self.feed);
    }

    fn travel(&mut self, rapid: bool, axes: &[Position<'_, '_>], mistakes: &mut Mistakes) -> Command {
        if !rapid && self.feed.is_none() {
            mistakes.pass(PassedKind::NoFeed, axes[0].placed.column, "");
        }
        let mut ends = Vec::new();
        for Position { axis, number, .. } in axes {
            let way = self.length(*axis, *number);
            let shift = self.shift.get(axis).copied().unwrap_or_default();
            let place = self.place.entry(*axis).or_default();
            *place = if self.is_incremental { *place + way } else { way + shift };
            ends.push((*axis, *place));
        }
        Command::Move { rapid, axes: ends, feed_mm_min: self.feed.filter(|_| !rapid) }
    }

    /// A length or an angle in mm or deg.
    fn length(&self, axis: Axis, number: f64) -> f64 {
        if self.is_inch && axis.is_linear() { number * INCH } else { number }
    }

    /// G92: the present position of an axis has this number from now on. With a feed it is a thread on a lathe.
    fn preset(
        &mut self,
        function: &Placed<'_>,
        words: &[Placed<'_>],
        axes: &[Position<'_, '_>],
        mistakes: &mut Mistakes,
    ) {
        if words.iter().any(|placed| matches!(placed.word, Word::Feed(_))) {
            mistakes.foreign(function.column, function.text, Foreign::Thread);
            return;
        }
        lonely(function, axes, "`G92 X0`", mistakes);
        mistakes.pass(PassedKind::Preset, function.column, "");
        for Position { axis, number, .. } in axes {
            let place = self.place.get(axis).copied().unwrap_or_default();
            self.shift.insert(*axis, place - self.length(*axis, *number));
        }
    }
}

fn position<'w, 't>(placed: &'w Placed<'t>) -> Option<Position<'w, 't>> {
    if let Word::Axis(axis, number) = placed.word { Some(Position { placed, axis, number }) } else { None }
}

/// The G words of a valid combination: one, or two of a pair, in this order; `None` after a reported error.
fn functions<'w, 't>(words: &'w [Placed<'t>], mistakes: &mut Mistakes) -> Option<Vec<(&'w Placed<'t>, Function)>> {
    const PAIRS: [[Function; 2]; 3] = [
        [Function::FeedforwardOn, Function::Percentage],
        [Function::Rapid, Function::MachinePosition],
        [Function::Linear, Function::MachinePosition],
    ];
    let function = |placed: &'w Placed<'t>| match placed.word {
        Word::Function(function) => Some((placed, function)),
        _ => None,
    };
    let mut all: Vec<(&Placed<'t>, Function)> = words.iter().filter_map(function).collect();
    let mut good = true;
    for (at, (placed, function)) in all.iter().enumerate() {
        let apart = |(_, other): &&(&Placed<'t>, Function)| {
            !PAIRS.iter().any(|pair| pair.contains(other) && pair.contains(function))
        };
        if let Some((other, _)) = all[..at].iter().find(apart) {
            let found = format!("{} with {}", shown(placed.text), shown(other.text));
            let allowed = "one G word that moves, waits or sets feedforward in a block, or `G135` with `G136`";
            mistakes.push(placed.column, found, allowed, format!("{} in a block of its own", shown(placed.text)));
            good = false;
        }
    }
    all.sort_by_key(|(_, function)| *function == Function::Percentage);
    good.then_some(all)
}

/// Reports axis words without a G word: one message for the block.
fn needless(axes: &[Position<'_, '_>], mistakes: &mut Mistakes) {
    if let Some(Position { placed, .. }) = axes.first() {
        let found = format!("{} without its G word", shown(placed.text));
        let allowed = "axes after `G00` or `G01`, or with `G04`, `G74` or `G136` of the same block";
        mistakes.push(placed.column, found, allowed, format!("the G word before it, as in `G00 {}`", placed.text));
    }
}

/// Reports a function without an axis.
fn lonely(placed: &Placed<'_>, axes: &[Position<'_, '_>], example: &str, mistakes: &mut Mistakes) {
    if axes.is_empty() {
        let found = format!("{} without an axis", shown(placed.text));
        mistakes.push(placed.column, found, "an axis with it, such as X, Y or Z", format!("a block like {example}"));
    }
}

fn percentages(function: &Placed<'_>, axes: &[Position<'_, '_>], mistakes: &mut Mistakes) -> Vec<Command> {
    lonely(function, axes, "`G136 X80`", mistakes);
    let mut commands = Vec::new();
    for Position { placed, axis, number } in axes {
        if let Some(percent) = integer(&number.to_string()) {
            commands.push(Command::Percentage { target: Target::Axis(*axis), percent });
        } else {
            let found = format!("{} with `G136`", shown(placed.text));
            mistakes.push(placed.column, found, INTEGER, format!("`{axis}` and such a number"));
        }
    }
    commands
}

fn homes(
    function: &Placed<'_>,
    axes: &[Position<'_, '_>],
    force: &mut InForce,
    mistakes: &mut Mistakes,
) -> Vec<Command> {
    lonely(function, axes, "`G74 X1`, or `S[G74]` for a spindle", mistakes);
    let mut commands = Vec::new();
    for Position { placed, axis, number } in axes {
        if integer(&number.to_string()) != Some(1) {
            let found = format!("{} with `G74`", shown(placed.text));
            let allowed = "1 after each axis of `G74`: they are homed at once";
            mistakes.push(placed.column, found, allowed, format!("`{axis}1`, in a later block if it comes later"));
        }
        force.place.insert(*axis, 0.0);
        force.shift.remove(axis);
        commands.push(Command::Home { target: Target::Axis(*axis) });
    }
    commands
}
