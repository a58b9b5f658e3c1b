//! Gantries: finds the master of each slave among the axes of the set. Only rules for two axes are here; those for their
//! motion are in `askew`.

use super::askew;
use crate::axis::{Axis, Enable, Location, PositionControl, Ratio, Velocity};
use crate::codes;
use crate::config::{given::GivenAxis, values::key};
use crate::design::scale;
use crate::diagnostics::{Diagnostic, Place, Report};
use crate::number::rounded;
use crate::parameters::{Name, Value, words::Words};
use std::{collections::BTreeMap, fmt::Write};

/// Rejects logical axis numbers that two axes have; 0, the default, means none.
pub(crate) fn numbers(axes: &[GivenAxis]) -> Report {
    let (mut report, mut first) = (Report::default(), BTreeMap::new());
    let number = |axis: &GivenAxis| axis.values.as_ref()?.get(key(Name::AxisNumber)).cloned();
    for (name, setting) in axes.iter().filter_map(|axis| Some((&axis.name, number(axis)?))) {
        let Some(Value::Integer(number @ 1..)) = setting.value else { continue };
        let owner = *first.entry(number).or_insert(name);
        if owner != name {
            let found =
                format!("{name} has the logical axis number {number} (P-AXIS-00016), which {owner} has already");
            let diagnostic = Diagnostic::error(codes::NUMBER_TWICE, setting.value_place(), found);
            report.push(diagnostic.instead("kopf.achs_nr with a number that no other axis has"));
        }
    }
    report
}

/// Couples the slaves of a set to their masters and returns the messages. `places` has the place of P-AXIS-00070 for each
/// axis.
pub(crate) fn couple(axes: &mut [&mut Axis], places: &[Place]) -> Report {
    let mut report = Report::default();
    for (slave, place) in places.iter().enumerate() {
        let Some(number) = axes[slave].control.master else { continue };
        match master_of(axes, slave, number) {
            Err((found, instead)) => {
                report.push(Diagnostic::error(codes::MASTER, place.clone(), found).instead(instead));
            }
            Ok(master) => {
                compare(axes[slave], axes[master], place, &mut report);
                askew::advise(axes[slave], axes[master], place, &mut report);
                way_out(axes[slave], axes[master], place, &mut report);
                spindle(axes[slave], axes[master], place, &mut report);
                take(axes, slave, master);
            }
        }
    }
    report
}

/// Warns of a slave whose list is used alone: its master is unknown.
pub(crate) fn alone(axis: &Axis, place: Place) -> Report {
    let has_a_way_out = axis.control.position_control.is_some();
    let Some(number) = axis.control.master.filter(|_| has_a_way_out) else { return Report::default() };
    let found = format!(
        "the master of the gantry, axis {number} (P-AXIS-00070), is not there: its additive velocity is left out"
    );
    let instead = "a set with both axes, whose lists they name";
    Diagnostic::warning(codes::MASTER_UNKNOWN, place, found).instead(instead).into()
}

/// The position of the master among the axes; else what is wrong and what to write instead.
fn master_of(axes: &[&mut Axis], slave: usize, number: u32) -> Result<usize, (String, String)> {
    let named: Vec<usize> = (0..axes.len()).filter(|axis| axes[*axis].control.number == number).collect();
    let name = &axes[slave].name;
    match named[..] {
        [] => {
            let others = (0..axes.len()).filter(|other| *other != slave).map(|other| &axes[other]);
            let numbers: Vec<String> = others.map(|axis| format!("{} of {}", axis.control.number, axis.name)).collect();
            let found = format!("{name} follows the axis {number}, and no axis of the set has this number");
            let instead = match numbers.is_empty() {
                true => "the master's list in the set".to_owned(),
                false => format!("one of {} (P-AXIS-00016), or the master's list in the set", numbers.join(", ")),
            };
            Err((found, instead))
        }
        [master, ..] if axes[master].control.master.is_some() => {
            let how = match follows(axes, master, slave) {
                true => format!("follows {name} in the end"),
                false => "is a slave itself".to_owned(),
            };
            let found = format!("{name} follows {}, which {how}", axes[master].name);
            Err((found, "the number of an axis that follows no other".to_owned()))
        }
        [master, ..] => Ok(master),
    }
}

/// Whether an axis follows another one, directly or through other masters.
fn follows(axes: &[&mut Axis], axis: usize, wanted: usize) -> bool {
    let master_of = |axis: &usize| {
        let master = axes[*axis].control.master?;
        axes.iter().position(|other| other.control.number == master)
    };
    std::iter::successors(Some(axis), master_of).take(axes.len() + 1).skip(1).any(|master| master == wanted)
}

/// Warns of unequal scalings: they are legal, but usually a mistake.
fn compare(slave: &Axis, master: &Axis, place: &Place, report: &mut Report) {
    let (Some(of_slave), Some(of_master)) = (&slave.control.position_control, &master.control.position_control) else {
        return;
    };
    let mut warn = |found: String, instead: &str| {
        report.push(Diagnostic::warning(codes::SCALINGS, place.clone(), found).instead(instead));
    };
    if slave.control.is_rotary != master.control.is_rotary {
        let [of_slave, of_master] = [slave, master].map(|axis| axis.control.velocity_unit());
        let found = format!(
            "{} has velocities in {of_slave}, and its master {} in {of_master} (P-AXIS-00018): the additive velocity of the one is \
             none of the other",
            slave.name, master.name
        );
        warn(found, "equal axis types, kenngr.achs_typ (P-AXIS-00018)");
    }
    let [of_slave, of_master] = [of_slave, of_master].map(scaling);
    if of_slave != of_master {
        let found = format!(
            "{} and its master {} scale their velocities differently: {of_slave}, and {of_master}",
            slave.name, master.name
        );
        warn(found, "equal scalings, unless the drives are different");
    }
}

/// Reports a slave that cannot follow what its master adds: it would skew the gantry. A warning as long as the master is OFF.
fn way_out(slave: &Axis, master: &Axis, place: &Place, report: &mut Report) {
    let passes_v_add = slave.control.position_control.as_ref().is_none_or(PositionControl::passes_v_add);
    if !passes_v_add && master.ipc.is_active() {
        let found = format!(
            "{} follows {}, which has improved position control, and its own process data have no additive velocity",
            slave.name, master.name
        );
        let said = match master.ipc.enable {
            Enable::Off => Diagnostic::warning(codes::NO_WAY_OUT_YET, place.clone(), found),
            Enable::On | Enable::DryRun => Diagnostic::error(codes::NO_WAY_OUT, place.clone(), found),
        };
        report.push(
            said.allowed("an additive velocity command in the process data of the slave too")
                .instead("process_data.additive_velocity = \"INT32\" for this axis, if the drive has it"),
        );
    }
}

/// Warns of a master that loses its position: it skews the gantry.
fn spindle(slave: &Axis, master: &Axis, place: &Place, report: &mut Report) {
    if master.control.spindle.is_some() {
        let found =
            format!("{} follows {}, which changes to velocity control (P-AXIS-00767, 00768)", slave.name, master.name);
        let said = Diagnostic::error(codes::GANTRY_SPINDLE, place.clone(), found);
        report.push(said.instead("no gantry, or no P-AXIS-00767 and P-AXIS-00768 of the master"));
    }
}

/// All scalings of the output in use, in words.
fn scaling(control: &PositionControl) -> String {
    let resolution = control.resolution.as_ref().map(scale::resolution);
    let resolution = resolution.map(|of| format!(", {} increments per mm or deg", rounded(of * 1e4)));
    let velocity = match (control.location, control.velocity) {
        (Location::Cnc, _) => {
            let Ratio { num, denom } = control.multi_gain;
            format!("multi_gain {num}/{denom}, {}", control.command.name())
        }
        (_, Some(Velocity { reso, time_base, width })) => {
            format!("v_reso {}/{}, v_time_base {}, {}", reso.num, reso.denom, time_base as u32, width.name())
        }
        (_, None) => "no additive velocity".to_owned(),
    };
    velocity + &resolution.unwrap_or_default()
}

/// Copies to the slave what its block needs to know of the master, and to the master the name of the slave.
fn take(axes: &mut [&mut Axis], slave: usize, master: usize) {
    let (number, ipc) = (axes[master].control.number, axes[master].ipc.clone());
    if !ipc.is_active() {
        return;
    }
    let name = axes[slave].name.clone();
    axes[master].control.slaves.push(name);
    let slave = &mut axes[slave];
    slave.control.master_limit = Some(ipc.limit());
    // Values that the slave's block depends on are part of its own parameters.
    let _ = writeln!(slave.canonical, "master {number} v_add_max_fact {} vb_max {}", ipc.v_add_max_fact, ipc.v_max);
}
