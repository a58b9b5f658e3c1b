//! The rate of the calls, from the text of docs/improved-position-control.md alone ("Called once in each cycle").

/// What is remembered of the calls.
#[derive(Clone, Copy, Debug, Default)]
pub struct Calls {
    /// the counter of the call before, if that is known
    last: Option<u32>,
    score: u32,
}

/// What follows from a call.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Verdict {
    /// the block starts anew
    pub restarts: bool,
    /// error 9
    pub is_fault: bool,
}

impl Calls {
    /// One call; `is_counted`: the axis has the key.
    pub fn call(&mut self, is_counted: bool, counter: u32) -> Verdict {
        if !is_counted {
            return Verdict { restarts: false, is_fault: false };
        }
        // Modulo 2^32: 1 is the next call.
        let distance = match self.last {
            Some(last) if counter != 0 => counter.wrapping_sub(last),
            _ => 1,
        };
        if distance == 1 {
            self.score = self.score.saturating_sub(1);
        } else {
            self.score = if self.score + 8 >= 16 { 32 } else { self.score + 8 };
        }
        // A counter of 0 is none. The one before it is the last that there is.
        self.last = (counter != 0 && counter != u32::MAX).then_some(counter);
        Verdict { restarts: distance > 3, is_fault: self.score >= 16 }
    }
}
