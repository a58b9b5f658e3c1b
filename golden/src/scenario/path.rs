//! Scenarios of path axes: moves, dwell, feedforward. The axis follows with the lag of its position controller. No spindle.

use super::in_loop::{InLoop, Run, perform_all};
use super::notes::Note;
use super::{Options, Scenario, program_axis, refused};
use crate::drive::AxisDrive;
use generator::blocks::{Block, Designed};
use generator::codes;
use machine::drive::Setup;
use machine::grid::{position, rate};
use machine::profile::{self, Limits, Mover};
use machine::{Machine, Measured};
use nc::{Axis, Command, Mistake, Program, Target};
use std::collections::BTreeMap;

/// um in 1 mm.
const MM: f64 = 1000.0;
/// Distance of the axis from the end of a move at which the next block begins [um].
const POSITION_WINDOW: f64 = 10.0;
/// Gain of the position controller of an axis without a stated one [1/s].
const KV: f64 = 20.0;
/// Times in which the largest velocity, and the largest acceleration, are reached [s].
const RISE_TIME: f64 = 0.2;
const JERK_TIME: f64 = 0.05;
/// Velocity of homing, as a part of the largest velocity.
const HOMING: f64 = 0.1;
/// Shorter distances are ignored [um].
const SHORTEST: f64 = 1e-3;
/// Time within which an axis must reach the end of a move [s].
const LATEST: f64 = 60.0;

/// Runs a program.
pub(super) fn run(
    program: &Program,
    designed: &Designed,
    block: &Block,
    options: &Options,
) -> Result<Scenario, Mistake> {
    let mut notes = Vec::new();
    let axis = program_axis::of(program, &designed.axis.name, options, &mut notes)?;
    let kv = designed.axis.control.position_control.as_ref().map_or(KV, |control| f64::from(control.kv) / 100.0);
    let drive = AxisDrive::of(designed, Setup { delay: 1.0, ..Setup::DELAY_AND_LAG }, kv);
    let run = Run::start(designed, block, &drive.model, options.cycles);
    let mut scenario = perform_all(Closed::start(axis, run, &drive), program)?;
    scenario.notes.append(&mut notes);
    Ok(scenario)
}

/// The loop: program, interpolator, block, drive.
struct Closed<'d> {
    run: Run<'d>,
    axis: Axis,
    limits: Limits,
    cycle: f64,
    kv: f64,
    /// end of the last move [um, 0.001 deg]; 0 for an axis that has not moved
    place: BTreeMap<Axis, f64>,
    machine: Box<dyn Machine>,
    actual: Measured,
}

impl<'d> Closed<'d> {
    fn start(axis: Axis, run: Run<'d>, drive: &AxisDrive) -> Self {
        let of = &run.designed.axis;
        let (cycle, velocity) = (of.cycle_time(), of.ipc.v_max);
        let acceleration = velocity / RISE_TIME;
        Self {
            run,
            axis,
            limits: Limits { velocity, acceleration, jerk: acceleration / JERK_TIME },
            cycle,
            kv: drive.position_gain,
            place: BTreeMap::new(),
            machine: drive.machine(),
            actual: Measured::default(),
        }
    }
}

impl<'d> InLoop<'d> for Closed<'d> {
    fn perform(&mut self, command: &Command, line: usize) -> Result<(), Mistake> {
        match command {
            Command::Feedforward { target: Target::Axes, on } => {
                self.run.subject.set("feedforward_active", f64::from(u8::from(*on)));
                self.hold(line)
            }
            Command::Percentage { target: Target::Axis(axis), percent } if *axis == self.axis => {
                self.run.subject.set("feedforward_percentage", f64::from(*percent));
                self.hold(line)
            }
            Command::Dwell { seconds } => self.dwell(*seconds, line),
            Command::Move { axes, feed_mm_min, .. } => {
                // Without a feed it acts as G00.
                let feed = feed_mm_min.map_or(self.limits.velocity, |feed| feed * MM / 60.0);
                self.travel(axes, feed, line)
            }
            Command::Home { target: Target::Axis(axis) } => {
                self.travel(&[(*axis, 0.0)], self.limits.velocity * HOMING, line)
            }
            Command::Turn { .. } | Command::Stop { .. } | Command::Position { .. } => {
                self.run.other.push(line);
                Ok(())
            }
            // Commands to spindles, and to other axes.
            Command::Feedforward { .. } | Command::Percentage { .. } => Ok(()),
            Command::Home { .. } | Command::Release { .. } | Command::End => Ok(()),
        }
    }

    fn hold(&mut self, line: usize) -> Result<(), Mistake> {
        self.cycle(profile::Sample { x: self.own(), ..Default::default() }, line)
    }

    fn notes(&self) -> Vec<Note> {
        let allowed =
            format!(" above vb_max (P-AXIS-00212), {} mm/min: limited to it", self.limits.velocity * 60.0 / MM);
        let rest = " of a spindle passed over: this is the scenario of an axis";
        let limited = self.run.limited.note(codes::NC_LIMITED, "feed", &allowed, "a lower feed, or another vb_max");
        let other =
            self.run.other.note(codes::NC_OTHER_DRIVE, "command", rest, "a scenario of its own for the spindle");
        limited.into_iter().chain(other).collect()
    }

    fn run(&self) -> &Run<'d> {
        &self.run
    }

    fn into_run(self) -> Run<'d> {
        self.run
    }
}

impl Closed<'_> {
    /// A straight line, of which the axis has a component. The feed is that of X, Y and Z, and the other axes follow; if
    /// none of these three moves, it is that of the others.
    fn travel(&mut self, axes: &[(Axis, f64)], feed: f64, line: usize) -> Result<(), Mistake> {
        let start = self.own();
        let mut ways = BTreeMap::new();
        for (axis, mm) in axes {
            let end = mm * MM;
            ways.insert(*axis, end - self.place.insert(*axis, end).unwrap_or_default());
        }
        let length = |is_of_path| {
            let ways = ways.iter().filter(|(axis, _)| axis.is_of_path() == is_of_path);
            libm::sqrt(ways.map(|(_, way)| way * way).fold(0.0, |sum, square| sum + square))
        };
        let length = Some(length(true)).filter(|length| *length > SHORTEST).unwrap_or_else(|| length(false));
        if length > SHORTEST {
            let part = ways.get(&self.axis).map_or(0.0, |way| way / length);
            self.along(length, part, start, feed, line)?;
        }
        self.arrive(line)
    }

    /// A path of a length, of which the axis has a component.
    fn along(&mut self, length: f64, part: f64, start: f64, feed: f64, line: usize) -> Result<(), Mistake> {
        let failed = |error: profile::Error| {
            let instead = "another feed, or another vb_max (P-AXIS-00212)";
            refused(line, error.to_string(), "what the interpolator can do", instead)
        };
        // An axis that is faster than the path has its own limits.
        let share = if part.abs() > 1.0 { 1.0 / part.abs() } else { 1.0 };
        let Limits { velocity, acceleration, jerk } = self.limits;
        let limits = Limits { velocity: velocity * share, acceleration: acceleration * share, jerk: jerk * share };
        // G00 asks for vb_max, for any component.
        let is_rapid = (feed - velocity).abs() == 0.0;
        if feed > limits.velocity && !is_rapid {
            self.run.limited.push(line);
        }
        let mut mover = Mover::at(limits, self.cycle, 0.0, 0.0).map_err(failed)?;
        let feed = if feed > limits.velocity { limits.velocity } else { feed };
        mover.go(length, feed).map_err(failed)?;
        while !mover.is_done() && !self.run.is_full() {
            let profile::Sample { x, v, a, j } = mover.next();
            self.cycle(profile::Sample { x: start + x * part, v: v * part, a: a * part, j: j * part }, line)?;
        }
        Ok(())
    }

    /// Waits until the axis is at the end of its move.
    fn arrive(&mut self, line: usize) -> Result<(), Mistake> {
        let end = self.own();
        let latest = self.run.subject.inputs.len() as f64 + LATEST / self.cycle;
        while (self.actual.x - end).abs() > POSITION_WINDOW && !self.run.is_full() {
            if self.run.subject.inputs.len() as f64 > latest {
                let found =
                    format!("an axis that is not within {POSITION_WINDOW} um of the end of its move after {LATEST} s");
                return Err(refused(line, found, "an axis that follows", "a higher Kv, or other parameters"));
            }
            self.hold(line)?;
        }
        Ok(())
    }

    /// The commanded end position of the axis.
    fn own(&self) -> f64 {
        self.place.get(&self.axis).copied().unwrap_or_default()
    }

    /// One cycle with a command: block, then the axis.
    fn cycle(&mut self, command: profile::Sample, line: usize) -> Result<(), Mistake> {
        let x_command = position(command.x);
        let error = x_command - self.actual.x;
        // With position control in the drive SET_POINT takes the planned velocity.
        let in_cnc = self.run.designed.axis.control.commands_by_position();
        let v_command = if in_cnc { self.kv * error } else { command.v };
        let inputs = [
            ("x_command", x_command),
            ("v_interpolator", rate(command.v)),
            ("v_command", rate(v_command)),
            ("a_interpolator", rate(command.a)),
            ("j_interpolator", rate(command.j)),
            ("x_actual", position(self.actual.x)),
            ("v_motor", rate(self.actual.v_motor)),
            ("v_direct", rate(self.actual.v_load)),
            ("position_controlled", 1.0),
        ];
        self.run.cycle(&inputs, command.a != 0.0, line)?;
        let subject = &self.run.subject;
        let v = self.kv * error + subject.get("v_feedforward") + subject.get("v_add");
        self.actual = self.machine.step(v);
        Ok(())
    }
}
