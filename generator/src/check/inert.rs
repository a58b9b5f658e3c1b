//! Feedforward and position control that contribute next to nothing, and parameters that nothing uses: warnings.

use super::control_advice::warn;
use super::drive::key;
use super::effective::Effective;
use super::ipc::rounded;
use crate::axis::{Axis, Feedforward};
use crate::codes;
use crate::config::Key;
use crate::diagnostics::Diagnostic;
use crate::parameters::{Name, Value};

/// A time constant below this part of a cycle is none that a drive has: a weight was written, or another unit.
const LEAST_PART_OF_A_CYCLE: f64 = 0.05;

/// Says what is there and does nothing.
pub fn advise(axis: &Axis, gear: u32, e: &mut Effective<'_>) {
    if let Some(feedforward) = &axis.control.feedforward {
        defaults(feedforward, gear, e);
        time_constant(feedforward, axis.cycle_time_ns, e);
    }
    zeros(gear, e);
    no_effect(axis, gear, e);
}

/// Defaults with which a quantity contributes next to nothing.
fn defaults(feedforward: &Feedforward, gear: u32, e: &mut Effective<'_>) {
    let sums = [feedforward.conventional, feedforward.additive];
    let uses_time = sums.iter().any(|sum| sum.acceleration || sum.jerk);
    if uses_time && e.given(key(Name::VsAFaktor)).is_none() && e.given(key(Name::VsANenner)).is_none() {
        let found = "the time constant of the acceleration (P-AXIS-00225/00226) has its default, 1 us".to_owned();
        let instead = "vorsteuer.vs_a_faktor with the drive's time constant in us";
        warn(e, codes::INERT_DEFAULT, key(Name::FeedforwardMode), found, instead);
    }
    let uses_jerk = sums.iter().any(|sum| sum.jerk) || feedforward.torque.jerk;
    if uses_jerk && e.given(key(Name::JerkFactNum)).is_none() && e.given(key(Name::JerkFactDenom)).is_none() {
        let (found, instead) = match feedforward.torque.jerk {
            true => (
                "the factor of the jerk (P-AXIS-00337/00338) has its default, 1/100, which ADD_JERK takes for 0.01 s",
                "vorsteuer.jerk_fact_num and jerk_fact_denom: with ADD_JERK the lag of the torque loop in s",
            ),
            false => (
                "the factor of the jerk (P-AXIS-00337/00338) has its default, 1/100",
                "vorsteuer.jerk_fact_num and jerk_fact_denom: 1/2 for a drive that only delays",
            ),
        };
        warn(e, codes::INERT_DEFAULT, key(Name::FeedforwardMode), found.to_owned(), instead);
    }
    if feedforward.torque.any() && e.given((Name::Load, [gear, 0])).is_none() {
        let found = format!("getriebe[{gear}].load (P-AXIS-00391) has its default, 1e-6");
        let instead = "the inertia of motor and load in kg m^2, of a linear motor the mass in kg";
        warn(e, codes::INERT_DEFAULT, key(Name::FeedforwardMode), found, instead);
    }
}

/// A time constant that no drive has. Where ADD_ACC takes it for a weight, the two meanings are said.
fn time_constant(feedforward: &Feedforward, cycle_time_ns: u32, e: &mut Effective<'_>) {
    let sums = [feedforward.conventional, feedforward.additive];
    let uses_time = sums.iter().any(|sum| sum.acceleration || sum.jerk);
    let is_given = [Name::VsAFaktor, Name::VsANenner].into_iter().any(|name| e.given(key(name)).is_some());
    let ratio = feedforward.acceleration;
    let cycles = ratio.value() * 1e3 / f64::from(cycle_time_ns);
    if uses_time && is_given && !feedforward.torque.acceleration && 0.0 < cycles && cycles < LEAST_PART_OF_A_CYCLE {
        let found = format!(
            "the time constant of the acceleration is {}/{} = {} us (P-AXIS-00225/00226), {} of a cycle: next to nothing",
            ratio.num,
            ratio.denom,
            rounded(ratio.value()),
            rounded(cycles)
        );
        let instead = "the drive's time constant in us; a plain weight such as 12/10 is for ADD_ACC";
        warn(e, codes::SHORT_TIME, key(Name::VsAFaktor), found, instead);
    }
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
            warn(e, codes::ZERO, key, format!("{title} is 0: {consequence}"), &instead);
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
    let is_idle = |key: &Key| {
        let value = e.given(*key).map(|setting| setting.value.as_ref());
        value.is_some_and(|value| value != Some(&Value::Word("NONE"))) && !e.is_used(*key)
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
