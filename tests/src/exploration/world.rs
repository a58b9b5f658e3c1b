//! The block, its drive and what the rules remember: one step of all of them, and the bits by which a state is known again.

use super::drive::{Drive, GRAIN, Model, SLOW_BRAKE_CYCLES, wrap};
use super::letters::{self, Letter};
use super::transitions::{By, Node, TRANSITIONS, Transition};
use portable::Block;
use reference::spindle::{Coeffs, Inputs, Job, Outputs, Request, Spindle, SpindleState, State};

/// All that the next cycle depends on.
#[derive(Clone, Copy, Debug)]
pub struct World {
    /// the block
    pub block: State<f64>,
    /// the drive
    pub drive: Drive,
    /// what the block is doing, told from its inputs and outputs
    pub node: Node,
    /// the transition that led there
    pub last: Option<Transition>,
    /// for how many cycles
    pub waited: u32,
    /// cycles in a row in BRAKE with an actual velocity within the window
    pub settled: u32,
    /// a reset came in TO_VELOCITY or VELOCITY, and the spindle has not left them since
    pub was_reset: bool,
    /// POSITION has not had its first cycle with samples in range
    pub takes_over: bool,
    /// where position control is taken up in the next cycle
    pub x_start: Option<f64>,
}

/// One cycle.
#[derive(Clone, Copy, Debug)]
pub struct Edge<'a> {
    /// coefficients of the block
    pub coeffs: &'a Coeffs<f64>,
    /// before
    pub before: &'a World,
    /// what the block got
    pub inputs: Inputs<f64>,
    /// what the block put out
    pub outputs: Outputs<f64>,
    /// what the block was doing in this cycle
    pub inside: Node,
    /// drive_on FALSE, or the cycle is wrong
    pub is_off: bool,
    /// the transitions of this cycle, at most one to `inside` and one from there
    pub transitions: [Option<Transition>; 2],
    /// behind
    pub after: World,
}

/// By which a state is known again.
pub type Key = [u8; 40];

impl World {
    /// Before the first cycle.
    #[must_use]
    pub fn start() -> Self {
        let block = <Spindle as Block<f64>>::state();
        let (drive, node) = (Drive::default(), Node::Off);
        let (was_reset, takes_over) = (false, false);
        Self { block, drive, node, last: None, waited: 0, settled: 0, was_reset, takes_over, x_start: None }
    }

    /// A cycle.
    #[must_use]
    pub fn step<'a>(&'a self, coeffs: &'a Coeffs<f64>, model: Model, letter: Letter) -> Edge<'a> {
        let mut after = *self;
        after.drive.advance(model, coeffs.in_drive, &self.block);
        let mut inputs = after.drive.samples(coeffs, &self.block);
        letters::apply(letter, &mut inputs, &self.block);
        let mut outputs = <Spindle as Block<f64>>::outputs();
        <Spindle as Block<f64>>::step(&mut after.block, coeffs, &inputs, &mut outputs);
        let is_off = !inputs.drive_on || inputs.task_cycle_ns != coeffs.cycle_time_ns;
        let inside = self.inside(&inputs, is_off);
        let then = if is_off { inside } else { node_of(&after.block) };
        let mut edge = Edge { coeffs, before: self, inputs, outputs, inside, is_off, transitions: [None; 2], after };
        edge.transitions = [edge.transition(self.node, inside), edge.transition(inside, then)];
        edge.remember(then);
        edge
    }

    /// What the block is doing in this cycle, by docs/spindle.md, (3) to (5).
    fn inside(&self, inputs: &Inputs<f64>, is_off: bool) -> Node {
        let is_stopped = matches!(self.node, Node::Stopped | Node::OffStopped);
        match self.node {
            _ if is_off && is_stopped && !inputs.reset => Node::OffStopped,
            _ if is_off => Node::Off,
            _ if is_stopped && inputs.reset => Node::Brake,
            _ if is_stopped => Node::Stopped,
            Node::Off => Node::ToPosition,
            node => node,
        }
    }

    /// The bits. What no later cycle can depend on is left out: the number of jobs, times beyond the last comparison, the time in
    /// POSITION and VELOCITY, requests behind the last one that waits. `is_absolute` false: only how far positions lie
    /// from `x_spindle`, for the block and the drive have no zero.
    #[must_use]
    pub fn key(&self, is_absolute: bool, remembers: bool) -> Key {
        let Self { block, drive, .. } = self;
        let is_timed = matches!(self.node, Node::ToVelocity | Node::Brake | Node::ToPosition);
        let is_first = self.node == Node::ToPosition && block.cycles == 0 && block.preset;
        let zero = if is_absolute { 0.0 } else { block.x };
        let place = |x: f64| grains(wrap(x - zero));
        let flags = [block.asks_velocity, block.returns, block.preset, block.takes_over, drive.is_velocity];
        let flags = flags.into_iter().chain([self.was_reset, self.takes_over, self.x_start.is_some()]);
        let held = block.before;
        let held = [held.m3, held.m4, held.m5, held.m19, held.putax, held.g74];
        let last = TRANSITIONS.iter().position(|one| remembers && Some(*one) == self.last);
        let mut key = [0; 40];
        let mut bytes = vec![
            block.control as u8,
            if is_timed { byte(block.cycles.min(SLOW_BRAKE_CYCLES + 1)) } else { 0 },
            if self.node == Node::Brake { byte(block.settled.min(3)) } else { 0 },
            byte(block.lasting_error),
            bits(flags),
            bits(held.into_iter()),
            place(block.x),
            grains(block.v),
            if is_first { place(block.x_start) } else { 0 },
            place(drive.x),
            grains(drive.v),
            grains(drive.v_before),
            drive.asked,
            drive.halved,
            self.node as u8,
            last.map_or(u8::MAX, |place| byte(u32::try_from(place).unwrap_or(u32::MAX))),
            if is_timed { byte(self.waited.min(SLOW_BRAKE_CYCLES + 2)) } else { 0 },
            byte(self.settled),
            self.x_start.map_or(0, place),
            byte(block.queued),
        ];
        let waiting = &block.request[..(block.queued as usize).min(4)];
        for Request { kind, speed, position } in [block.present].iter().chain(waiting) {
            bytes.extend([*kind as u8, grains(*speed), grains(*position)]);
        }
        key[..bytes.len()].copy_from_slice(&bytes);
        key
    }
}

impl Edge<'_> {
    /// The transition between two nodes, if they differ.
    fn transition(&self, from: Node, to: Node) -> Option<Transition> {
        let by = match (from, to) {
            (Node::Velocity, Node::Brake) if self.before.was_reset || self.inputs.reset => By::Reset,
            (Node::Velocity, Node::Brake) => By::Request,
            (Node::Stopped | Node::OffStopped, _) => By::Ends,
            (_, Node::Stopped) => By::Error(self.after.block.lasting_error),
            _ => By::Ends,
        };
        (from != to).then_some(Transition { from, to, by })
    }

    /// What the rules need in the next cycle.
    fn remember(&mut self, then: Node) {
        let Self { inputs, outputs, inside, .. } = *self;
        let (coeffs, after) = (self.coeffs, &mut self.after);
        let is_new = after.node != inside;
        let waited = if is_new { 1 } else { after.waited + 1 };
        let settled = if is_new { 0 } else { after.settled };
        let is_settled = inside == Node::Brake && inputs.v_actual.abs() <= coeffs.v_settled;
        let was_reset = inputs.reset || after.was_reset;
        let is_blind = matches!(outputs.error_id, 14 | 17);
        after.node = then;
        after.waited = if then == inside { waited.min(SLOW_BRAKE_CYCLES + 2) } else { 0 };
        after.settled = if is_settled && then == inside { (settled + 1).min(3) } else { 0 };
        after.was_reset = was_reset
            && matches!(inside, Node::ToVelocity | Node::Velocity)
            && matches!(then, Node::ToVelocity | Node::Velocity);
        after.takes_over = then == Node::Position && (inside != then || after.takes_over && is_blind);
        let leaves = inside == Node::Brake && then == Node::ToPosition;
        after.x_start = leaves.then_some(inputs.x_actual + outputs.v_spindle * coeffs.lead_time);
        after.last = self.transitions.into_iter().flatten().last().or(after.last);
        after.block.jobs = 0;
    }
}

/// What the block does next.
fn node_of(block: &State<f64>) -> Node {
    match block.control {
        _ if block.lasting_error != 0 => Node::Stopped,
        SpindleState::Position => Node::Position,
        SpindleState::ToVelocity => Node::ToVelocity,
        SpindleState::Velocity => Node::Velocity,
        SpindleState::Brake => Node::Brake,
        SpindleState::ToPosition => Node::ToPosition,
    }
}

/// Whether a job needs no position control.
#[must_use]
pub fn is_free(job: Job) -> bool {
    matches!(job, Job::Stop | Job::Turn)
}

/// A number as a multiple of the grain; that it is one keeps the states few.
#[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "checked before")]
fn grains(x: f64) -> u8 {
    let grains = x / GRAIN;
    assert!(grains.fract() == 0.0 && grains.abs() <= 127.0, "exploration: {x} is no multiple of {GRAIN} within a byte");
    grains as i8 as u8
}

fn byte(value: u32) -> u8 {
    u8::try_from(value).expect("a small number")
}

fn bits(flags: impl Iterator<Item = bool>) -> u8 {
    flags.fold(0, |sum, flag| sum << 1 | u8::from(flag))
}
