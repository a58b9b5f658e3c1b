//! The velocities of the changeover: P-AXIS-00767 and 00768, or their predecessors, and the largest velocity.

use crate::config::values::{Key, key};
use crate::parameters::{Name, Value};
use crate::rules::effective::{Effective, number_as_written};
use crate::{codes, diagnostics::Diagnostic};

/// The parameters that ask for a changeover.
pub(super) const VELOCITIES: [Name; 4] = [
    Name::VVelocityControlOn,
    Name::VPositionControlOn,
    Name::VelocityPositionControlOn,
    Name::VelocityPositionControlOff,
];

/// Whether a parameter asks for a changeover.
pub(super) fn asks(name: Name) -> bool {
    VELOCITIES.contains(&name)
}

/// A velocity and the parameter that it comes from.
#[derive(Clone, Copy, Debug)]
pub(super) struct Velocity {
    /// [0.001 deg/s]
    pub(super) value: u32,
    pub(super) key: Key,
}

#[derive(Clone, Copy, Debug)]
pub(super) struct Velocities {
    /// above which velocity control begins
    pub(super) on: Velocity,
    /// at which position control begins again
    pub(super) off: Velocity,
    /// the largest velocity of the spindle
    pub(super) largest: Velocity,
}

/// All three; the first must not be below the second.
pub(super) fn check(e: &mut Effective<'_>, gear: u32) -> Option<Velocities> {
    let on = one_of(e, Name::VVelocityControlOn, Name::VelocityPositionControlOn);
    let off = one_of(e, Name::VPositionControlOn, Name::VelocityPositionControlOff);
    let largest_key = (Name::VbMax, [gear, 0]);
    let largest = e.integer(largest_key).map(|value| Velocity { value, key: largest_key });
    let (on, off) = (on?, off?);
    if on.value < off.value {
        let at = if e.given(on.key).is_some() { on.key } else { off.key };
        let found = format!("{} is {}, below {} with {}", e.title(on.key), on.value, e.title(off.key), off.value);
        let said = Diagnostic::error(codes::CHANGEOVER, e.place_of(at), found);
        let said = said.allowed("v_velocity_control_on >= v_position_control_on [0.001 deg/s]");
        e.report.push(said.instead("both velocities, each at its own name: 200 rpm are 1200000"));
    }
    Some(Velocities { on, off, largest: largest? })
}

/// A velocity from its parameter, or from the predecessor of the parameter; an error if they have different values.
fn one_of(e: &mut Effective<'_>, new: Name, old: Name) -> Option<Velocity> {
    let [new, old] = [new, old].map(key);
    if e.given(old).is_none() {
        return e.integer(new).map(|value| Velocity { value, key: new });
    }
    let old_value = e.validated_integer(old);
    let id = new.0.parameter().id.unwrap_or_default();
    if e.given(new).is_none() {
        let value = old_value?;
        // The block does not depend on which of the two parameters the value came from.
        e.adopt(new, Value::Integer(i64::from(value)));
        let found = format!("{} is the predecessor of {id}, which takes its value", e.title(old));
        let instead = number_as_written(&e.place_of(old), new, value);
        e.warn(codes::PREDECESSOR, old, found, instead);
        return e.integer(new).map(|value| Velocity { value, key: old });
    }
    let (value, old_value) = (e.integer(new)?, old_value?);
    if value == old_value {
        let found = format!("{} is given together with {id}, its successor", e.title(old));
        e.warn(codes::PREDECESSOR, old, found, format!("only {id}"));
    } else {
        let found = format!("{} is {old_value}, and its successor {} is {value}", e.title(old), e.title(new));
        let said = Diagnostic::error(codes::TWO_VELOCITIES, e.place_of(old), found);
        e.report.push(said.allowed("one of the two, or equal values").instead(format!("only {id}")));
    }
    Some(Velocity { value, key: new })
}
