//! The block, its drive and what the rules remember: one step of all of them, and the bits by which a state is known again.

use super::drive::{Drive, GRAIN, Model, SLOW_BRAKE_CYCLES, wrap};
use super::letters::{self, Act, Letter};
use super::transitions::{By, Node, TRANSITIONS, Transition};
use portable::Block;
use reference::spindle::{Coeffs, Inputs, Job, Outputs, Request, Seen, Spindle, SpindleState, State};

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
    /// the block does not move the spindle yet
    pub is_idle: bool,
    /// cycles in a row with a sample of the actual velocity while it is idle, and with a slow one, up to 3
    pub samples: [u8; 2],
    /// the samples of the last two cycles
    pub velocities: [f64; 2],
    /// a spindle was caught, and the drive has not displayed velocity control since
    pub is_caught: bool,
    /// a reset came in TO_VELOCITY or VELOCITY, and the spindle has not left them since
    pub was_reset: bool,
    /// the take-over is watched: the first cycle of POSITION with all samples, or one after missing ones
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
    /// after
    pub after: World,
}

/// By which a state is known again.
pub type Key = [u8; 56];

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
            is_idle: true,
            samples: [0; 2],
            velocities: [0.0; 2],
            is_caught: false,
            was_reset: false,
            takes_over: false,
            x_start: None,
        }
    }

    /// A cycle.
    #[must_use]
    pub fn step<'a>(&'a self, coeffs: &'a Coeffs<f64>, model: Model, letter: Letter) -> Edge<'a> {
        let mut after = *self;
        let is_on = !letter.contains(&Act::Off);
        after.drive.advance(model, coeffs.in_drive, is_on, &self.block);
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

    /// What the block is doing after (2) of docs/spindle.md: a reset ends an error that stays.
    fn between(&self, inputs: &Inputs<f64>) -> Node {
        match self.node {
            Node::Stopped | Node::OffStopped if inputs.reset && inputs.drive_on && self.is_idle => Node::ToPosition,
            Node::Stopped | Node::OffStopped if inputs.reset && inputs.drive_on => Node::Brake,
            Node::Stopped | Node::OffStopped if inputs.reset => Node::Off,
            node => node,
        }
    }

    /// The bits. What no later cycle can depend on is left out: the number of jobs, times beyond the last comparison, the time in
    /// POSITION and VELOCITY, requests after the last one that waits. `is_absolute` false: only how far positions lie
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
        let flags = [block.asks_velocity, block.returns, block.is_moving, takes_over, drive.velocity_control.mode];
        let flags = flags.into_iter().chain([self.was_reset, self.takes_over, self.x_start.is_some()]);
        let held = block.before;
        let held = [held.m3, held.m4, held.m5, held.m19, held.putax, held.g74];
        let last = TRANSITIONS.iter().position(|one| remembers && Some(*one) == self.last);
        let bytes = [
            block.control as u8,
            if is_timed { byte(block.cycles.min(SLOW_BRAKE_CYCLES + 1)) } else { 0 },
            if self.node == Node::Brake { byte(block.settled.min(3)) } else { 0 },
            byte(block.lasting_error),
            bits(flags),
            bits(held.into_iter()),
            bits(self.held.into_iter()),
            bits([self.is_first, self.is_idle, self.is_caught, block.catches].into_iter()),
            if is_coasting { byte(block.missing) } else { 0 },
            byte(self.missing),
            place(block.x),
            grains(block.v),
            if is_first { place(block.x_start) } else { 0 },
            place(drive.x),
            grains(drive.velocity.v),
            grains(drive.velocity.before),
            byte(drive.velocity_control.asked.min(3)),
            drive.velocity.halved,
            self.node as u8,
            last.map_or(u8::MAX, |place| byte(u32::try_from(place).unwrap_or(u32::MAX))),
            if is_timed { byte(self.waited.min(SLOW_BRAKE_CYCLES + 2)) } else { 0 },
            byte(self.settled),
            self.x_start.map_or(0, place),
            byte(block.queued),
        ];
        let idle = if self.is_idle {
            let Seen { samples, slow, v_last, v_before, .. } = block.seen;
            let [own, own_slow] = self.samples;
            let [v, v_earlier] = self.velocities.map(grains);
            [byte(samples), byte(slow), grains(v_last), grains(v_before), own, own_slow, v, v_earlier]
        } else {
            [0; 8]
        };
        let waiting = &block.request[..(block.queued as usize).min(4)];
        let jobs = [block.present].into_iter().chain(waiting.iter().copied());
        let jobs = jobs.flat_map(|Request { kind, speed, position }| [kind as u8, grains(speed), grains(position)]);
        let mut key = [0; 56];
        key.iter_mut().zip(bytes.into_iter().chain(idle).chain(jobs)).for_each(|(place, byte)| *place = byte);
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
        let v_before = self.before.block.v;
        let is_slow = v_before.abs() <= self.coeffs.v_position_control_on;
        // From 0 to the command, and a window more on both sides.
        let ends = [v_before.min(0.0) - self.coeffs.window, v_before.max(0.0) + self.coeffs.window];
        let is_settled = is_slow && (ends[0]..=ends[1]).contains(&self.inputs.v_actual);
        let before = if self.before.node == Node::Brake { self.before.settled } else { 0 };
        if self.inside == Node::Brake && is_settled { before + 1 } else { 0 }
    }

    /// Whether this cycle is one of TO_POSITION in which the block does not move the spindle yet.
    #[must_use]
    pub fn is_start(&self) -> bool {
        self.inside == Node::ToPosition && self.before.is_idle
    }

    /// Whether an error stays in the first cycle with a drive that has come on, or begins with a reset at the start.
    #[must_use]
    pub fn is_seized(&self) -> bool {
        let was_off = matches!(self.before.node, Node::Off | Node::OffStopped);
        let begins = self.before.node == Node::Stopped && self.inputs.reset;
        self.inside == Node::Stopped && self.before.is_idle && (was_off || begins)
    }

    /// Whether the block looks at the actual velocity of a spindle that it does not move.
    #[must_use]
    pub fn looks(&self) -> bool {
        self.is_off || self.is_start() || self.is_seized()
    }

    /// The samples that are known before this cycle.
    fn known(&self) -> ([u8; 2], [f64; 2]) {
        let was_stopped = matches!(self.before.node, Node::Stopped | Node::OffStopped);
        let is_new = was_stopped && self.inputs.reset;
        let is_kept = self.before.is_idle && (self.is_off || !is_new);
        if is_kept { (self.before.samples, self.before.velocities) } else { ([0; 2], [0.0; 2]) }
    }

    /// Cycles in a row with a sample of the actual velocity, and with a slow one, this one included.
    #[must_use]
    pub fn samples(&self) -> [u8; 2] {
        let ([samples, slow], _) = self.known();
        let v = self.inputs.v_actual;
        if !is_number(v) {
            return [0; 2];
        }
        let is_slow = v.abs() <= self.coeffs.v_position_control_on + self.coeffs.window;
        [(samples + 1).min(3), if is_slow { (slow + 1).min(3) } else { 0 }]
    }

    /// With what the spindle turns, by the last three samples; 0 within the window. None without a sample.
    #[must_use]
    pub fn turning(&self) -> Option<f64> {
        let ([samples, _], velocities) = self.known();
        let v = self.inputs.v_actual;
        if !is_number(v) {
            return None;
        }
        let mut three = match samples {
            0 => [v; 3],
            _ => [velocities[0], velocities[1], v],
        };
        three.sort_by(f64::total_cmp);
        Some(if three[1].abs() <= self.coeffs.window { 0.0 } else { three[1] })
    }

    /// Whether the block takes hold of a spindle that turns slowly.
    #[must_use]
    pub fn moves(&self) -> bool {
        self.may_begin() && self.turning().is_some_and(|v| v != 0.0)
    }

    /// Whether the block may take hold of the spindle for position control.
    #[must_use]
    pub fn may_begin(&self) -> bool {
        self.is_start() && self.samples()[1] >= 3 && is_place(self.inputs.x_actual)
    }

    /// Whether the spindle turns too fast for position control, and is caught.
    #[must_use]
    pub fn is_too_fast(&self) -> bool {
        let end = self.coeffs.v_position_control_on + self.coeffs.window;
        let is_known = self.samples()[0] >= 3 && is_place(self.inputs.x_actual);
        self.is_start() && is_known && self.turning().is_some_and(|v| v.abs() > end)
    }

    /// What the rules need in the next cycle.
    fn remember(&mut self, then: Node) {
        let Self { inputs, outputs, inside, coeffs, .. } = *self;
        let stays = then == inside;
        let settled = if stays { self.settled().min(3) } else { 0 };
        let is_missing = self.missing() != 0;
        let missing = if is_missing && stays { self.before.missing + 1 } else { 0 };
        let (samples, turning) = (self.samples(), self.turning());
        let (_, velocities) = self.known();
        let moves = self.is_start() && stays && self.moves();
        let waited = if stays && !moves { self.cycles().min(SLOW_BRAKE_CYCLES + 2) } else { 0 };
        let is_held = moves || self.is_seized() || !matches!(then, Node::ToPosition | Node::Stopped);
        let is_idle = self.is_off || self.before.is_idle && !is_held;
        let looks = self.looks() && is_idle;
        let is_answered = !coeffs.in_drive || inputs.operation_mode_display == coeffs.velocity_mode;
        let is_caught = match inside {
            _ if self.is_off => false,
            Node::ToPosition if self.is_start() => then == Node::Brake,
            Node::Stopped if self.is_seized() => {
                outputs.operation_mode == coeffs.velocity_mode && self.after.block.asks_velocity
            }
            Node::Brake => self.before.is_caught && !is_answered && then != Node::ToPosition,
            _ => self.before.is_caught,
        };
        let is_free = |node| matches!(node, Node::ToVelocity | Node::Velocity);
        let after = &mut self.after;
        after.node = then;
        after.waited = waited;
        after.settled = settled;
        after.missing = missing;
        after.held = [inputs.m3, inputs.m4, inputs.m5, inputs.m19, inputs.putax, inputs.g74];
        after.is_first = false;
        after.is_idle = is_idle;
        after.is_caught = is_caught;
        if looks && turning.is_some() {
            let before = if samples[0] > 1 { velocities[1] } else { inputs.v_actual };
            (after.samples, after.velocities) = (samples, [before, inputs.v_actual]);
        } else if looks || !is_idle {
            (after.samples, after.velocities) = ([0; 2], [0.0; 2]);
        }
        after.was_reset = (inputs.reset || after.was_reset) && is_free(inside) && is_free(then);
        after.takes_over = match then {
            Node::Position => inside != then || is_missing,
            Node::ToVelocity => is_missing,
            _ => false,
        };
        let leaves = inside == Node::Brake && then == Node::ToPosition || moves;
        after.x_start = leaves.then_some(inputs.x_actual + outputs.v_spindle * coeffs.lead_time);
        after.last = self.transitions.into_iter().flatten().last().or(after.last);
        after.block.jobs = 0;
    }
}

/// What the block is doing in this cycle, by docs/spindle.md, (3) and (4), from what it was doing after (2).
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
