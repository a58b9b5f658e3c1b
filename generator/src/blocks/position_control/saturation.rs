//! Process data that the axis saturates within its own limits: warnings with both numbers.

use crate::axis::{Axis, Location, PositionControl, Width};
use crate::config::values::{Key, key};
use crate::{
    codes, design::scale, number::rounded, parameters::Name, parameters::words::Words, rules::effective::Effective,
};

/// Says where a velocity that the axis may have does not fit into its process datum.
pub(crate) fn advise(axis: &Axis, control: &PositionControl, gear: u32, e: &mut Effective<'_>) {
    if control.location == Location::Cnc {
        let keys = [key(Name::VelocityCommandData), (Name::MultiGainZ, [gear, 0])];
        let scaling = (scale::manipulated(control.multi_gain), control.command);
        fits(axis, e, keys, ("the velocity command at vb_max", axis.ipc.v_max), scaling);
    }
    if let Some((velocity, largest)) = control.velocity.zip(additive(axis, control)) {
        let keys = [key(Name::AdditiveVelocityData), key(Name::VResoNum)];
        fits(axis, e, keys, largest, (scale::velocity(&velocity, axis.cycle_time_ns), velocity.width));
    }
}

/// The largest additive velocity and where it comes from: of feedforward, of improved position control, or both; a gantry
/// slave's is its master's.
fn additive(axis: &Axis, control: &PositionControl) -> Option<(&'static str, f64)> {
    if let Some(feedforward) = axis.control.feedforward.as_ref().filter(|feedforward| feedforward.additive.any()) {
        return Some(("the additive velocity at vb_max", feedforward.weight.value() * axis.ipc.v_max));
    }
    let is_active = axis.ipc.is_active() && axis.control.master.is_none() && control.location != Location::Cnc;
    let limit = axis.ipc.limit();
    (is_active && limit > 0.0).then_some(("the additive velocity at its limit v_add_max_fact", limit))
}

fn fits(
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
