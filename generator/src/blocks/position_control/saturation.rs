//! Process data that the axis saturates within its own limits: warnings with both numbers.

use crate::axis::{Axis, Location, PositionControl, Width};
use crate::codes;
use crate::config::values::{Key, key};
use crate::design::scale;
use crate::number::rounded;
use crate::parameters::Name;
use crate::parameters::words::Words;
use crate::rules::effective::Effective;

/// Says where a velocity that the axis may have does not fit into its process datum.
pub(crate) fn advise(axis: &Axis, control: &PositionControl, gear: u32, e: &mut Effective<'_>) {
    let unit = axis.control.velocity_unit();
    if control.location == Location::Cnc {
        let per_velocity = scale::manipulated(control.multi_gain);
        let largest = Largest { what: "the velocity command at vb_max", velocity: axis.ipc.v_max, unit };
        fits(
            e,
            [key(Name::VelocityCommandData), (Name::MultiGainZ, [gear, 0])],
            largest,
            per_velocity,
            control.command,
        );
    }
    if let Some((velocity, largest)) = control.velocity.zip(additive(axis, control)) {
        let per_velocity = scale::velocity(&velocity, axis.cycle_time_ns);
        fits(e, [key(Name::AdditiveVelocityData), key(Name::VResoNum)], largest, per_velocity, velocity.width);
    }
}

/// A velocity, and where it comes from.
struct Largest {
    what: &'static str,
    velocity: f64,
    unit: &'static str,
}

/// The largest additive velocity: of feedforward, of improved position control, or both; a gantry slave's is its master's.
fn additive(axis: &Axis, control: &PositionControl) -> Option<Largest> {
    let unit = axis.control.velocity_unit();
    let feedforward = axis.control.feedforward.as_ref().filter(|feedforward| feedforward.additive.any());
    let is_active = axis.ipc.is_active() && axis.control.master.is_none();
    let limit = if is_active && control.location != Location::Cnc { axis.ipc.limit() } else { 0.0 };
    match feedforward {
        Some(feedforward) => {
            let velocity = feedforward.weight.value() * axis.ipc.v_max;
            Some(Largest { what: "the additive velocity at vb_max", velocity, unit })
        }
        None if limit > 0.0 => {
            Some(Largest { what: "the additive velocity at its limit v_add_max_fact", velocity: limit, unit })
        }
        None => None,
    }
}

fn fits(e: &mut Effective<'_>, keys: [Key; 2], largest: Largest, per_velocity: f64, width: Width) {
    let Largest { what, velocity, unit } = largest;
    let [_, end] = width.range().map(f64::from);
    let increments = velocity * per_velocity;
    if increments <= end {
        return;
    }
    let found = format!(
        "{}, {} {unit}, is {} increments, and {} ends at {end}: it saturates at {} {unit}",
        what,
        velocity,
        rounded(increments),
        width.name(),
        rounded(end / per_velocity)
    );
    let place = keys.into_iter().find(|key| e.given(*key).is_some()).unwrap_or(keys[1]);
    let instead = match width {
        Width::Int16 => "INT32, if the drive has it, or a scaling with fewer increments",
        Width::Int32 => "a scaling with fewer increments",
    };
    e.warn(codes::SATURATES, place, found, Some(instead.to_owned()));
}
