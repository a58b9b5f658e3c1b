//! What the block knows of a spindle that it does not move yet: the samples of its velocity in a row. No state.

use super::motion::{is_velocity, weight, wrap};
use super::{Inputs, Parameters};

/// Samples of the actual velocity, without one that is missing between them.
#[derive(Clone, Debug, Default)]
pub struct Samples(Vec<f64>);

impl Samples {
    /// A cycle: whether it has a sample. Without one nothing is known any more.
    pub fn take(&mut self, v_actual: f64) -> bool {
        let is_known = is_velocity(v_actual);
        if is_known {
            self.0.push(v_actual);
        } else {
            self.0.clear();
        }
        is_known
    }

    pub fn forget(&mut self) {
        self.0.clear();
    }

    /// The last three; before there are three the first one instead of those before it.
    fn last_three(&self) -> Option<[f64; 3]> {
        let first = *self.0.first()?;
        let back = |age: usize| self.0.len().checked_sub(age).map_or(first, |place| self.0[place]);
        Some([back(3), back(2), back(1)])
    }

    /// The median of the last three; 0 within the window, for the spindle stands.
    #[must_use]
    pub fn velocity(&self, p: &Parameters) -> Option<f64> {
        let mut sorted = self.last_three()?;
        sorted.sort_by(f64::total_cmp);
        Some(if sorted[1].abs() <= p.window { 0.0 } else { sorted[1] })
    }

    /// Whether three cycles in a row were slow enough for position control.
    #[must_use]
    pub fn is_slow(&self, p: &Parameters) -> bool {
        self.0.len() >= 3 && self.0.iter().rev().take(3).all(|v| v.abs() <= p.v_off + p.window)
    }

    /// Whether the median of three is too fast for it.
    #[must_use]
    pub fn is_fast(&self, p: &Parameters) -> bool {
        self.0.len() >= 3 && self.velocity(p).is_some_and(|v| v.abs() > p.v_off + p.window)
    }
}

/// By how long the command of the next cycle leads the actual position of this one.
#[must_use]
pub fn lead_time(p: &Parameters, inputs: &Inputs) -> f64 {
    let late = if p.in_cnc { 0 } else { p.nd };
    let lag = if p.only_velocity { 0.0 } else { (1.0 - weight(p, inputs)) / p.kv };
    f64::from(late + 1) * p.cycle + lag
}

/// A position that leads another one; that one, if the way is beyond what is in range.
#[must_use]
pub fn ahead(x: f64, v: f64, time: f64) -> f64 {
    let way = v * time;
    wrap(if way.abs() <= 1e9 { x + way } else { x })
}
