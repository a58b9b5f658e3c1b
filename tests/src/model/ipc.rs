//! Improved position control inside `axis`: which inputs are read, when the stages rest, settle and run, the limit, the gate.
//! The filters stand in `sections`.

use super::coefficients::Coefficients;
use super::feedforward::is_usable;
use super::history::Inputs;
use super::parameters::{Mode, Parameters, Place};
use super::rounding::{Interval, flags};
use super::sections::Filters;

/// Relative to the largest input since the stages settled: two realisations of one filter round differently.
const OF_DOUBLES: f64 = 1e-10;
/// The same in single precision.
const OF_SINGLES: f64 = 4e-6;

/// What it remembers.
#[derive(Clone, Debug)]
pub struct Ipc {
    stages: Vec<Filters>,
    /// cycles in which the gate opens
    fade_cycles: u32,
    /// open so far, in cycles
    open: u32,
    runs: bool,
    /// largest contribution of an input since the stages settled
    largest: f64,
    relative: f64,
}

/// What it puts out.
#[derive(Clone, Copy, Debug)]
pub struct Added {
    /// `v_add`
    pub v_add: Interval,
    /// `v_add_calculated`
    pub calculated: Interval,
    /// whether the limit acts
    pub limited: Interval,
}

/// Nothing is added.
pub const NOTHING: Added = Added { v_add: [0.0; 2], calculated: [0.0; 2], limited: [0.0; 2] };

impl Ipc {
    /// Of an axis.
    #[must_use]
    pub fn of(p: &Parameters) -> Self {
        let ts = f64::from(p.cycle_ns) * 1e-9;
        let lowest = p.stages.iter().map(|stage| stage.band_pass.2).fold(f64::INFINITY, f64::min);
        let fade = (f64::from(p.fade_ns) * 1e-9).max(if lowest.is_finite() { 1.0 / lowest } else { 0.0 });
        #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "at most 1000 cycles")]
        let fade_cycles = (fade / ts - 1e-9).ceil().max(1.0) as u32;
        let stages = p.stages.iter().map(|stage| Filters::of(stage, ts)).collect();
        let relative = if p.single { OF_SINGLES } else { OF_DOUBLES };
        Self { stages, fade_cycles, open: 0, runs: false, largest: 0.0, relative }
    }

    /// The reason why it cannot act, the first in the order 2, 11, 12, 13; 0: none. `v_command` is what SET_POINT reads.
    #[must_use]
    pub fn fault(p: &Parameters, c: &Coefficients, inputs: &Inputs, v_command: f64) -> u32 {
        let bad = |modes: &[Mode], value: f64| Coefficients::reads(p, modes) && !is_usable(c, value);
        match () {
            () if !c.runs_stages => 0,
            () if !(0..=2).contains(&inputs.mode) => 2,
            () if bad(&[Mode::SetPoint], v_command) => 11,
            () if bad(&[Mode::Indirect, Mode::DirectMotor], inputs.v_motor) => 12,
            () if bad(&[Mode::DirectLoad], inputs.v_direct) => 13,
            () => 0,
        }
    }

    /// At once to 0; the stages settle anew afterwards.
    pub fn stop(&mut self) -> Added {
        (self.open, self.runs) = (0, false);
        NOTHING
    }

    /// A cycle without a fault. `mode`: 0 OFF, 1 ON, 2 DRYRUN.
    pub fn cycle(&mut self, c: &Coefficients, inputs: &Inputs, v_command: f64) -> Added {
        let x = |mode: Mode| match mode {
            Mode::SetPoint => v_command,
            Mode::Indirect | Mode::DirectMotor => inputs.v_motor,
            Mode::DirectLoad => inputs.v_direct,
        };
        let here: f64 = self.stages.iter().map(|stage| stage.gain * x(stage.mode).abs()).sum();
        if !self.runs {
            if inputs.mode == 0 {
                return NOTHING;
            }
            self.stages.iter_mut().for_each(|stage| stage.settle(x(stage.mode)));
            (self.runs, self.largest) = (true, here);
            return NOTHING;
        }
        self.largest = self.largest.max(here);
        let v_sum: f64 = self.stages.iter_mut().map(|stage| stage.run(x(stage.mode))).sum();
        let limit = c.limit.near();
        let off = self.relative * self.largest + limit * c.u * 4.0;
        let sums = [v_sum - off, v_sum + off];
        let calculated = sums.map(|sum| sum.clamp(-limit, limit));
        self.open = if inputs.mode == 1 { (self.open + 1).min(self.fade_cycles) } else { self.open.saturating_sub(1) };
        let gate = f64::from(self.open) / f64::from(self.fade_cycles);
        if inputs.mode == 0 && self.open == 0 {
            self.runs = false;
        }
        let may_be = |off: f64| v_sum.abs() + off > limit;
        Added {
            v_add: [gate * calculated[0] - off * c.u, gate * calculated[1] + off * c.u],
            calculated: if inputs.mode == 0 { [0.0; 2] } else { calculated },
            limited: flags([may_be(-off), may_be(off)]),
        }
    }
}

/// What SET_POINT reads: the controller's output of this cycle, with a drive that controls the position the interpolator's.
#[must_use]
pub fn command(c: &Coefficients, inputs: &Inputs, v_command: f64) -> f64 {
    if c.place == Place::Cnc { v_command } else { inputs.v_interpolator }
}

/// A gantry slave: the master's value within the master's limit.
#[must_use]
pub fn follow(limit: f64, v_add_master: f64) -> Added {
    let v_add = v_add_master.clamp(-limit, limit);
    Added { v_add: [v_add; 2], calculated: [v_add; 2], limited: flags([v_add_master.abs() > limit; 2]) }
}
