//! Warnings about feedforward that is legal, but without effect or dangerous. No errors here.

use super::design::nominal_torques;
use crate::axis::{Axis, Feedforward, Motor, Ratio};
use crate::config::values::{Key, key};
use crate::parameters::{Name, Value};
use crate::{codes, number::rounded, rules::effective::Effective};

/// A drive's time constant is above this part of a cycle. A smaller value is a weight, or in another unit.
const LEAST_PART_OF_A_CYCLE: f64 = 0.05;

/// No drive that follows an axis is slower [us].
const LONGEST_TIME: f64 = 100_000.0;

/// The largest weight of a torque that no warning mentions: that of the manual's example (4.2).
const LARGEST_TORQUE_WEIGHT: f64 = 1.2;

/// Every motor accelerates its axis faster with its nominal torque [mm/s^2 or deg/s^2].
const LEAST_AT_NOMINAL: f64 = 10.0;

/// Numerator and denominator of the time constant of the acceleration.
const TIME_CONSTANT: [Name; 2] = [Name::VsAFaktor, Name::VsANenner];

/// Warns of quantities that contribute next to nothing.
pub(crate) fn inert(axis: &Axis, gear: u32, e: &mut Effective<'_>) {
    if let Some(feedforward) = &axis.control.feedforward {
        defaults(feedforward, gear, e);
        time_constant(axis, feedforward, e);
        torque(axis, feedforward, gear, e);
    }
}

/// Warns of what a user should know before the block acts.
pub(crate) fn advise(axis: &Axis, e: &mut Effective<'_>) {
    let Some(feedforward) = &axis.control.feedforward else { return };
    if feedforward.global_disable {
        let found = "vorsteuer.global_disable (P-AXIS-00256) is TRUE: feedforward puts out 0, despite G135";
        let instead = "FALSE, or NONE in vorsteuer.vorsteuerung".to_owned();
        e.warn(codes::DISABLED, key(Name::GlobalDisable), found, instead);
    }
    leads(feedforward, e);
    // A stroke of 0, the default, is not a probe.
    let stroke = e.given(key(Name::HubMesstaster)).map(|setting| setting.value.as_ref());
    if stroke.is_some_and(|stroke| stroke != Some(&Value::Integer(0))) {
        let found = "the axis has a measuring probe (P-AXIS-00086), and feedforward delays its position by a cycle at the least";
        let instead = "a kenngr.hub_messtaster that is longer by the path of the delay".to_owned();
        e.warn(codes::PROBE, key(Name::HubMesstaster), found, instead);
    }
    // P-AXIS-00225/00226 is a time constant, or a plain weight with ADD_ACC.
    if feedforward.sums().use_time() && feedforward.torque.acceleration {
        let found = format!(
            "vorsteuer.vs_a_faktor/vs_a_nenner (P-AXIS-00225/00226) is {}: a weight of ADD_ACC, and a time constant in us of JERK",
            rounded(feedforward.acceleration.value())
        );
        let instead = "ADD_ACC without JERK, or ACC with JERK".to_owned();
        e.warn(codes::TWO_MEANINGS, key(Name::FeedforwardMode), found, instead);
    }
}

/// Warns of weights with which the axis leads its command, or gets more torque than its acceleration needs.
fn leads(of: &Feedforward, e: &mut Effective<'_>) {
    let (weight, of_torque) = (of.weight, rounded(of.torque_weight()));
    if weight.num > weight.denom {
        let found = format!(
            "feedforward has the weight {}/{} = {} (P-AXIS-00228/00229): above 1 the axis leads its command",
            weight.num,
            weight.denom,
            rounded(weight.value())
        );
        e.warn(codes::LEADS, key(Name::VsVFaktor), found, "0.7 to 1".to_owned());
    }
    if of.torque.acceleration && of_torque > LARGEST_TORQUE_WEIGHT {
        let found = format!(
            "the additive torque of the acceleration has the weight {} (P-AXIS-00225/00226 times P-AXIS-00228/00229): with \
             ADD_ACC it is a plain number, and above 1 the torque is more than the load needs",
            of_torque
        );
        let instead = format!("a weight of about 1, at most {LARGEST_TORQUE_WEIGHT}; a time constant in us is for ACC");
        e.warn(codes::LEADS, key(Name::VsAFaktor), found, instead);
    }
}

/// Warns of defaults with which a quantity contributes next to nothing.
fn defaults(feedforward: &Feedforward, gear: u32, e: &mut Effective<'_>) {
    let (sums, torque) = (feedforward.sums(), feedforward.torque);
    let mut say = |is_used: bool, keys: &[Key], found: &str, instead: &str| {
        if is_used && keys.iter().all(|key| e.given(*key).is_none()) {
            e.warn(codes::INERT_DEFAULT, key(Name::FeedforwardMode), found, instead.to_owned());
        }
    };
    let found = "the time constant of the acceleration (P-AXIS-00225/00226) has its default, 1 us";
    let instead = "vorsteuer.vs_a_faktor with the drive's time constant in us";
    say(sums.use_time(), &TIME_CONSTANT.map(key), found, instead);
    let jerk = [Name::JerkFactNum, Name::JerkFactDenom].map(key);
    let found = "the factor of the jerk (P-AXIS-00337/00338) has its default, 1/100";
    let instead = "vorsteuer.jerk_fact_num and jerk_fact_denom: 1/2 for a drive that only delays";
    say(sums.jerk && !torque.jerk, &jerk, found, instead);
    let found = format!("{found}, which ADD_JERK takes for 0.01 s");
    let instead = "vorsteuer.jerk_fact_num and jerk_fact_denom: with ADD_JERK the lag of the torque loop in s";
    say(torque.jerk, &jerk, &found, instead);
    let found = format!("getriebe[{gear}].load (P-AXIS-00391) has its default, 1e-6");
    let instead = "the inertia of motor and load in kg m^2, of a linear motor the mass in kg";
    say(torque.any(), &[(Name::Load, [gear, 0])], &found, instead);
}

/// Warns of a time constant and of a jerk factor that no drive has. Where ADD_ACC reads the time constant as a weight, its
/// message names both meanings.
fn time_constant(axis: &Axis, feedforward: &Feedforward, e: &mut Effective<'_>) {
    let is_given = TIME_CONSTANT.into_iter().any(|name| e.given(key(name)).is_some());
    let is_one = feedforward.sums().use_time() && !feedforward.torque.acceleration;
    let Ratio { num, denom } = feedforward.acceleration;
    let us = feedforward.acceleration.value();
    let cycles = us * 1e3 / f64::from(axis.cycle_time_ns);
    let value =
        format!("the time constant of the acceleration is {num}/{denom} = {} us (P-AXIS-00225/00226)", rounded(us));
    if is_one && is_given && 0.0 < cycles && cycles < LEAST_PART_OF_A_CYCLE {
        let found = format!("{value}, {} of a cycle: next to nothing", rounded(cycles));
        let instead = "the drive's time constant in us; a plain weight such as 12/10 is for ADD_ACC".to_owned();
        e.warn(codes::SHORT_TIME, key(Name::VsAFaktor), found, instead);
    }
    if is_one && us > LONGEST_TIME {
        let per = if axis.control.is_rotary { ["1000 deg/s^2", "deg/s"] } else { ["1 m/s^2", "mm/s"] };
        let found = format!("{value}: at {} it adds {} {} to the velocity command", per[0], rounded(us / 1e3), per[1]);
        let instead = format!("the drive's time constant in us, at most {LONGEST_TIME}: 4000 is 4 ms");
        e.warn(codes::SHORT_TIME, key(Name::VsAFaktor), found, instead);
    }
    let Ratio { num, denom } = feedforward.jerk;
    if feedforward.sums().with(feedforward.torque).jerk && num > denom {
        let found = format!("the factor of the jerk is {num}/{denom} (P-AXIS-00337/00338): no drive has more than 1");
        let instead = "1/2 for a drive that only delays, (T2/Ta)^2 for one of second order".to_owned();
        e.warn(codes::SHORT_TIME, key(Name::JerkFactNum), found, instead);
    }
}

/// Warns of an additive torque that no motor has.
fn torque(axis: &Axis, feedforward: &Feedforward, gear: u32, e: &mut Effective<'_>) {
    let Some(torque) = feedforward.torque_scale.as_ref().filter(|_| feedforward.torque.any()) else { return };
    let at_nominal = 1e3 / nominal_torques(torque);
    if at_nominal >= LEAST_AT_NOMINAL {
        return;
    }
    let unit = if axis.control.is_rotary { "deg/s^2" } else { "mm/s^2" };
    let at = (Name::Load, [gear, 0]);
    let (what, instead) = match torque.motor {
        Motor::Rotary => (
            "torque",
            "the inertia in kg m^2 at the motor, the feed constant and the nominal torque of the machine; a load in kg is for \
             motor = \"linear\"",
        ),
        Motor::Linear => ("force", "the mass in kg, and the nominal force of the motor in N"),
    };
    let found = format!(
        "with {} {} the nominal {what} of the motor (P-AXIS-00392) accelerates the axis by only {} {unit}",
        e.title(at),
        torque.load,
        rounded(at_nominal)
    );
    e.warn(codes::TORQUE, at, found, instead.to_owned());
}
