//! Stages as rows of data, with their verdicts: what tables and pages show of them. Nothing is computed here.

use crate::axis::Stage;
use crate::number::{decimals, significant};
use serde::Serialize;

/// A stage of an axis.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct StageRow {
    pub stage: usize,
    /// the word of P-AXIS-00753
    pub mode: &'static str,
    /// `None` if it is not active
    pub active: Option<ActiveStage>,
}

impl StageRow {
    /// The columns of its cells.
    pub const COLUMNS: [&str; 7] = ["stage", "mode", "f0", "Q", "weight", "phase at f0", "filters"];

    /// Its numbers as text; of a stage that is not active, the first two.
    #[must_use]
    pub fn cells(&self) -> Vec<String> {
        let Some(of) = &self.active else { return vec![self.stage.to_string(), self.mode.to_owned()] };
        let damping = of.damping.map_or_else(String::new, |damping| format!(", D {damping}"));
        vec![
            self.stage.to_string(),
            format!("{} from {}{damping}", self.mode, of.source),
            format!("{} Hz", of.f0),
            of.q_factor.to_string(),
            format!("{}{}", significant(of.weight, 4), Stage::cap_of(of.asked_weight)),
            format!("{} deg", decimals(of.phase_at_f0_deg, 0)),
            of.filters.join(", "),
        ]
    }
}

/// The numbers of an active stage, and its verdict.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct ActiveStage {
    /// the input velocity
    pub source: &'static str,
    /// centre frequency [Hz] and quality factor of its first band-pass
    pub f0: f64,
    pub q_factor: f64,
    /// damping ratio of the simulated oscillation, if the mode has one
    pub damping: Option<f64>,
    pub weight: f64,
    /// the weight in the parameters, which may be above the largest one
    pub asked_weight: f64,
    /// of its response from the input velocity to its output, at f0
    pub phase_at_f0_deg: f64,
    pub filters: Vec<String>,
    /// with each drive; empty if it closes no loop
    pub reserves: Vec<WithDrive>,
    /// that with the first drive
    pub reserve: Option<Reserve>,
    /// in words
    pub verdict: String,
}

/// What a stage bears in the loop with a drive, the other stages unchanged.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct WithDrive {
    pub drive: String,
    /// the weight up to which Ms stays within 2
    pub calm_up_to: f64,
    /// the weight up to which the loop is stable
    pub stable_up_to: f64,
    pub reserve: Reserve,
}

/// The reserve of a stage in a loop; the greatest is the worst.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Reserve {
    Calm,
    LittleReserve,
    Unstable,
}

impl Reserve {
    /// That of a weight, by the weights up to which the loop is calm and stable.
    pub(crate) fn of(weight: f64, [calm, stable]: [f64; 2]) -> Self {
        match weight {
            weight if weight <= calm => Self::Calm,
            weight if weight <= stable => Self::LittleReserve,
            _ => Self::Unstable,
        }
    }

    pub(crate) fn word(self) -> &'static str {
        match self {
            Self::Calm => "calm",
            Self::LittleReserve => "little reserve",
            Self::Unstable => "unstable",
        }
    }
}
