//! What is legal in feedforward and position control, but inert or dangerous: warnings. Nothing here is an error.

use super::drive::key;
use super::effective::Effective;
use super::ipc::rounded;
use super::{inert, saturation};
use crate::axis::{Axis, Feedforward, Place, PositionControl};
use crate::codes;
use crate::config::Key;
use crate::diagnostics::Diagnostic;
use crate::parameters::{Name, Value};
use portable::RealKind;

/// Says what a user would want to know before the blocks act.
pub fn advise(axis: &Axis, gear: u32, e: &mut Effective<'_>) {
    inert::advise(axis, gear, e);
    if let Some(feedforward) = &axis.control.feedforward {
        disabled(feedforward, e);
        weight(feedforward, e);
        two_meanings(feedforward, e);
    }
    if let Some(control) = &axis.control.position_control {
        if let Some(feedforward) = &axis.control.feedforward {
            twice(control, feedforward, e);
        }
        kv_default(control, axis, gear, e);
        saturation::advise(axis, control, gear, e);
        single(axis, control, e);
    }
}

/// A warning about a parameter, with what to write.
pub fn warn(e: &mut Effective<'_>, code: &'static str, key: Key, found: String, instead: &str) {
    let diagnostic = Diagnostic::warning(code, e.place_of(key), found);
    e.report.push(diagnostic.instead(instead));
}

fn disabled(feedforward: &Feedforward, e: &mut Effective<'_>) {
    if feedforward.global_disable {
        let found = "vorsteuer.global_disable (P-AXIS-00256) is TRUE: feedforward puts out 0, despite G135".to_owned();
        warn(e, codes::DISABLED, key(Name::GlobalDisable), found, "FALSE, or NONE in vorsteuer.vorsteuerung");
    }
}

fn weight(feedforward: &Feedforward, e: &mut Effective<'_>) {
    if feedforward.weight.num > feedforward.weight.denom {
        let found = format!(
            "feedforward has the weight {}/{} = {} (P-AXIS-00228/00229): above 1 the axis leads its command",
            feedforward.weight.num,
            feedforward.weight.denom,
            rounded(feedforward.weight.value())
        );
        warn(e, codes::LEADS, key(Name::VsVFaktor), found, "0.7 to 1");
    }
}

/// P-AXIS-00225/00226 is a time constant, or a plain weight with ADD_ACC.
fn two_meanings(feedforward: &Feedforward, e: &mut Effective<'_>) {
    let as_time = [feedforward.conventional, feedforward.additive].iter().any(|sum| sum.acceleration || sum.jerk);
    if as_time && feedforward.torque.acceleration {
        let found = format!(
            "vorsteuer.vs_a_faktor/vs_a_nenner (P-AXIS-00225/00226) is {}: a weight of ADD_ACC, and a time constant in us of JERK",
            rounded(feedforward.acceleration.value())
        );
        warn(e, codes::TWO_MEANINGS, key(Name::FeedforwardMode), found, "ADD_ACC without JERK, or ACC with JERK");
    }
}

/// Feedforward in the CNC beside that of the drive.
fn twice(control: &PositionControl, feedforward: &Feedforward, e: &mut Effective<'_>) {
    let in_drive = control.place != Place::Cnc;
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
        warn(e, codes::TWICE, key(name), found, "feedforward in one of the two");
    }
}

/// A default gain is nobody's gain.
fn kv_default(control: &PositionControl, axis: &Axis, gear: u32, e: &mut Effective<'_>) {
    let leads = axis.control.feedforward.as_ref().is_some_and(|feedforward| feedforward.conventional.any());
    let kv_key = (Name::Kv, [gear, 0]);
    if (control.place == Place::Cnc || leads) && e.given(kv_key).is_none() {
        let found = format!(
            "getriebe[{gear}].kv (P-AXIS-00099) is not given: its default {} is used, {}/s",
            control.kv,
            rounded(f64::from(control.kv) / 100.0)
        );
        let place = e.place_near(kv_key, |name| {
            matches!(name, Name::FeedforwardMode | Name::GantryMaster) || name.parameter().path.starts_with("getriebe[")
        });
        e.report
            .push(Diagnostic::warning(codes::KV_DEFAULT, place, found).instead("the gain of the machine, in 0.01/s"));
    }
}

fn single(axis: &Axis, control: &PositionControl, e: &mut Effective<'_>) {
    if axis.real == RealKind::F32 {
        let what = if control.place == Place::Cnc { "the position lag" } else { "the drive's position command" };
        let found = format!("{what} is computed in single precision, which has 24 bits for a position");
        warn(e, codes::SINGLE_POSITION, key(Name::RealType), found, "real = \"f64\" for this axis");
    }
}
