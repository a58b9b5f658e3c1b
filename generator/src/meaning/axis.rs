//! Two axes beside each other: their own values, and which stages to compare.

use super::number::{pair, significant};
use super::stage::{self, Designed};
use crate::axis::{Axis, Enable};
use crate::design::ipc::{fade_cycles, limit};
use portable::RealKind;

/// What differs: the axis's own values, one a line, then a line for each stage.
pub fn differences(old: &Axis, new: &Axis) -> Vec<String> {
    let both = |value: &dyn Fn(&Axis) -> f64| [value(old), value(new)];
    let mut lines = Vec::new();
    let mut number = |what: &str, [old, new]: [f64; 2], unit: &str| {
        if !same(old, new) {
            lines.push(format!("{what} {}{unit}", pair(old, new, 7)));
        }
    };
    number("cycle time", both(&|axis| f64::from(axis.cycle_time_ns) / 1e3), " us");
    number("v_max", both(&|axis| axis.ipc.v_max), "");
    let limits = both(&|axis| limit(&axis.ipc));
    if !same(limits[0], limits[1]) {
        let parts = both(&|axis| f64::from(axis.ipc.v_add_max_fact) / 10.0);
        let parts = if same(parts[0], parts[1]) { significant(parts[0], 7) } else { pair(parts[0], parts[1], 4) };
        lines.push(format!("limit {} ({parts} % of v_max)", pair(limits[0], limits[1], 7)));
    }
    if old.real != new.real {
        lines.push(format!("real type {} -> {}", real(old), real(new)));
    }
    if old.ipc.enable != new.ipc.enable {
        lines.push(format!("starts {} -> {}", enable(old), enable(new)));
    }
    let fades = both(&fade);
    if !same(fades[0], fades[1]) {
        lines.push(format!("fade {} s", pair(fades[0], fades[1], 4)));
    }
    let designed = |axis: &'_ Axis, index: usize| {
        axis.ipc.stage[index].as_ref().map(|stage| Designed::new(stage.clone(), axis.cycle_time()))
    };
    for index in 0..old.ipc.stage.len() {
        let line = stage::difference(designed(old, index).as_ref(), designed(new, index).as_ref());
        lines.extend(line.map(|line| format!("stage[{index}]: {line}")));
    }
    lines
}

/// A block that there was no other of.
pub fn described(axis: &Axis) -> Vec<String> {
    let mut lines = vec![format!(
        "{}, cycle time {} us, limit {} ({} % of v_max), starts {}, fade {} s",
        real(axis),
        significant(f64::from(axis.cycle_time_ns) / 1e3, 7),
        significant(limit(&axis.ipc), 7),
        significant(f64::from(axis.ipc.v_add_max_fact) / 10.0, 7),
        enable(axis),
        significant(fade(axis), 4),
    )];
    for (index, stage) in axis.ipc.stage.iter().enumerate() {
        let Some(stage) = stage else { continue };
        lines.push(format!("stage[{index}]: {}", stage::described(&Designed::new(stage.clone(), axis.cycle_time()))));
    }
    lines
}

/// What the block does, in whole cycles [s].
fn fade(axis: &Axis) -> f64 {
    f64::from(fade_cycles(axis)) * axis.cycle_time()
}

/// Whether two values are the same but for their last digits.
pub fn same(old: f64, new: f64) -> bool {
    (old - new).abs() <= 1e-12 * old.abs().max(new.abs())
}

fn real(axis: &Axis) -> &'static str {
    match axis.real {
        RealKind::F64 => "f64",
        RealKind::F32 => "f32",
    }
}

fn enable(axis: &Axis) -> &'static str {
    match axis.ipc.enable {
        Enable::Off => "OFF",
        Enable::On => "ON",
        Enable::DryRun => "DRYRUN",
    }
}
