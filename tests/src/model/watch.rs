//! The watch over the loop (docs/improved-position-control.md, "The watch"): blocks of the sum, their spans, the score. Where rounding leaves a
//! comparison open, both scores are kept.

use super::parameters::Parameters;

/// What it remembers.
#[derive(Clone, Debug)]
pub struct Watch {
    /// cycles of a block
    length: u32,
    /// a score that trips
    alarm: u32,
    /// the growth of a block that spans less does not count
    pub quiet: f64,
    /// cycles of this block that are over, its highest and its lowest sum
    cycles: u32,
    sums: [f64; 2],
    /// the span of the block before
    before: f64,
    /// least and most that the score may be
    score: [u32; 2],
    /// whether it has tripped
    pub tripped: bool,
}

impl Watch {
    /// Of an axis with this limit; none: nothing is watched.
    #[must_use]
    pub fn new(p: &Parameters, limit: f64) -> Option<Self> {
        let lowest = p.stages.iter().map(|stage| stage.band_pass.2).min_by(f64::total_cmp)?;
        if !p.watch || limit <= 0.0 || p.master.is_some() {
            return None;
        }
        let ts = f64::from(p.cycle_ns) * 1e-9;
        #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "a few thousand")]
        let up = |quotient: f64| (quotient - 1e-9 * quotient).ceil() as u32;
        let length = up((0.6 / lowest).max(0.03) / ts).max(8);
        let alarm = 2 * up(0.15 / (f64::from(length) * ts)).max(3);
        let (cycles, sums, before, score, tripped) = (0, [0.0; 2], 0.0, [0; 2], false);
        let quiet = limit / 50.0;
        Some(Self { length, alarm, quiet, cycles, sums, before, score, tripped })
    }

    /// The stages start: blocks are counted anew.
    pub fn restart(&mut self) {
        (self.cycles, self.before, self.score) = (0, 0.0, [0; 2]);
    }

    /// The mode is not ON, or a reset.
    pub fn rearm(&mut self) {
        self.restart();
        self.tripped = false;
    }

    /// A cycle in which the mode is ON, with a sum that is known but for `off`, and this limit. Where that leaves open whether it trips, it does as `found` says.
    pub fn cycle(&mut self, v_sum: f64, off: f64, limit: f64, found: bool) {
        if self.tripped {
            return;
        }
        if limit <= 0.0 {
            return self.restart();
        }
        self.sums = match (self.cycles, self.sums) {
            (0, _) => [v_sum; 2],
            (_, [high, low]) => [high.max(v_sum), low.min(v_sum)],
        };
        self.cycles += 1;
        if self.cycles < self.length {
            return;
        }
        let [high, low] = self.sums;
        let span = high - low;
        // A condition holds, may hold: every term is known but for four of `off`, and of the rounding of a limit.
        let off = 4.0 * off + 1e-6 * limit.max(50.0 * self.quiet);
        let is_above = |excess: f64| [excess > off, excess > -off];
        let all = |of: &[[bool; 2]]| [of.iter().all(|of| of[0]), of.iter().all(|of| of[1])];
        let beyond = [is_above(high - limit), is_above(-limit - low)];
        let fills = all(&[beyond[0], beyond[1], is_above(span - 0.9 * self.before)]);
        let beyond = all(&beyond);
        let grows = all(&[is_above(self.before - self.quiet), is_above(span - 1.1 * self.before)]);
        let [least, most] = self.score;
        let least = match (fills, grows) {
            ([true, _], _) => least + 2,
            (_, [true, _]) => least + 1,
            _ if beyond[0] => least.saturating_sub(1),
            _ => 0,
        };
        let most = match (fills, grows) {
            ([_, true], _) => most + 2,
            (_, [_, true]) => most + 1,
            _ if beyond[1] => most.saturating_sub(1),
            _ => 0,
        };
        let wide = is_above(span - 2.0 * limit);
        let trips = [least >= self.alarm && wide[0], most >= self.alarm && wide[1]];
        self.tripped = if trips[0] == trips[1] { trips[0] } else { found };
        self.score = [least, most];
        (self.before, self.cycles) = (span, 0);
    }
}
