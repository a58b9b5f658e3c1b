//! The events in a run of improved position control, in words. A run of other signals has none.

use super::{Signals, cycles};
use crate::samples::Samples;
use portable::Literal;
use std::collections::BTreeSet;

/// Cycles at rest, up to the end of the run, in which the output must be exactly 0.
const REST: usize = 100;

/// Larger velocities are bad samples: the limit of single precision, which no axis in double precision reaches either.
const FASTEST: f64 = 1e9;

const OFF: i32 = 0;
const ON: i32 = 1;
const DRYRUN: i32 = 2;

/// One cycle. Reals are f64, which holds them exactly.
#[derive(Default)]
struct Cycle {
    velocities: Vec<f64>,
    mode: i32,
    position_controlled: bool,
    reset: bool,
    task_cycle_ns: u32,
    v_add: f64,
    v_add_calculated: f64,
    limited: bool,
    tripped: bool,
    fault: bool,
    error_id: u32,
}

/// The events of a run.
pub fn shown(inputs: &Samples, outputs: &Samples) -> BTreeSet<String> {
    let mut watch = Watch::default();
    for signals in cycles(inputs, outputs) {
        let Some(cycle) = cycle(&signals) else { return BTreeSet::new() };
        watch.see(cycle);
    }
    if watch.rest >= REST {
        watch.shown.insert("rest is exactly 0".to_owned());
    }
    watch.shown
}

/// The state of the search for events.
#[derive(Default)]
struct Watch {
    shown: BTreeSet<String>,
    /// the previous cycle
    last: Cycle,
    /// reasons why the block stopped, until it acts again
    stops: BTreeSet<String>,
    /// number of cycles at rest
    rest: usize,
}

impl Watch {
    fn see(&mut self, now: Cycle) {
        let words = [
            of_limit(&now),
            of_samples(&now),
            of_task_cycle(&now),
            of_fade(&now, &self.last),
            of_watch(&now, &self.last),
        ];
        self.shown.extend(words.into_iter().flatten().map(str::to_owned));
        if now.v_add == 0.0 {
            self.stops.extend(of_stop(&now, self.last.v_add != 0.0));
        } else {
            self.shown
                .extend(std::mem::take(&mut self.stops).into_iter().map(|stop| format!("acts again after {stop}")));
        }
        self.shown.extend(now.fault.then(|| format!("fault {}", now.error_id)));
        self.rest = if at_rest(&now) { self.rest + 1 } else { 0 };
        self.last = now;
    }
}

fn of_limit(now: &Cycle) -> Option<&'static str> {
    match now.v_add_calculated {
        v if now.limited && v > 0.0 => Some("limited above"),
        v if now.limited && v < 0.0 => Some("limited below"),
        _ if now.limited => Some("limited to 0"),
        _ => None,
    }
}

fn of_samples(now: &Cycle) -> Option<&'static str> {
    let bad = now.velocities.iter().find(|v| v.is_nan() || v.abs() > FASTEST)?;
    match bad {
        _ if !now.fault => Some("bad sample that no stage reads").filter(|_| !bad.is_finite()),
        _ if bad.is_nan() => Some("bad sample: NaN"),
        _ if bad.is_infinite() => Some("bad sample: infinity"),
        _ => Some("bad sample: beyond the limit"),
    }
}

fn of_task_cycle(now: &Cycle) -> Option<&'static str> {
    (now.task_cycle_ns != 0 && !now.fault).then_some("task cycle is right")
}

fn of_fade(now: &Cycle, last: &Cycle) -> Option<&'static str> {
    let is_between = |cycle: &Cycle| 0.0 < cycle.v_add.abs() && cycle.v_add.abs() < cycle.v_add_calculated.abs();
    let moves = now.velocities.iter().any(|v| *v != 0.0) && !now.fault && now.position_controlled && !now.reset;
    match now.mode {
        ON if is_between(now) && last.mode == DRYRUN && is_between(last) => Some("fade turns round"),
        ON if is_between(now) => Some("fading in"),
        ON if now.v_add != 0.0 => Some("faded in"),
        DRYRUN if is_between(now) => Some("fading out in DRYRUN"),
        DRYRUN if now.v_add == 0.0 && now.v_add_calculated != 0.0 => Some("DRYRUN while moving"),
        OFF if now.v_add != 0.0 => Some("fading out in OFF"),
        OFF if moves => Some("OFF while moving"),
        _ => None,
    }
}

fn of_watch(now: &Cycle, last: &Cycle) -> Option<&'static str> {
    match (last.tripped, now.tripped) {
        (false, true) => Some("tripped"),
        (true, true) if now.v_add == 0.0 && now.v_add_calculated != 0.0 => Some("tripped and faded out"),
        (true, false) if now.reset => Some("armed again by reset"),
        (true, false) => Some("armed again by mode"),
        _ => None,
    }
}

/// The reasons why a block that has just acted does not act.
fn of_stop(now: &Cycle, acted: bool) -> Vec<String> {
    let reasons = [(now.reset, "reset"), (!now.position_controlled, "loss of position control")];
    let reasons = reasons.into_iter().filter(|(holds, _)| *holds && acted).map(|(_, reason)| reason.to_owned());
    reasons.chain(now.fault.then(|| format!("fault {}", now.error_id))).collect()
}

/// Whether the block is on, the axis is at rest, and the output is exactly +0.
fn at_rest(now: &Cycle) -> bool {
    let positive_zero = 0.0f64.to_bits();
    now.mode == ON
        && now.position_controlled
        && !now.reset
        && !now.fault
        && now.velocities.iter().all(|v| v.to_bits() == positive_zero)
        && now.v_add.to_bits() == positive_zero
        && now.v_add_calculated.to_bits() == positive_zero
}

/// The values of a cycle; `None` if they belong to another block.
fn cycle(of: &Signals<'_>) -> Option<Cycle> {
    let Literal::I32(mode) = of.value("mode")? else { return None };
    Some(Cycle {
        velocities: ["v_command", "v_motor", "v_direct"]
            .into_iter()
            .map(|name| of.real(name))
            .collect::<Option<_>>()?,
        mode,
        position_controlled: of.bool("position_controlled")?,
        reset: of.bool("reset")?,
        task_cycle_ns: of.number("task_cycle_ns")?,
        v_add: of.real("v_add")?,
        v_add_calculated: of.real("v_add_calculated")?,
        limited: of.bool("limited")?,
        tripped: of.bool("tripped")?,
        fault: of.bool("fault")?,
        error_id: of.number("error_id")?,
    })
}
