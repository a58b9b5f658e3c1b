//! The command `tune`: proposals from recordings as data, and the one that is chosen.

use crate::measure::{Recordings, Said};
use generator::axis::{Filter, Mode, Stage};
use generator::codes;
use generator::parameters::words::Words;
use golden::measure::Verdict;
use golden::tune::{Proposal, Tuning, text};
use serde::Serialize;

/// The proposal of a name, else the first one; `None` after a message.
pub fn chosen(tuning: &mut Tuning, kind: Option<&str>) -> Option<Proposal> {
    let is_it = |of: &&Proposal| kind.is_none_or(|kind| of.kind.word() == kind);
    let found = tuning.proposals.iter().find(is_it).cloned();
    if let (None, Some(kind), false) = (&found, kind, tuning.proposals.is_empty()) {
        let all: Vec<&str> = tuning.proposals.iter().map(|of| of.kind.word()).collect();
        let found = format!("there is no proposal {kind}; there are: {}", all.join(", "));
        let instead = "one of these; `first` is for a drive whose response is not known";
        tuning.verdicts.push(Verdict::refusal(codes::NO_PROPOSAL, found, instead));
    }
    found
}

/// A proposal in words: the lines above a picture.
#[must_use]
pub fn setup(axis: &str, tuning: &Tuning, of: &Proposal) -> Vec<String> {
    let report = text::report(&Tuning { proposals: vec![of.clone()], ..tuning.clone() }, axis);
    report.lines().map(|line| line.trim_start().to_owned()).collect()
}

/// The proposals for an axis.
#[derive(Clone, Debug, Serialize)]
pub struct Proposals<'a> {
    pub axis: &'a str,
    pub proposals: Vec<ProposalRow>,
    /// why something is not proposed
    pub refused: Vec<Said>,
    pub notes: Vec<Said>,
}

/// A proposal: `null` is what cannot be predicted.
#[derive(Clone, Debug, Serialize)]
pub struct ProposalRow {
    pub kind: &'static str,
    pub stages: Vec<StageRow>,
    pub residuals: Vec<Residual>,
    pub ring_down: Option<f64>,
    /// of the load's motion after stops
    pub settled: Option<f64>,
    pub following_error_ratio: Option<f64>,
    pub peak_v_add: Option<f64>,
    pub ms: Option<f64>,
    pub ms_half_cycle: Option<f64>,
    pub ms_load: Option<Vec<f64>>,
    pub hardly_useful: Option<bool>,
}

/// What is left of a vibration.
#[derive(Clone, Copy, Debug, Serialize)]
pub struct Residual {
    pub hz: f64,
    pub ratio: f64,
}

/// A stage of a proposal.
#[derive(Clone, Debug, Serialize)]
pub struct StageRow {
    pub stage: usize,
    pub mode: &'static str,
    pub direct_source: Option<&'static str>,
    pub f0: Option<f64>,
    pub q: Option<f64>,
    pub damping: Option<f64>,
    pub weight: f64,
    pub prototype: Option<&'static str>,
    pub order: Option<usize>,
    pub allpass: Option<Allpass>,
}

#[derive(Clone, Copy, Debug, Serialize)]
pub struct Allpass {
    pub f0: f64,
    pub q: f64,
}

/// The proposals, with the verdicts on the recordings.
#[must_use]
pub fn proposals<'a>(axis: &'a str, tuning: &Tuning, all: &Recordings) -> Proposals<'a> {
    let said = |refuses: bool| {
        let each = all.measured().flat_map(|measured| &measured.verdicts).chain(&tuning.verdicts);
        each.filter(|verdict| verdict.refuses == refuses).map(Said::from).collect()
    };
    let proposals = tuning.proposals.iter().map(|proposal| row(tuning, proposal)).collect();
    Proposals { axis, proposals, refused: said(true), notes: said(false) }
}

fn row(tuning: &Tuning, proposal: &Proposal) -> ProposalRow {
    let predicted = proposal.predicted.as_ref();
    let residuals = predicted.iter().flat_map(|of| tuning.chosen.iter().zip(&of.left.residuals));
    ProposalRow {
        kind: proposal.kind.word(),
        stages: proposal.stages.iter().enumerate().map(stage).collect(),
        residuals: residuals.map(|(chosen, left)| Residual { hz: chosen.hz, ratio: *left }).collect(),
        ring_down: predicted.and_then(|of| of.left.ring),
        settled: predicted.and_then(|of| of.left.settled),
        following_error_ratio: predicted.and_then(|of| of.effect.following_error),
        peak_v_add: predicted.map(|of| of.effect.peak_v_add),
        ms: predicted.map(|of| of.ms[0]),
        ms_half_cycle: predicted.map(|of| of.ms[1]),
        ms_load: predicted.map(|of| of.ms[2..].to_vec()),
        hardly_useful: predicted.map(|_| proposal.is_useless()),
    }
}

fn stage((index, stage): (usize, &Stage)) -> StageRow {
    let (direct_source, damping) = match stage.mode {
        Mode::Direct { source } => (Some(source.name()), None),
        Mode::Indirect { osc_damping } | Mode::SetPoint { osc_damping } => (None, Some(osc_damping)),
    };
    let bandpass = stage.filter.iter().find_map(|filter| match filter {
        Filter::Bandpass { prototype, order, f0, q_factor } => Some((prototype.name(), *order, *f0, *q_factor)),
        Filter::NoFilter | Filter::Allpass { .. } => None,
    });
    let allpass = stage.filter.iter().find_map(|filter| match filter {
        Filter::Allpass { f0, q_factor } => Some(Allpass { f0: *f0, q: *q_factor }),
        Filter::NoFilter | Filter::Bandpass { .. } => None,
    });
    StageRow {
        stage: index,
        mode: stage.mode.word(),
        direct_source,
        f0: bandpass.map(|of| of.2),
        q: bandpass.map(|of| of.3),
        damping,
        weight: stage.weight(),
        prototype: bandpass.map(|of| of.0),
        order: bandpass.map(|of| of.1),
        allpass,
    }
}
