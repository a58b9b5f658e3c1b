//! The command `run --compare`: what a recording can prove, its agreement with an engine, and its differences.

use crate::words::{counted, made};
use generator::blocks::{Block, Designed};
use generator::codes;
use generator::diagnostics::{Diagnostic, Place, Report};
use golden::compare::{self, Difference, compare};
use golden::csv::{self, Reals};
use golden::engine::{self, Engine};
use golden::evidence::{Evidence, Lack, Mode};
use golden::explain::{self, Agreement, Case, Explanation};
use golden::recording::{self, Recording};
use golden::samples::Samples;
use golden::written::Precision;

/// The block that is compared with a recording.
pub struct Subject<'s> {
    pub designed: &'s Designed,
    pub block: &'s Block,
    pub engine: Engine,
    /// the other axes of the set
    pub others: Vec<&'s Designed>,
}

/// The signals that moved, the part with mode ON, and the assumptions.
#[must_use]
pub fn evidence(evidence: &Evidence, recording: &Recording, subject: &Subject<'_>) -> Vec<String> {
    let mut lines = Vec::new();
    let (moving, still): (Vec<_>, Vec<_>) = evidence.signals.iter().partition(|span| span.moves());
    let list = |texts: Vec<String>| if texts.is_empty() { "nothing".to_owned() } else { texts.join(", ") };
    let moves = moving.iter().map(|span| {
        let unit = subject.unit(&span.name);
        format!("{} {} to {}{unit}", span.name, shown(span.least), shown(span.greatest))
    });
    let of_mode =
        evidence.mode.map_or_else(String::new, |Mode { moving_on, .. }| format!(", {moving_on} of them with mode ON"));
    let count = format!("{} of {}", evidence.moving, counted(evidence.samples, "sample"));
    lines.push(format!("moved: {}; in {count}{of_mode}", list(moves.collect())));
    if !still.is_empty() && evidence.samples > 0 {
        let still = still.iter().map(|span| format!("{} {}", span.name, shown(span.least)));
        lines.push(format!("constant: {}", list(still.collect())));
    }
    if !evidence.taken.is_empty() {
        let taken = evidence.taken.iter().map(|(name, value)| format!("{name} {}", shown(*value)));
        lines.push(format!("no column, taken at the start value: {}", list(taken.collect())));
    }
    for (name, count) in &recording.skipped {
        lines.push(format!("{name} begins earlier: its first {} left out", counted(count, "sample")));
    }
    lines
}

/// The reasons why the recording proves nothing. `file`: its name in messages.
pub fn proof(evidence: &Evidence, file: &str) -> Report {
    let mut report = Report::default();
    for lack in evidence.lacks() {
        let (found, instead) = match lack {
            Lack::NoSample => ("proves nothing: there is no sample", "record a move with mode ON"),
            Lack::NoInputMoves => (
                "proves nothing: no input of the block moves",
                "record the inputs of the block, too, while the axis moves; --map NAME=SIGNAL where the names differ",
            ),
            Lack::NoOutputMoves => (
                "proves nothing: no output that was recorded moves",
                "record the outputs that the move changes: v_add, or v_add_calculated with mode DRYRUN",
            ),
            Lack::ModeOff => ("proves nothing: mode is OFF throughout", "record a move with mode ON (1)"),
        };
        report.push(Diagnostic::error(codes::PROVES_NOTHING, Place::whole(file), found).instead(instead));
    }
    report
}

/// The differences between a recording and the outputs of an engine for these inputs, and whether they agree.
#[must_use]
pub fn agreement(
    recording: &Recording,
    inputs: &Samples,
    found: &Samples,
    subject: &Subject<'_>,
) -> (Vec<String>, bool) {
    let Subject { designed, block, engine, .. } = subject;
    let names: Vec<&str> = recording.outputs.shape.signals.iter().map(|signal| signal.name.as_str()).collect();
    let outputs = found.only(&recording.recorded);
    let Difference { bits, first } = compare(&outputs, &recording.outputs);
    let samples = counted(recording.outputs.len(), "sample");
    let bits = counted(bits, "differing bit");
    let mut lines = vec![format!("{} against engine {engine}, {samples}: {bits}", names.join(", "))];
    if !recording.left_out.is_empty() {
        lines.push(format!("left out, no signal of {}: {}", block.program.block, recording.left_out.join(", ")));
    }
    // The reference shows the effect of rounded inputs: every engine has the same result.
    let moved = recording.moved_inputs();
    let moved = moved.map(|moved| made(engine::run(Engine::Reference, designed, block, &moved)));
    let moved = moved.map(|moved| moved.only(&recording.recorded));
    let errors = recording.errors(&outputs, moved.as_ref());
    let is_explained = |error: &recording::Error| error.is_explained() && !error.is_vague();
    let agrees = errors.iter().all(is_explained) && outputs.len() == recording.outputs.len();
    if let Some(first) = first.filter(|_| !agrees) {
        lines.push(first_difference(&first, recording));
    }
    if inputs.len() != recording.outputs.len() {
        let of_inputs = counted(inputs.len(), "sample");
        lines.push(format!("the recording has {samples}, the inputs have {of_inputs}"));
    }
    for ((error, name), precision) in errors.iter().zip(&names).zip(&recording.output_precision) {
        if error.largest > 0.0 && error.largest.is_finite() {
            lines.push(largest_error(error, name, *precision, recording, subject));
        }
    }
    lines.extend(explanation(recording, inputs, &errors, subject));
    (lines, agrees)
}

/// The lines about the first unexplained difference: the mistakes that explain it, or that no known one does.
fn explanation(
    recording: &Recording,
    inputs: &Samples,
    errors: &[recording::Error],
    subject: &Subject<'_>,
) -> Vec<String> {
    let mut lines = Vec::new();
    let first = errors.iter().filter_map(|error| error.unexplained).map(|[first, _]| first).min();
    let Some(first) = first else { return lines };
    let Subject { designed, block, others, .. } = subject;
    let recording = recording.clone().with_inputs(inputs);
    let (found, tried) = explain::explain(&Case { designed, block, recording, others: others.clone() }, first);
    for (at, Explanation { said, agreement }) in found.iter().enumerate() {
        let or = if at == 0 { "explained" } else { "or" };
        let how = match agreement {
            Agreement::EveryBit => "; with that undone every bit agrees",
            Agreement::EveryDigit => "; with that undone every sample agrees within its digits",
            Agreement::InPart => "",
        };
        lines.push(format!("{or}: {said}{how}"));
    }
    if found.is_empty() {
        let cause = match only_last_digits(errors) {
            true => {
                "only the last digits differ: other options of the compiler (fused multiply-add, fast math), or another version \
                 of the block"
            }
            false => {
                "the block on the machine probably has other parameters: compare with the set of that day, and \
                 its digest with that in the head of the generated file"
            }
        };
        lines.push(format!("not explained by any of {tried} mistakes ({TRIED}); {cause}"));
    }
    lines
}

/// The mistakes that are tried, in words.
const TRIED: &str = "sign, factor, swapped or late columns, sampling, start, lost samples, inputs without a column, cycle time, real \
     type, axis";

/// Whether no output differs by more than a millionth of its largest value, and no BOOL and no integer differs.
fn only_last_digits(errors: &[recording::Error]) -> bool {
    errors.iter().all(|error| error.largest <= 1e-6 * error.scale)
}

fn largest_error(
    error: &recording::Error,
    name: &str,
    precision: Precision,
    recording: &Recording,
    subject: &Subject<'_>,
) -> String {
    let recording::Error { largest, sample, .. } = *error;
    let unit = subject.unit(name);
    let line = recording.lines.get(sample).copied().unwrap_or_default();
    let verdict = match (precision.digits, error.is_explained()) {
        (_, true) if error.is_vague() => {
            format!("; the digits recorded would explain {:.2e}{unit}: too few to prove anything", error.allowance)
        }
        (0, true) => "; the digits recorded of the inputs explain it".to_owned(),
        (0, false) => String::new(),
        (digits, true) => format!("; agrees within the {} recorded", counted(digits, "digit")),
        (digits, false) => format!("; more than the {} recorded explain", counted(digits, "digit")),
    };
    format!("{name}: largest error {largest:.2e}{unit} at sample {sample} (line {line}){verdict}")
}

fn first_difference(first: &compare::FirstDifference, recording: &Recording) -> String {
    let compare::FirstDifference { sample, signal, expected, found } = first;
    let [recorded, computed] = [found, expected].map(|value| {
        let mut texts = [String::new(), String::new()];
        csv::cell(*value, Reals::Decimal, &mut texts[0]);
        csv::cell(*value, Reals::Hexadecimal, &mut texts[1]);
        if texts[0] == texts[1] { texts[0].clone() } else { texts.join(" = ") }
    });
    let line = recording.lines.get(*sample).copied().unwrap_or_default();
    format!("first: sample {sample} (line {line}), {signal}: {recorded} recorded, {computed} computed")
}

/// A number with four digits.
fn shown(value: f64) -> String {
    let text = format!("{value:.3e}");
    let (digits, exponent) = text.split_once('e').unwrap_or((&text, "0"));
    match exponent.parse::<i32>() {
        Ok(exponent) if (-4..7).contains(&exponent) => {
            let decimals = usize::try_from(3 - exponent).unwrap_or(0);
            let plain = format!("{value:.decimals$}");
            let trimmed = if plain.contains('.') { plain.trim_end_matches('0').trim_end_matches('.') } else { &plain };
            trimmed.to_owned()
        }
        _ => format!("{}e{exponent}", digits.trim_end_matches('0').trim_end_matches('.')),
    }
}

impl Subject<'_> {
    /// The unit of a signal, of this axis: ` um/s` of `[um/s or 0.001 deg/s]` in its comment.
    fn unit(&self, signal: &str) -> String {
        let variables = self.block.program.inputs.iter().chain(&self.block.program.outputs);
        let doc = variables.into_iter().find(|variable| variable.path == signal).map_or("", |variable| variable.doc);
        let Some((_, rest)) = doc.split_once('[') else { return String::new() };
        let unit = rest.split_once(']').map_or(rest, |(unit, _)| unit);
        let of_axis = match unit.split_once(" or ") {
            Some((_, rotary)) if self.designed.axis.control.is_rotary => rotary,
            Some((linear, _)) => linear,
            None => unit,
        };
        format!(" {of_axis}")
    }
}
