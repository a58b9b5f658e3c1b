//! Whether a recording agrees after a mistake is undone.

use super::change::Change;
use super::undo::{Undone, undo};
use super::{Agreement, Case, answers};
use crate::recording::{Error, Recording};
use crate::samples::Samples;

/// The agreement of all samples without this mistake, if they agree.
pub(super) fn agrees(case: &Case<'_>, change: &Change) -> Option<Agreement> {
    let Undone { recording, block } = undo(case, change)?;
    let (designed, block) = block.as_ref().map_or((case.designed, case.block), |(designed, block)| (designed, block));
    let run = |inputs: &Samples| answers(designed, block, inputs).only(&recording.recorded);
    let found = run(&recording.inputs).first(recording.outputs.len());
    if found.bytes == recording.outputs.bytes {
        return Some(Agreement::EveryBit);
    }
    let is_explained = |error: &Error| error.is_explained() && !error.is_vague();
    let agrees = found.len() == recording.outputs.len() && errors(&recording, &found, run).iter().all(is_explained);
    agrees.then_some(Agreement::EveryDigit)
}

/// The differences between the recording and answers; `run` returns the answers to other inputs.
pub(super) fn errors(recording: &Recording, found: &Samples, run: impl Fn(&Samples) -> Samples) -> Vec<Error> {
    let moved = recording.moved_inputs().map(|moved| run(&moved).first(found.len()));
    recording.errors(found, moved.as_ref())
}
