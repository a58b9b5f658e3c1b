//! The gear step in use: an error if it does not exist, warnings if it may be a surprise.

use crate::config::values::{Key, key};
use crate::parameters::{Name, path_with};
use crate::{axis::Axis, codes, diagnostics::Diagnostic, rules::effective::Effective};
use std::collections::BTreeSet;

/// Checks that the axis has the gear step that the set names, or no gear steps at all.
pub(crate) fn check(e: &mut Effective<'_>) {
    let gear_key = key(Name::Gear);
    let steps = steps(e);
    let Some(gear) = e.validated_integer(gear_key) else { return };
    let Some(first) = steps.first().filter(|_| !steps.contains(&gear) && e.given(gear_key).is_some()) else { return };
    let found = format!("`gear` is {gear}, and the axis has {} only", listed(&steps));
    let diagnostic = Diagnostic::error(codes::NO_GEAR, e.place_of(gear_key), found);
    let instead = format!("gear = {first}, or the parameters getriebe[{gear}]");
    e.report.push(diagnostic.allowed("a gear step that the list or the set has").instead(instead));
}

/// Warns a user who did not choose the step, or whose step is incomplete.
pub(crate) fn advise(axis: &Axis, e: &mut Effective<'_>) {
    let steps = steps(e);
    let gear_key = key(Name::Gear);
    let Some(gear) = e.validated_integer(gear_key) else { return };
    // The first parameter of another step, as the place of the message.
    let Some(other) = of_others(e, gear).min_by_key(|(name, [step, _])| (*step, *name)) else { return };
    let lacking = lacking(e, gear, axis.control.position_control.is_none());
    if !lacking.is_empty() {
        let found = format!("gear step {gear} is used, and lacks what other steps have: {}", lacking.join("; "));
        let instead = format!("the parameters getriebe[{gear}], or the key `gear` of another step");
        e.warn(codes::GEAR, other, found, instead);
    } else if e.given(gear_key).is_none() {
        let found = format!("{} are given; step {gear} is used", listed(&steps));
        e.warn(codes::GEAR, other, found, "the key `gear` in a set, to choose one".to_owned());
    }
}

/// The gear steps with given parameters.
fn steps(e: &Effective<'_>) -> BTreeSet<u32> {
    e.all_given().filter(|(key, _)| is_of_a_gear(*key)).map(|((_, [step, _]), _)| step).collect()
}

fn is_of_a_gear((name, _): Key) -> bool {
    name.parameter().path.starts_with("getriebe[")
}

/// The given parameters of other steps.
fn of_others(e: &Effective<'_>, gear: u32) -> impl Iterator<Item = Key> {
    e.all_given().map(|(key, _)| key).filter(move |key| is_of_a_gear(*key) && key.1[0] != gear)
}

/// Parameters that the axis needs, that other steps have and this one lacks, with their defaults.
fn lacking(e: &Effective<'_>, gear: u32, is_uncontrolled: bool) -> Vec<String> {
    let is_needed = |name: Name| name == Name::Kv && is_uncontrolled || e.is_used((name, [gear, 0]));
    let names: BTreeSet<Name> = of_others(e, gear).map(|(name, _)| name).collect();
    (names.into_iter())
        .filter(|name| e.given((*name, [gear, 0])).is_none() && is_needed(*name))
        .map(|name| {
            let parameter = name.parameter();
            let path = path_with(parameter.path, [gear, 0]);
            let end = path.split_once('.').map_or(path.as_str(), |(_, end)| end);
            let id = parameter.id.unwrap_or_default();
            let default = parameter.default_at([gear, 0]).unwrap_or_default();
            match e.is_used((name, [gear, 0])) {
                true => format!("{end} ({id}), whose default {default} holds"),
                false => format!("{end} ({id}), without which there is no position control"),
            }
        })
        .collect()
}

/// `the gear steps 0, 2`.
fn listed(steps: &BTreeSet<u32>) -> String {
    let numbers = steps.iter().map(u32::to_string).collect::<Vec<_>>().join(", ");
    format!("the gear step{} {numbers}", if steps.len() == 1 { "" } else { "s" })
}
