//! The exhaustive exploration of the block `spindle`: breadth first over all states of the block and of a drive, with every
//! letter of an alphabet in each of them, until there is no new state.
//!
//! Few numbers make the states few: velocities and positions are multiples of an eighth of a turn a cycle, times are 2 and 6
//! cycles. A rule that a cycle breaks is found with the shortest way to it.

#![expect(clippy::float_cmp, reason = "all numbers are small multiples of one grain: exact")]

pub mod drive;
pub mod letters;
mod orders;
pub mod rules;
pub mod scenarios;
pub mod transitions;
pub mod world;

use drive::IDEAL;
use letters::{Letter, QUIET, RESET};
use reference::spindle::{Coeffs, Job};
use rules::Rule;
use scenarios::Scenario;
use std::collections::{BTreeMap, BTreeSet, HashSet};
use std::fmt::Write;
use transitions::{Node, Transition};
use world::{Edge, World};

/// Cycles after which a spindle with a drive and an interpolator that do their part must have arrived.
const PATIENCE: u32 = 40;

/// What an exploration has found.
#[derive(Debug, Default)]
pub struct Found {
    /// different states
    pub states: usize,
    /// cycles, one for each state and letter
    pub edges: usize,
    /// length of the longest shortest way to a state
    pub depth: u32,
    /// transitions, each with how often it was passed
    pub transitions: BTreeMap<Transition, usize>,
    /// pairs of transitions, the second one directly after the first
    pub pairs: BTreeSet<(Transition, Transition)>,
    /// the depth at which the last new pair was found
    pub depth_of_pairs: u32,
    /// the most cycles from a reset to POSITION
    pub longest_return: u32,
    /// rules that are broken: how often, and the shortest way there
    pub broken: BTreeMap<Rule, (usize, String)>,
}

/// Explores until there is no new state, or to a depth. Of the new states one in `part` is judged by where it leads.
///
/// # Panics
/// If a number is none of the few, or there are more states than indices.
#[must_use]
pub fn explore(scenario: &Scenario, depth: u32, part: usize) -> Found {
    let coeffs = drive::coefficients(scenario.in_drive, scenario.v_off, scenario.v_step);
    let mut found = Found::default();
    let mut known = HashSet::new();
    let mut parents: Vec<(u32, u8)> = vec![(0, 0)];
    let mut layer = vec![(0u32, World::start())];
    known.insert(World::start().key(scenario.is_absolute, scenario.remembers));
    while !layer.is_empty() && found.depth < depth {
        let mut next = Vec::new();
        for (number, world) in &layer {
            for (letter, place) in scenario.letters.iter().zip(0u8..) {
                if !scenario.allows(world, letter) {
                    continue;
                }
                let edge = world.step(&coeffs, scenario.model, letter);
                found.edges += 1;
                found.count(&edge, world);
                let way = || scenario.way(&coeffs, &parents, *number, letter);
                for rule in rules::broken(&edge) {
                    found.report(rule, way);
                }
                let key = edge.after.key(scenario.is_absolute, scenario.remembers);
                if known.insert(key) {
                    if parents.len().is_multiple_of(part) {
                        found.judge(&edge.after, &coeffs, way);
                    }
                    next.push((u32::try_from(parents.len()).expect("few states"), edge.after));
                    parents.push((*number, place));
                }
            }
        }
        found.depth += 1;
        layer = next;
    }
    found.states = known.len();
    found
}

impl Found {
    /// Counts the transitions of a cycle, and the pairs that they make with the one before.
    fn count(&mut self, edge: &Edge<'_>, world: &World) {
        let mut last = world.last;
        for one in edge.transitions.into_iter().flatten() {
            *self.transitions.entry(one).or_default() += 1;
            if last.is_some_and(|before| self.pairs.insert((before, one))) {
                self.depth_of_pairs = self.depth + 1;
            }
            last = Some(one);
        }
    }

    /// Writes down that a rule is broken; the first way to it is a shortest one.
    fn report(&mut self, rule: Rule, way: impl Fn() -> String) {
        self.broken.entry(rule).or_insert_with(|| (0, way())).0 += 1;
    }

    /// Whether a new state can be left by those who do their part.
    fn judge(&mut self, world: &World, coeffs: &Coeffs<f64>, way: impl Fn() -> String) {
        let is_back = |world: &World| world.node == Node::Position && world.block.present.kind == Job::Stop;
        match arrival(world, coeffs, RESET, is_back) {
            Some(cycles) => self.longest_return = self.longest_return.max(cycles),
            None => self.report(Rule::Returns, &way),
        }
        let serves = |world: &World| matches!(world.node, Node::Position | Node::Velocity | Node::Stopped);
        let is_served = |world: &World| serves(world) && (world.block.queued == 0 || world.node == Node::Stopped);
        let is_stopped = matches!(world.node, Node::Stopped | Node::OffStopped);
        if !is_stopped && arrival(world, coeffs, QUIET, is_served).is_none() {
            self.report(Rule::Settles, way);
        }
    }
}

/// After how many cycles of an ideal drive a state is reached, which then stays for two cycles.
fn arrival(start: &World, coeffs: &Coeffs<f64>, first: Letter, is_there: impl Fn(&World) -> bool) -> Option<u32> {
    let mut world = *start;
    let mut since = 0;
    for cycle in 1..=PATIENCE {
        // A time that was nearly over may still run out: whoever has reset the spindle does it again.
        let letter = if cycle == 1 || world.node == Node::Stopped { first } else { QUIET };
        world = world.step(coeffs, IDEAL, letter).after;
        since = if is_there(&world) { since + 1 } else { 0 };
        if since == 3 {
            return Some(cycle - 2);
        }
    }
    None
}

impl Scenario {
    /// The way to a state and the cycle after it, cycle by cycle.
    fn way(&self, coeffs: &Coeffs<f64>, parents: &[(u32, u8)], number: u32, last: Letter) -> String {
        let mut letters = vec![last];
        let mut at = number;
        while at != 0 {
            let (parent, place) = parents[at as usize];
            letters.push(self.letters[place as usize]);
            at = parent;
        }
        let mut text = format!("{}\n", self.name);
        let mut world = World::start();
        for (letter, cycle) in letters.into_iter().rev().zip(1..) {
            let edge = world.step(coeffs, self.model, letter);
            let (i, o) = (&edge.inputs, &edge.outputs);
            let _ = writeln!(
                text,
                "cycle {cycle} {letter:?}: {:?}, then {:?}; display {}, v_actual {}; x {} v {} job {:?} {} waiting {} error {}",
                edge.inside,
                edge.after.node,
                i.operation_mode_display,
                i.v_actual,
                o.x_spindle,
                o.v_spindle,
                o.job,
                o.job_speed,
                o.waiting,
                o.error_id,
            );
            world = edge.after;
        }
        text
    }
}
