//! The events of a run of the block `excitation`, in words. Another block has none.

use crate::samples::Samples;
use portable::Literal;
use std::collections::BTreeSet;

/// One cycle, as far as it is looked at.
#[derive(Clone, Copy, Default)]
struct Cycle {
    active: bool,
    done: bool,
    fault: bool,
    held: bool,
    period: u32,
    error_id: u32,
}

/// The events of a run.
pub fn events(inputs: &Samples, outputs: &Samples) -> BTreeSet<String> {
    let mut shown = BTreeSet::new();
    let output = |name| outputs.shape.place(name);
    let Some(held) = inputs.shape.place("hold_to_run") else { return shown };
    let places = (output("active"), output("done"), output("fault"), output("period"), output("error_id"));
    let (Some(active), Some(done), Some(fault), Some(period), Some(error_id)) = places else { return shown };
    let (mut given, mut answers, mut last) = (Vec::new(), Vec::new(), Cycle::default());
    for sample in 0..inputs.len() {
        inputs.read(sample, &mut given);
        outputs.read(sample, &mut answers);
        let is = |value| value == Literal::Bool(true);
        let number = |value| if let Literal::U32(number) = value { number } else { 0 };
        let now = Cycle {
            active: is(answers[active]),
            done: is(answers[done]),
            fault: is(answers[fault]),
            held: is(given[held]),
            period: number(answers[period]),
            error_id: number(answers[error_id]),
        };
        shown.extend(words(&last, &now).into_iter().map(str::to_owned));
        last = now;
    }
    shown
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
        (!now.active && !now.fault && now.held && !now.done && !notice, "no start without a rising edge"),
    ];
    events.into_iter().filter(|(is, _)| *is).map(|(_, word)| word).collect()
}
