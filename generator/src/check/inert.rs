//! Factors that are 0, and parameters that nothing uses: warnings. It looks at all blocks of an axis at once.

use crate::axis::Axis;
use crate::codes;
use crate::config::values::{Key, key};
use crate::diagnostics::Diagnostic;
use crate::parameters::words::{ProcessDatum, Words};
use crate::parameters::{Name, Value};
use crate::rules::effective::Effective;

pub(crate) fn advise(axis: &Axis, gear: u32, e: &mut Effective<'_>) {
    zeros(gear, e);
    no_effect(axis, gear, e);
}

/// Factors that are given as 0: all that they weight is 0.
fn zeros(gear: u32, e: &mut Effective<'_>) {
    let factors = [
        (key(Name::VResoNum), "the additive velocity is always 0"),
        (key(Name::VsVFaktor), "the whole feedforward is always 0"),
        (key(Name::VsAFaktor), "the acceleration is always 0, and so is a jerk that has its time constant"),
        (key(Name::JerkFactNum), "the feedforward of the jerk is always 0"),
        ((Name::Load, [gear, 0]), "the additive torque is always 0"),
    ];
    for (key, consequence) in factors {
        let is_zero = |value: &Value| matches!(value, Value::Integer(0)) || *value == Value::Real(0.0);
        let Some(setting) = e.given(key).filter(|setting| setting.value.as_ref().is_some_and(is_zero)) else {
            continue;
        };
        if e.is_used(key) {
            let title = key.0.parameter().title(setting.spelling, key.1);
            let instead = format!("a value above 0, or {}", without(key.0));
            e.warn(codes::ZERO, key, format!("{title} is 0: {consequence}"), Some(instead));
        }
    }
}

/// How to do without what a factor weights.
fn without(name: Name) -> &'static str {
    match name {
        Name::VResoNum => "process_data.additive_velocity = \"NONE\"",
        Name::VsVFaktor => "NONE in vorsteuer.vorsteuerung",
        Name::VsAFaktor => "no ACC in vorsteuer.vorsteuerung",
        Name::JerkFactNum => "no JERK in vorsteuer.vorsteuerung",
        _ => "no ADD_ACC in vorsteuer.vorsteuerung",
    }
}

/// Parameters that are given and that nothing uses: told by use, not by the manual's column of drive types. Where neither
/// feedforward nor position control is there, a list may have them for other functions; keys of our own are for this one only.
fn no_effect(axis: &Axis, gear: u32, e: &mut Effective<'_>) {
    let control = &axis.control;
    let of_gear = [Name::MultiGainN, Name::MultiGainZ, Name::Load].map(|name| (name, [gear, 0]));
    let others = [
        Name::VResoDenom,
        Name::VResoNum,
        Name::VTimeBase,
        Name::VsAFaktor,
        Name::VsANenner,
        Name::VsVFaktor,
        Name::VsVNenner,
        Name::JerkFactNum,
        Name::JerkFactDenom,
        Name::VelocityDelayTime,
        Name::AccelerationDelayTime,
        Name::JerkDelayTime,
        Name::ShiftTime,
        Name::TorqueScaleNum,
        Name::TorqueScaleDenom,
        Name::AccReferenceValue,
    ]
    .map(key);
    let own = [Name::Motor, Name::VelocityCommandData, Name::AdditiveVelocityData, Name::AdditiveTorqueData].map(key);
    let is_controlled = control.feedforward.is_some() || control.position_control.is_some();
    let of_lists = of_gear.into_iter().chain(others).filter(|_| is_controlled);
    let none = Value::Word(ProcessDatum::None.name());
    let is_idle = |key: &Key| {
        let value = e.given(*key).map(|setting| setting.value.as_ref());
        value.is_some_and(|value| value != Some(&none)) && !e.is_used(*key)
    };
    let idle: Vec<Key> = of_lists.chain(own).filter(is_idle).collect();
    let Some(first) = idle.first() else { return };
    let listed: Vec<String> = idle
        .iter()
        .map(|(name, _)| name.parameter().id.map_or_else(|| name.parameter().path.to_owned(), str::to_owned))
        .collect();
    let found = format!("nothing of what this axis does uses {}", listed.join(", "));
    let diagnostic = Diagnostic::warning(codes::NO_EFFECT, e.place_of(*first), found);
    let is_forgotten = control.feedforward.is_none() && idle.iter().any(|(name, _)| is_of_feedforward(*name));
    e.report.push(match is_forgotten {
        true => {
            diagnostic.instead("vorsteuer.vorsteuerung (P-AXIS-00223) with VEL, ACC or others, if feedforward is meant")
        }
        false => diagnostic,
    });
}

fn is_of_feedforward(name: Name) -> bool {
    name.parameter().path.starts_with("vorsteuer.")
}
