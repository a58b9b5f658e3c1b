//! What a run has in it, beyond what its text shows: so that no engine is compared on zeros alone.

use super::subject::Frame;
use compiler::program::{Program, Statement};
use portable::Literal;

/// Notes what the values of the Rust itself are.
pub fn of_frames(frames: &[Vec<Frame>], facts: &mut Vec<&'static str>) {
    let values = || frames.iter().flatten().flat_map(|frame| frame.outputs.iter().chain(&frame.state));
    let mut note = |fact, holds: bool| facts.extend(holds.then_some(fact));
    note("value: NaN", values().any(|value| real(*value).is_some_and(f64::is_nan)));
    note("value: infinity", values().any(|value| real(*value).is_some_and(f64::is_infinite)));
    note("value: -0.0", values().any(|value| real(*value).is_some_and(|real| real.to_bits() == 1 << 63)));
    note("value: subnormal", values().any(|value| is_subnormal(*value)));
    let first_run = frames.first();
    let varies = first_run.is_some_and(|run| run.windows(2).any(|pair| pair[0].outputs != pair[1].outputs));
    note("outputs change from sample to sample", varies);
    let remembers = first_run.is_some_and(|run| run.windows(2).any(|pair| pair[0].state != pair[1].state));
    note("state changes from sample to sample", remembers);
}

/// Notes what a pass did.
pub fn of_pass(name: &str, before: &Program, after: &Program, facts: &mut Vec<&'static str>) {
    let changes = before.step != after.step || before.init != after.init;
    match name {
        "identity" if changes => facts.push("pass: identity changes it"),
        "coalesced" if changes => facts.push("pass: coalesce changes it"),
        "pruned" => {
            facts.extend((count(&before.step) != count(&after.step)).then_some("pass: prune drops statements"));
            facts.extend((before.state.len() != after.state.len()).then_some("pass: prune drops state"));
            facts.extend((!after.constants.is_empty()).then_some("program: named constants"));
            facts.extend(after.step.iter().any(is_branch).then_some("program: branches at run time"));
        }
        _ => {}
    }
}

fn is_branch(statement: &Statement) -> bool {
    matches!(statement, Statement::If { .. })
}

fn count(statements: &[Statement]) -> usize {
    let inside = |statement: &Statement| match statement {
        Statement::If { then, otherwise, .. } => 1 + count(then) + count(otherwise),
        _ => 1,
    };
    statements.iter().map(inside).sum()
}

fn real(value: Literal) -> Option<f64> {
    match value {
        Literal::F64(value) => Some(value),
        Literal::F32(value) => Some(f64::from(value)),
        _ => None,
    }
}

fn is_subnormal(value: Literal) -> bool {
    match value {
        Literal::F64(value) => value.is_subnormal(),
        Literal::F32(value) => value.is_subnormal(),
        _ => false,
    }
}
