//! What is legal in position control, but inert or dangerous: warnings. Nothing here is an error.

use super::saturation;
use crate::axis::{Axis, Feedforward, Location, PositionControl};
use crate::parameters::{Name, Value};
use crate::{codes, config::values::key, diagnostics::Diagnostic, number::rounded, rules::effective::Effective};
use portable::RealKind;

/// Says what a user would want to know before the block acts.
pub(crate) fn advise(axis: &Axis, gear: u32, e: &mut Effective<'_>) {
    let Some(control) = &axis.control.position_control else { return };
    if let Some(feedforward) = &axis.control.feedforward {
        twice(control, feedforward, e);
    }
    kv_default(control, axis, gear, e);
    saturation::advise(axis, control, gear, e);
    if axis.real == RealKind::F32 {
        let what = if control.location == Location::Cnc { "the position lag" } else { "the drive's position command" };
        let found = format!("{what} is computed in single precision, which has 24 bits for a position");
        e.warn(codes::SINGLE_POSITION, key(Name::RealType), found, "real = \"f64\" for this axis".to_owned());
    }
}

/// Feedforward in the CNC beside that of the drive.
fn twice(control: &PositionControl, feedforward: &Feedforward, e: &mut Effective<'_>) {
    let in_drive = control.location != Location::Cnc;
    let weights = [Name::FeedForwardVWeighting, Name::ChangeFeedForwardVWeighting];
    let drives = weights.into_iter().find_map(|name| match e.given(key(name))?.value.as_ref()? {
        Value::Integer(weight) if *weight > 0 => Some((name, *weight)),
        _ => None,
    });
    let has_velocity = feedforward.conventional.velocity || feedforward.additive.velocity;
    if let Some((name, weight)) = drives.filter(|_| in_drive && has_velocity) {
        let found = format!(
            "the drive feeds {} % of the velocity forward itself ({}), and the CNC does too: the axis leads",
            rounded(weight as f64 / 10.0),
            name.parameter().id.unwrap_or_default()
        );
        e.warn(codes::TWICE, key(name), found, "feedforward in one of the two".to_owned());
    }
}

/// A default gain is nobody's gain.
fn kv_default(control: &PositionControl, axis: &Axis, gear: u32, e: &mut Effective<'_>) {
    let leads = axis.control.feedforward.as_ref().is_some_and(|feedforward| feedforward.conventional.any());
    let kv_key = (Name::Kv, [gear, 0]);
    if (control.location == Location::Cnc || leads) && e.given(kv_key).is_none() {
        let found = format!(
            "getriebe[{gear}].kv (P-AXIS-00099) is not given: its default {} is used, {}/s",
            control.kv,
            rounded(f64::from(control.kv) / 100.0)
        );
        let place = e.place_near(kv_key, |name| {
            matches!(name, Name::FeedforwardMode | Name::GantryMaster) || name.parameter().path.starts_with("getriebe[")
        });
        let diagnostic = Diagnostic::warning(codes::KV_DEFAULT, place, found);
        e.report.push(diagnostic.instead("the gain of the machine, in 0.01/s"));
    }
}
