//! The velocities that the stages use, and their changes since the previous cycle, computed once for all stages. No section.
#![expect(clippy::needless_range_loop, reason = "the portable subset has one way to go through an array")]

use super::signals::{Inputs, STAGES};
use crate::section::is_driven_by_change;
use crate::signal::sample_limit;
use crate::{change, stage};
use portable::{Real, in_range, portable};

/// State: the velocities of the previous cycle.
#[portable]
#[derive(Clone, Copy, Debug, Default)]
pub struct State<R> {
    /// the command velocity
    pub v_command: change::State<R>,
    /// the motor's velocity
    pub v_motor: change::State<R>,
    /// the velocity of the direct measuring system
    pub v_direct: change::State<R>,
}

/// The changes.
#[portable]
#[derive(Clone, Copy, Debug, Default)]
pub struct Changes<R> {
    /// of the command velocity
    pub v_command: R,
    /// of the motor's velocity
    pub v_motor: R,
    /// of the velocity of the direct measuring system
    pub v_direct: R,
}

/// Whether a stage simulates the oscillation.
#[portable]
pub fn simulates<R: Real>(stages: &[stage::Coeffs<R>; STAGES]) -> bool {
    let mut found = false;
    for i in 0..STAGES {
        found = found || stages[i].mode != stage::Mode::NotActive && stages[i].mode != stage::Mode::Direct;
    }
    found
}

/// Whether a stage uses the command velocity.
#[portable]
pub fn reads_command<R: Real>(stages: &[stage::Coeffs<R>; STAGES]) -> bool {
    let mut found = false;
    for i in 0..STAGES {
        found = found || stage::reads_command(&stages[i]);
    }
    found
}

/// Whether a stage uses the motor's velocity.
#[portable]
pub fn reads_motor<R: Real>(stages: &[stage::Coeffs<R>; STAGES]) -> bool {
    let mut found = false;
    for i in 0..STAGES {
        found = found || stage::reads_motor(&stages[i]);
    }
    found
}

/// Whether a stage uses the velocity of the direct measuring system.
#[portable]
pub fn reads_direct<R: Real>(stages: &[stage::Coeffs<R>; STAGES]) -> bool {
    let mut found = false;
    for i in 0..STAGES {
        found = found || stage::reads_direct(&stages[i]);
    }
    found
}

/// Whether every velocity that a stage uses is in range.
#[portable]
pub fn are_in_range<R: Real>(stages: &[stage::Coeffs<R>; STAGES], inputs: &Inputs<R>) -> bool {
    (!reads_command(stages) || in_range(inputs.v_command, sample_limit()))
        && (!reads_motor(stages) || in_range(inputs.v_motor, sample_limit()))
        && (!reads_direct(stages) || in_range(inputs.v_direct, sample_limit()))
}

/// Computes the changes of the velocities that the stages use. Single precision needs them; ride-through needs the stored last
/// good velocities.
#[portable]
pub fn step<R: Real>(
    state: &mut State<R>,
    stages: &[stage::Coeffs<R>; STAGES],
    rides_through: bool,
    inputs: &Inputs<R>,
    changes: &mut Changes<R>,
) {
    if is_driven_by_change::<R>() || rides_through {
        if reads_command(stages) {
            changes.v_command = change::step(&mut state.v_command, inputs.v_command);
        }
        if reads_motor(stages) {
            changes.v_motor = change::step(&mut state.v_motor, inputs.v_motor);
        }
        if reads_direct(stages) {
            changes.v_direct = change::step(&mut state.v_direct, inputs.v_direct);
        }
    }
}

/// The next changes are relative to the present input.
#[portable]
pub fn preset<R: Real>(
    state: &mut State<R>,
    stages: &[stage::Coeffs<R>; STAGES],
    rides_through: bool,
    inputs: &Inputs<R>,
) {
    if is_driven_by_change::<R>() || rides_through {
        if reads_command(stages) {
            change::preset(&mut state.v_command, inputs.v_command);
        }
        if reads_motor(stages) {
            change::preset(&mut state.v_motor, inputs.v_motor);
        }
        if reads_direct(stages) {
            change::preset(&mut state.v_direct, inputs.v_direct);
        }
    }
}
