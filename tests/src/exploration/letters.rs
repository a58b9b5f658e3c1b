//! The alphabet of the inputs: what can happen in one cycle next to what a cooperative drive and interpolator give. No search.

use super::drive::{POSITION_MODE, U, V_ON, VELOCITY_MODE};
use reference::spindle::{Inputs, State};

/// One thing that happens.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Act {
    /// m3
    M3,
    /// m4
    M4,
    /// m5
    M5,
    /// m19
    M19,
    /// putax
    Putax,
    /// g74
    G74,
    /// another s_word than 3 U
    Speed(f64),
    /// another s_position
    Target(f64),
    /// reset
    Reset,
    /// drive_on FALSE
    Off,
    /// the caller's cycle is another one
    WrongCycle,
    /// v_interpolator, whatever the job is
    Interpolator(f64),
    /// the interpolator stays at its velocity
    Hold,
    /// x_command is so far off
    Jump(f64),
    /// another v_actual
    Actual(f64),
    /// another x_command
    Command(f64),
    /// another x_actual
    Position(f64),
    /// job_done
    Done,
    /// another display
    Display(i32),
}

/// What happens in a cycle.
pub type Letter = &'static [Act];

/// Nothing but what should.
pub const QUIET: Letter = &[];

/// Reset and nothing else.
pub const RESET: Letter = &[Act::Reset];

/// Each request alone, with S below, at and above Von.
pub const REQUESTS: [Letter; 7] = [
    &[Act::M3, Act::Speed(U)],
    &[Act::M3, Act::Speed(V_ON)],
    &[Act::M3],
    &[Act::M5],
    &[Act::M19],
    &[Act::Putax],
    &[Act::G74],
];

/// Two requests for each kind of state: one for velocity control, one for position control.
pub const FEW_REQUESTS: [Letter; 3] = [&[Act::M3], &[Act::M5], &[Act::M19]];

/// The other direction.
pub const BACKWARD: [Letter; 2] = [&[Act::M4], &[Act::M19, Act::M4]];

/// Several requests at once, and such that are refused.
pub const REFUSED: [Letter; 11] = [
    &[Act::M3, Act::M4],
    &[Act::M19, Act::M3, Act::M4],
    &[Act::M5, Act::M3],
    &[Act::M19, Act::M5],
    &[Act::Putax, Act::M19],
    &[Act::G74, Act::Putax, Act::M19, Act::M5, Act::M3],
    &[Act::M3, Act::Speed(f64::NAN)],
    &[Act::M19, Act::Speed(1.1e15)],
    &[Act::M19, Act::Target(f64::INFINITY)],
    &[Act::M5, Act::Speed(f64::NAN)],
    &[Act::M3, Act::M4, Act::Interpolator(f64::NAN)],
];

/// Reset with what it has to win against, and what wins against it.
pub const RESETS: [Letter; 8] = [
    &[Act::Reset, Act::M3],
    &[Act::Reset, Act::Off],
    &[Act::Reset, Act::WrongCycle],
    &[Act::Reset, Act::Off, Act::WrongCycle],
    &[Act::Reset, Act::Interpolator(f64::NAN)],
    &[Act::Reset, Act::Display(0)],
    &[Act::Reset, Act::Actual(f64::NAN)],
    &[Act::Reset, Act::Jump(U)],
];

/// The drive is off, or the cycle is wrong.
pub const OFF: [Letter; 7] = [
    &[Act::Off],
    &[Act::Off, Act::Position(f64::NAN)],
    &[Act::WrongCycle],
    &[Act::Off, Act::WrongCycle],
    &[Act::Off, Act::M3],
    &[Act::Off, Act::M3, Act::M4],
    &[Act::WrongCycle, Act::M5],
];

/// A request in the cycle in which the drive goes off: with a full queue, too.
pub const OFF_AND_ASKED: [Letter; 1] = [&[Act::Off, Act::M5]];

/// Bad samples of each kind.
pub const SAMPLES: [Letter; 5] = [
    &[Act::Interpolator(f64::NAN)],
    &[Act::Command(f64::INFINITY)],
    &[Act::Actual(-1.1e15)],
    &[Act::Position(7.1e14)],
    &[Act::Interpolator(f64::NEG_INFINITY), Act::Command(f64::NAN), Act::Actual(f64::NAN), Act::Position(f64::NAN)],
];

/// Bad samples of what the drive measures.
pub const ACTUAL: [Letter; 2] = [&[Act::Actual(f64::INFINITY)], &[Act::Position(f64::NAN)]];

/// The interpolator does not do its job, or says that it has done it.
pub const INTERPOLATOR: [Letter; 6] = [
    &[Act::Hold],
    &[Act::Jump(U)],
    &[Act::Jump(U / 2.0)],
    &[Act::Interpolator(4.0 * U)],
    &[Act::Interpolator(3.0 * U)],
    &[Act::Done],
];

/// The display flickers.
pub const DISPLAY: [Letter; 3] = [&[Act::Display(0)], &[Act::Display(POSITION_MODE)], &[Act::Display(VELOCITY_MODE)]];

/// What a spindle does that turns while its drive goes off and on: fast, its display lost, reset with the drive off.
pub const COASTING: [Letter; 4] = [
    &[Act::Interpolator(4.0 * U)],
    &[Act::Display(0), Act::Actual(f64::NAN)],
    &[Act::Reset, Act::Off],
    &[Act::Reset, Act::Display(0)],
];

/// Whether a letter has a request.
#[must_use]
pub fn is_request(letter: Letter) -> bool {
    let is_one = |act: &Act| matches!(act, Act::M3 | Act::M4 | Act::M5 | Act::M19 | Act::Putax | Act::G74);
    letter.iter().any(is_one)
}

/// Changes the inputs of a cycle.
pub fn apply(letter: Letter, inputs: &mut Inputs<f64>, block: &State<f64>) {
    for act in letter {
        match *act {
            Act::M3 => inputs.m3 = true,
            Act::M4 => inputs.m4 = true,
            Act::M5 => inputs.m5 = true,
            Act::M19 => inputs.m19 = true,
            Act::Putax => inputs.putax = true,
            Act::G74 => inputs.g74 = true,
            Act::Speed(speed) => inputs.s_word = speed,
            Act::Target(target) => inputs.s_position = target,
            Act::Reset => inputs.reset = true,
            Act::Off => inputs.drive_on = false,
            Act::WrongCycle => inputs.task_cycle_ns += 1,
            Act::Interpolator(v) => inputs.v_interpolator = v,
            Act::Hold => inputs.v_interpolator = block.v,
            Act::Jump(distance) => inputs.x_command += distance,
            Act::Actual(v) => inputs.v_actual = v,
            Act::Command(x) => inputs.x_command = x,
            Act::Position(x) => inputs.x_actual = x,
            Act::Done => inputs.job_done = true,
            Act::Display(mode) => inputs.operation_mode_display = mode,
        }
    }
}
