//! The constructs of feedforward, position control and gantries, and the events of their runs, in words.

use crate::samples::Samples;
use generator::axis::{Axis, Location, Quantities};
use portable::Literal;
use std::collections::BTreeSet;

pub fn constructs(axis: &Axis) -> BTreeSet<String> {
    let mut shown = BTreeSet::new();
    if let Some(feedforward) = &axis.control.feedforward {
        named("conventional", feedforward.conventional, &mut shown);
        named("additive", feedforward.additive, &mut shown);
        named("torque", feedforward.torque, &mut shown);
        for us in [feedforward.velocity_delay, feedforward.acceleration_delay, feedforward.jerk_delay] {
            let cycles = f64::from(us) * 1e3 / f64::from(axis.cycle_time_ns);
            shown.insert(format!("delay of {cycles} cycles"));
        }
        shown.insert(format!("weight {}", feedforward.weight.value()));
        if feedforward.default_active {
            shown.insert("active despite G137".to_owned());
        }
    }
    if let Some(control) = &axis.control.position_control {
        let place = match control.location {
            Location::Cnc => "position control in the CNC",
            Location::Drive => "position control in the drive",
            Location::Profidrive => "PROFIdrive",
        };
        shown.insert(place.to_owned());
    }
    if axis.control.master_limit.is_some() {
        shown.insert("gantry slave".to_owned());
    }
    shown
}

fn named(way: &str, quantities: Quantities, shown: &mut BTreeSet<String>) {
    let Quantities { velocity, acceleration, jerk } = quantities;
    for (is, name) in [(velocity, "velocity"), (acceleration, "acceleration"), (jerk, "jerk")] {
        if is {
            shown.insert(format!("{way} {name}"));
        }
    }
}

/// The events of a run; a block without feedforward and process data has only faults.
pub fn events(inputs: &Samples, outputs: &Samples) -> BTreeSet<String> {
    let mut shown = BTreeSet::new();
    let (mut given, mut answers) = (Vec::new(), Vec::new());
    for sample in 0..inputs.len() {
        inputs.read(sample, &mut given);
        outputs.read(sample, &mut answers);
        for (signal, value) in outputs.shape.signals.iter().zip(&answers) {
            of_output(&signal.name, *value, &mut shown);
        }
        for (signal, value) in inputs.shape.signals.iter().zip(&given) {
            of_input(&signal.name, *value, &mut shown);
        }
    }
    shown
}

fn of_output(name: &str, value: Literal, shown: &mut BTreeSet<String>) {
    let is_process_data = ["manipulated_variable", "xerr", "additive_velocity", "additive_torque"].contains(&name);
    let ends = [i32::MIN, i32::MAX, i32::from(i16::MIN), i32::from(i16::MAX)];
    match value {
        Literal::I32(value) if is_process_data && ends.contains(&value) => {
            shown.insert(format!("{name} saturates {}", if value > 0 { "above" } else { "below" }));
        }
        Literal::I32(value) if is_process_data && value != 0 => {
            shown.insert(format!("{name} is put out"));
        }
        Literal::U32(id) if name == "error_id" && id != 0 => {
            shown.insert(format!("error {id}"));
        }
        _ => {}
    }
}

fn of_input(name: &str, value: Literal, shown: &mut BTreeSet<String>) {
    match (name, value) {
        ("feedforward_active", Literal::Bool(active)) => {
            shown.insert(if active { "G135" } else { "G137" }.to_owned());
        }
        ("feedforward_percentage", Literal::I32(percent)) if percent != 100 => {
            shown.insert(format!("G136 {percent} %"));
        }
        _ => {}
    }
}
