//! A velocity that follows its command with a time constant, sample by sample. Nothing else of a machine.

/// `Tc dv/dt = v_command - v` with a command that is held for a cycle.
#[derive(Clone, Copy, Debug)]
pub struct Lag {
    /// part of the distance to the command that a cycle covers, 1 - exp(-Ts / Tc)
    part: f64,
    /// the velocity
    pub v: f64,
}

impl Lag {
    /// At rest; with a time constant of 0 it follows at once. Both times are in s.
    #[must_use]
    pub fn new(cycle: f64, time_constant: f64) -> Self {
        Self { part: 1.0 - libm::exp(-cycle / time_constant), v: 0.0 }
    }

    /// One cycle; gives the velocity at its end.
    pub fn next(&mut self, v_command: f64) -> f64 {
        self.v = if self.part < 1.0 { self.v + (v_command - self.v) * self.part } else { v_command };
        self.v
    }
}
