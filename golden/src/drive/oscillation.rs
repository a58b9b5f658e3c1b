//! The effect of an unstable loop in a run: `v_add` stays at its limit without a ramp as the reason.

/// The permitted time of `v_add` at its limit without a ramp [s].
const ALLOWED: f64 = 0.2;
/// The time after a ramp in which it may still be the reason for limiting [s].
const SETTLED: f64 = 0.3;

/// A loop and the result of its run.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Oscillation {
    /// whether the loop is stable, from its frequency responses; `None` if these do not show it
    pub is_stable: Option<bool>,
    /// time of `v_add` at its limit without a ramp [s]
    pub at_limit: f64,
}

impl Oscillation {
    /// The message; `None` if there is nothing to report.
    #[must_use]
    pub fn message(self) -> Option<String> {
        let time = self.at_limit;
        match (time > ALLOWED, self.is_stable) {
            (_, None) => Some("whether the loop is stable is not known: a stage has the input v_direct".to_owned()),
            (true, Some(false)) => Some(format!("v_add at its limit for {time:.1} s: the loop is unstable")),
            (false, Some(false)) => Some("v_add has not reached its limit yet, but the loop is unstable".to_owned()),
            (true, Some(true)) => Some(format!(
                "v_add at its limit for {time:.1} s: the loop is stable, the limit too small for this vibration"
            )),
            (false, Some(true)) => None,
        }
    }
}

/// Measures the time of `v_add` at its limit without a ramp.
pub(crate) struct AtLimit {
    /// [s]
    cycle: f64,
    since_ramp: f64,
    time: f64,
}

impl AtLimit {
    /// The state long after any ramp; the cycle is in seconds.
    pub(crate) fn new(cycle: f64) -> Self {
        Self { cycle, since_ramp: SETTLED, time: 0.0 }
    }

    /// A cycle.
    pub(crate) fn count(&mut self, is_ramp: bool, is_limited: bool) {
        self.since_ramp = if is_ramp { 0.0 } else { self.since_ramp + self.cycle };
        if is_limited && self.since_ramp > SETTLED {
            self.time += self.cycle;
        }
    }

    /// The time so far [s].
    pub(crate) fn time(&self) -> f64 {
        self.time
    }
}
