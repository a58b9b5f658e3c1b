//! Which transitions the block `spindle` has, by docs/spindle.md, and which of them can follow each other. Nothing is run here.

/// What the block is doing.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Node {
    /// the drive is off
    Off,
    /// the drive is off, and an error stays
    OffStopped,
    /// an error stays
    Stopped,
    /// the state POSITION
    Position,
    /// the state TO_VELOCITY
    ToVelocity,
    /// the state VELOCITY
    Velocity,
    /// the state BRAKE
    Brake,
    /// the state TO_POSITION
    ToPosition,
}

/// What a transition is told apart by, where its ends are not enough.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum By {
    /// nothing else
    Ends,
    /// a reset in TO_VELOCITY or VELOCITY
    Reset,
    /// a request that waits
    Request,
    /// this error
    Error(u32),
}

/// From one node to another.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Transition {
    /// left
    pub from: Node,
    /// entered
    pub to: Node,
    /// how
    pub by: By,
}

const fn t(from: Node, to: Node) -> Transition {
    Transition { from, to, by: By::Ends }
}

const fn error(from: Node, id: u32) -> Transition {
    Transition { from, to: Node::Stopped, by: By::Error(id) }
}

/// The error of a wrong cycle, in a cycle in which the drive is off.
const fn wrong_and_off(from: Node) -> Transition {
    Transition { from, to: Node::OffStopped, by: By::Error(1) }
}

/// All transitions.
pub const TRANSITIONS: [Transition; 47] = [
    t(Node::Off, Node::ToPosition),
    t(Node::ToPosition, Node::Position),
    t(Node::ToPosition, Node::Brake),
    t(Node::Position, Node::ToVelocity),
    t(Node::ToVelocity, Node::Velocity),
    Transition { from: Node::Velocity, to: Node::Brake, by: By::Request },
    Transition { from: Node::Velocity, to: Node::Brake, by: By::Reset },
    t(Node::Brake, Node::ToPosition),
    error(Node::Off, 1),
    error(Node::Position, 1),
    error(Node::ToVelocity, 1),
    error(Node::Velocity, 1),
    error(Node::Brake, 1),
    error(Node::ToPosition, 1),
    wrong_and_off(Node::Off),
    wrong_and_off(Node::Position),
    wrong_and_off(Node::ToVelocity),
    wrong_and_off(Node::Velocity),
    wrong_and_off(Node::Brake),
    wrong_and_off(Node::ToPosition),
    error(Node::Position, 14),
    error(Node::ToVelocity, 14),
    error(Node::Velocity, 14),
    error(Node::Position, 17),
    error(Node::ToVelocity, 17),
    error(Node::ToVelocity, 41),
    error(Node::Brake, 41),
    error(Node::Brake, 42),
    error(Node::ToPosition, 43),
    error(Node::Position, 44),
    error(Node::ToVelocity, 44),
    error(Node::Position, 45),
    error(Node::Velocity, 45),
    error(Node::Position, 46),
    error(Node::ToVelocity, 46),
    t(Node::Stopped, Node::Brake),
    t(Node::Stopped, Node::ToPosition),
    t(Node::Stopped, Node::Off),
    t(Node::Stopped, Node::OffStopped),
    t(Node::OffStopped, Node::Off),
    t(Node::OffStopped, Node::Stopped),
    t(Node::OffStopped, Node::ToPosition),
    t(Node::Position, Node::Off),
    t(Node::ToVelocity, Node::Off),
    t(Node::Velocity, Node::Off),
    t(Node::Brake, Node::Off),
    t(Node::ToPosition, Node::Off),
];

/// Transitions that position control in the CNC does not have, and why.
pub const NOT_IN_CNC: [(Transition, &str); 6] = [
    (error(Node::Brake, 41), "the CNC answers at once"),
    (error(Node::ToVelocity, 41), "the CNC answers at once"),
    (error(Node::Position, 44), "the CNC counts the turns"),
    (error(Node::ToVelocity, 44), "the CNC counts the turns"),
    (error(Node::Position, 45), "there is no display"),
    (error(Node::Velocity, 45), "there is no display"),
];

/// Pairs of transitions that position control in the CNC does not have though it has both, and why.
pub const NO_PAIR_IN_CNC: [(Transition, Transition, &str); 2] = [
    (
        t(Node::Brake, Node::ToPosition),
        error(Node::ToPosition, 43),
        "the CNC answers at once, and only at the start can x_actual be missing",
    ),
    (error(Node::ToPosition, 43), t(Node::Stopped, Node::Brake), "an error of the start leads back to the start"),
];

/// The transitions that there are.
#[must_use]
pub fn possible(in_drive: bool) -> Vec<Transition> {
    let is_there = |of: &Transition| in_drive || NOT_IN_CNC.iter().all(|(missing, _)| missing != of);
    TRANSITIONS.into_iter().filter(is_there).collect()
}

/// The pairs of transitions, the second one directly after the first, that there are.
#[must_use]
pub fn possible_pairs(in_drive: bool) -> Vec<(Transition, Transition)> {
    let mut pairs = Vec::new();
    for first in possible(in_drive) {
        for second in possible(in_drive) {
            let is_missing = NO_PAIR_IN_CNC.iter().any(|(a, b, _)| (*a, *b) == (first, second));
            if first.to == second.from && can_follow(first, second) && (in_drive || !is_missing) {
                pairs.push((first, second));
            }
        }
    }
    pairs
}

/// Whether the second transition can come directly after the first, which leads to where it begins.
fn can_follow(first: Transition, second: Transition) -> bool {
    let is_start = matches!(first.from, Node::Off | Node::OffStopped | Node::Stopped);
    match (second.from, second.to) {
        // Only a spindle that BRAKE has not slowed down is caught.
        (Node::ToPosition, Node::Brake) => is_start,
        // Only one that was caught waits for the drive's answer in BRAKE.
        (Node::Brake, Node::Stopped) if second.by == By::Error(41) => first.from != Node::Velocity,
        // Only an error of the start, in which the block does not move the spindle yet, leads back there.
        (Node::Stopped, Node::ToPosition) => first.from == Node::ToPosition,
        _ => true,
    }
}
