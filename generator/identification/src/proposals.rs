//! The proposals: recommended, strong and cautious stages from a response and a record; first ones without a response. The
//! search is in `search`.

use crate::figures::{Effect, Judge, Left, Record, Vibration};
use crate::response::{Lines, is_too_uncertain};
use crate::scenarios::{MOST_STAGES, Scenarios, controller, most};
use crate::search::{Judged, Search};
use crate::shape::{Mode, Shape, Stages};
use crate::what_if::Axis;
use portable::Extreme;
use stability::{Drive, Loop, Points};

/// The largest |S| at P, half a cycle later, and with other loads.
const RECOMMENDED: [f64; 4] = [1.75, 2.0, 2.0, 2.0];
const STRONG: [f64; 4] = [2.0; 4];
const CAUTIOUS: [f64; 4] = [1.4; 4];
/// Stages are useless if more than this part of every vibration remains.
const USELESS: f64 = 0.8;
/// The assumed drive if none is known [cycles, s], and the part of its largest weight.
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
    /// the recommended shapes with Ms within 1.4 in all scenarios
    Cautious,
    /// a tenth of the largest weights with a usual drive: the response is not known
    First,
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
        }
    }
}

/// Stages with weights, and their effect.
#[derive(Clone, Debug, PartialEq)]
pub struct Proposal {
    pub kind: Kind,
    /// one stage per vibration
    pub stages: Vec<(Shape, f64)>,
    /// the remaining parts of the vibrations
    pub left: Left,
    /// their effect on the motor in the record
    pub effect: Effect,
    /// the largest |S|: at P, half a cycle later, with 15 % less load, with 15 % more
    pub ms: [f64; 4],
    /// more than 0.8 of every vibration remains
    pub is_useless: bool,
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

/// The recommended, the strong and the cautious proposal.
///
/// # Errors
/// [`Refused`]
pub fn propose(task: &Task<'_, '_>) -> Result<Vec<Proposal>, Refused> {
    let count = task.vibrations.len();
    if count == 0 || count > MOST_STAGES {
        return Err(Refused::Vibrations(count));
    }
    let lowest = task.vibrations.iter().fold(f64::INFINITY, |lowest: f64, vibration| lowest.smaller(vibration.hz));
    let scenarios =
        Scenarios::new(task.lines, task.cycle_time, task.position_gain, lowest).ok_or(Refused::NoResponse)?;
    let response = &scenarios.drives[0];
    if let Some(vibration) = task.vibrations.iter().find(|vibration| is_too_uncertain(response, vibration.hz)) {
        return Err(Refused::TooUncertain(vibration.hz));
    }
    let axis = Axis { cycle_time: task.cycle_time, position_gain: task.position_gain, response };
    let judge = Judge::new(axis, task.record, task.vibrations).ok_or(Refused::NotRecorded)?;
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
    if let Some(Judged { candidate, .. }) = recommended {
        let search = search(CAUTIOUS);
        let cautious = search.judged(&crate::search::Candidate { used: 0.0, ..candidate });
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
    let (stages, left) = (found.stages.clone(), found.left.clone());
    search.scenarios.are_stable(search.stages, &stages).then(|| Proposal {
        kind,
        effect: search.judge.effect(search.stages, &stages),
        ms: search.scenarios.ms(&search.scenarios.controller(search.stages, &stages), 1.0),
        is_useless: left.residuals.iter().all(|left| *left > USELESS),
        left,
        stages,
    })
}

/// First stages without a response: 10 % of the largest weights, Ms within 2, with a drive of 1.5 cycles and 3 ms. Modes and
/// frequencies [Hz] of the vibrations; one stage for each. `None` if there is no vibration, or more than there are stages.
#[must_use]
pub fn first(
    vibrations: &[(Mode, f64)],
    cycle_time: f64,
    position_gain: Option<f64>,
    stages: &Stages<'_>,
) -> Option<Vec<(Shape, f64)>> {
    (1..=MOST_STAGES).contains(&vibrations.len()).then_some(())?;
    let shape = |(mode, hz): &(Mode, f64)| {
        let q = FIRST_Q[usize::from(*mode == Mode::Indirect)];
        (Shape { mode: *mode, f0: *hz, q, damping: FIRST_DAMPING, allpass: None }, 1.0)
    };
    let mut of: Vec<(Shape, f64)> = vibrations.iter().map(shape).collect();
    let drive = Drive::Delay { cycles: UNKNOWN[0], time_constant: Some(UNKNOWN[1]) };
    let points = Points::new(controller(stages, &of, cycle_time, position_gain), &[drive]);
    let [_, largest] = Loop::new(&points, drive).largest_parts();
    let factor = FIRST * largest.smaller(most(&of));
    of.iter_mut().for_each(|(_, weight)| *weight = factor);
    Some(of)
}
