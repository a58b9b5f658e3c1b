//! What an axis's blocks do, in a few lines for the user, and what that means for the machine.

use crate::blocks::{self, Designed, Summary};

/// The lines for an axis.
pub fn text(designed: &Designed) -> String {
    let summaries: Vec<Summary> = blocks::of_axis(&designed.axis).map(|kind| kind.summary(designed)).collect();
    let heads: String = summaries.iter().map(|summary| summary.head.as_str()).collect();
    lines(designed, &heads, summaries.into_iter().flat_map(|summary| summary.lines))
}

/// The lines for an axis whose user wants to know what to think of it: a table and verdicts.
pub fn verdict(designed: &Designed) -> String {
    lines(designed, "", blocks::of_axis(&designed.axis).flat_map(|kind| kind.verdict(designed)))
}

fn lines(designed: &Designed, heads: &str, lines: impl Iterator<Item = String>) -> String {
    let axis = &designed.axis;
    let cycle = f64::from(axis.cycle_time_ns) / 1000.0;
    let names = blocks::names(axis).join(", ");
    let mut text = format!("axis {}: {names}, {}, cycle {cycle} us{heads}\n", axis.name, axis.real_name());
    for line in lines {
        text.extend(["  ", &line, "\n"]);
    }
    if !axis.control.assumed.is_empty() {
        text.extend(["  assumed: ", &axis.control.assumed.join(", "), "\n"]);
    }
    text
}
