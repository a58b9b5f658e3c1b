//! What makes the axes of a gantry lag or move differently: the bridge is askew while it moves. Scalings are compared elsewhere.

use crate::axis::Axis;
use crate::blocks::{differing, feedforward, position_control};
use crate::codes;
use crate::diagnostics::{Diagnostic, Place, Report};
use crate::number::rounded;

/// The effects of the parameters that determine by how much an axis leads or lags its command. Loads and scalings of process
/// data may differ: they belong to the drive and to the mechanics of each axis.
const LEADS: [&str; 12] = [
    "feedforward: to the position controller",
    "feedforward: as additive velocity",
    "feedforward: as additive torque",
    "feedforward: active",
    "feedforward: weight",
    "feedforward: time constant",
    "feedforward: jerk factor",
    "feedforward: weight of the torque",
    "feedforward: delay of the velocity",
    "feedforward: delay of the torque",
    "feedforward: delay of the jerk",
    "position control: shift time",
];

/// Warns of everything that skews a gantry while it moves.
pub(super) fn advise(slave: &Axis, master: &Axis, place: &Place, report: &mut Report) {
    gains(slave, master, place, report);
    leads(slave, master, place, report);
    excitations(slave, master, place, report);
    counters(slave, master, place, report);
}

/// Warns of unequal gains of the position controllers.
fn gains(slave: &Axis, master: &Axis, place: &Place, report: &mut Report) {
    let [Some(of_slave), Some(of_master)] = [slave, master].map(|axis| axis.control.kv) else { return };
    if of_slave == of_master {
        return;
    }
    let [of_slave, of_master] = [of_slave, of_master].map(f64::from);
    let v_max = if slave.ipc.v_max < master.ipc.v_max { slave.ipc.v_max } else { master.ipc.v_max };
    // 0.01/s, and thousandths of a unit.
    let askew = (100.0 / of_slave - 100.0 / of_master).abs() * v_max / 1e3;
    let unit = if master.control.is_rotary { "deg" } else { "mm" };
    let found = format!(
        "{} has Kv {}/s, and its master {} {}/s (P-AXIS-00099): without feedforward the gantry is askew by {} {unit} at {v_max} {}",
        slave.name,
        of_slave / 100.0,
        master.name,
        of_master / 100.0,
        rounded(askew),
        master.control.velocity_unit()
    );
    let said = Diagnostic::warning(codes::GANTRY_KV, place.clone(), found);
    report.push(
        said.instead(format!("kv = {of_master} of {}, or equal values in both, and in their drives", slave.name)),
    );
}

/// Warns of unequal feedforward.
fn leads(slave: &Axis, master: &Axis, place: &Place, report: &mut Report) {
    let [of_slave, of_master] = [slave, master].map(|axis| {
        let effects = feedforward::diff::effects(axis).into_iter().chain(position_control::diff::effects(axis));
        effects.filter(|(what, _)| LEADS.contains(&what.as_str())).collect()
    });
    let differing = differing(&of_slave, &of_master);
    if differing.is_empty() {
        return;
    }
    let found = format!(
        "{} and its master {} lead their commands differently, and the gantry is askew while it moves: {}",
        slave.name,
        master.name,
        differing.join("; ")
    );
    let said = Diagnostic::warning(codes::GANTRY_LEAD, place.clone(), found);
    report.push(said.instead("in both axes the same values of vorsteuer.*, and the process data that they need"));
}

/// Warns of an axis that is excited alone, or in another way.
fn excitations(slave: &Axis, master: &Axis, place: &Place, report: &mut Report) {
    if slave.excitation == master.excitation {
        return;
    }
    let found = format!(
        "{} and its master {} are not excited alike, and a slave does not get v_excite of its master: the excitation pulls the gantry \
         askew",
        slave.name, master.name
    );
    let said = Diagnostic::warning(codes::GANTRY_EXCITATION, place.clone(), found);
    report.push(
        said.instead("the same keys `excitation` for both axes, and one button that starts both in the same cycle"),
    );
}

/// Warns of an axis that alone stops after skipped or doubled calls.
fn counters(slave: &Axis, master: &Axis, place: &Place, report: &mut Report) {
    if slave.counts_calls == master.counts_calls {
        return;
    }
    let (counts, other) = if slave.counts_calls { (slave, master) } else { (master, slave) };
    let found = format!(
        "{} stops with error 9 after skipped or doubled calls (cycle_counter), and {} goes on: the gantry is pulled askew",
        counts.name, other.name
    );
    let said = Diagnostic::warning(codes::GANTRY_COUNTER, place.clone(), found);
    report.push(said.instead(format!("cycle_counter = true for {} too, or for none of them", other.name)));
}
