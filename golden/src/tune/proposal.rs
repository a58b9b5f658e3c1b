//! Proposals as data: stages and their effect, or the reason why there are none.

use super::chosen::Chosen;
use super::stage::{Stage, responses};
use crate::measure::{Record, Verdict};
use generator::axis::Axis;
use generator::codes;
use identification::figures::{self, Vibration};
use identification::proposals::{self, Kind, Refused, first, propose};
use identification::response::Lines;
use std::ops::Range;

/// Micrometres of a metre.
const UM: f64 = 1e6;

/// Stages, one for each vibration.
#[derive(Clone, Debug, PartialEq)]
pub struct Proposal {
    pub kind: Kind,
    pub stages: Vec<Stage>,
    /// `None` if the response of the drive is unknown
    pub predicted: Option<Predicted>,
}

/// The predicted effect of the stages.
#[derive(Clone, Debug, PartialEq)]
pub struct Predicted {
    /// the remaining part of each vibration
    pub residuals: Vec<f64>,
    /// the remaining part of the largest ring-down after ramps; `None` if no vibration belongs to ramps
    pub ring_down: Option<f64>,
    /// the peak of the following error, relative to that without stages; `None` if it is not recorded
    pub following_error: Option<f64>,
    /// the largest |v_add| [um/s or 0.001 deg/s]
    pub peak_v_add: f64,
    /// the largest |S|: as measured, half a cycle later, with 15 % less load, with 15 % more
    pub ms: [f64; 4],
    /// more than 0.8 of every vibration remains
    pub is_useless: bool,
}

/// The data for proposals.
pub(super) struct Task<'a> {
    pub axis: &'a Axis,
    pub record: &'a Record,
    pub ramps: Vec<Range<usize>>,
    pub chosen: &'a [Chosen],
}

impl Task<'_> {
    /// The proposals: recommended, strong, cautious.
    pub(super) fn proposals(&self, lines: &Lines, verdicts: &mut Vec<Verdict>) -> Vec<Proposal> {
        let (v_motor, error) = (self.record.get("v_motor").unwrap_or_default(), self.following_error());
        let of_error = self.record.following_error();
        let channel = |name: &str| match name {
            "following_error" => of_error.as_deref().unwrap_or_default(),
            _ => self.record.get(name).unwrap_or_default(),
        };
        let channels: Vec<&[f64]> = self.chosen.iter().map(|chosen| channel(chosen.channel)).collect();
        let vibration = |(channel, chosen): (usize, &Chosen)| Vibration { hz: chosen.hz, when: chosen.when, channel };
        let vibrations: Vec<Vibration> = self.chosen.iter().enumerate().map(vibration).collect();
        let record = figures::Record { channels: &channels, v_motor, error: error.as_deref(), ramps: &self.ramps };
        let stages = responses(self.axis.cycle_time());
        let found = propose(&proposals::Task {
            cycle_time: self.axis.cycle_time(),
            position_gain: self.axis.drive.position_gain,
            lines,
            record,
            vibrations: &vibrations,
            stages: &*stages,
        });
        let all: Vec<Proposal> = match found {
            Ok(found) => found.into_iter().map(|of| self.proposal(of)).collect(),
            Err(refused) => {
                verdicts.push(self.said(refused));
                return Vec::new();
            }
        };
        let useless = all.iter().filter(|of| of.predicted.as_ref().is_some_and(|predicted| predicted.is_useless));
        let useless: Vec<&str> = useless.map(|of| of.kind.word()).collect();
        if !useless.is_empty() {
            let found = format!("hardly useful, more than 0.8 of every vibration is left: {}", useless.join(", "));
            let instead = "reduce the delay between position controller and drive, or speed up the velocity controller";
            verdicts.push(Verdict::note(codes::HARDLY_USEFUL, found, instead));
        }
        all
    }

    /// The first stages without a response; reports what to measure next.
    pub(super) fn first(&self, verdicts: &mut Vec<Verdict>) -> Vec<Proposal> {
        let (cycle, stages) = (self.axis.cycle_time(), responses(self.axis.cycle_time()));
        let vibrations: Vec<_> = self.chosen.iter().map(|chosen| (chosen.mode, chosen.hz)).collect();
        let Some(found) = first(&vibrations, cycle, self.axis.drive.position_gain, &*stages) else {
            verdicts.push(self.said(Refused::Vibrations(vibrations.len())));
            return Vec::new();
        };
        let found: Vec<Stage> = found.iter().map(|(shape, weight)| Stage::rounded(shape, *weight)).collect();
        let said = "the response of the drive is not known: 10 % of the largest weight with a usual drive";
        let instead = "record v_cmd, v_motor, v_excite and a_load with an excitation at constant speed: --excited FILE";
        verdicts.push(Verdict::note(codes::FIRST_STAGES, said, instead));
        vec![Proposal { kind: Kind::First, stages: found, predicted: None }]
    }

    /// The following error in the unit of the distance that `v_motor` covers in 1 s; `None` if it is not recorded, or if a
    /// unit is unknown.
    fn following_error(&self) -> Option<Vec<f64>> {
        let (error, unit) = (self.record.following_error()?, self.record.unit("following_error")?);
        let factor = unit.size / self.record.unit("v_motor")?.size;
        Some(error.iter().map(|error| error * factor).collect())
    }

    fn proposal(&self, of: proposals::Proposal) -> Proposal {
        let unit = self.record.unit("v_motor").filter(|_| !self.axis.control.is_rotary);
        let predicted = Predicted {
            residuals: of.left.residuals,
            ring_down: of.left.ring,
            following_error: of.effect.following_error,
            peak_v_add: of.effect.peak_v_add * unit.map_or(1.0, |unit| unit.size * UM),
            ms: of.ms,
            is_useless: of.is_useless,
        };
        let stages = of.stages.iter().map(|(shape, weight)| Stage::rounded(shape, *weight)).collect();
        Proposal { kind: of.kind, stages, predicted: Some(predicted) }
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
