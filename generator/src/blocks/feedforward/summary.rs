//! What feedforward of an axis does, in a line.

use crate::axis::{Feedforward, Quantities};
use crate::number::digits;

/// Which quantities go which way.
pub(crate) fn line(of: &Feedforward) -> String {
    let ways = [
        (of.conventional, "to the position controller", String::new()),
        (of.additive, "as additive velocity", delayed(&[of.velocity_delay])),
        (of.torque, "as additive torque", delayed(&[of.acceleration_delay, of.jerk_delay])),
    ];
    let said = ways.into_iter().filter(|(what, ..)| what.any());
    let said: Vec<String> = said.map(|(what, way, delay)| format!("{} {way}{delay}", quantities(what))).collect();
    let said = if said.is_empty() { "nothing goes out".to_owned() } else { said.join("; ") };
    format!("feedforward: {said}; weight {}", digits(of.weight.value()))
}

fn delayed(us: &[u32]) -> String {
    us.iter().filter(|us| **us > 0).map(|us| format!(", {us} us later")).collect()
}

/// Which quantities a sum has, in words.
pub(crate) fn quantities(of: Quantities) -> String {
    let named = [(of.velocity, "velocity"), (of.acceleration, "acceleration"), (of.jerk, "jerk")];
    let there: Vec<&str> = named.into_iter().filter(|(is, _)| *is).map(|(_, name)| name).collect();
    there.join(", ")
}
