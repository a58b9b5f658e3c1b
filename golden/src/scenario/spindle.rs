//! Scenarios of the blocks `spindle` and `spindle_axis`: the commands of spindle 1, each until it is finished. No path axis.

use super::in_loop::{InLoop, Run, perform_all};
use super::notes::Note;
use super::spindle_machine::{self, Machine};
use super::{Options, Scenario, refused};
use generator::axis::{Axis, Spindle};
use generator::blocks::{Block, Designed};
use generator::codes;
use machine::grid::{angle, shortest};
use machine::profile;
use machine::spindle::interpolator::{Job, Seen, State};
use nc::{Command, Direction, Mistake, Program, Target};
use portable::Extreme;

/// 0.001 deg/s in 1 rpm.
const RPM: f64 = 6000.0;
/// The position of the spindle at the start [0.001 deg].
const START: f64 = 10_000.0;
/// Distance of the actual position from the target at which a job is done [0.001 deg].
const POSITION_WINDOW: f64 = 100.0;
/// Distance of the actual velocity from the speed at which it is reached: a part of the speed, at least 1 rpm.
const SPEED_WINDOW: f64 = 0.01;
/// Speed of M19 without an S word, if the velocity of position control is 0 [0.001 deg/s].
const SLOW: f64 = 300_000.0;

/// Runs a program.
pub(super) fn run(
    program: &Program,
    designed: &Designed,
    block: &Block,
    options: &Options,
) -> Result<Scenario, Mistake> {
    let axis = &designed.axis;
    let line = program.blocks.first().map_or(1, |block| block.line);
    let Some(spindle) = &axis.control.spindle else {
        let found = format!("axis `{}` does not change over", axis.name);
        return Err(refused(line, found, "an axis with the block `spindle`", "another axis"));
    };
    let run = Run::start(designed, block, &Machine::model(axis, spindle), options.cycles);
    let closed = Closed::start(spindle, run).map_err(|error| no_motion(line, &error))?;
    perform_all(closed, program)
}

fn no_motion(line: usize, error: &profile::Error) -> Mistake {
    refused(line, error.to_string(), "what the interpolator can do", "other speeds, or another vb_max (P-AXIS-00212)")
}

/// The loop: program, interpolator, block, drive.
struct Closed<'a> {
    run: Run<'a>,
    axis: &'a Axis,
    spindle: &'a Spindle,
    machine: Machine<'a>,
    /// G135, and the percentage of G136
    feedforward: [f64; 2],
    is_done: bool,
    /// velocity of the previous cycle
    v_before: f64,
    /// cycles up to the last request
    requested: usize,
}

impl<'a> Closed<'a> {
    fn start(spindle: &'a Spindle, mut run: Run<'a>) -> Result<Self, profile::Error> {
        run.subject.set("drive_on", 1.0);
        let axis = &run.designed.axis;
        let machine = Machine::start(axis, spindle, START)?;
        Ok(Self { run, axis, spindle, machine, feedforward: [0.0, 100.0], is_done: false, v_before: 0.0, requested: 0 })
    }
}

impl<'a> InLoop<'a> for Closed<'a> {
    fn perform(&mut self, command: &Command, line: usize) -> Result<(), Mistake> {
        match *command {
            Command::Feedforward { target: Target::Spindle(1), on } => self.feedforward[0] = f64::from(u8::from(on)),
            Command::Percentage { target: Target::Spindle(1), percent } => self.feedforward[1] = f64::from(percent),
            Command::Turn { direction, rpm, .. } => {
                let speed = self.speed(rpm, line);
                let is_negative = direction == Direction::Negative;
                self.request(if is_negative { &["m4"] } else { &["m3"] }, speed, 0.0, Job::Turn, line)?;
                let v = if is_negative { -speed } else { speed };
                while !self.turns(v) && !self.run.is_full() {
                    self.cycle(line)?;
                }
            }
            Command::Stop { .. } => {
                self.request(&["m5"], 0.0, 0.0, Job::Stop, line)?;
                while !self.turns(0.0) && !self.run.is_full() {
                    self.cycle(line)?;
                }
            }
            Command::Position { direction, rpm, degrees, .. } => {
                self.position(direction, rpm, degrees, line)?;
            }
            Command::Home { target: Target::Spindle(1) } => {
                self.request(&["g74"], 0.0, 0.0, Job::Home, line)?;
                self.until_done(line)?;
            }
            Command::Release { spindle: 1 } => {
                self.request(&["putax"], 0.0, 0.0, Job::Release, line)?;
                self.until_done(line)?;
            }
            Command::Dwell { seconds } => self.dwell(seconds, line)?,
            Command::Move { .. } | Command::Home { target: Target::Axis(_) } => self.run.other.push(line),
            // Commands to other spindles, and to path axes.
            Command::Feedforward { .. } | Command::Percentage { .. } => {}
            Command::Home { .. } | Command::Release { .. } | Command::End => {}
        }
        Ok(())
    }

    fn hold(&mut self, line: usize) -> Result<(), Mistake> {
        self.cycle(line)
    }

    fn notes(&self) -> Vec<Note> {
        let allowed = format!(" above vb_max (P-AXIS-00212), {} rpm: limited to it", self.axis.ipc.v_max / RPM);
        let rest = " of path axes passed over, which take no time: this is the scenario of a spindle";
        let limited = self.run.limited.note(codes::NC_LIMITED, "speed", &allowed, "a lower speed, or another vb_max");
        let other = self.run.other.note(codes::NC_OTHER_DRIVE, "motion", rest, "a scenario of its own for the axis");
        limited.into_iter().chain(other).collect()
    }

    fn run(&self) -> &Run<'a> {
        &self.run
    }

    fn into_run(self) -> Run<'a> {
        self.run
    }
}

impl Closed<'_> {
    /// M19: without a direction the present one, at rest the shorter way; without a speed that of position control.
    fn position(
        &mut self,
        direction: Option<Direction>,
        rpm: Option<f64>,
        degrees: f64,
        line: usize,
    ) -> Result<(), Mistake> {
        let off = f64::from(self.spindle.v_position_control_on);
        let speed = match rpm {
            Some(rpm) => self.speed(rpm, line),
            None if off > 0.0 => off,
            None => SLOW,
        };
        if speed == 0.0 {
            let instead = "`M19` with another speed, or without one";
            return Err(refused(line, "`M19` with the speed 0", "a speed above 0", instead));
        }
        let target = angle(degrees * 1000.0);
        let v = self.run.subject.get("v_spindle");
        let is_negative = match direction {
            Some(direction) => direction == Direction::Negative,
            None if v == 0.0 => shortest(target - self.machine.actual.x) < 0.0,
            None => v < 0.0,
        };
        self.request(if is_negative { &["m19", "m4"] } else { &["m19", "m3"] }, speed, target, Job::Orient, line)?;
        self.until_done(line)
    }

    /// A speed, limited to the largest one of the axis [0.001 deg/s].
    fn speed(&mut self, rpm: f64, line: usize) -> f64 {
        let (speed, largest) = (rpm * RPM, self.axis.ipc.v_max);
        if speed > largest {
            self.run.limited.push(line);
            return largest;
        }
        speed
    }

    /// Sets a request for one cycle, and waits until it is the job. A request is an edge: before it is a cycle without one.
    fn request(&mut self, inputs: &[&str], speed: f64, target: f64, job: Job, line: usize) -> Result<(), Mistake> {
        if self.requested == self.run.subject.inputs.len() {
            self.cycle(line)?;
        }
        let number = self.run.subject.get("job_number");
        for input in inputs {
            self.run.subject.set(input, 1.0);
        }
        self.run.subject.set("s_word", speed);
        self.run.subject.set("s_position", target);
        self.cycle(line)?;
        self.requested = self.run.subject.inputs.len();
        for input in inputs.iter().chain(&["s_word", "s_position"]) {
            self.run.subject.set(input, 0.0);
        }
        while self.run.subject.get("job_number") <= number
            || self.run.subject.get("waiting") > 0.0
            || self.seen().job != job
        {
            if self.run.is_full() {
                break;
            }
            self.cycle(line)?;
        }
        Ok(())
    }

    fn until_done(&mut self, line: usize) -> Result<(), Mistake> {
        loop {
            self.cycle(line)?;
            if self.is_done || self.run.is_full() {
                return Ok(());
            }
        }
    }

    /// Whether a speed is reached without a pending change of the state.
    fn turns(&self, v: f64) -> bool {
        let is_fast = v.abs() > f64::from(self.spindle.v_velocity_control_on);
        let is_there = match self.seen().state {
            State::Position => !is_fast,
            State::Velocity => true,
            _ => false,
        };
        let window = (v.abs() * SPEED_WINDOW).larger(RPM);
        is_there && (self.machine.actual.v - v).abs() <= window && (self.run.subject.get("v_spindle") - v).abs() < 1.0
    }

    /// One cycle: actual values, interpolator, block, drive.
    fn cycle(&mut self, line: usize) -> Result<(), Mistake> {
        let commanded = self.machine.next(&self.seen()).map_err(|error| no_motion(line, &error))?;
        let actual = self.machine.actual;
        let is_near = shortest(commanded.x - actual.x).abs() <= POSITION_WINDOW;
        self.is_done = commanded.is_done && is_near;
        let inputs = [
            ("x_command", commanded.x),
            ("v_interpolator", commanded.v),
            ("job_done", f64::from(u8::from(self.is_done))),
            ("x_actual", actual.x),
            ("v_actual", actual.v),
            ("v_motor", actual.v),
            ("v_direct", actual.v),
            ("operation_mode_display", f64::from(actual.mode)),
            ("feedforward_active", self.feedforward[0]),
            ("feedforward_percentage", self.feedforward[1]),
        ];
        self.run.cycle(&inputs, commanded.v.to_bits() != self.v_before.to_bits(), line)?;
        self.v_before = commanded.v;
        self.machine.obey(&|name| self.run.subject.output(name), self.feedforward);
        Ok(())
    }

    fn seen(&self) -> Seen {
        spindle_machine::seen(&|name| self.run.subject.output(name))
    }
}
