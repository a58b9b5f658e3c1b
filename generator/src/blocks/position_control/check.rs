//! The rules of position control, and the condition for an axis to get it.

use super::gain;
use crate::axis::{Enable, Feedforward, Ipc, Location, PositionControl, Quantities, Ratio, Resolution, Width};
use crate::diagnostics::{Diagnostic, Severity};
use crate::parameters::{Name, Value};
use crate::rules::drive::{self, Drive, ratio};
use crate::rules::{effective::Effective, presence::Presence};
use crate::{codes, config::values::key};

/// Position control of one axis; absent: nothing asks for it; `None` after a reported error.
///
/// An axis gets it if its list gives Kv, if there is feedforward, if its drive controls the position and improved position
/// control needs an output there, and if it is a gantry slave: otherwise it could not output the velocity that its master
/// adds.
pub(crate) fn check(
    e: &mut Effective<'_>,
    (drive, cycle_time): (&Drive, Option<u32>),
    ipc: Option<&Ipc>,
    feedforward: Option<&Feedforward>,
    is_slave: bool,
) -> Option<Presence<PositionControl>> {
    let is_active = ipc.is_some_and(Ipc::is_active);
    let in_drive = drive.location != Location::Cnc;
    if in_drive && is_active && !is_slave && drive.velocity.is_none() {
        no_way_out(e, ipc.is_some_and(|ipc| ipc.enable != Enable::Off));
    }
    let kv_key = (Name::Kv, [drive.gear, 0]);
    if e.given(kv_key).is_none() && feedforward.is_none() && !is_slave && !(in_drive && is_active) {
        return Some(Presence::Absent);
    }
    drive::note(e, &[Name::DriveType, Name::OperationMode]);
    let [leads, additive, torque] =
        feedforward.map_or([false; 3], |of| [of.conventional, of.additive, of.torque].map(Quantities::any));
    let velocity = drive.velocity(e, additive || in_drive && (is_active || is_slave));
    let kv = if drive.location == Location::Cnc || leads { e.integer(kv_key) } else { Some(0) };
    if let (Location::Cnc, Some(kv), Some(cycle_ns)) = (drive.location, kv, cycle_time) {
        gain::check(e, cycle_ns, kv_key, kv);
    }
    let of_command = velocity_command(e, drive);
    let resolution = resolution(e, drive);
    // A feedforward that is switched off does not lead: the position must not be delayed for it. A torque leads too.
    let is_led = drive.location == Location::Profidrive && (leads || additive || torque);
    let shift_time = if is_led { e.integer(key(Name::ShiftTime)) } else { Some(0) };
    let (multi_gain, command) = of_command?;
    Some(Presence::Present(PositionControl {
        location: drive.location,
        kv: kv?,
        multi_gain,
        command,
        velocity: velocity?.present(),
        resolution: resolution?.present(),
        shift_time: shift_time?,
    }))
}

/// Scaling and process data of the velocity command of the CNC; `None` after a reported error.
fn velocity_command(e: &mut Effective<'_>, drive: &Drive) -> Option<(Ratio, Width)> {
    if drive.location != Location::Cnc {
        return Some((Ratio::ZERO, Width::Int32));
    }
    let multi_gain = ratio(e, (Name::MultiGainZ, [drive.gear, 0]), (Name::MultiGainN, [drive.gear, 0]));
    let command = e.word(key(Name::VelocityCommandData));
    Some((multi_gain?, command?))
}

/// Path resolution of PROFIdrive; `None` after a reported error.
fn resolution(e: &mut Effective<'_>, drive: &Drive) -> Option<Presence<Resolution>> {
    if drive.location != Location::Profidrive {
        return Some(Presence::Absent);
    }
    let resolution = drive::resolution(e, drive.gear)?;
    // With a feed constant the path resolution is a multiple of the increments per revolution.
    if resolution.incr_per_rev == 0 && resolution.has_feed_const() {
        let Ratio { num, denom } = resolution.feed_const;
        let feed_const = format!("the feed constant {num}/{denom} (P-AXIS-00362/00363)");
        drive.no_increments(e, &format!("with {feed_const} the control deviation XERR is always 0"));
        return None;
    }
    Some(Presence::Present(resolution))
}

/// Improved position control for which the drive's process data have no room: an error if it is enabled.
fn no_way_out(e: &mut Effective<'_>, is_enabled: bool) {
    let (code, severity, how) = match is_enabled {
        true => (codes::NO_WAY_OUT, Severity::Error, "enabled"),
        false => (codes::NO_WAY_OUT_YET, Severity::Warning, "configured"),
    };
    let drive_type = e.validated(key(Name::DriveType)).as_ref().map(Value::text).unwrap_or_default();
    let found = format!(
        "improved position control is {how}, the drive controls the position ({drive_type}, P-AXIS-00020), and its process data \
         have no additive velocity"
    );
    let diagnostic = Diagnostic::error(code, e.place_of(key(Name::Enable)), found)
        .allowed(format!("an additive velocity command in the process data: {}", PositionControl::ADDITIVE_VELOCITY))
        .instead(
            "process_data.additive_velocity = \"INT32\" in a set, if the drive has it, or antr.operation_mode \
             CNC_POSITION_CONTROL (P-AXIS-00320)",
        );
    e.report.push(Diagnostic { severity, ..diagnostic });
}
