//! The common mistake that explains the differences of a recording: each is undone, and the reference runs again. A mistake
//! explains them only if every sample then agrees, in all its bits or within the recorded digits.

mod change;
mod judge;
mod undo;
mod window;

pub use change::Change;

use crate::engine::{self, Engine};
use crate::recording::Recording;
use crate::samples::Samples;
use generator::blocks::{Block, Designed};

/// A recording with all inputs, and its expected block.
pub struct Case<'c> {
    pub designed: &'c Designed,
    pub block: &'c Block,
    /// its `inputs` are all inputs of the block, its `given` those in a file
    pub recording: Recording,
    /// the other axes of the set
    pub others: Vec<&'c Designed>,
}

/// The explanation of a difference.
#[derive(Clone, Debug, PartialEq)]
pub struct Explanation {
    /// the mistake
    pub said: String,
    /// the agreement of the recording without it
    pub agreement: Agreement,
}

/// The agreement of a recording.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Agreement {
    EveryBit,
    /// within the written digits
    EveryDigit,
    /// in the samples that the text names
    InPart,
}

/// Number of samples after the first difference with which a mistake is tried before all samples are.
const TRIAL: usize = 3_000;
/// The largest number of explanations of one recording.
const MOST: usize = 3;

/// The mistakes that explain the differences of the recording, the most likely ones first; and the number of tried ones.
/// `first` is the first sample that differs.
#[must_use]
pub fn explain(case: &Case<'_>, first: usize) -> (Vec<Explanation>, usize) {
    let changes = change::all(case);
    let short = case.first(first + TRIAL);
    let mut found = Vec::new();
    for change in &changes {
        if found.len() == MOST {
            break;
        }
        let is_short = short.recording.outputs.len() < case.recording.outputs.len();
        if is_short && judge::agrees(&short, change).is_none() {
            continue;
        }
        if let Some(agreement) = judge::agrees(case, change) {
            found.push(Explanation { said: change.said(case), agreement });
        }
    }
    let tried = changes.len() + window::TRIED;
    if found.is_empty() {
        found.extend(window::explain(case));
    }
    (found, tried)
}

impl Case<'_> {
    /// The case with the first samples only.
    fn first(&self, count: usize) -> Self {
        let Self { designed, block, recording, others } = self;
        Case { designed, block, recording: recording.first(count), others: others.clone() }
    }

    /// The answers of the reference to other inputs, as far as they were recorded.
    fn answers(&self, inputs: &Samples) -> Samples {
        answers(self.designed, self.block, inputs).only(&self.recording.recorded)
    }
}

/// The answers of the reference.
fn answers(designed: &Designed, block: &Block, inputs: &Samples) -> Samples {
    engine::run(Engine::Reference, designed, block, inputs)
        .unwrap_or_else(|failure| panic!("a defect of axgen: {failure}"))
}
