//! The operation modes of CANopen drives (6060h, P-AXIS-00463 and 00464): any number is allowed, and two of them fit.

use crate::config::values::key;
use crate::parameters::Name;
use crate::rules::effective::Effective;
use crate::{codes, diagnostics::Diagnostic};

/// Cyclic synchronous position and velocity mode (IEC 61800-7-201).
const POSITION: i32 = 8;
const VELOCITY: i32 = 9;

/// Checks the modes of position and velocity control, which differ.
pub(super) fn check(e: &mut Effective<'_>, [position, velocity]: [i32; 2]) {
    let [of_position, of_velocity_control] = [Name::CyclicPositionOpMode, Name::CyclicVelocityOpMode].map(key);
    if [position, velocity] == [VELOCITY, POSITION] {
        let found = format!(
            "{} is {position}, the cyclic synchronous velocity mode, and {} is {velocity}, the cyclic synchronous position mode: \
             they are swapped",
            e.title(of_position),
            e.title(of_velocity_control)
        );
        let said = Diagnostic::error(codes::SWAPPED_MODES, e.place_of(of_position), found);
        let said =
            said.allowed("the mode of position control (P-AXIS-00463), then that of velocity control (P-AXIS-00464)");
        e.report.push(said.instead(format!("cyclic_position_op_mode {POSITION}, cyclic_velocity_op_mode {VELOCITY}")));
        return;
    }
    other(e, Name::CyclicPositionOpMode, position, POSITION);
    of_velocity(e, velocity);
}

/// Checks the mode of velocity control.
pub(super) fn of_velocity(e: &mut Effective<'_>, velocity: i32) {
    other(e, Name::CyclicVelocityOpMode, velocity, VELOCITY);
}

/// Warns of another mode than the cyclic synchronous one.
fn other(e: &mut Effective<'_>, name: Name, mode: i32, fits: i32) {
    if mode == fits {
        return;
    }
    let what = match mode {
        ..0 => "a mode of the drive's manufacturer",
        0 => "no mode",
        1 => "the profile position mode",
        2 | 3 => "a velocity mode whose ramps the drive makes",
        4 => "the profile torque mode",
        6 => "homing",
        7 => "the interpolated position mode",
        POSITION => "the cyclic synchronous position mode",
        VELOCITY => "the cyclic synchronous velocity mode",
        10 => "the cyclic synchronous torque mode",
        _ => "a mode that is not defined",
    };
    let wanted = if fits == POSITION { "position" } else { "velocity" };
    let found = format!("{} is {mode}, {what}", e.title(key(name)));
    let instead = format!("{fits}, the cyclic synchronous {wanted} mode, unless the manual of the drive says {mode}");
    e.warn(codes::OTHER_MODE, key(name), found, instead);
}
