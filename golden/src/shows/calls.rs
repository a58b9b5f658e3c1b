//! The events in a run of a block that counts its calls, in words. Other blocks have no such events.

use super::cycles;
use crate::samples::Samples;
use std::collections::BTreeSet;

/// The error id of the call rate.
const CALL_RATE: u32 = 9;

/// The examined values of one call.
#[derive(Clone, Copy, Default)]
struct Call {
    counter: u32,
    error_id: u32,
    /// whether v_add is not 0
    acts: bool,
}

/// The events of a run.
pub fn events(inputs: &Samples, outputs: &Samples) -> BTreeSet<String> {
    let (mut before, mut last, mut shown) = (Call::default(), Call::default(), BTreeSet::new());
    for of in cycles(inputs, outputs) {
        let (Some(counter), Some(error_id)) = (of.number("cycle_counter"), of.number("error_id")) else { break };
        let now = Call { counter, error_id, acts: of.real("v_add").is_some_and(|v| v != 0.0) };
        shown.extend(word(before, last, now).map(str::to_owned));
        (before, last) = (last, now);
    }
    shown
}

/// The event of a call, given the two previous calls.
fn word(before: Call, last: Call, now: Call) -> Option<&'static str> {
    let is_fault = now.error_id == CALL_RATE;
    let goes_on = now.acts && !is_fault;
    let [more, more_before] = [now.counter.wrapping_sub(last.counter), last.counter.wrapping_sub(before.counter)];
    match more {
        _ if now.counter == 0 && last.counter == u32::MAX && goes_on => Some("the counter wraps"),
        _ if now.counter == 0 && last.counter == 0 && goes_on => Some("calls are not counted"),
        _ if now.counter == 0 || last.counter == 0 => None,
        2 if is_fault && (last.acts || more_before == 2) => Some("fault 9 as calls are lost"),
        0 if is_fault => Some("fault 9 as calls are doubled"),
        2 if goes_on && last.acts => Some("a lost call is tolerated"),
        0 if goes_on && last.acts => Some("a doubled call is tolerated"),
        1.. if now.counter < last.counter && last.acts && !now.acts && !is_fault => {
            Some("restarts as the counter does")
        }
        4.. if last.acts && !now.acts && !is_fault => Some("restarts after a pause"),
        _ => None,
    }
}
