//! Warnings for factors of 0, and for parameters that nothing uses. All blocks of an axis are considered together.

use crate::axis::{Axis, Location};
use crate::config::values::{Key, key};
use crate::parameters::words::{ProcessDatum, Tunable, Words};
use crate::parameters::{Name, Parameter, Value};
use crate::{blocks::spindle::check::KEYS, codes, rules::effective::Effective};
use std::ops::RangeInclusive;

/// The list parameters, in the order of their table, that only feedforward and position control use.
const OF_CONTROL: [RangeInclusive<Name>; 6] = [
    Name::MultiGainN..=Name::MultiGainZ,
    Name::Load..=Name::Load,
    Name::VResoDenom..=Name::VTimeBase,
    Name::VsAFaktor..=Name::VsVNenner,
    Name::JerkFactNum..=Name::JerkDelayTime,
    Name::ShiftTime..=Name::AccReferenceValue,
];

/// axgen's own keys that only stages use. A watch that sees nothing has its own warning.
const OF_STAGES: [Name; 6] =
    [Name::Fade, Name::RideThrough, Name::Tunable, Name::LowestF0, Name::TuningLimit, Name::TuningWeight];

pub(crate) fn advise(axis: &Axis, gear: u32, e: &mut Effective<'_>) {
    zeros(gear, e);
    no_effect(axis, gear, e);
}

/// Warns of factors that are given as 0: everything that they weight is 0.
fn zeros(gear: u32, e: &mut Effective<'_>) {
    let (load, without_load) = ((Name::Load, [gear, 0]), "no ADD_ACC in vorsteuer.vorsteuerung");
    let shared = "the acceleration is always 0, and so is a jerk that has its time constant";
    let factors = [
        (key(Name::VResoNum), "the additive velocity is always 0", "process_data.additive_velocity = \"NONE\""),
        (key(Name::VsVFaktor), "the whole feedforward is always 0", "NONE in vorsteuer.vorsteuerung"),
        (key(Name::VsAFaktor), shared, "no ACC in vorsteuer.vorsteuerung"),
        (key(Name::JerkFactNum), "the feedforward of the jerk is always 0", "no JERK in vorsteuer.vorsteuerung"),
        (load, "the additive torque is always 0", without_load),
    ];
    for (key, consequence, without) in factors {
        let value = e.given(key).and_then(|setting| setting.value.as_ref());
        let is_zero = matches!(value, Some(Value::Integer(0))) || value == Some(&Value::Real(0.0));
        if is_zero && e.is_used(key) {
            let found = format!("{} is 0: {consequence}", e.title(key));
            e.warn(codes::ZERO, key, found, format!("a value above 0, or {without}"));
        }
    }
}

/// Warns of given parameters that nothing uses, decided by use, not by the manual's column of drive types. Without
/// feedforward and position control, a list may contain them for other functions; axgen's own keys have no other use. Those
/// of the stages are used, for the digest, even where no stage acts.
fn no_effect(axis: &Axis, gear: u32, e: &mut Effective<'_>) {
    let control = &axis.control;
    let own = [Name::Motor, Name::VelocityCommandData, Name::AdditiveVelocityData, Name::AdditiveTorqueData];
    // The changeover's own rules report which of these it does not use.
    let of_spindle = if control.spindle.is_some() { &[] } else { &KEYS[..] };
    let own = own.into_iter().chain(of_spindle.iter().copied()).map(key);
    let given = || e.all_given().map(|(key, _)| key);
    let is_of_stages = |key: &Key| OF_STAGES.contains(&key.0);
    let is_controlled = !control.is_empty();
    let is_of_step = |(name, [step, _]): Key| step == gear || !name.parameter().path.starts_with("getriebe[");
    let of_lists = given()
        // The list of a machine with improved position control alone contains the scalings of its drive, too: only
        // feedforward warns.
        .filter(|key| is_controlled || key.0.parameter().path.starts_with("vorsteuer."))
        .filter(|key| is_of_step(*key) && OF_CONTROL.iter().any(|names| names.contains(&key.0)));
    let nothing = [ProcessDatum::None.name(), Tunable::Nothing.name()].map(Value::Word);
    let is_idle = |key: &Key| {
        let value = e.given(*key).and_then(|setting| setting.value.as_ref());
        let acts = e.is_used(*key) && (axis.stages_act() || !is_of_stages(key));
        value.is_some_and(|value| !nothing.contains(value)) && !acts && !carries_excitation(axis, key.0)
    };
    let idle: Vec<Key> = of_lists.chain(own).chain(given().filter(is_of_stages)).filter(is_idle).collect();
    let Some(first) = idle.first() else { return };
    let parameters: Vec<&Parameter> = idle.iter().map(|(name, _)| name.parameter()).collect();
    let listed: Vec<&str> = parameters.iter().map(|parameter| parameter.id.unwrap_or(parameter.path)).collect();
    let found = format!("nothing of what this axis does uses {}", listed.join(", "));
    let is_of_feedforward = parameters.iter().any(|parameter| parameter.path.starts_with("vorsteuer."));
    let instead = "vorsteuer.vorsteuerung (P-AXIS-00223) with VEL, ACC or others, if feedforward is meant".to_owned();
    e.warn(codes::NO_EFFECT, *first, found, (control.feedforward.is_none() && is_of_feedforward).then_some(instead));
}

/// Whether the caller needs a parameter to add v_excite to the additive velocity of a drive that controls the position.
fn carries_excitation(axis: &Axis, name: Name) -> bool {
    let in_cnc = axis.control.position_control.as_ref().is_some_and(|of| of.location == Location::Cnc);
    let is_of_velocity = name == Name::AdditiveVelocityData || (Name::VResoDenom..=Name::VTimeBase).contains(&name);
    axis.excitation.is_some() && !in_cnc && is_of_velocity
}
