//! Improved position control of two versions of an axis beside each other: its own values, and which stages to compare.

use super::super::values::is_same;
use super::stage_diff;
use crate::blocks::designed::Designed;
use crate::number::{pair, significant};
use crate::parameters::words::Words;

/// What differs: limit, start and fade, a line each, then a line for each stage.
pub(crate) fn differences(old: &Designed, new: &Designed) -> Vec<String> {
    let both = |value: &dyn Fn(&Designed) -> f64| [value(old), value(new)];
    let mut lines = Vec::new();
    let limits = both(&|of| of.axis.ipc.limit());
    if !is_same(limits[0], limits[1]) {
        let parts = both(&part);
        let parts = if is_same(parts[0], parts[1]) { significant(parts[0], 7) } else { pair(parts[0], parts[1], 4) };
        lines.push(format!("limit {} ({parts} % of v_max)", pair(limits[0], limits[1], 7)));
    }
    let starts = [old, new].map(|of| of.axis.ipc.enable);
    if starts[0] != starts[1] {
        lines.push(format!("starts {} -> {}", starts[0].name(), starts[1].name()));
    }
    let fades = both(&fade);
    if !is_same(fades[0], fades[1]) {
        lines.push(format!("fade {} s", pair(fades[0], fades[1], 4)));
    }
    for (index, (old, new)) in old.stage.iter().zip(&new.stage).enumerate() {
        let line = stage_diff::difference(old.as_ref(), new.as_ref());
        lines.extend(line.map(|line| format!("stage[{index}]: {line}")));
    }
    lines
}

/// The same of an axis that has no older version.
pub(crate) fn description(of: &Designed) -> Vec<String> {
    let ipc = &of.axis.ipc;
    let mut lines = vec![format!(
        "limit {} ({} % of v_max), starts {}, fade {} s",
        significant(ipc.limit(), 7),
        significant(part(of), 7),
        ipc.enable.name(),
        significant(fade(of), 4),
    )];
    let stages = of.stage.iter().flatten();
    lines.extend(stages.map(|stage| format!("stage[{}]: {}", stage.index, stage_diff::description(stage))));
    lines
}

/// The limit as a part of v_max [%].
fn part(of: &Designed) -> f64 {
    f64::from(of.axis.ipc.v_add_max_fact) / 10.0
}

/// What the block does, in whole cycles [s].
fn fade(of: &Designed) -> f64 {
    f64::from(of.ipc.fade_cycles) * of.axis.cycle_time()
}
