//! The blocks of a program one after the other, on an axis in its loop: until the program or the scenario ends.

use super::notes::Note;
use super::{MOST, Scenario, Step, refused};
use crate::drive::{AtLimit, Oscillation, margins};
use crate::subject::Subject;
use generator::axis::{DriveModel, Enable};
use generator::blocks::Designed;
use generator::codes;
use nc::{Command, Mistake, Program};

/// Within which a limit is one in single precision.
const ROUNDING: f64 = 1e-6;

/// An axis in its loop.
pub(super) trait InLoop {
    /// Does what a command asks for; is back when that is done, or when the scenario is full.
    fn perform(&mut self, command: &Command, line: usize) -> Result<(), Mistake>;

    /// Some cycles without a command.
    fn rest(&mut self, line: usize) -> Result<(), Mistake>;

    /// What of the program does not act as it says.
    fn notes(&self) -> Vec<Note>;

    fn designed(&self) -> &Designed;

    fn subject(&self) -> &Subject;

    fn at_limit(&mut self) -> &mut AtLimit;

    /// The scenario is full with this number of cycles.
    fn most(&self) -> usize;

    fn is_full(&self) -> bool {
        self.subject().inputs.len() >= self.most()
    }

    /// Looks at the outputs of a cycle, which is part of a ramp or not.
    ///
    /// # Errors
    /// The block has an error.
    fn look(&mut self, is_ramp: bool, line: usize) -> Result<(), Mistake> {
        let subject = self.subject();
        if subject.get("fault") != 0.0 {
            let found =
                format!("error {} of the block at sample {}", subject.get("error_id"), subject.inputs.len() - 1);
            let instead = "other parameters, or another program; `axgen explain` says what the error means";
            return Err(refused(line, found, "a scenario without an error", instead));
        }
        let limit = self.designed().axis.ipc.limit() * (1.0 - ROUNDING);
        let is_limited = subject.get("v_add") != 0.0 && subject.get("v_add_calculated").abs() >= limit;
        self.at_limit().count(is_ramp, is_limited);
        Ok(())
    }
}

/// Whether `v_add` acts in a loop that is stable with that drive: the block starts ON, and puts `v_add` out.
pub(super) fn is_stable(designed: &Designed, subject: &Subject, drive: &DriveModel) -> bool {
    let acts = designed.axis.ipc.enable == Enable::On && subject.output("v_add").is_some();
    !acts || margins::margins(designed, drive).stable
}

/// Runs a program, between rests, in a loop that is stable or not.
pub(super) fn perform_all(closed: &mut impl InLoop, program: &Program, is_stable: bool) -> Result<Scenario, Mistake> {
    let steps = steps(closed, program).map_err(|mistake| if is_stable { mistake } else { oscillates(mistake) })?;
    let mut notes = closed.notes();
    if closed.is_full() {
        notes.push(stopped(closed, program, &steps));
    }
    let oscillation = Oscillation { is_stable, at_limit: closed.at_limit().time() };
    let Subject { inputs, outputs, .. } = closed.subject();
    Ok(Scenario { inputs: inputs.clone(), outputs: outputs.clone(), steps, notes, oscillation })
}

/// When each block acted, until the scenario is full.
fn steps(closed: &mut impl InLoop, program: &Program) -> Result<Vec<Step>, Mistake> {
    closed.rest(program.blocks.first().map_or(1, |block| block.line))?;
    let mut steps: Vec<Step> = Vec::with_capacity(program.blocks.len());
    for block in &program.blocks {
        if closed.is_full() {
            return Ok(steps);
        }
        let from = closed.subject().inputs.len();
        block.commands.iter().try_for_each(|command| closed.perform(command, block.line))?;
        steps.push(Step { line: block.line, number: block.number, from, to: closed.subject().inputs.len() });
    }
    if !closed.is_full() {
        closed.rest(steps.last().map_or(1, |step| step.line))?;
    }
    Ok(steps)
}

/// A mistake in a loop that oscillates, which may be why.
fn oscillates(mistake: Mistake) -> Mistake {
    let instead = "weights with which the loop is stable: it is not, and `axgen analyze` prints the largest ones";
    Mistake { instead: instead.to_owned(), ..mistake }
}

/// That the program is longer than its scenario.
fn stopped(closed: &impl InLoop, program: &Program, steps: &[Step]) -> Note {
    let line = steps.last().map_or(1, |step| step.line);
    let last = program.blocks.last().map_or(line, |block| block.line);
    let cycles = closed.most();
    let seconds = cycles as f64 * closed.designed().axis.cycle_time();
    let found = format!(
        "a program that goes on: the scenario stops after {cycles} cycles, {seconds:.3} s, in line {line} of {last}"
    );
    let instead = format!("--cycles with more of them, up to {MOST}, or a shorter program");
    Note::new(codes::NC_STOPPED, line, found, instead)
}
