//! The operation mode that a drive displays. The meanings of the modes are not known here.

/// A drive changes its mode after another one has been requested for some cycles.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Display<M> {
    /// the displayed mode
    pub mode: M,
    /// number of consecutive cycles in which another mode has been requested
    pub asked: u32,
}

impl<M: PartialEq> Display<M> {
    /// Displays a mode.
    pub const fn of(mode: M) -> Self {
        Self { mode, asked: 0 }
    }

    /// One cycle. `after`: the number of cycles until it answers; `None` if it does not answer.
    pub fn ask(&mut self, mode: M, after: Option<u32>) {
        self.asked = if mode == self.mode { 0 } else { self.asked.saturating_add(1) };
        if after.is_some_and(|after| self.asked > after) {
            *self = Self::of(mode);
        }
    }
}
