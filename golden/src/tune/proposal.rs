//! Proposals as data: stages and their effect, or the reason why there are none.

use super::chosen::Chosen;
use super::stage::{controller, responses, rounded};
use crate::measure::{Record, Verdict};
use generator::analysis;
use generator::axis::{Axis, Stage};
use generator::blocks::Designed;
use generator::codes;
use identification::figures::{self, Left, Vibration};
use identification::proposals::{self, Kind, Prediction, Refused, first, propose, try_out};
use identification::response::Lines;
use identification::scenarios::MOST_STAGES;
use identification::shape::Shape;
use std::ops::Range;

/// Micrometres of a metre.
const UM: f64 = 1e6;
/// A proposal gets a warning if its following error is larger than that without stages by more than this factor.
const MUCH_ERROR: f64 = 5.0;
/// The largest v_add_max_fact [0.1 %] (P-AXIS-00757).
const LARGEST_LIMIT: f64 = 2000.0;

/// Stages, one for each vibration.
#[derive(Clone, Debug, PartialEq)]
pub struct Proposal {
    pub kind: Kind,
    pub stages: Vec<Stage>,
    /// its velocity in um/s or 0.001 deg/s; `None` if the response of the drive is unknown
    pub predicted: Option<Prediction>,
}

impl Proposal {
    /// Whether more than 0.8 of every vibration remains.
    #[must_use]
    pub fn is_useless(&self) -> bool {
        self.predicted.as_ref().is_some_and(|predicted| predicted.left.is_useless())
    }
}

/// The data for proposals.
pub(super) struct Task<'a> {
    pub axis: &'a Axis,
    pub record: &'a Record,
    pub ramps: Vec<Range<usize>>,
    pub chosen: &'a [Chosen],
}

impl Task<'_> {
    /// Recommended, strong, cautious; without a search, and instead of them, the stages that are given.
    pub(super) fn proposals(
        &self,
        lines: &Lines,
        given: Option<&[Stage]>,
        verdicts: &mut Vec<Verdict>,
    ) -> Vec<Proposal> {
        let all = match self.predicted(lines, given) {
            Ok(found) if !found.is_empty() => found,
            found => {
                let refused = found.err().unwrap_or(Refused::NoWeight);
                verdicts.push(self.said(refused));
                return Vec::new();
            }
        };
        if all.iter().any(|of| !is_stable(of, verdicts)) {
            return Vec::new();
        }
        let all = settled(all, verdicts);
        let useless = all.iter().filter(|of| of.is_useless());
        let useless: Vec<&str> = useless.map(|of| of.kind.word()).collect();
        if !useless.is_empty() {
            let found = format!("hardly useful, more than 0.8 of every vibration is left: {}", useless.join(", "));
            let instead = "reduce the delay between position controller and drive, or speed up the velocity controller";
            verdicts.push(Verdict::note(codes::HARDLY_USEFUL, found, instead));
        }
        self.find_limit(&all, verdicts);
        find_error(&all, verdicts);
        all
    }

    /// The proposals of the search, or the prediction for the given stages.
    fn predicted(&self, lines: &Lines, given: Option<&[Stage]>) -> Result<Vec<Proposal>, Refused> {
        let (v_motor, error) = (self.record.get("v_motor").unwrap_or_default(), self.following_error());
        let load = self.record.load();
        let channel = |chosen: &Chosen| self.record.get(chosen.channel).unwrap_or_default();
        let channels: Vec<&[f64]> = self.chosen.iter().map(channel).collect();
        let vibration = |(channel, chosen): (usize, &Chosen)| {
            let channel = (chosen.channel != "following_error").then_some(channel);
            Vibration { hz: chosen.hz, when: chosen.when, channel }
        };
        let vibrations: Vec<Vibration> = self.chosen.iter().enumerate().map(vibration).collect();
        let (load, error) = (load.as_deref(), error.as_deref());
        let record = figures::Record { channels: &channels, v_motor, load, error, ramps: &self.ramps };
        let stages = responses(self.axis.cycle_time());
        let (cycle_time, [position_gain, _]) = (self.axis.cycle_time(), self.gains());
        let task =
            proposals::Task { cycle_time, position_gain, lines, record, vibrations: &vibrations, stages: &*stages };
        match given {
            Some(given) => try_out(&task, controller(given, cycle_time, position_gain))
                .map(|prediction| vec![self.proposal(Kind::Given, given.to_vec(), prediction)]),
            None => propose(&task).map(|found| {
                let all = found.into_iter().map(|of| self.proposal(of.kind, all_rounded(&of.stages), of.prediction));
                all.filter(|of| !of.stages.is_empty()).collect()
            }),
        }
    }

    /// Whether what the stages add stays below the largest v_add of the axis (P-AXIS-00757).
    fn find_limit(&self, all: &[Proposal], verdicts: &mut Vec<Verdict>) {
        let ipc = &self.axis.ipc;
        let above = all.iter().filter_map(|of| Some((of.kind.word(), of.predicted.as_ref()?.effect.peak_v_add)));
        let above: Vec<_> = above.filter(|(_, peak)| *peak > ipc.limit()).collect();
        if above.is_empty() {
            return;
        }
        let needed = |peak: f64| libm::ceil(peak / ipc.v_max * 1000.0);
        let list: Vec<String> = (above.iter())
            .map(|(kind, peak)| format!("{kind} {} (peak v_add {:.0})", needed(*peak), libm::ceil(*peak)))
            .collect();
        let found = format!(
            "the stages would saturate at v_add_max_fact {} (P-AXIS-00757, {:.0}); at least needed: {}",
            ipc.v_add_max_fact,
            ipc.limit(),
            list.join(", ")
        );
        let instead = match above.iter().all(|(_, peak)| needed(*peak) <= LARGEST_LIMIT) {
            true => "write the number of the proposal that is used into v_add_max_fact",
            false => "choose stages that add less: not even the largest v_add_max_fact, 2000, is enough",
        };
        verdicts.push(Verdict::note(codes::LIMIT_TOO_LOW, found, instead));
    }

    /// The stages of the axis, to be predicted; `None` after a verdict.
    pub(super) fn given(&self, verdicts: &mut Vec<Verdict>) -> Option<Vec<Stage>> {
        let all: Vec<Stage> = self.axis.ipc.stage.iter().flatten().cloned().collect();
        let mut refuse = |code, found: String, instead| {
            verdicts.push(Verdict::refusal(code, found, instead));
            None
        };
        if all.is_empty() {
            let instead = "give --stage with mode=DIRECT or mode=INDIRECT";
            return refuse(codes::NOT_PREDICTED, "no stage is active".to_owned(), instead);
        }
        if let Some(other) = all.iter().find(|stage| !analysis::looks_at_motor(stage.mode)) {
            // SET_POINT may act inside the position loop.
            let of_axis = analysis::analyze(&Designed::from(self.axis.clone()), &self.axis.drive);
            if let Some(of) = of_axis.drives.first().filter(|of| !of.margins.stable) {
                let found = format!("the loop oscillates with these stages: {}", of.drive.words());
                let instead = "smaller weights: `axgen analyze` prints the largest ones";
                return refuse(codes::OSCILLATES, found, instead);
            }
            let found = format!("a stage takes {}, of which the response of the drive says nothing", other.mode.text());
            return refuse(
                codes::NOT_PREDICTED,
                found,
                "try stages that look at v_motor: mode=INDIRECT, or mode=DIRECT without direct_source",
            );
        }
        Some(all)
    }

    /// Kv of a position loop in the CNC, and in the drive: a response from an additive velocity contains the second one.
    fn gains(&self) -> [Option<f64>; 2] {
        self.axis.control.placed(self.axis.drive.position_gain)
    }

    /// Without a response; says what to measure next.
    pub(super) fn first(&self, verdicts: &mut Vec<Verdict>) -> Vec<Proposal> {
        let (cycle, stages) = (self.axis.cycle_time(), responses(self.axis.cycle_time()));
        let vibrations: Vec<_> = self.chosen.iter().map(|chosen| (chosen.mode, chosen.hz)).collect();
        let Some(found) = first(&vibrations, cycle, self.gains(), &*stages) else {
            let is_one_each = (1..=MOST_STAGES).contains(&vibrations.len());
            let refused = if is_one_each { Refused::NoWeight } else { Refused::Vibrations(vibrations.len()) };
            verdicts.push(self.said(refused));
            return Vec::new();
        };
        let said = "the response of the drive is not known: 10 % of the largest weight with a usual drive";
        let instead = "record v_cmd, v_motor, v_excite and a_load with an excitation at constant speed: --excited FILE";
        verdicts.push(Verdict::note(codes::FIRST_STAGES, said, instead));
        vec![Proposal { kind: Kind::First, stages: all_rounded(&found), predicted: None }]
    }

    /// The following error in the unit of the distance that `v_motor` covers in 1 s; `None` if it is not recorded, or if a
    /// unit is unknown.
    fn following_error(&self) -> Option<Vec<f64>> {
        let (error, factor) = (self.record.following_error()?, self.record.error_unit()?);
        Some(error.iter().map(|error| error * factor).collect())
    }

    fn proposal(&self, kind: Kind, stages: Vec<Stage>, mut predicted: Prediction) -> Proposal {
        predicted.effect.peak_v_add *= self.record.unit("v_motor").map_or(1.0, |unit| unit.size * UM);
        Proposal { kind, stages, predicted: Some(predicted) }
    }

    fn said(&self, refused: Refused) -> Verdict {
        match refused {
            Refused::TooUncertain(hz) => {
                let found = format!("at {hz:.1} Hz two standard errors are half of the response or more");
                Verdict::refusal(codes::UNCERTAIN_LINES, found, "measure more periods, or with a larger amplitude")
            }
            Refused::Vibrations(count) => {
                let found = format!("{count} vibrations, 1 to 3 get a stage");
                Verdict::refusal(codes::NO_PROPOSAL, found, "record a move that shows the vibration")
            }
            Refused::NoResponse => {
                let instead = "measure the response anew, from below the lowest vibration to above the highest one";
                Verdict::refusal(codes::NO_PROPOSAL, "the response has no line", instead)
            }
            Refused::NotRecorded => {
                let all: Vec<String> = self.chosen.iter().map(|chosen| format!("{:.1} Hz", chosen.hz)).collect();
                let found = format!("the recording is too short to judge what is left of {}", all.join(", "));
                let instead = "record at least 1.5 s at constant speed, and 1.2 s after the last ramp";
                Verdict::refusal(codes::NO_PROPOSAL, found, instead)
            }
            Refused::NoWeight => {
                let found = "no weight is safe: the loop is beyond the limit of |S| without a stage";
                Verdict::refusal(codes::NO_PROPOSAL, found, "reduce the gain of the position controller, or the delay")
            }
        }
    }
}

/// Says which stages make the load settle worse after stops; those remain that do not, and those that somebody else chose.
fn settled(all: Vec<Proposal>, verdicts: &mut Vec<Verdict>) -> Vec<Proposal> {
    let left = |of: &Proposal| of.predicted.as_ref().map(|predicted| predicted.left.clone());
    let restless = |of: &Proposal| left(of).filter(Left::is_unsettled)?.settled;
    let worse: Vec<String> =
        all.iter().filter_map(|of| Some(format!("{} x{:.2}", of.kind.word(), restless(of)?))).collect();
    if worse.is_empty() {
        return all;
    }
    let remaining: Vec<Proposal> =
        all.into_iter().filter(|of| of.kind == Kind::Given || restless(of).is_none()).collect();
    let found = format!("the load moves more after stops than without stages: {}", worse.join(", "));
    let instead = "try smaller weights and a smaller Q with --stage, or ramps with less jerk";
    let said = if remaining.is_empty() { Verdict::refusal } else { Verdict::note };
    verdicts.push(said(codes::UNSETTLED, found, instead));
    remaining
}

/// Warns of proposals with which the axis lags far behind its command, although it vibrates less.
fn find_error(all: &[Proposal], verdicts: &mut Vec<Verdict>) {
    let error = |of: &Proposal| of.predicted.as_ref()?.effect.following_error.filter(|error| *error > MUCH_ERROR);
    let far: Vec<String> = all.iter().filter_map(|of| Some(format!("{} x{:.2}", of.kind.word(), error(of)?))).collect();
    if !far.is_empty() {
        let found =
            format!("the peak of the following error grows to many times that without stages: {}", far.join(", "));
        let instead =
            "choose a proposal with less, or a smaller weight; see whether the axis still reaches its position in time";
        verdicts.push(Verdict::note(codes::MUCH_FOLLOWING_ERROR, found, instead));
    }
}

/// Stages as parameters; one whose weight is rounded down to 0 would not be a valid stage, and is left out.
fn all_rounded(stages: &[(Shape, f64)]) -> Vec<Stage> {
    let all = stages.iter().map(|(shape, weight)| rounded(shape, *weight));
    all.filter(|stage| stage.weight_fact_num > 0).collect()
}

/// Says in which cases stages are not stable; whether their figures mean something: they are stable as measured.
fn is_stable(of: &Proposal, verdicts: &mut Vec<Verdict>) -> bool {
    const CASES: [&str; 4] = ["as measured", "half a cycle later", "with 15 % less load", "with 15 % more load"];
    let Some(predicted) = &of.predicted else { return true };
    let cases: Vec<&str> =
        CASES.iter().zip(predicted.ms).filter(|(_, ms)| ms.is_infinite()).map(|(of, _)| *of).collect();
    if cases.is_empty() {
        return true;
    }
    let found = format!("the loop oscillates with these stages: {}", cases.join(", "));
    let instead = "smaller weights; without --stage, tune proposes safe ones";
    let has_figures = predicted.ms[0].is_finite();
    let said = if has_figures { Verdict::note } else { Verdict::refusal };
    verdicts.push(said(codes::OSCILLATES, found, instead));
    has_figures
}
