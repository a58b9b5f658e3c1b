//! What is legal in feedforward and position control, but inert or dangerous: warnings. Nothing here is an error.

use super::drive::key;
use super::effective::Effective;
use super::ipc::rounded;
use crate::axis::{Axis, Feedforward, Place, PositionControl};
use crate::codes;
use crate::config::Key;
use crate::diagnostics::Diagnostic;
use crate::parameters::{Name, Value};
use portable::RealKind;

/// Says what a user would want to know before the blocks act.
pub fn advise(axis: &Axis, gear: u32, e: &mut Effective<'_>) {
    if let Some(feedforward) = &axis.control.feedforward {
        disabled(feedforward, e);
        weight(feedforward, e);
        inert_defaults(feedforward, gear, e);
        two_meanings(feedforward, e);
        no_effect(gear, e);
    }
    if let Some(control) = &axis.control.position_control {
        if let Some(feedforward) = &axis.control.feedforward {
            twice(control, feedforward, e);
        }
        kv_default(control, axis, gear, e);
        single(axis, control, e);
    }
}

fn warn(e: &mut Effective<'_>, code: &'static str, key: Key, found: String, instead: &str) {
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

/// Defaults with which a quantity contributes next to nothing.
fn inert_defaults(feedforward: &Feedforward, gear: u32, e: &mut Effective<'_>) {
    let sums = [feedforward.conventional, feedforward.additive];
    let uses_time = sums.iter().any(|sum| sum.acceleration || sum.jerk);
    if uses_time && e.given(key(Name::VsAFaktor)).is_none() && e.given(key(Name::VsANenner)).is_none() {
        let found = "the time constant of the acceleration (P-AXIS-00225/00226) has its default, 1 us".to_owned();
        let instead = "vorsteuer.vs_a_faktor with the drive's time constant in us";
        warn(e, codes::INERT_DEFAULT, key(Name::FeedforwardMode), found, instead);
    }
    let uses_jerk = sums.iter().any(|sum| sum.jerk) || feedforward.torque.jerk;
    if uses_jerk && e.given(key(Name::JerkFactNum)).is_none() && e.given(key(Name::JerkFactDenom)).is_none() {
        let found = "the factor of the jerk (P-AXIS-00337/00338) has its default, 1/100".to_owned();
        let instead = "vorsteuer.jerk_fact_num and jerk_fact_denom: 1/2 for a drive that only delays";
        warn(e, codes::INERT_DEFAULT, key(Name::FeedforwardMode), found, instead);
    }
    if feedforward.torque.any() && e.given((Name::Load, [gear, 0])).is_none() {
        let found = format!("getriebe[{gear}].load (P-AXIS-00391) has its default, 1e-6");
        let instead = "the inertia of motor and load in kg m^2, of a linear motor the mass in kg";
        warn(e, codes::INERT_DEFAULT, key(Name::FeedforwardMode), found, instead);
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
        warn(e, codes::KV_DEFAULT, kv_key, found, "the gain of the machine, in 0.01/s");
    }
}

fn single(axis: &Axis, control: &PositionControl, e: &mut Effective<'_>) {
    if axis.real == RealKind::F32 {
        let what = if control.place == Place::Cnc { "the position lag" } else { "the drive's position command" };
        let found = format!("{what} is computed in single precision, which has 24 bits for a position");
        warn(e, codes::SINGLE_POSITION, key(Name::RealType), found, "real = \"f64\" for this axis");
    }
}

/// Parameters of feedforward that are given and that nothing uses: told by use, not by the manual's column of drive types.
fn no_effect(gear: u32, e: &mut Effective<'_>) {
    let of_gear = [Name::MultiGainN, Name::MultiGainZ, Name::Load].map(|name| (name, [gear, 0]));
    let others = [
        Name::VResoDenom,
        Name::VResoNum,
        Name::VTimeBase,
        Name::VsAFaktor,
        Name::VsANenner,
        Name::JerkFactNum,
        Name::JerkFactDenom,
        Name::VelocityDelayTime,
        Name::AccelerationDelayTime,
        Name::JerkDelayTime,
        Name::ShiftTime,
        Name::TorqueScaleNum,
        Name::TorqueScaleDenom,
        Name::AccReferenceValue,
        Name::Motor,
    ]
    .map(key);
    let idle: Vec<Key> =
        of_gear.into_iter().chain(others).filter(|key| e.given(*key).is_some() && !e.is_used(*key)).collect();
    if let Some(first) = idle.first() {
        let listed: Vec<String> = idle
            .iter()
            .map(|(name, _)| name.parameter().id.map_or_else(|| name.parameter().short().to_owned(), str::to_owned))
            .collect();
        let found = format!("nothing of what this axis does uses {}", listed.join(", "));
        e.report.push(Diagnostic::warning(codes::NO_EFFECT, e.place_of(*first), found));
    }
}
