//! Proposals as text for readers.

use super::{Chosen, Kind, Prediction, Proposal, Tuning};
use crate::measure::text::side_word;
use generator::axis::{Filter, Mode, Stage};
use generator::parameters::words::Words;
use identification::excitation::{AMPLITUDE, Excitation, LEAST_SPEED, PERIODS, Sequence};
use identification::figures::When;
use std::fmt::Write;

/// The report.
#[must_use]
pub fn report(tuning: &Tuning, axis: &str) -> String {
    let kv = match tuning.gains {
        [Some(kv), _] => format!("Kv {kv}/s"),
        [None, Some(kv)] => format!("Kv {kv}/s in the drive"),
        [None, None] => "Kv is not in the set: the position loop counts as open".to_owned(),
    };
    let mut text = format!("axis {axis}: cycle {} ms, {kv}\n", tuning.cycle_time * 1e3);
    tuning.chosen.iter().for_each(|chosen| text += &of_chosen(chosen));
    tuning.proposals.iter().for_each(|proposal| text += &of_proposal(tuning, proposal));
    if tuning.proposals.iter().any(|proposal| proposal.kind == Kind::First) {
        text += &next(tuning);
    }
    text
}

fn of_chosen(chosen: &Chosen) -> String {
    let when = match chosen.when {
        When::Driving => "while driving",
        When::Ramps => "after ramps",
    };
    let side = chosen.source.map_or("side unknown".to_owned(), |side| format!("enters at the {}", side_word(side)));
    format!("  {:.2} Hz, {} {when}, {side}\n", chosen.hz, chosen.channel)
}

fn of_proposal(tuning: &Tuning, proposal: &Proposal) -> String {
    let mut text = format!("{}\n", proposal.kind.word());
    let useless = proposal.is_useless();
    if useless {
        text = format!("{}: hardly useful\n", proposal.kind.word());
    }
    for (index, stage) in proposal.stages.iter().enumerate() {
        let _ = writeln!(text, "  stage[{index}] {}", of_stage(stage));
    }
    proposal.predicted.iter().for_each(|predicted| text += &of_prediction(tuning, predicted));
    text
}

fn of_stage(stage: &Stage) -> String {
    let damping = match stage.mode {
        Mode::Direct { .. } => String::new(),
        Mode::Indirect { osc_damping } | Mode::SetPoint { osc_damping } => format!(", damping {osc_damping}"),
    };
    let filters: String = stage.filter.iter().map(of_filter).collect();
    let (num, denom) = (stage.weight_fact_num, stage.weight_fact_denom);
    format!("{}{damping}{filters}, weight {num}/{denom}", stage.mode.text())
}

fn of_filter(filter: &Filter) -> String {
    match filter {
        Filter::NoFilter => String::new(),
        Filter::Bandpass { order: 1, f0, q_factor, .. } => format!(", f0 {f0} Hz, Q {q_factor}"),
        Filter::Bandpass { order, f0, q_factor, prototype } => {
            format!(", f0 {f0} Hz, Q {q_factor}, order {order} {}", prototype.name())
        }
        Filter::Allpass { f0, q_factor } => format!(", all-pass f0 {f0} Hz Q {q_factor}"),
    }
}

fn of_prediction(tuning: &Tuning, of: &Prediction) -> String {
    let left =
        tuning.chosen.iter().zip(&of.left.residuals).map(|(chosen, left)| format!("{left:.2} of {:.2} Hz", chosen.hz));
    let ring = of.left.ring.map(|ring| format!("{ring:.2} of the ring-down"));
    let settled = of.left.settled.map(|settled| format!("{settled:.2} of the load's motion after stops"));
    let left: Vec<String> = left.chain(ring).chain(settled).collect();
    let error = of.effect.following_error.map_or("is not recorded".to_owned(), |error| format!("x{error:.2}"));
    let [ms, later, less, more] =
        of.ms.map(|ms| if ms.is_finite() { format!("{ms:.2}") } else { "unstable".to_owned() });
    format!(
        "  left: {}\n  following error {error}, peak v_add {:.0}\n  \
         Ms {ms}; half a cycle later {later}; load -15 % {less}, +15 % {more}\n",
        left.join(", "),
        of.effect.peak_v_add
    )
}

/// The next measurement if no response is known. Its lines are close enough for the narrowest vibration with a known
/// damping.
fn next(tuning: &Tuning) -> String {
    let damped = tuning.chosen.iter().filter_map(|chosen| Some((chosen.hz, chosen.damping?)));
    let narrowest = damped.min_by(|a, b| (a.0 * a.1).total_cmp(&(b.0 * b.1)));
    let sequence = match narrowest {
        Some((hz, damping)) => Sequence::for_vibration(tuning.cycle_time, hz, damping),
        None => Sequence::for_cycle(tuning.cycle_time),
    };
    let excitation = Excitation { sequence, cycle_time: tuning.cycle_time, amplitude: AMPLITUDE, periods: PERIODS };
    let unit = if tuning.is_rotary { "deg/s" } else { "mm/s" };
    format!(
        "measure next: an excitation {}x{} of {} {unit}, {PERIODS} periods, {:.1} s, at a constant speed of at least {} {unit}\n",
        sequence.bits(),
        sequence.clock(),
        AMPLITUDE * 1e3,
        excitation.duration(),
        AMPLITUDE * LEAST_SPEED * 1e3
    )
}
