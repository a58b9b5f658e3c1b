//! Ride-through of consecutive bad samples: the last good sample replaces each of them. Not a fault.

use super::signals::{Inputs, STAGES};
use super::sources::{self, are_in_range, reads_command, reads_direct, reads_motor};
use crate::{signal::sample_limit, stage};
use portable::{Real, copy, in_range, portable};

/// Coefficients.
#[portable]
#[derive(Clone, Copy, Debug, Default)]
pub struct Coeffs {
    /// whether the last good sample replaces bad samples (key ride_through)
    pub active: bool,
    /// largest number of consecutive cycles in which the last good sample replaces a bad one
    pub cycles: u32,
}

/// State.
#[portable]
#[derive(Clone, Copy, Debug, Default)]
pub struct State {
    /// consecutive cycles in which a sample was bad
    pub bad: u32,
}

/// Before the first cycle.
#[portable]
pub fn init(state: &mut State) {
    state.bad = 0u32;
}

/// Copies the inputs. A velocity that is out of range is replaced by that of the previous cycle, for at most as many
/// consecutive cycles as the coefficients allow; `is_remembered`: a previous velocity exists. Returns whether a sample was
/// replaced.
#[portable]
pub fn replace<R: Real>(
    state: &mut State,
    coeffs: &Coeffs,
    stages: &[stage::Coeffs<R>; STAGES],
    source: &sources::State<R>,
    is_remembered: bool,
    inputs: &Inputs<R>,
    replaced: &mut Inputs<R>,
) -> bool {
    copy!(replaced = inputs:
        v_command, v_motor, v_direct, tuning_weight, tuning_limit, mode, position_controlled, reset, task_cycle_ns);
    let mut held = false;
    if are_in_range(stages, inputs) {
        state.bad = 0u32;
    } else if is_remembered && state.bad < coeffs.cycles {
        state.bad += 1u32;
        held = true;
        if reads_command(stages) && !in_range(inputs.v_command, sample_limit()) {
            replaced.v_command = source.v_command.before;
        }
        if reads_motor(stages) && !in_range(inputs.v_motor, sample_limit()) {
            replaced.v_motor = source.v_motor.before;
        }
        if reads_direct(stages) && !in_range(inputs.v_direct, sample_limit()) {
            replaced.v_direct = source.v_direct.before;
        }
    }
    held
}
