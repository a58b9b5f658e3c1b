//! What an axis's blocks do, in a few lines for the user.

use crate::blocks::{self, Designed, Summary};

/// The lines for an axis.
pub fn text(designed: &Designed) -> String {
    let axis = &designed.axis;
    let real = axis.real_name();
    let cycle = f64::from(axis.cycle_time_ns) / 1000.0;
    let summaries: Vec<Summary> = blocks::of_axis(axis).map(|kind| kind.summary(designed)).collect();
    let heads: String = summaries.iter().map(|summary| summary.head.as_str()).collect();
    let names = blocks::names(axis).join(", ");
    let mut text = format!("axis {}: {names}, {real}, cycle {cycle} us{heads}\n", axis.name);
    for line in summaries.iter().flat_map(|summary| &summary.lines) {
        text.extend(["  ", line, "\n"]);
    }
    if !axis.control.assumed.is_empty() {
        text.extend(["  assumed: ", &axis.control.assumed.join(", "), "\n"]);
    }
    text
}
