//! The events of a run of the block `excitation`, in words. Another block has none.

use super::{Signals, cycles};
use crate::samples::Samples;
use std::collections::BTreeSet;

/// One cycle, as far as it is looked at.
#[derive(Clone, Copy, Default)]
struct Cycle {
    active: bool,
    done: bool,
    fault: bool,
    held: bool,
    controlled: bool,
    period: u32,
    error_id: u32,
}

/// The events of a run.
pub fn events(inputs: &Samples, outputs: &Samples) -> BTreeSet<String> {
    let (mut shown, mut last) = (BTreeSet::new(), Cycle::default());
    for signals in cycles(inputs, outputs) {
        let Some(now) = cycle(&signals) else { break };
        shown.extend(words(&last, &now).into_iter().map(str::to_owned));
        last = now;
    }
    shown
}

fn cycle(of: &Signals<'_>) -> Option<Cycle> {
    Some(Cycle {
        active: of.bool("active")?,
        done: of.bool("done")?,
        fault: of.bool("fault")?,
        held: of.bool("hold_to_run")?,
        controlled: of.bool("position_controlled")?,
        period: of.number("period")?,
        error_id: of.number("error_id")?,
    })
}

fn words(last: &Cycle, now: &Cycle) -> Vec<&'static str> {
    let notice = !now.fault && now.error_id > 0;
    let events = [
        (!last.active && now.active, "excitation starts"),
        (last.period == 0 && now.period == 1, "the first period is measured"),
        (!last.done && now.done, "all periods are measured"),
        (last.done && now.done && now.held, "the button stays pressed after the end"),
        (last.active && now.active && !now.held, "the button ends the excitation"),
        (last.active && now.active && notice, "the motor's direction ends the excitation"),
        (!last.active && !now.active && notice && last.error_id == 0, "no start at standstill"),
        (last.active && now.fault, "a fault ends the excitation"),
        (last.active && !now.controlled && !now.active, "the loss of position control ends the excitation"),
        (
            !last.controlled && now.controlled && now.held && !now.active,
            "the button stays pressed without position control",
        ),
        (!now.active && !now.fault && now.held && !now.done && !notice, "no start without a rising edge"),
    ];
    events.into_iter().filter(|(is, _)| *is).map(|(_, word)| word).collect()
}
