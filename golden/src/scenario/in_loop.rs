//! Runs the blocks of a program one after the other, on an axis in its loop, until the program or the scenario ends.

use super::notes::{Counted, Note};
use super::{MOST, Scenario, Step, refused};
use crate::drive::{AtLimit, Oscillation, margins};
use crate::subject::Subject;
use generator::axis::{DriveModel, Enable};
use generator::blocks::{Block, Designed};
use generator::codes;
use nc::{Command, Mistake, Program};

/// Tolerance for comparing limits in single precision.
const ROUNDING: f64 = 1e-6;
/// Cycles before the first block, and after the last one.
const REST: usize = 20;

/// The block of an axis in its loop, and the record of its cycles.
pub(super) struct Run<'d> {
    pub(super) designed: &'d Designed,
    pub(super) subject: Subject,
    /// feeds or speeds above vb_max
    pub(super) limited: Counted,
    /// commands to other drives
    pub(super) other: Counted,
    at_limit: AtLimit,
    is_stable: bool,
    /// maximum number of cycles of the scenario
    most: usize,
}

impl<'d> Run<'d> {
    /// The state before the first cycle, with the drive in the loop.
    pub(super) fn start(designed: &'d Designed, block: &Block, drive: &DriveModel, most: usize) -> Self {
        let subject = Subject::start(designed, block);
        // `v_add` acts if the block starts ON and has this output.
        let acts = designed.axis.ipc.enable == Enable::On && subject.output("v_add").is_some();
        Self {
            designed,
            subject,
            limited: Counted::default(),
            other: Counted::default(),
            at_limit: AtLimit::new(designed.axis.cycle_time()),
            is_stable: !acts || margins::margins(designed, drive).stable,
            most,
        }
    }

    pub(super) fn is_full(&self) -> bool {
        self.subject.inputs.len() >= self.most
    }

    /// One cycle with these inputs; `is_ramp` says whether it is part of a ramp.
    ///
    /// # Errors
    /// The block has an error.
    pub(super) fn cycle(&mut self, inputs: &[(&str, f64)], is_ramp: bool, line: usize) -> Result<(), Mistake> {
        let Self { subject, designed, at_limit, .. } = self;
        for (name, value) in inputs {
            subject.set(name, *value);
        }
        subject.step();
        if subject.get("fault") != 0.0 {
            let found =
                format!("error {} of the block at sample {}", subject.get("error_id"), subject.inputs.len() - 1);
            let instead = "other parameters, or another program; `axgen explain` says what the error means";
            return Err(refused(line, found, "a scenario without an error", instead));
        }
        let limit = designed.axis.ipc.limit() * (1.0 - ROUNDING);
        let is_limited = subject.get("v_add") != 0.0 && subject.get("v_add_calculated").abs() >= limit;
        at_limit.count(is_ramp, is_limited);
        Ok(())
    }
}

/// An axis in its loop.
pub(super) trait InLoop<'d> {
    /// Executes a command; returns when it is finished, or when the scenario is full.
    fn perform(&mut self, command: &Command, line: usize) -> Result<(), Mistake>;

    /// A cycle without a command.
    fn hold(&mut self, line: usize) -> Result<(), Mistake>;

    /// Notes about parts of the program that do not act as written.
    fn notes(&self) -> Vec<Note>;

    fn run(&self) -> &Run<'d>;

    /// The run after all cycles.
    fn into_run(self) -> Run<'d>;

    /// Cycles without a command for a time [s].
    fn dwell(&mut self, seconds: f64, line: usize) -> Result<(), Mistake> {
        let end = seconds / self.run().designed.axis.cycle_time();
        let mut cycles = 0_u32;
        while f64::from(cycles) < end && !self.run().is_full() {
            self.hold(line)?;
            cycles += 1;
        }
        Ok(())
    }
}

/// Runs a program, with rests before and after it.
pub(super) fn perform_all<'d>(mut closed: impl InLoop<'d>, program: &Program) -> Result<Scenario, Mistake> {
    let is_stable = closed.run().is_stable;
    let steps = steps(&mut closed, program).map_err(|mistake| if is_stable { mistake } else { oscillates(mistake) })?;
    let mut notes = closed.notes();
    let run = closed.into_run();
    if run.is_full() {
        notes.push(stopped(&run, program, &steps));
    }
    let oscillation = Oscillation { is_stable: Some(is_stable), at_limit: run.at_limit.time() };
    Ok(Scenario { inputs: run.subject.inputs, outputs: run.subject.outputs, steps, notes, oscillation })
}

/// The times of each block, until the scenario is full.
fn steps<'d>(closed: &mut impl InLoop<'d>, program: &Program) -> Result<Vec<Step>, Mistake> {
    rest(closed, program.blocks.first().map_or(1, |block| block.line))?;
    let mut steps: Vec<Step> = Vec::with_capacity(program.blocks.len());
    for block in &program.blocks {
        if closed.run().is_full() {
            return Ok(steps);
        }
        let from = closed.run().subject.inputs.len();
        block.commands.iter().try_for_each(|command| closed.perform(command, block.line))?;
        steps.push(Step { line: block.line, number: block.number, from, to: closed.run().subject.inputs.len() });
    }
    if !closed.run().is_full() {
        rest(closed, steps.last().map_or(1, |step| step.line))?;
    }
    Ok(steps)
}

fn rest<'d>(closed: &mut impl InLoop<'d>, line: usize) -> Result<(), Mistake> {
    (0..REST).try_for_each(|_| closed.hold(line))
}

/// An error in a loop that oscillates, which may be the cause.
fn oscillates(mistake: Mistake) -> Mistake {
    let instead = "weights with which the loop is stable: it is not, and `axgen analyze` prints the largest ones";
    Mistake { instead: instead.to_owned(), ..mistake }
}

/// The note that the program is longer than its scenario.
fn stopped(run: &Run<'_>, program: &Program, steps: &[Step]) -> Note {
    let line = steps.last().map_or(1, |step| step.line);
    let last = program.blocks.last().map_or(line, |block| block.line);
    let cycles = run.most;
    let seconds = cycles as f64 * run.designed.axis.cycle_time();
    let found = format!(
        "a program that goes on: the scenario stops after {cycles} cycles, {seconds:.3} s, in line {line} of {last}"
    );
    let instead = format!("--cycles with more of them, up to {MOST}, or a shorter program");
    Note::new(codes::NC_STOPPED, line, found, instead)
}
