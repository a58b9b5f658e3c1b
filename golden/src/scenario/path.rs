//! Scenarios of path axes: moves, dwell, feedforward. The axis follows with the lag of its position controller. No spindle.

use super::{InLoop, Scenario, is_limited, is_stable, perform_all, refused};
use crate::drive::{AtLimit, AxisDrive};
use crate::subject::Subject;
use generator::blocks::{Block, Designed};
use machine::drive::Setup;
use machine::grid::{position, rate};
use machine::profile::{self, Limits, Mover};
use machine::{Machine, Measured};
use nc::{Axis, Command, Mistake, Program, Target};

/// um in 1 mm.
const MM: f64 = 1000.0;
/// How near the axis is to the end of a move, when the next block begins [um].
const POSITION_WINDOW: f64 = 10.0;
/// Gain of the position controller of an axis that says none [1/s].
const KV: f64 = 20.0;
/// Within which the largest velocity, and the largest acceleration, are there [s].
const RISE_TIME: f64 = 0.2;
const JERK_TIME: f64 = 0.05;
/// Homing is so much slower than the largest velocity.
const HOMING: f64 = 0.1;
/// Cycles before the first block and behind the last one.
const REST: usize = 20;

/// Runs a program.
pub(super) fn run(program: &Program, designed: &Designed, block: &Block) -> Result<Scenario, Mistake> {
    let of = &designed.axis;
    let line = program.blocks.first().map_or(1, |block| block.line);
    let axes = [("X", Axis::X), ("Y", Axis::Y), ("Z", Axis::Z)];
    let Some((_, axis)) = axes.into_iter().find(|(name, _)| of.name.eq_ignore_ascii_case(name)) else {
        let found = format!("axis `{}`, which NC programs do not have", of.name);
        return Err(refused(line, found, "an axis named X, Y or Z", "another name for the axis in its set"));
    };
    let kv = of.control.position_control.as_ref().map_or(KV, |control| f64::from(control.kv) / 100.0);
    let drive = AxisDrive::of(designed, Setup { delay: 1.0, ..Setup::DELAY_AND_LAG }, kv);
    let subject = Subject::start(designed, block);
    let is_stable = is_stable(designed, &subject, &drive.model);
    let mut closed = Closed::start(designed, axis, subject, &drive);
    perform_all(&mut closed, program, is_stable)
}

/// The loop: program, interpolator, block, drive.
struct Closed<'d> {
    designed: &'d Designed,
    axis: Axis,
    limits: Limits,
    cycle: f64,
    kv: f64,
    subject: Subject,
    /// end of the last move, of X, Y and Z [um]
    place: [f64; 3],
    machine: Box<dyn Machine>,
    actual: Measured,
    at_limit: AtLimit,
}

impl<'d> Closed<'d> {
    fn start(designed: &'d Designed, axis: Axis, subject: Subject, drive: &AxisDrive) -> Self {
        let of = &designed.axis;
        let (cycle, velocity) = (of.cycle_time(), of.ipc.v_max);
        let acceleration = velocity / RISE_TIME;
        Self {
            designed,
            axis,
            limits: Limits { velocity, acceleration, jerk: acceleration / JERK_TIME },
            cycle,
            kv: drive.model.position_gain.unwrap_or(KV),
            subject,
            place: [0.0; 3],
            machine: drive.machine(),
            actual: Measured::default(),
            at_limit: AtLimit::new(cycle),
        }
    }
}

impl InLoop for Closed<'_> {
    fn perform(&mut self, command: &Command, line: usize) -> Result<(), Mistake> {
        match command {
            Command::Feedforward { target: Target::Axes, on } => {
                self.subject.set("feedforward_active", f64::from(u8::from(*on)));
                self.cycle(profile::Sample { x: self.own(), ..Default::default() }, line)
            }
            Command::Percentage { target: Target::Axis(axis), percent } if *axis == self.axis => {
                self.subject.set("feedforward_percentage", f64::from(*percent));
                self.cycle(profile::Sample { x: self.own(), ..Default::default() }, line)
            }
            Command::Dwell { seconds } => {
                let end = seconds / self.cycle;
                let at = profile::Sample { x: self.own(), ..Default::default() };
                (0_u32..).take_while(|cycle| f64::from(*cycle) < end).try_for_each(|_| self.cycle(at, line))
            }
            Command::Move { axes, feed_mm_min, .. } => {
                // Without a feed it is G00.
                let feed = feed_mm_min.map_or(self.limits.velocity, |feed| feed * MM / 60.0);
                self.travel(axes, feed, line)
            }
            Command::Home { target: Target::Axis(axis) } => {
                self.travel(&[(*axis, 0.0)], self.limits.velocity * HOMING, line)
            }
            Command::Turn { .. } | Command::Stop { .. } | Command::Position { .. } => {
                let found = "a motion of a spindle in the scenario of an axis";
                Err(refused(line, found, "moves, dwell and feedforward", "a scenario of its own for the spindle"))
            }
            // Of spindles, and of other axes.
            Command::Feedforward { .. } | Command::Percentage { .. } => Ok(()),
            Command::Home { .. } | Command::Release { .. } | Command::End => Ok(()),
        }
    }

    fn rest(&mut self, line: usize) -> Result<(), Mistake> {
        let at = profile::Sample { x: self.own(), ..Default::default() };
        (0..REST).try_for_each(|_| self.cycle(at, line))
    }

    fn subject(&self) -> &Subject {
        &self.subject
    }

    fn at_limit(&self) -> &AtLimit {
        &self.at_limit
    }
}

impl Closed<'_> {
    /// A straight line, on which the axis has its part.
    fn travel(&mut self, axes: &[(Axis, f64)], feed: f64, line: usize) -> Result<(), Mistake> {
        let mut end = self.place;
        for (axis, mm) in axes {
            end[*axis as usize] = mm * MM;
        }
        let ways = [0, 1, 2].map(|axis| end[axis] - self.place[axis]);
        let length = libm::sqrt(ways.iter().map(|way| way * way).fold(0.0, |sum, square| sum + square));
        let (start, own) = (self.own(), self.axis as usize);
        if length > 0.0 {
            let failed = |error: profile::Error| {
                let instead = "another feed, or another vb_max (P-AXIS-00212)";
                refused(line, error.to_string(), "what the interpolator can do", instead)
            };
            if feed > self.limits.velocity {
                let allowed = format!("up to {} mm/min, vb_max (P-AXIS-00212)", self.limits.velocity * 60.0 / MM);
                let found = format!("a feed of {} mm/min", feed * 60.0 / MM);
                return Err(refused(line, found, allowed, "a lower feed, or another vb_max"));
            }
            let part = ways[own] / length;
            let mut mover = Mover::at(self.limits, self.cycle, 0.0, 0.0).map_err(failed)?;
            mover.go(length, feed).map_err(failed)?;
            while !mover.is_done() {
                let profile::Sample { x, v, a, j } = mover.next();
                self.cycle(profile::Sample { x: start + x * part, v: v * part, a: a * part, j: j * part }, line)?;
            }
        }
        self.place = end;
        let at = profile::Sample { x: self.own(), ..Default::default() };
        while (self.actual.x - at.x).abs() > POSITION_WINDOW {
            self.cycle(at, line)?;
        }
        Ok(())
    }

    /// Where the axis was sent.
    fn own(&self) -> f64 {
        self.place[self.axis as usize]
    }

    /// One cycle with a command: block, then the axis.
    fn cycle(&mut self, command: profile::Sample, line: usize) -> Result<(), Mistake> {
        let x_command = position(command.x);
        let error = x_command - self.actual.x;
        let inputs = [
            ("x_command", x_command),
            ("v_interpolator", rate(command.v)),
            ("v_command", rate(self.kv * error)),
            ("a_interpolator", rate(command.a)),
            ("j_interpolator", rate(command.j)),
            ("x_actual", position(self.actual.x)),
            ("v_motor", rate(self.actual.v_motor)),
            ("v_direct", rate(self.actual.v_load)),
            ("position_controlled", 1.0),
        ];
        for (name, value) in inputs {
            self.subject.set(name, value);
        }
        super::cycle(&mut self.subject, line)?;
        self.at_limit.count(command.a != 0.0, is_limited(self.designed, &self.subject));
        let v = self.kv * error + self.subject.get("v_feedforward") + self.subject.get("v_add");
        self.actual = self.machine.step(v);
        Ok(())
    }
}
