//! Mistakes whose effect decays: the state differed for a while, and then every sample agrees again.

use super::judge::errors;
use super::{Agreement, Case, Explanation};
use crate::recording::{Error, Recording};
use crate::samples::{Samples, Signal};
use crate::subject::{literal, number};
use compiler::program::Type;
use portable::Literal;

/// The number of mistakes that are tried here.
pub(super) const TRIED: usize = 2;
/// A recording that starts in the middle differs within this number of samples.
const AT_ONCE: usize = 5;
/// The last bits of a state need longer to decay than a recording lasts: this number of digits must agree again.
const DIGITS: usize = 9;
/// The part of the recording that must agree again.
const AGREEING: usize = 4;
/// The largest number of lost samples that is tried.
const MOST_LOST: usize = 20;
/// The factor by which the error decreases when the lost samples are restored.
const SMALLER: f64 = 5.0;

/// Whether the recording starts in the middle, or lacks samples at one place.
pub(super) fn explain(case: &Case<'_>) -> Option<Explanation> {
    let recording = case.recording.clone().inexact(None).up_to(DIGITS);
    let samples = recording.outputs.len();
    let found = case.answers(&recording.inputs).first(samples);
    let errors = errors(&recording, &found, |inputs| case.answers(inputs));
    if errors.iter().any(Error::is_vague) {
        return None;
    }
    let ranges = errors.iter().filter_map(|error| error.unexplained);
    let [first, last] = ranges.reduce(|a, b| [a[0].min(b[0]), a[1].max(b[1])])?;
    // The remaining part must be long enough and contain motion.
    let agreeing = last + 1..samples;
    let moves = agreeing.clone().skip(1).any(|sample| recording.outputs.differs(sample - 1, sample));
    if !moves || AGREEING * agreeing.len() < samples || last - first < AT_ONCE {
        return None;
    }
    let line = |sample: usize| recording.lines.get(sample).copied().unwrap_or_default();
    let until = format!("from sample {} (line {}) on every sample agrees", last + 1, line(last + 1));
    let said = if first <= AT_ONCE {
        format!("the recording starts in the middle, the block was not at rest at its first sample; {until}")
    } else {
        let lost = lost(case, &recording, &found, [first, last])?;
        let count = if lost == 1 { "1 sample is lost".to_owned() } else { format!("about {lost} samples are lost") };
        format!("{count} before sample {first} (line {}); {until}", line(first))
    };
    Some(Explanation { said, agreement: Agreement::InPart })
}

/// The number of samples that make the error much smaller when they are inserted before the first difference.
fn lost(case: &Case<'_>, recording: &Recording, found: &Samples, [first, last]: [usize; 2]) -> Option<usize> {
    let window = |answers: &Samples| largest(&recording.outputs.between(first, last), &answers.between(first, last));
    let before = window(found);
    let with = |count: usize| {
        let longer = inserted(&recording.inputs.first(last + 1), first, count);
        let answers = case.answers(&longer);
        window(&answers.first(first).joined(&answers.after(first + count)))
    };
    let errors = (1..=MOST_LOST).map(|count| (with(count), count));
    let (error, count) = errors.min_by(|a, b| a.0.total_cmp(&b.0))?;
    (error * SMALLER <= before).then_some(count)
}

/// The inputs with interpolated samples inserted before one of them; signals that are not reals stay constant.
fn inserted(inputs: &Samples, at: usize, count: usize) -> Samples {
    let mut longer = inputs.first(at);
    let (mut from, mut to) = (Vec::new(), Vec::new());
    inputs.read(at - 1, &mut from);
    inputs.read(at, &mut to);
    for step in 1..=count {
        let part = step as f64 / (count + 1) as f64;
        let between = |((from, to), signal): ((&Literal, &Literal), &Signal)| match signal.ty {
            Type::Real => {
                let value = number(*from) + part * (number(*to) - number(*from));
                literal(value, Type::Real, inputs.shape.real)
            }
            Type::Bool | Type::I32 | Type::U32 => *from,
        };
        let values: Vec<Literal> = from.iter().zip(&to).zip(&inputs.shape.signals).map(between).collect();
        longer.push(&values);
    }
    longer.joined(&inputs.after(at))
}

/// The largest difference of reals.
fn largest(a: &Samples, b: &Samples) -> f64 {
    let (mut of_a, mut of_b, mut largest) = (Vec::new(), Vec::new(), 0.0);
    for sample in 0..a.len().min(b.len()) {
        a.read(sample, &mut of_a);
        b.read(sample, &mut of_b);
        for ((a, b), signal) in of_a.iter().zip(&of_b).zip(&a.shape.signals) {
            let apart = (number(*a) - number(*b)).abs();
            if signal.ty == Type::Real && apart > largest {
                largest = apart;
            }
        }
    }
    largest
}
