//! Improved position control inside `axis`: which inputs are read, when the stages rest, are preset and run, the limit, the fade.
//! The filters stand in `sections`.

use super::coefficients::Coefficients;
use super::exact::Exact;
use super::feedforward::is_in_range;
use super::history::Inputs;
use super::parameters::{Location, Mode, Parameters, Stage};
use super::rounding::{Interval, flags};
use super::sections::Filters;
use super::watch::Watch;

/// Relative to the largest input since the stages were preset: two realisations of one filter round differently.
const OF_DOUBLES: f64 = 1e-10;
/// The same in single precision.
const OF_SINGLES: f64 = 4e-6;

/// What it remembers.
#[derive(Clone, Debug)]
pub struct Ipc {
    stages: Vec<Filters>,
    /// cycles that the fade has moved up
    fade_cycles: u32,
    /// open so far, in cycles
    open: u32,
    runs: bool,
    /// largest contribution of an input since the stages were preset
    largest: f64,
    relative: f64,
    /// a sum of at most this is 0
    nothing: f64,
    /// bad samples in a row that are replaced; how many there have been
    ride_through: u32,
    bad: u32,
    /// whether weights and limit follow inputs; each stage's part of its weight, and that of the limit
    tunable: bool,
    weights: Vec<f64>,
    part_of_limit: f64,
    /// `v_command`, `v_motor`, `v_direct` with which the stages ran last
    before: [f64; 3],
    /// largest |v_add|
    limit: f64,
    /// a sum above this is a fault
    sum_limit: f64,
    /// whether the sum was, in the last cycle in which the stages ran
    is_disturbed: bool,
    /// what it is if that was a fault, where only the next cycle tells
    disturbed: Option<Box<Self>>,
    watch: Option<Watch>,
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
    /// Of an axis. The largest sum is the block's own number, [`assert_sum_limit`] compares it.
    ///
    /// # Panics
    /// If it is.
    #[must_use]
    pub fn new(p: &Parameters, c: &Coefficients, sum_limit: f64) -> Self {
        let ts = f64::from(p.cycle_ns) * 1e-9;
        let frequencies = |stage: &Stage| [Some(stage.band_pass.2), stage.all_pass.map(|(f0, _)| f0)];
        let lowest = p.stages.iter().flat_map(frequencies).flatten().fold(f64::INFINITY, f64::min);
        let fade = (f64::from(p.fade_ns) * 1e-9).max(if lowest.is_finite() { 1.0 / lowest } else { 0.0 });
        #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "at most 1000 cycles")]
        let fade_cycles = (fade / ts - 1e-9).ceil().max(1.0) as u32;
        let stages: Vec<Filters> = p.stages.iter().map(|stage| Filters::new(stage, ts)).collect();
        let nothing = f64::from(p.vb_max) * 2f64.powi(if p.single { -40 } else { -60 });
        let relative = if p.single { OF_SINGLES } else { OF_DOUBLES };
        assert_sum_limit(&stages, p, c, sum_limit);
        let (open, runs, largest, is_disturbed, disturbed) = (0, false, 0.0, false, None);
        let (ride_through, bad, before) = (p.ride_through, 0, [0.0; 3]);
        let tunable = p.tunable == "weights";
        let start = if tunable { 0.0 } else { 1.0 };
        let (weights, part_of_limit) = (vec![start; stages.len()], start);
        Self {
            stages,
            ride_through,
            bad,
            tunable,
            weights,
            part_of_limit,
            before,
            fade_cycles,
            open,
            runs,
            largest,
            relative,
            nothing,
            limit: c.limit.near(),
            sum_limit,
            is_disturbed,
            disturbed,
            watch: Watch::new(p, c.limit.near()),
        }
    }

    /// The reason why it cannot act, the first in the order 11, 12, 13, 3, 2; 0: none. `v_command` is what SET_POINT reads.
    #[must_use]
    pub fn fault(&self, p: &Parameters, c: &Coefficients, inputs: &Inputs, v_command: f64) -> u32 {
        let bad = |modes: &[Mode], value: f64| Coefficients::reads(p, modes) && !is_in_range(c, value);
        match () {
            () if !c.runs_stages => 0,
            () if bad(&[Mode::SetPoint], v_command) => 11,
            () if bad(&[Mode::Indirect, Mode::DirectMotor], inputs.v_motor) => 12,
            () if bad(&[Mode::DirectLoad], inputs.v_direct) => 13,
            () if self.is_disturbed => 3,
            () if !(0..=2).contains(&inputs.mode) => 2,
            () => 0,
        }
    }

    /// Where rounding left open whether the sum of the cycle before was a fault: whether it was.
    pub fn decide(&mut self, was_fault: bool) {
        if let Some(disturbed) = self.disturbed.take().filter(|_| was_fault) {
            *self = *disturbed;
        }
    }

    /// Moves the parts of weights and limit towards their inputs, by 1 / fade_cycles a cycle at most; while nothing is added, at once. Whether an
    /// input is not a number from 0 to 1, so that its part stays.
    #[must_use]
    pub fn tune(&mut self, inputs: &Inputs) -> bool {
        if !self.tunable {
            return false;
        }
        let step = 1.0 / f64::from(self.fade_cycles);
        let mut is_held = false;
        let parts = self.weights.iter_mut().zip(inputs.tuning_weight);
        for (part, wanted) in parts.chain([(&mut self.part_of_limit, inputs.tuning_limit)]) {
            if !(0.0..=1.0).contains(&wanted) {
                is_held = true;
                continue;
            }
            let wanted = if wanted < 1e-6 { 0.0 } else { wanted };
            *part = if self.open == 0 { wanted } else { wanted.clamp(*part - step, *part + step) };
        }
        is_held
    }

    /// A cycle in which the whole axis does not act: it does not read what the caller tunes.
    pub fn rest(&mut self) -> Added {
        self.tune_anew();
        self.stop()
    }

    /// What the caller tunes is 0 until its input is usable, as before the first cycle.
    fn tune_anew(&mut self) {
        if self.tunable {
            self.weights.fill(0.0);
            self.part_of_limit = 0.0;
        }
    }

    /// The inputs and `v_command` with which a cycle runs, and whether the last good sample stands instead of one of them.
    #[must_use]
    pub fn ride(&mut self, p: &Parameters, c: &Coefficients, inputs: &Inputs, v_command: f64) -> (Inputs, f64, bool) {
        const READ_BY: [&[Mode]; 3] = [&[Mode::SetPoint], &[Mode::Indirect, Mode::DirectMotor], &[Mode::DirectLoad]];
        let mut velocities = [v_command, inputs.v_motor, inputs.v_direct];
        let is_bad = [0, 1, 2].map(|i| Coefficients::reads(p, READ_BY[i]) && !is_in_range(c, velocities[i]));
        let is_held = is_bad.contains(&true) && inputs.position_controlled && !inputs.reset && self.can_ride();
        if !is_bad.contains(&true) {
            self.bad = 0;
        } else if is_held {
            self.bad += 1;
            (0..3).filter(|i| is_bad[*i]).for_each(|i| velocities[i] = self.before[i]);
        }
        let [v_command, v_motor, v_direct] = velocities;
        (Inputs { v_motor, v_direct, ..*inputs }, v_command, is_held)
    }

    /// Whether the last good sample would stand instead of a bad one.
    #[must_use]
    pub fn can_ride(&self) -> bool {
        self.runs && self.bad < self.ride_through
    }

    /// The watch is ready again where the mode is not ON, and with a reset, whatever else the cycle does.
    pub fn rearm(&mut self, inputs: &Inputs) {
        if inputs.mode != 1 || inputs.reset {
            self.watch.iter_mut().for_each(Watch::rearm);
        }
    }

    /// Filters, limit, largest sum and quiet span of another parameter set: the stages start anew.
    pub fn take(&mut self, stages: &[Filters], [limit, sum_limit, quiet]: [f64; 3]) {
        (self.stages, self.limit, self.sum_limit, self.runs) = (stages.to_vec(), limit, sum_limit, false);
        self.watch.iter_mut().for_each(|watch| watch.quiet = quiet);
    }

    /// Whether something is added: the fade is not 0.
    #[must_use]
    pub fn is_open(&self) -> bool {
        self.open > 0
    }

    /// Cycles from 0 to the whole fade.
    #[must_use]
    pub fn fade_cycles(&self) -> u32 {
        self.fade_cycles
    }

    /// Whether the sum of the cycle before was a fault, which this cycle tells.
    #[must_use]
    pub fn is_disturbed(&self) -> bool {
        self.is_disturbed
    }

    /// Whether the watch has tripped.
    #[must_use]
    pub fn is_tripped(&self) -> bool {
        self.watch.as_ref().is_some_and(|watch| watch.tripped)
    }

    /// At once to 0; the stages are preset again afterwards, and an overwritten state is none any more.
    pub fn stop(&mut self) -> Added {
        (self.open, self.runs, self.is_disturbed, self.disturbed) = (0, false, false, None);
        NOTHING
    }

    /// A cycle without a fault. `mode`: 0 OFF, 1 ON, 2 DRYRUN. Where rounding leaves open whether the sum is a fault, it is none if `found`, the
    /// block's own `v_add_calculated` or `v_add`, is not 0; else the next cycle tells. `trips`: the block's own `tripped`.
    pub fn cycle(&mut self, c: &Coefficients, inputs: &Inputs, v_command: f64, found: f64, trips: bool) -> Added {
        let x = |mode: Mode| match mode {
            Mode::SetPoint => v_command,
            Mode::Indirect | Mode::DirectMotor => inputs.v_motor,
            Mode::DirectLoad => inputs.v_direct,
        };
        if self.runs || inputs.mode != 0 {
            self.before = [v_command, inputs.v_motor, inputs.v_direct];
        }
        let here: f64 = self.stages.iter().map(|stage| stage.gain * x(stage.mode).abs()).sum();
        if !self.runs {
            if inputs.mode == 0 {
                return NOTHING;
            }
            self.stages.iter_mut().for_each(|stage| stage.preset(x(stage.mode)));
            (self.runs, self.largest) = (true, here);
            self.watch.iter_mut().for_each(Watch::restart);
            return NOTHING;
        }
        // The fade in OFF ends: the output is 0, and no stage runs any more.
        if inputs.mode == 0 && self.open <= 1 {
            return self.stop();
        }
        self.largest = self.largest.max(here);
        let tuned = self.stages.iter_mut().zip(&self.weights);
        let v_sum: f64 = tuned.map(|(stage, weight)| stage.run(x(stage.mode)) * weight).sum();
        let limit = self.limit * self.part_of_limit;
        // A ramp adds up a rounding a cycle.
        let of_ramp = if self.tunable { 4.0 * c.u * f64::from(self.fade_cycles) } else { 0.0 };
        let off = (self.relative + of_ramp) * self.largest + of_ramp * self.limit;
        let [least, most] = [v_sum.abs() - off, v_sum.abs() + off];
        if most > self.sum_limit {
            let mut disturbed = Self { open: 0, runs: false, is_disturbed: true, disturbed: None, ..self.clone() };
            disturbed.tune_anew();
            if least > self.sum_limit {
                *self = disturbed;
                return Added { limited: [1.0; 2], ..NOTHING };
            }
            self.disturbed = (found == 0.0).then(|| Box::new(disturbed));
        }
        let is_open = self.disturbed.is_some();
        let limits = [(limit - of_ramp * self.limit).max(0.0), limit + of_ramp * self.limit];
        let within = |from: f64, to: f64, sum: f64| if sum < 0.0 { sum.max(-from) } else { sum.min(to) };
        let calculated = if is_open {
            [0.0; 2]
        } else {
            [within(limits[1], limits[0], v_sum - off), within(limits[0], limits[1], v_sum + off)]
        };
        self.open = if inputs.mode == 1 && !self.is_tripped() {
            (self.open + 1).min(self.fade_cycles)
        } else {
            self.open.saturating_sub(1)
        };
        let fade = f64::from(self.open) / f64::from(self.fade_cycles);
        if inputs.mode == 1 {
            self.watch.iter_mut().for_each(|watch| watch.cycle(v_sum, off, limit, trips));
        }
        // Rounding of the limit, of the fade and of their product.
        let rounded = |[from, to]: Interval| [from - 4.0 * c.u * from.abs(), to + 4.0 * c.u * to.abs()];
        // With the limit 0 the flag sees the states' constant, before a sum of next to nothing becomes 0.
        let off = off.max(4.0 * c.u * limit).max(self.nothing);
        let [least, most] = [v_sum.abs() - off, v_sum.abs() + off];
        Added {
            v_add: rounded(calculated.map(|v| fade * v)),
            calculated: if inputs.mode == 0 { [0.0; 2] } else { rounded(calculated) },
            limited: flags([least > limit && !is_open, most > limit]),
        }
    }
}

/// The largest sum that is not a fault is the block's own number. It is the one of the documents, but for rounding.
///
/// # Panics
/// If it is not.
pub fn assert_sum_limit(stages: &[Filters], p: &Parameters, c: &Coefficients, sum_limit: f64) {
    let norms: f64 = stages.iter().map(|stage| stage.norm).sum();
    let own = (2.0 * c.limit.near().max(f64::from(p.vb_max) * norms)).min(2f64.powi(35));
    let off = (1e-14 + 2.0 * c.u) * own;
    assert!((sum_limit - own).abs() <= off, "sum_limit {sum_limit}, by the documents {own}");
}

/// What SET_POINT reads: the controller's output of this cycle, with a drive that controls the position the interpolator's.
#[must_use]
pub fn command(c: &Coefficients, inputs: &Inputs, v_command: f64) -> f64 {
    if c.location == Location::Cnc { v_command } else { inputs.v_interpolator }
}

/// A gantry slave: the master's value within the master's limit, which is rounded once.
#[must_use]
pub fn follow(c: &Coefficients, limit: &Exact, v_add_master: f64) -> Added {
    let limits = limit.range(c.u);
    let within = limits.map(|limit| v_add_master.clamp(-limit, limit));
    let v_add = [within[0].min(within[1]), within[0].max(within[1])];
    let beyond = limits.map(|limit| v_add_master.abs() > limit);
    Added { v_add, calculated: v_add, limited: flags(beyond) }
}
