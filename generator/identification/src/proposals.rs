//! The proposals: recommended, strong and cautious stages from a response and a record; first ones without a response. The
//! search is in `search`.

use crate::figures::{Effect, Judge, Left, Record, Vibration};
use crate::response::{Lines, is_too_uncertain};
use crate::scenarios::{MOST_STAGES, Scenarios, controller, most};
use crate::search::{Candidate, Judged, MANDATORY, Search};
use crate::shape::{Mode, Shape, Stages, allpass};
use crate::what_if::Axis;
use portable::Extreme;
use stability::{Complex64, Controller, Drive, Loop, Points};

/// The largest |S| at P, half a cycle later, and with other loads.
const RECOMMENDED: [f64; 4] = [1.75, 2.0, 2.0, 2.0];
const STRONG: [f64; 4] = [2.0; 4];
const CAUTIOUS: [f64; 4] = [1.4; 4];
/// The drive where none is known [cycles, s], and the part of its largest weight.
const UNKNOWN: [f64; 2] = [1.5, 0.003];
const FIRST: f64 = 0.1;
/// The shapes for it: quality factors of DIRECT and INDIRECT, damping.
const FIRST_Q: [f64; 2] = [10.0, 2.0];
const FIRST_DAMPING: f64 = 0.8;

/// The kind of a proposal.
#[derive(Clone, Copy, Debug, Eq, PartialEq)]
pub enum Kind {
    /// Ms within 1.75, within 2 in the other scenarios
    Recommended,
    /// Ms within 2 in all scenarios
    Strong,
    /// the recommended shapes with Ms within 1.4 in all scenarios, at most the recommended weights
    Cautious,
    /// a tenth of the largest weights with a usual drive: the response is not known
    First,
    /// stages that somebody else chose
    Given,
}

impl Kind {
    /// Its name in reports.
    #[must_use]
    pub fn word(self) -> &'static str {
        match self {
            Self::Recommended => "recommended",
            Self::Strong => "strong",
            Self::Cautious => "cautious",
            Self::First => "first",
            Self::Given => "given",
        }
    }
}

/// Stages with weights, and their effect.
#[derive(Clone, Debug, PartialEq)]
pub struct Proposal {
    pub kind: Kind,
    /// one stage per vibration
    pub stages: Vec<(Shape, f64)>,
    pub prediction: Prediction,
}

/// The predicted effect of stages.
#[derive(Clone, Debug, PartialEq)]
pub struct Prediction {
    /// the remaining parts of the vibrations; without meaning if the first loop is not stable
    pub left: Left,
    /// the effect on the motor in the record
    pub effect: Effect,
    /// the largest |S|: at P, half a cycle later, with 15 % less load, with 15 % more; infinite: not stable
    pub ms: [f64; 4],
}

/// The reason why nothing is proposed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Refused {
    /// no vibration, or more than there are stages
    Vibrations(usize),
    /// the response has no line
    NoResponse,
    /// two standard errors of P are at least half of |P| at this frequency [Hz]
    TooUncertain(f64),
    /// the record has no window, or no channel, for a vibration
    NotRecorded,
    /// no weight is allowed: the drive alone is beyond the limit
    NoWeight,
}

/// The data for a proposal.
pub struct Task<'a, 's> {
    /// T [s]
    pub cycle_time: f64,
    /// Kv [1/s], if the position loop is closed
    pub position_gain: Option<f64>,
    /// P, smoothed
    pub lines: &'a Lines,
    /// a record with the stages off
    pub record: Record<'a>,
    /// vibrations that enter at the motor: |S/S0| does not describe others
    pub vibrations: &'a [Vibration],
    pub stages: &'a Stages<'s>,
}

impl Task<'_, '_> {
    /// The drives; the lowest f0 [Hz] of the stages, if it may lie below all vibrations.
    fn scenarios(&self, lowest: f64) -> Result<Scenarios, Refused> {
        let count = self.vibrations.len();
        if count == 0 || count > MOST_STAGES {
            return Err(Refused::Vibrations(count));
        }
        let lowest = self.vibrations.iter().fold(lowest, |lowest: f64, vibration| lowest.smaller(vibration.hz));
        Scenarios::new(self.lines, self.cycle_time, self.position_gain, lowest).ok_or(Refused::NoResponse)
    }

    fn judge<'a>(&'a self, scenarios: &'a Scenarios) -> Result<Judge<'a>, Refused> {
        let response = &scenarios.drives[0];
        if let Some(vibration) = self.vibrations.iter().find(|vibration| is_too_uncertain(response, vibration.hz)) {
            return Err(Refused::TooUncertain(vibration.hz));
        }
        let axis = Axis { cycle_time: self.cycle_time, position_gain: self.position_gain, response };
        Judge::new(axis, self.record, self.vibrations).ok_or(Refused::NotRecorded)
    }
}

/// What given stages do, as a controller; the stages of the task have no effect.
///
/// # Errors
/// [`Refused`]
pub fn try_out(task: &Task<'_, '_>, controller: Controller<'_>) -> Result<Prediction, Refused> {
    let lowest = controller.bands.iter().fold(f64::INFINITY, |lowest: f64, band| lowest.smaller(band.centre));
    let scenarios = task.scenarios(lowest)?;
    let judge = task.judge(&scenarios)?;
    let of = |t: f64| -> Complex64 {
        (controller.stage)(t).iter().zip(controller.weight).map(|(stage, weight)| stage * weight).sum()
    };
    let (left, effect) = judge.figures(of);
    let mut ms = scenarios.ms(&scenarios.at_places(of), 1.0);
    for (ms, is_stable) in ms.iter_mut().zip(scenarios.stable(controller)) {
        *ms = if is_stable { *ms } else { f64::INFINITY };
    }
    Ok(Prediction { left, effect, ms })
}

/// The recommended, the strong and the cautious proposal.
///
/// # Errors
/// [`Refused`]
pub fn propose(task: &Task<'_, '_>) -> Result<Vec<Proposal>, Refused> {
    let count = task.vibrations.len();
    let scenarios = task.scenarios(f64::INFINITY)?;
    let judge = task.judge(&scenarios)?;
    let search = |limits| Search {
        scenarios: &scenarios,
        judge: &judge,
        stages: task.stages,
        cycle_time: task.cycle_time,
        limits,
        vibrations: task.vibrations.iter().map(|vibration| vibration.hz).collect(),
    };
    let mut proposals = Vec::new();
    let mut recommended = None;
    for (kind, limits) in [(Kind::Recommended, RECOMMENDED), (Kind::Strong, STRONG)] {
        let search = search(limits);
        let found = search.best(&modes(count)).ok_or(Refused::NoWeight)?;
        proposals.extend(proposal(kind, &search, &found));
        recommended.get_or_insert(found);
    }
    if let Some(Judged { candidate, stages, .. }) = recommended {
        let search = search(CAUTIOUS);
        let of = |used: f64| search.judged(&Candidate { used, ..candidate.clone() });
        // The recommended weights are the largest: the search may have found that more would do harm.
        let cautious = of(0.0).and_then(|whole| of(libm::log(stages[0].1 / whole.stages[0].1).smaller(0.0)));
        proposals.extend(cautious.and_then(|found| proposal(Kind::Cautious, &search, &found)));
    }
    if proposals.is_empty() { Err(Refused::NoWeight) } else { Ok(proposals) }
}

/// Each combination of modes of a number of stages.
fn modes(count: usize) -> Vec<Vec<Mode>> {
    let mode = |bits: usize, i: usize| if bits >> i & 1 == 0 { Mode::Direct } else { Mode::Indirect };
    (0..1_usize << count).map(|bits| (0..count).map(|i| mode(bits, i)).collect()).collect()
}

/// A proposal; `None` if a loop is unstable between the points at which its weights were found.
fn proposal(kind: Kind, search: &Search<'_, '_>, found: &Judged) -> Option<Proposal> {
    let stages = found.stages.clone();
    search.scenarios.are_stable(search.stages, &stages).then(|| {
        let left = found.left.clone();
        let effect = search.judge.effect(search.stages, &stages);
        let ms = search.scenarios.ms(&search.scenarios.controller(search.stages, &stages), 1.0);
        Proposal { kind, stages, prediction: Prediction { left, effect, ms } }
    })
}

/// First stages without a response: 10 % of the largest weights, Ms within 2, with a drive of 1.5 cycles and 3 ms. A stage has
/// an all-pass where that drive lags by more than 90 degrees, and is left out if none is possible. Modes and frequencies [Hz]
/// of the vibrations, one stage for each; Kv [1/s] of a position loop in the CNC, or in the drive. `None` without vibrations,
/// with more vibrations than stages, or if no stage remains.
#[must_use]
pub fn first(
    vibrations: &[(Mode, f64)],
    cycle_time: f64,
    [position_gain, gain_in_drive]: [Option<f64>; 2],
    stages: &Stages<'_>,
) -> Option<Vec<(Shape, f64)>> {
    (1..=MOST_STAGES).contains(&vibrations.len()).then_some(())?;
    let shape = |(mode, hz): &(Mode, f64)| {
        let q = FIRST_Q[usize::from(*mode == Mode::Indirect)];
        (Shape { mode: *mode, f0: *hz, q, damping: FIRST_DAMPING, allpass: None }, 1.0)
    };
    let drive = Drive::Delay { cycles: UNKNOWN[0], time_constant: Some(UNKNOWN[1]) };
    let points = |of: &[(Shape, f64)]| {
        let controller = Controller { gain_in_drive, ..controller(stages, of, cycle_time, position_gain) };
        Points::new(controller, &[drive])
    };
    let plain: Vec<(Shape, f64)> = vibrations.iter().map(shape).collect();
    let without_allpass = points(&plain);
    let turned = plain.iter().filter_map(|(shape, weight)| {
        let lag = Loop::new(&without_allpass, drive).lag(shape.f0);
        // Without it the stage would excite what it is to damp.
        let allpass = if lag > MANDATORY { Some(allpass(shape.f0, lag, cycle_time)?) } else { None };
        Some((Shape { allpass, ..*shape }, *weight))
    });
    let mut of: Vec<(Shape, f64)> = turned.collect();
    if of.is_empty() {
        return None;
    }
    let points = points(&of);
    let [_, largest] = Loop::new(&points, drive).largest_parts();
    let factor = FIRST * largest.smaller(most(&of));
    of.iter_mut().for_each(|(_, weight)| *weight = factor);
    Some(of)
}
