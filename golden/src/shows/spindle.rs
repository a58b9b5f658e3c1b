//! The constructs of a spindle that changes over, and the events of its runs, in words.

use super::cycles;
use crate::samples::Samples;
use generator::axis::{Axis, Bus, Changeover};
use portable::Literal;
use std::collections::BTreeSet;

/// Its states, by their numbers.
pub(crate) const STATES: [&str; 5] = ["POSITION", "TO_VELOCITY", "VELOCITY", "BRAKE", "TO_POSITION"];

/// Its requests: the input of each, and the word.
const REQUESTS: [(&str, &str); 6] =
    [("m3", "M3"), ("m4", "M4"), ("m5", "M5"), ("m19", "M19"), ("putax", "S[PUTAX]"), ("g74", "G74")];

/// Smaller velocities count as rounding [0.001 deg/s].
const MOVING: f64 = 1000.0;

pub fn constructs(axis: &Axis) -> BTreeSet<String> {
    let word = |drive: &Changeover| match drive {
        Changeover::Cnc => "changeover in the CNC",
        Changeover::Drive { bus: Bus::Sercos, .. } => "changeover of a SERCOS drive",
        Changeover::Drive { bus: Bus::CanOpen, .. } => "changeover of a CANopen drive",
    };
    axis.control.spindle.iter().map(|of| word(&of.drive).to_owned()).collect()
}

/// The events of a run; empty if it is a run of another block.
pub fn events(inputs: &Samples, outputs: &Samples) -> BTreeSet<String> {
    let (mut shown, mut states, mut turned) = (BTreeSet::new(), Vec::new(), 0.0);
    for of in cycles(inputs, outputs) {
        let Some(Literal::I32(number)) = of.value("spindle_state") else { break };
        let Some(velocity) = of.real("v_spindle") else { break };
        if states.last() != Some(&number) {
            states.push(number);
        }
        let requested = REQUESTS.iter().filter(|(name, _)| of.bool(name) == Some(true));
        shown.extend(requested.map(|(_, word)| (*word).to_owned()));
        if velocity.abs() > MOVING {
            if velocity * turned < 0.0 && number == 0 {
                shown.insert("turns round in POSITION".to_owned());
            }
            turned = velocity;
        }
    }
    if states[..] == [4, 0] {
        shown.insert("stays in POSITION".to_owned());
    }
    let name = |number: &i32| usize::try_from(*number).ok().and_then(|number| STATES.get(number));
    shown.extend(states.iter().filter_map(name).map(|name| format!("state {name}")));
    shown
}
