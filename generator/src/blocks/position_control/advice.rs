//! Warnings about position control that is legal, but without effect or dangerous. No errors here.

use crate::axis::{Axis, Feedforward, Location, PositionControl, Velocity, Width};
use crate::config::values::{Key, key};
use crate::parameters::words::{DriveType, Words};
use crate::parameters::{Name, Value};
use crate::{codes, design::scale, diagnostics::Diagnostic, number::rounded, rules::effective::Effective};
use portable::RealKind;

/// Fewest increments of the largest additive velocity: with fewer, most of a vibration is lost by rounding.
const FEWEST_INCREMENTS: f64 = 10.0;

/// Warns of what a user should know before the block acts.
pub(crate) fn advise(axis: &Axis, gear: u32, e: &mut Effective<'_>) {
    if let (Some(control), Some(feedforward)) = (&axis.control.position_control, &axis.control.feedforward) {
        twice(control, feedforward, axis.control.drive_type, e);
    }
    kv_default(gear, e);
    let Some(control) = &axis.control.position_control else { return };
    saturation(axis, control, gear, e);
    turns(axis, control, e);
    // The controller in the CNC takes the following error instead of positions.
    if axis.real == RealKind::F32 && control.location != Location::Cnc {
        let found = "the drive's position command is computed in single precision, which has 24 bits for a position";
        e.warn(
            codes::SINGLE_POSITION,
            key(Name::RealType),
            found.to_owned(),
            "real = \"f64\" for this axis".to_owned(),
        );
    }
}

/// Warns of feedforward in the CNC together with that of the drive.
fn twice(control: &PositionControl, feedforward: &Feedforward, drive: Option<DriveType>, e: &mut Effective<'_>) {
    let in_drive = control.location != Location::Cnc;
    let weights = [Name::FeedForwardVWeighting, Name::ChangeFeedForwardVWeighting];
    let drives = weights.into_iter().find_map(|name| {
        let Value::Integer(weight) = *e.given(key(name))?.value.as_ref()? else { return None };
        (weight > 0).then_some((name, weight))
    });
    let has_velocity = feedforward.conventional.velocity || feedforward.additive.velocity;
    if let Some((name, weight)) = drives.filter(|_| in_drive && has_velocity) {
        let found = format!(
            "the drive feeds {} % of the velocity forward itself ({}), and the CNC does too: the axis leads",
            rounded(weight as f64 / 10.0),
            name.parameter().id.unwrap_or_default()
        );
        let gains = match drive {
            Some(DriveType::Sercos) => ": in the drive its gains are S-0-0296 (velocity) and S-0-0348 (acceleration)",
            Some(DriveType::CanOpen) => ": in the drive its weight is 3062h",
            _ => "",
        };
        e.warn(codes::TWICE, key(name), found, format!("feedforward in one of the two{gains}"));
    }
}

/// Warns of a gain that was not given.
fn kv_default(gear: u32, e: &mut Effective<'_>) {
    let kv_key = (Name::Kv, [gear, 0]);
    if !e.is_used(kv_key) || e.given(kv_key).is_some() {
        return;
    }
    let Some(kv) = e.validated_integer(kv_key).map(f64::from) else { return };
    let found =
        format!("getriebe[{gear}].kv (P-AXIS-00099) is not given: its default {kv} is used, {}/s", rounded(kv / 100.0));
    let place = e.place_near(kv_key, |name| {
        let path = name.parameter().path;
        matches!(name, Name::FeedforwardMode | Name::GantryMaster)
            || path.starts_with("getriebe[")
            || path.starts_with("antr.sai_op_mode_change.v_")
            || path.starts_with("antr.velocity_position_control_")
    });
    let diagnostic = Diagnostic::warning(codes::KV_DEFAULT, place, found);
    e.report.push(diagnostic.instead("the gain of the machine, in 0.01/s"));
}

/// Warns if a velocity of the axis does not fit into its process datum.
fn saturation(axis: &Axis, control: &PositionControl, gear: u32, e: &mut Effective<'_>) {
    if control.location == Location::Cnc {
        let keys = [key(Name::VelocityCommandData), (Name::MultiGainZ, [gear, 0])];
        let per_velocity = scale::manipulated(control.multi_gain);
        let (v_max, limit) = (axis.ipc.v_max, added(axis));
        let largest = match limit > 0.0 {
            true => ("the velocity command at vb_max, with v_add at its limit v_add_max_fact", v_max + limit),
            false => ("the velocity command at vb_max", v_max),
        };
        fits(axis, e, keys, largest, (per_velocity, control.command));
        resolves(axis, e, [keys[1], (Name::MultiGainN, [gear, 0])], slowest(axis), per_velocity);
    }
    if let Some((velocity, [largest, finest])) = control.velocity.zip(additive(axis, control)) {
        let keys = [key(Name::AdditiveVelocityData), key(Name::VResoNum)];
        fits(axis, e, keys, largest, (scale::velocity(&velocity, axis.cycle_time_ns), velocity.width));
        resolves_addition(axis, e, &velocity, finest);
    }
}

/// Warns of a rotary axis whose drive gets a position of another turn than the command, if that wraps.
fn turns(axis: &Axis, control: &PositionControl, e: &mut Effective<'_>) {
    let leads = axis.control.feedforward.as_ref().is_some_and(|of| of.conventional.any() && !of.global_disable);
    let (at, found, instead) = match (control.location, control.shift_time) {
        _ if !axis.control.is_rotary => return,
        (Location::Profidrive, cycles @ 1..) => (
            key(Name::ShiftTime),
            format!(
                "the axis is rotary, and XERR takes the position command of {cycles} cycles before (P-AXIS-00165): with a \
                 modulo command it jumps by a turn in these cycles"
            ),
            "shift_time 0, unless the position command counts on across turns",
        ),
        (Location::Drive, _) if leads => (
            key(Name::FeedforwardMode),
            "the axis is rotary, and x_drive leads by v_feedforward / Kv: with a modulo command it leaves the turn before \
             the command wraps"
                .to_owned(),
            "a position command that counts on across turns, x_drive wrapped before it is sent, or ADD_VEL",
        ),
        _ => return,
    };
    let place = e.place_near(at, |name| matches!(name, Name::DriveType | Name::AxisType));
    let said = Diagnostic::warning(codes::TURNS, place, found);
    e.report.push(said.instead(instead));
}

/// The lowest velocity that the axis must be able to command: that of the change to position control, else the largest.
pub(crate) fn slowest(axis: &Axis) -> (&'static str, f64) {
    let off = axis.control.spindle.as_ref().map_or(0, |spindle| spindle.v_position_control_on);
    if off > 0 {
        ("the velocity command at v_position_control_on", f64::from(off))
    } else {
        ("the velocity command at vb_max", axis.ipc.v_max)
    }
}

/// The largest additive velocity and its source: feedforward, improved position control, or both; and the part of it that
/// needs the finest increments.
fn additive(axis: &Axis, control: &PositionControl) -> Option<[(&'static str, f64); 2]> {
    let feedforward = axis.control.feedforward.as_ref().filter(|feedforward| feedforward.additive.any());
    let forward = feedforward.map(|of| of.weight.value() * axis.ipc.v_max);
    let limit = if control.location == Location::Cnc { 0.0 } else { added(axis) };
    let added = ("the additive velocity at its limit v_add_max_fact", limit);
    match (forward, limit > 0.0) {
        (Some(forward), true) => {
            Some([("the additive velocity at vb_max, with v_add at its limit v_add_max_fact", forward + limit), added])
        }
        (Some(forward), false) => Some([("the additive velocity at vb_max", forward); 2]),
        (None, true) => Some([added; 2]),
        (None, false) => None,
    }
}

/// The limit of v_add: the axis's own, for a gantry slave that of its master; 0 if nothing is added.
fn added(axis: &Axis) -> f64 {
    match axis.control.master {
        Some(_) => axis.control.master_limit.unwrap_or_default(),
        None if axis.ipc.is_active() => axis.ipc.limit(),
        None => 0.0,
    }
}

/// Warns if a velocity has more increments than its process datum can hold.
pub(crate) fn fits(
    axis: &Axis,
    e: &mut Effective<'_>,
    keys: [Key; 2],
    (what, velocity): (&str, f64),
    (per_velocity, width): (f64, Width),
) {
    let unit = axis.control.velocity_unit();
    let [_, end] = width.range().map(f64::from);
    let increments = velocity * per_velocity;
    if increments <= end {
        return;
    }
    let found = format!(
        "{what}, {velocity} {unit}, is {} increments, and {} ends at {end}: it saturates at {} {unit}",
        rounded(increments),
        width.name(),
        rounded(end / per_velocity)
    );
    let place = keys.into_iter().find(|key| e.given(*key).is_some()).unwrap_or(keys[1]);
    let instead = match width {
        Width::Int16 => "INT32, if the drive has it, or a scaling with fewer increments",
        Width::Int32 => "a scaling with fewer increments",
    };
    e.warn(codes::SATURATES, place, found, instead.to_owned());
}

/// Warns if an additive velocity has few increments of its process datum. A scaling of 0 has another warning.
fn resolves_addition(axis: &Axis, e: &mut Effective<'_>, velocity: &Velocity, (what, largest): (&str, f64)) {
    let per_velocity = scale::velocity(velocity, axis.cycle_time_ns);
    let (increments, unit) = (largest * per_velocity, axis.control.velocity_unit());
    if increments >= FEWEST_INCREMENTS || increments <= 0.0 {
        return;
    }
    let found = format!(
        "{what}, {largest} {unit}, is {} increments: below {FEWEST_INCREMENTS} most of a vibration is lost by rounding",
        rounded(increments)
    );
    let instead = format!(
        "v_reso_num / v_reso_denom (P-AXIS-00206, 00205) of {} or more, as the drive has it: one increment is {} {unit}",
        rounded(velocity.reso.value() * FEWEST_INCREMENTS / increments),
        rounded(1.0 / per_velocity)
    );
    let place = [Name::VResoNum, Name::VResoDenom].map(key).into_iter().find(|key| e.given(*key).is_some());
    e.warn(codes::COARSE_COMMAND, place.unwrap_or(key(Name::AdditiveVelocityData)), found, instead);
}

/// Warns if a velocity of the axis is less than one increment of its process datum.
pub(crate) fn resolves(
    axis: &Axis,
    e: &mut Effective<'_>,
    keys: [Key; 2],
    (what, velocity): (&str, f64),
    per_velocity: f64,
) {
    let increments = velocity * per_velocity;
    if increments >= 1.0 {
        return;
    }
    let unit = axis.control.velocity_unit();
    let found = format!("{what}, {velocity} {unit}, is {} increments: the drive gets 0 or 1", rounded(increments));
    let place = keys.into_iter().find(|key| e.given(*key).is_some()).unwrap_or(keys[1]);
    let instead = format!("a scaling with more increments: one is {} {unit}", rounded(1.0 / per_velocity));
    e.warn(codes::COARSE_COMMAND, place, found, instead);
}
