//! Feedforward of an axis in words: a line for the summary, and named values, each in its unit, for the semantic diff.

use super::super::effects::{Effect, Effects, of_part};
use super::design::{nominal_torques, time_constant};
use crate::axis::{Axis, Feedforward, Motor, Quantities, Torque};
use crate::{design::scale, number::rounded, parameters::words::Words};

/// The values of feedforward; empty without it.
pub(crate) fn effects(axis: &Axis) -> Effects {
    let Some(of) = &axis.control.feedforward else { return Effects::new() };
    let way = |way: Quantities| way.any().then(|| Effect::Words(quantities(way)));
    let active = if of.global_disable { "never" } else { "always" };
    let delay = |is_used: bool, us: u32| is_used.then(|| Effect::Number(f64::from(us), " us"));
    let per_velocity = of.velocity.map(|velocity| scale::velocity(&velocity, axis.cycle_time_ns) * 1e6 / 60.0);
    let torque =
        |torque: &Torque| Effect::Number(scale::torque(torque) * 1e6, " increments at 1 m/s^2 or 1000 deg/s^2");
    let width = |torque: &Torque| Effect::Words(torque.width.name().to_owned());
    let has_jerk = of.sums().jerk || of.torque.jerk;
    let values = [
        ("to the position controller", way(of.conventional)),
        ("as additive velocity", way(of.additive)),
        ("as additive torque", way(of.torque)),
        ("active", (of.global_disable || of.default_active).then(|| Effect::Words(active.to_owned()))),
        ("weight", Some(Effect::Number(of.weight.value() * 100.0, " %"))),
        ("time constant", of.sums().use_time().then(|| Effect::Number(time_constant(of) * 1e3, " ms"))),
        ("jerk factor", has_jerk.then(|| Effect::Number(of.jerk.value(), ""))),
        ("weight of the torque", of.torque.acceleration.then(|| Effect::Number(of.acceleration.value() * 100.0, " %"))),
        ("delay of the velocity", delay(of.additive.any(), of.velocity_delay)),
        ("delay of the torque", delay(of.torque.acceleration, of.acceleration_delay)),
        ("delay of the jerk", delay(of.torque.jerk, of.jerk_delay)),
        ("additive velocity", per_velocity.map(|x| Effect::Number(x, " increments at 1 m/min or 1000 deg/min"))),
        ("additive torque", of.torque_scale.as_ref().map(torque)),
        ("process data of the torque", of.torque_scale.as_ref().map(width)),
    ];
    of_part("feedforward", values)
}

/// The quantities and their destinations.
pub(super) fn line(of: &Feedforward) -> String {
    let ways = [
        (of.conventional, "to the position controller", String::new()),
        (of.additive, "as additive velocity", delayed(&[of.velocity_delay])),
        (of.torque, "as additive torque", delayed(&[of.acceleration_delay, of.jerk_delay])),
    ];
    let said = ways.into_iter().filter(|(what, ..)| what.any());
    let said: Vec<String> = said.map(|(what, way, delay)| format!("{} {way}{delay}", quantities(what))).collect();
    let said = if said.is_empty() { "nothing goes out".to_owned() } else { said.join("; ") };
    format!("feedforward: {said}; weight {}", weights(of))
}

/// What an acceleration becomes as a torque.
pub(super) fn torque(of: &Feedforward, is_rotary: bool) -> Option<String> {
    let torque = of.torque_scale.as_ref().filter(|_| of.torque.acceleration)?;
    let [increments, nominal] = [scale::torque(torque) * 1e6, nominal_torques(torque)];
    let [increments, nominal] = [increments, nominal].map(|of_one| rounded(of_one * of.torque_weight()));
    let acceleration = if is_rotary { "1000 deg/s^2" } else { "1 m/s^2" };
    let what = if torque.motor == Motor::Linear { "force" } else { "torque" };
    Some(format!("additive torque: {acceleration} is {increments} increments, {nominal} of the nominal {what}"))
}

/// The weight of what is put out as a velocity, and that of the torque where it is another one.
fn weights(of: &Feedforward) -> String {
    let [weight, of_torque] = [of.weight.value(), of.torque_weight()].map(|of| rounded(of).to_string());
    match (of.torque.acceleration, of.sums().any() || of.torque.jerk) {
        (true, false) => of_torque,
        (true, true) if of_torque != weight => format!("{weight}, of the torque {of_torque}"),
        _ => weight,
    }
}

fn delayed(us: &[u32]) -> String {
    us.iter().filter(|us| **us > 0).map(|us| format!(", {us} us later")).collect()
}

/// The quantities of a sum, in words.
fn quantities(of: Quantities) -> String {
    let named = [(of.velocity, "velocity"), (of.acceleration, "acceleration"), (of.jerk, "jerk")];
    let there: Vec<&str> = named.into_iter().filter(|(is, _)| *is).map(|(_, name)| name).collect();
    there.join(", ")
}
