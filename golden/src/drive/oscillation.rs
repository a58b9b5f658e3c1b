//! What a run shows of an unstable loop: `v_add` stays at its limit where no ramp is the reason.

/// How long `v_add` may be at its limit without a ramp [s].
const ALLOWED: f64 = 0.2;
/// How long after a ramp the limit may still act because of it [s].
const SETTLED: f64 = 0.3;

/// A loop, and what a run of it showed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Oscillation {
    /// whether the loop is stable, by its frequency responses
    pub is_stable: bool,
    /// how long `v_add` was at its limit where no ramp is [s]
    pub at_limit: f64,
}

impl Oscillation {
    /// What has to be reported; none: nothing.
    #[must_use]
    pub fn verdict(self) -> Option<String> {
        let time = self.at_limit;
        match (time > ALLOWED, self.is_stable) {
            (true, false) => Some(format!("v_add at its limit for {time:.1} s: the loop is unstable")),
            (false, false) => Some("v_add has not reached its limit yet, but the loop is unstable".to_owned()),
            (true, true) => Some(format!(
                "v_add at its limit for {time:.1} s: the loop is stable, the limit too small for this vibration"
            )),
            (false, true) => None,
        }
    }
}

/// Counts for how long `v_add` is at its limit without a ramp.
pub(crate) struct AtLimit {
    /// [s]
    cycle: f64,
    since_ramp: f64,
    time: f64,
}

impl AtLimit {
    /// Long after any ramp; the cycle is in seconds.
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

    /// So far [s].
    pub(crate) fn time(&self) -> f64 {
        self.time
    }
}
