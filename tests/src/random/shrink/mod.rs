//! From a program that differs to a small one that still does: many small edits at once, those that keep the difference
//! together in the next round, until none is left.

mod edit;
mod repair;
mod rewrite;

use super::print;
use super::syntax::Program;
use edit::Edit;
use std::collections::BTreeSet;

/// Candidates that are built together.
const WIDTH: usize = 40;
/// Builds that a shrinking may take.
const BUILDS: usize = 60;

/// Shrinks a program. `differs` says of each candidate whether it still differs.
///
/// # Errors
/// Those of `differs`.
pub fn shrink(
    program: &Program,
    mut differs: impl FnMut(&[Program]) -> Result<Vec<bool>, String>,
) -> Result<Program, String> {
    let mut smallest = repair::program(program.clone());
    let mut builds = 0;
    'smaller: loop {
        let mut edits = edit::all(&smallest);
        // What leaves least comes first.
        edits.sort_by_cached_key(|edit| size(&edited(&smallest, std::slice::from_ref(edit))));
        for several in edits.chunks(WIDTH) {
            if builds >= BUILDS {
                return Ok(smallest);
            }
            let singles: Vec<Vec<Edit>> = several.iter().map(|edit| vec![edit.clone()]).collect();
            let kept = those_that_differ(&smallest, singles, &mut differs)?;
            let together = together(&kept.iter().flat_map(|(edits, _)| edits.clone()).collect::<Vec<_>>());
            builds += 1 + usize::from(!together.is_empty());
            let combined = those_that_differ(&smallest, together, &mut differs)?;
            let found = kept.into_iter().chain(combined).map(|(_, candidate)| candidate);
            if let Some(best) = found.min_by_key(size) {
                smallest = best;
                continue 'smaller;
            }
        }
        return Ok(smallest);
    }
}

/// The candidates that are smaller and still differ, each with its edits.
fn those_that_differ(
    program: &Program,
    edits: Vec<Vec<Edit>>,
    differs: &mut impl FnMut(&[Program]) -> Result<Vec<bool>, String>,
) -> Result<Vec<(Vec<Edit>, Program)>, String> {
    let (own, mut seen) = (size(program), BTreeSet::new());
    let mut candidates = Vec::new();
    for edits in edits {
        let candidate = edited(program, &edits);
        if size(&candidate) < own && seen.insert(print::module(&candidate, "")) {
            candidates.push((edits, candidate));
        }
    }
    if candidates.is_empty() {
        return Ok(Vec::new());
    }
    let programs: Vec<Program> = candidates.iter().map(|(_, candidate)| candidate.clone()).collect();
    let answers = differs(&programs)?;
    Ok(candidates.into_iter().zip(answers).filter_map(|(candidate, differs)| differs.then_some(candidate)).collect())
}

/// All edits at once, then halves, quarters and eighths of them.
fn together(edits: &[Edit]) -> Vec<Vec<Edit>> {
    let mut sets = Vec::new();
    let mut length = edits.len();
    while length > 1 && sets.len() < WIDTH / 2 {
        sets.extend(edits.chunks(length).map(<[Edit]>::to_vec));
        length = length.div_ceil(2);
    }
    sets
}

fn edited(program: &Program, edits: &[Edit]) -> Program {
    repair::program(rewrite::program(program, edits))
}

/// The length of the text.
fn size(program: &Program) -> usize {
    print::module(program, "").len()
}
