//! What is legal in feedforward, but inert or dangerous: warnings. Nothing here is an error.

use crate::axis::{Axis, Feedforward};
use crate::codes;
use crate::config::values::{Key, key};
use crate::number::rounded;
use crate::parameters::Name;
use crate::rules::effective::Effective;

/// A time constant below this part of a cycle is none that a drive has: a weight was written, or another unit.
const LEAST_PART_OF_A_CYCLE: f64 = 0.05;

/// Says what contributes next to nothing.
pub(crate) fn inert(axis: &Axis, gear: u32, e: &mut Effective<'_>) {
    if let Some(feedforward) = &axis.control.feedforward {
        defaults(feedforward, gear, e);
        time_constant(feedforward, axis.cycle_time_ns, e);
    }
}

/// Says what a user would want to know before the block acts.
pub(crate) fn advise(axis: &Axis, e: &mut Effective<'_>) {
    if let Some(feedforward) = &axis.control.feedforward {
        disabled(feedforward, e);
        weight(feedforward, e);
        two_meanings(feedforward, e);
    }
}

fn warn(e: &mut Effective<'_>, code: &'static str, key: Key, found: String, instead: &str) {
    e.warn(code, key, found, Some(instead.to_owned()));
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
