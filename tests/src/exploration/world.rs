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
    /// cycles in a row in which a sample has been missing
    pub missing: u32,
    /// m3, m4, m5, m19, putax, g74 of the cycle before
    pub held: [bool; 6],
    /// there was no cycle yet
    pub is_first: bool,
    /// TO_POSITION has not been entered from BRAKE
    pub is_start: bool,
    /// a reset came in TO_VELOCITY or VELOCITY, and the spindle has not left them since
    pub was_reset: bool,
    /// the take-over is watched: the first cycle of POSITION with all samples, or one behind missing ones
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
    /// drive_on FALSE
    pub is_off: bool,
    /// the transitions of this cycle: by a reset, to `inside`, from there
    pub transitions: [Option<Transition>; 3],
    /// behind
    pub after: World,
}

/// By which a state is known again.
pub type Key = [u8; 44];

impl World {
    /// Before the first cycle.
    #[must_use]
    pub fn start() -> Self {
        let block = <Spindle as Block<f64>>::state();
        let (drive, node) = (Drive::default(), Node::Off);
        Self {
            block,
            drive,
            node,
            last: None,
            waited: 0,
            settled: 0,
            missing: 0,
            // What is TRUE in the first cycle does not become TRUE.
            held: [true; 6],
            is_first: true,
            is_start: false,
            was_reset: false,
            takes_over: false,
            x_start: None,
        }
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
        let is_off = !inputs.drive_on;
        let between = self.between(&inputs);
        let inside = inside(between, &inputs, coeffs);
        let then = if is_off { inside } else { node_of(&after.block) };
        let mut edge = Edge { coeffs, before: self, inputs, outputs, inside, is_off, transitions: [None; 3], after };
        let ways = [(self.node, between), (between, inside), (inside, then)];
        edge.transitions = ways.map(|(from, to)| edge.transition(from, to));
        edge.remember(then);
        edge
    }

    /// What the block is doing behind (2) of docs/spindle.md: a reset ends an error that stays.
    fn between(&self, inputs: &Inputs<f64>) -> Node {
        match self.node {
            Node::Stopped | Node::OffStopped if inputs.reset && inputs.drive_on => Node::Brake,
            Node::Stopped | Node::OffStopped if inputs.reset => Node::Off,
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
        let is_first = self.node == Node::ToPosition && block.cycles == 0 && block.is_moving;
        let is_coasting = matches!(self.node, Node::Position | Node::ToVelocity | Node::Velocity);
        let zero = if is_absolute { 0.0 } else { block.x };
        let place = |x: f64| grains(wrap(x - zero));
        let takes_over = block.takes_over && matches!(self.node, Node::Position | Node::ToVelocity);
        let flags = [block.asks_velocity, block.returns, block.is_moving, takes_over, drive.is_velocity];
        let flags = flags.into_iter().chain([self.was_reset, self.takes_over, self.x_start.is_some()]);
        let held = block.before;
        let held = [held.m3, held.m4, held.m5, held.m19, held.putax, held.g74];
        let last = TRANSITIONS.iter().position(|one| remembers && Some(*one) == self.last);
        let mut key = [0; 44];
        let mut bytes = vec![
            block.control as u8,
            if is_timed { byte(block.cycles.min(SLOW_BRAKE_CYCLES + 1)) } else { 0 },
            if self.node == Node::Brake { byte(block.settled.min(3)) } else { 0 },
            byte(block.lasting_error),
            bits(flags),
            bits(held.into_iter()),
            bits(self.held.into_iter()),
            bits([self.is_first, self.is_start].into_iter()),
            if is_coasting { byte(block.missing) } else { 0 },
            byte(self.missing),
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
            (_, Node::Stopped | Node::OffStopped) => By::Error(self.after.block.lasting_error),
            _ => By::Ends,
        };
        (from != to).then_some(Transition { from, to, by })
    }

    /// The error of the sample that the state has missed in this cycle, else 0.
    #[must_use]
    pub fn missing(&self) -> u32 {
        let i = &self.inputs;
        let is_tracking = matches!(self.inside, Node::Position | Node::ToVelocity);
        let mode = match self.inside {
            Node::Position => Some(self.coeffs.position_mode),
            Node::Velocity => Some(self.coeffs.velocity_mode),
            _ => None,
        };
        match () {
            () if !is_tracking && self.inside != Node::Velocity => 0,
            () if !is_number(i.v_interpolator) => 14,
            () if is_tracking && !is_place(i.x_command) => 17,
            () if self.coeffs.in_drive && mode.is_some_and(|mode| i.operation_mode_display != mode) => 45,
            () => 0,
        }
    }

    /// Cycles in `inside`, this one included.
    #[must_use]
    pub fn cycles(&self) -> u32 {
        if self.before.node == self.inside { self.before.waited + 1 } else { 1 }
    }

    /// Cycles in a row in which BRAKE has been settled, this one included.
    #[must_use]
    pub fn settled(&self) -> u32 {
        let v_before = self.before.block.v.abs();
        let is_slow = v_before <= self.coeffs.v_position_control_on;
        let is_settled = is_slow && self.inputs.v_actual.abs() <= v_before + self.coeffs.window;
        let before = if self.before.node == Node::Brake { self.before.settled } else { 0 };
        if self.inside == Node::Brake && is_settled { before + 1 } else { 0 }
    }

    /// Whether this cycle is one of TO_POSITION that BRAKE does not precede.
    #[must_use]
    pub fn is_start(&self) -> bool {
        self.inside == Node::ToPosition && (self.before.node == Node::Off || self.before.is_start)
    }

    /// What the rules need in the next cycle.
    fn remember(&mut self, then: Node) {
        let Self { inputs, outputs, inside, coeffs, .. } = *self;
        let stays = then == inside;
        let waited = if stays { self.cycles().min(SLOW_BRAKE_CYCLES + 2) } else { 0 };
        let settled = if stays { self.settled().min(3) } else { 0 };
        let is_missing = self.missing() != 0;
        let missing = if is_missing && stays { self.before.missing + 1 } else { 0 };
        let is_start = self.is_start() && stays;
        let is_free = |node| matches!(node, Node::ToVelocity | Node::Velocity);
        let after = &mut self.after;
        after.node = then;
        after.waited = waited;
        after.settled = settled;
        after.missing = missing;
        after.held = [inputs.m3, inputs.m4, inputs.m5, inputs.m19, inputs.putax, inputs.g74];
        after.is_first = false;
        after.is_start = is_start;
        after.was_reset = (inputs.reset || after.was_reset) && is_free(inside) && is_free(then);
        after.takes_over = match then {
            Node::Position => inside != then || is_missing,
            Node::ToVelocity => is_missing,
            _ => false,
        };
        let leaves = inside == Node::Brake && then == Node::ToPosition;
        after.x_start = leaves.then_some(inputs.x_actual + outputs.v_spindle * coeffs.lead_time);
        after.last = self.transitions.into_iter().flatten().last().or(after.last);
        after.block.jobs = 0;
    }
}

/// What the block is doing in this cycle, by docs/spindle.md, (3) and (4), from what it was doing behind (2).
fn inside(between: Node, inputs: &Inputs<f64>, coeffs: &Coeffs<f64>) -> Node {
    let is_wrong = inputs.task_cycle_ns != coeffs.cycle_time_ns;
    let is_stopped = is_wrong || matches!(between, Node::Stopped | Node::OffStopped);
    match (inputs.drive_on, is_stopped) {
        (false, true) => Node::OffStopped,
        (false, false) => Node::Off,
        (true, true) => Node::Stopped,
        (true, false) if between == Node::Off => Node::ToPosition,
        (true, false) => between,
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

/// Whether a velocity is in range.
#[must_use]
pub fn is_number(v: f64) -> bool {
    v.abs() <= 1e15
}

/// Whether a position is in range.
#[must_use]
pub fn is_place(x: f64) -> bool {
    x.abs() <= 7e14
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
