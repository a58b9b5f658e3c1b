//! Process data that the axis saturates within its own limits: warnings with both numbers.

use super::drive::key;
use super::effective::Effective;
use super::ipc::rounded;
use crate::axis::{Axis, Place, PositionControl, Width};
use crate::codes;
use crate::config::Key;
use crate::design::{ipc, scale};
use crate::diagnostics::Diagnostic;
use crate::parameters::{Name, Value};

/// Says where a velocity that the axis may have does not fit into its process datum.
pub fn advise(axis: &Axis, control: &PositionControl, gear: u32, e: &mut Effective<'_>) {
    if control.place == Place::Cnc {
        let per_velocity = scale::manipulated(control.multi_gain);
        let largest = Largest { what: "the velocity command at vb_max", velocity: axis.ipc.v_max };
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
}

/// The largest additive velocity: of feedforward, of improved position control, or both; a gantry slave's is its master's.
fn additive(axis: &Axis, control: &PositionControl) -> Option<Largest> {
    let feedforward = axis.control.feedforward.as_ref().filter(|feedforward| feedforward.additive.any());
    let is_active = axis.ipc.stage.iter().any(Option::is_some) && axis.control.master.is_none();
    let limit = if is_active && control.place != Place::Cnc { ipc::limit(&axis.ipc) } else { 0.0 };
    match feedforward {
        Some(feedforward) => {
            let velocity = feedforward.weight.value() * axis.ipc.v_max;
            Some(Largest { what: "the additive velocity at vb_max", velocity })
        }
        None if limit > 0.0 => {
            Some(Largest { what: "the additive velocity at its limit v_add_max_fact", velocity: limit })
        }
        None => None,
    }
}

fn fits(e: &mut Effective<'_>, keys: [Key; 2], largest: Largest, per_velocity: f64, width: Width) {
    let [_, end] = width.range().map(f64::from);
    let increments = largest.velocity * per_velocity;
    if increments <= end {
        return;
    }
    let turns = !matches!(e.judged(key(Name::AxisType)), Some(Value::Word("ACHSTYP_TRANSLATOR")));
    let unit = if turns { "0.001 deg/s" } else { "um/s" };
    let found = format!(
        "{}, {} {unit}, is {} increments, and {} ends at {end}: it saturates at {} {unit}",
        largest.what,
        largest.velocity,
        rounded(increments),
        if width == Width::Int16 { "INT16" } else { "INT32" },
        rounded(end / per_velocity)
    );
    let place = keys.into_iter().find(|key| e.given(*key).is_some()).unwrap_or(keys[1]);
    let instead = match width {
        Width::Int16 => "INT32, if the drive has it, or a scaling with fewer increments",
        Width::Int32 => "a scaling with fewer increments",
    };
    e.report.push(Diagnostic::warning(codes::SATURATES, e.place_of(place), found).instead(instead));
}
