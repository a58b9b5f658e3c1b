//! The commissioning page of an axis: how to put its improved position control into operation at the machine, step by step,
//! with the numbers of this axis. Nothing is designed here. The text of the page is in its template;
//! tests/tests/commissioning.rs follows it.

mod excite;
mod first;
mod names;
mod rows;
mod stage;
mod unconnected;

use crate::axis::{Axis, PositionControl, Spindle};
use crate::blocks::ipc::closed_loop::{self, Known};
use crate::blocks::{self, Designed, IPC, WHOLE};
use crate::number::digits;
use crate::parameters::Name;
use crate::target::{File, Target, rendered, stem};
use askama::Template;
use names::Names;
use portable::Extreme;
use rows::{Limit, PARTS, limits};
use stability::{Loop, MAX_MS};
use stage::Stage;
use unconnected::Unconnected;

/// Largest difference of a measured velocity from the commanded one [%]: less than any wrong unit causes, more than a
/// rounding or a lag.
const AGREEMENT: f64 = 2.0;
/// Largest rest of a signal that should have vanished, relative to its peak [%].
const REST: f64 = 10.0;
/// The limit must be at least this multiple of the peak in DRYRUN, in which the loop is open.
const RESERVE: u32 = 2;
/// Permitted growth of an amplitude from one row to the next [%]: two records of a machine always differ.
const GROWTH: f64 = 5.0;
/// Shortest rest before and after a move [s]: `axgen measure` reads the decay from 0.15 to 0.95 s after a ramp.
const LEAST_QUIET: f64 = 1.2;
/// Denominator of a stage's weight that must exist and have no effect.
const NO_WEIGHT: u32 = 1_000_000;
/// Shortest time over which a mean is taken [s].
const LEAST_WINDOW: f64 = 0.5;
/// Shortest time at constant velocity in a recorded move [s], and its first part, which `axgen measure` leaves out.
const LEAST_DRIVE: f64 = 1.5;
const SETTLING: f64 = 0.3;

/// The data of the template.
#[derive(Template)]
#[template(path = "commissioning/page.md")]
struct Page<'a> {
    axis: &'a Axis,
    /// the block to call, by its name in the registry
    kind: &'static str,
    names: Names,
    /// whether the block to call contains the block `ipc`
    is_inside: bool,
    /// its command before it is connected
    unconnected: Unconnected,
    /// whether it is the whole axis of a spindle
    is_spindle: bool,
    /// whether what the stages add reaches the drive
    has_way_out: bool,
    /// other blocks to call, which do not contain the block `ipc`
    others: String,
    /// whether the block may report notices
    has_notices: bool,
    is_tunable: bool,
    /// the slaves of its gantry; may be empty
    slaves: String,
    /// inputs of the block that hold it at rest
    off: String,
    takes_sets: bool,
    /// digest of the parameters of the block `ipc`
    parameters: String,
    unit: &'static str,
    cycle: String,
    /// [ms]
    fade: String,
    limit: String,
    limit_path: &'static str,
    enable_path: &'static str,
    limits: Vec<Limit>,
    signals: Vec<Signal>,
    stages: Vec<Stage>,
    /// the drive for which the rows are judged
    drive: &'static str,
    /// [s]
    window: String,
    /// [s]
    drive_time: String,
    /// [s]
    quiet: String,
}

/// An input velocity of the block.
struct Signal {
    name: &'static str,
    meaning: &'static str,
}

/// The page of an axis, with an active stage or without one; `None` for a gantry slave, whose master's block acts, and for a
/// spindle without position control.
/// `parameters`: the digest of the parameters of its block `ipc`; `targets`: the targets of the page.
pub(crate) fn file(designed: &Designed, parameters: String, targets: &[Target]) -> Option<File> {
    let axis = &designed.axis;
    let name = format!("{}_commissioning.md", stem(&axis.name));
    match axis.ipc.is_active() {
        _ if axis.control.master.is_some() => None,
        _ if axis.control.spindle.as_ref().is_some_and(Spindle::only_velocity) => None,
        true => Some(rendered(&name, "", &page(designed, parameters, targets))),
        false => Some(rendered(&name, "", &first::page(axis, targets))),
    }
}

fn page<'a>(designed: &'a Designed, parameters: String, targets: &[Target]) -> Page<'a> {
    let axis = &designed.axis;
    // The last block of the registry that contains `ipc`.
    let kind = blocks::names(axis).into_iter().rfind(|name| WHOLE.contains(name)).unwrap_or(IPC);
    let is_inside = kind != IPC;
    let is_tunable = axis.ipc.tuning().is_some();
    let stages = stages(designed, command_name(axis, is_inside));
    let longest = |of: fn(&Stage) -> f64, least| stages.iter().map(of).fold(least, f64::larger);
    Page {
        axis,
        kind,
        names: Names::new(axis, kind, targets),
        is_inside,
        unconnected: Unconnected::new(axis),
        is_spindle: is_inside && axis.control.spindle.is_some(),
        has_way_out: axis.control.position_control.as_ref().is_none_or(PositionControl::passes_v_add),
        others: if is_inside { String::new() } else { others(axis) },
        has_notices: is_tunable || axis.ipc.takes_sets() || axis.ipc.watch,
        is_tunable,
        slaves: axis.control.slaves.iter().map(|slave| format!("`{slave}`")).collect::<Vec<_>>().join(", "),
        off: off(&stages, is_tunable),
        takes_sets: axis.ipc.takes_sets(),
        parameters,
        unit: axis.control.velocity_unit(),
        cycle: cycle(axis),
        fade: digits(f64::from(designed.ipc.fade_cycles) * f64::from(axis.cycle_time_ns) / 1e6),
        limit: digits(axis.ipc.limit()),
        limit_path: Name::VAddMaxFact.parameter().path,
        enable_path: Name::Enable.parameter().path,
        limits: limits(&axis.ipc),
        signals: signals(axis, is_inside),
        window: digits(longest(|stage| stage.seconds, LEAST_WINDOW)),
        drive_time: digits(longest(|stage| stage.seconds + SETTLING, LEAST_DRIVE)),
        quiet: digits(longest(|stage| stage.quiet, LEAST_QUIET)),
        stages,
        drive: if axis.drive.is_given() { "the drive that the set states" } else { "an ideal drive" },
    }
}

/// The active stages, each with the loop that it closes. The drive is the one that the set states, else the ideal one.
fn stages(designed: &Designed, command: &'static str) -> Vec<Stage> {
    let axis = &designed.axis;
    let drive = [Known::stated(&axis.drive).unwrap_or(Known::IDEAL)];
    let points = closed_loop::points(designed, &drive, axis.drive.position_gain);
    let closed = points.as_ref().map(|points| Loop::new(points, drive[0].drive()));
    let of_loop = |mode| closed.as_ref().filter(|_| closed_loop::closes_loop(&axis.control, mode));
    let stages = designed.stage.iter().flatten().enumerate();
    stages.map(|(n, design)| Stage::new(n, design, command, of_loop(design.stage.mode))).collect()
}

/// The cycle time as `--cycle-time` reads it.
fn cycle(axis: &Axis) -> String {
    format!("{}us", digits(f64::from(axis.cycle_time_ns) / 1000.0))
}

/// What is written to the inputs of the block so that it adds nothing.
fn off(stages: &[Stage], is_tunable: bool) -> String {
    let mut off = "`mode := 0`".to_owned();
    if is_tunable {
        stages.iter().for_each(|stage| off += &format!(", `tuning_weight{} := 0`", stage.index));
        off += " and `tuning_limit := 0`";
    }
    off
}

/// The blocks of an axis except `ipc`, if no block contains the others.
fn others(axis: &Axis) -> String {
    let names = blocks::names(axis).into_iter().filter(|name| *name != IPC);
    names.collect::<Vec<_>>().join(", ")
}

/// The input of the block to call that SET_POINT looks at: with position control in the drive it is the interpolator's velocity.
fn command_name(axis: &Axis, is_inside: bool) -> &'static str {
    if is_inside && !axis.control.commands_by_position() { "v_interpolator" } else { "v_command" }
}

/// The input velocities of the stages, and of a spindle that of the changeover.
fn signals(axis: &Axis, is_inside: bool) -> Vec<Signal> {
    let is_read = |name: &str| axis.ipc.stage.iter().flatten().any(|stage| stage.mode.source() == name);
    let command = match (axis.control.commands_by_position(), is_inside) {
        (true, true) => "the block itself",
        (true, false) => "the position controller with feedforward, before `v_add` is added",
        (false, _) => "the interpolator",
    };
    let is_spindle = is_inside && axis.control.spindle.is_some();
    let known = [
        (is_read("v_command"), command_name(axis, is_inside), command),
        (is_read("v_motor"), "v_motor", "the motor encoder"),
        (is_read("v_direct"), "v_direct", "the direct measuring system"),
        (is_spindle, "v_actual", "the actual velocity, for the changeover"),
    ];
    known.into_iter().filter(|(is_read, ..)| *is_read).map(|(_, name, meaning)| Signal { name, meaning }).collect()
}
