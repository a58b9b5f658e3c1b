//! The operation mode that a drive displays. What the modes are is the caller's.

/// A drive changes its mode after it has been asked for another one in some cycles.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Display<M> {
    /// the mode that is displayed
    pub mode: M,
    /// cycles in a row in which another mode has been asked for
    pub asked: u32,
}

impl<M: PartialEq> Display<M> {
    /// Displays a mode.
    pub const fn of(mode: M) -> Self {
        Self { mode, asked: 0 }
    }

    /// One cycle. `after`: the cycles that it answers later than at once; none: it does not answer.
    pub fn ask(&mut self, mode: M, after: Option<u32>) {
        self.asked = if mode == self.mode { 0 } else { self.asked.saturating_add(1) };
        if after.is_some_and(|after| self.asked > after) {
            *self = Self::of(mode);
        }
    }
}
