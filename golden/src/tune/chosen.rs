//! The vibrations of a recording that get a stage: those of the sensor nearest to the tool, the strongest first. No search.

use crate::measure::{Measured, Record, Verdict, Vibration, When};
use generator::codes;
use identification::figures;
use identification::scenarios::MOST_STAGES;
use identification::shape::Mode;
use identification::source::Side;

/// Channels by their distance from the tool: the first group that shows a vibration counts.
const NEAREST: [&[&str]; 3] = [&["a_load"], &["v_direct"], &["v_motor", "following_error"]];
/// Relative tolerance for equal frequencies: one stage damps both.
const SAME: f64 = 0.05;

/// A vibration that gets a stage.
#[derive(Clone, Debug, PartialEq)]
pub struct Chosen {
    /// [Hz]
    pub hz: f64,
    pub when: figures::When,
    /// `None` if it is forced
    pub damping: Option<f64>,
    pub channel: &'static str,
    /// `None` if unknown
    pub source: Option<Side>,
    /// DIRECT if the velocity of the motor shows it
    pub mode: Mode,
}

/// Chooses vibrations; reports those that get no stage.
pub(super) fn choose(moves: &Measured, verdicts: &mut Vec<Verdict>) -> Vec<Chosen> {
    // What is left of the following error is known only if its unit is.
    let has_error = moves.record.as_ref().and_then(Record::error_unit).is_some();
    let all = || moves.vibrations.iter().filter(|of| has_error || of.channel != "following_error");
    let of = |group: &&[&str]| all().any(|of| group.contains(&of.channel) && when(of).is_some());
    let Some(group) = NEAREST.iter().find(|group| of(group)) else { return Vec::new() };
    let mut found: Vec<&Vibration> = all().filter(|of| group.contains(&of.channel)).collect();
    // Only amplitudes of the same channel can be compared.
    found.sort_by(|a, b| a.channel.cmp(b.channel).reverse().then(b.amplitude.total_cmp(&a.amplitude)));
    let mut chosen: Vec<Chosen> = Vec::new();
    let (mut at_load, mut beyond) = (Vec::new(), Vec::new());
    for vibration in found {
        let Some(when) = when(vibration) else { continue };
        if chosen.iter().any(|known| is_same(known.hz, vibration.hz)) {
            continue;
        }
        if vibration.source == Some(Side::Load) {
            add(&mut at_load, vibration.hz);
        } else if chosen.len() == MOST_STAGES {
            add(&mut beyond, vibration.hz);
        } else {
            let is_seen = |of: &&Vibration| of.channel == "v_motor" && is_same(of.hz, vibration.hz);
            let mode = if moves.vibrations.iter().any(|of| is_seen(&of)) { Mode::Direct } else { Mode::Indirect };
            let Vibration { hz, channel, source, .. } = *vibration;
            let damping = vibration.damping.map(|[damping, _]| damping);
            chosen.push(Chosen { hz, when, damping, channel, source, mode });
        }
    }
    let instead = "a stage at the motor cannot damp it: look for its cause at the load";
    say(&at_load, "enters at the load: no stage is proposed", instead, verdicts);
    say(&beyond, "weaker than the three that get a stage", "damp it in another way, if it matters", verdicts);
    chosen
}

/// Adds a frequency that is not there yet.
fn add(all: &mut Vec<f64>, hz: f64) {
    if !all.iter().any(|known| is_same(*known, hz)) {
        all.push(hz);
    }
}

fn say(all: &[f64], what: &str, instead: &'static str, verdicts: &mut Vec<Verdict>) {
    if !all.is_empty() {
        let all: Vec<String> = all.iter().map(|hz| format!("{hz:.1} Hz")).collect();
        verdicts.push(Verdict::note(codes::WITHOUT_STAGE, format!("{}: {what}", all.join(", ")), instead));
    }
}

/// The time for its evaluation; `None` if it was excited.
fn when(of: &Vibration) -> Option<figures::When> {
    match of.when {
        When::Driving => Some(figures::When::Driving),
        When::Ramps => Some(figures::When::Ramps),
        When::Excited => None,
    }
}

fn is_same(a: f64, b: f64) -> bool {
    libm::fabs(a / b - 1.0) < SAME
}
