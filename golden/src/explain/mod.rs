//! Which of the commonest mistakes explains that a recording differs: each is undone, and the reference runs again. What does not make
//! every sample agree, in all its bits or within the digits that were recorded, explains nothing.

mod change;
mod judge;
mod undo;
mod window;

pub use change::Change;

use crate::engine::{self, Engine};
use crate::recording::Recording;
use crate::samples::Samples;
use generator::blocks::{Block, Designed};

/// A recording with all inputs, and the block that should have made it.
pub struct Case<'c> {
    pub designed: &'c Designed,
    pub block: &'c Block,
    /// its `inputs` are all that the block got, its `given` those that a file says
    pub recording: Recording,
    /// the other axes of the set
    pub others: Vec<&'c Designed>,
}

/// What explains a difference.
#[derive(Clone, Debug, PartialEq)]
pub struct Explanation {
    /// the mistake
    pub said: String,
    /// how far the recording agrees without it
    pub agreement: Agreement,
}

/// How far a recording agrees.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Agreement {
    EveryBit,
    /// within the digits that were written
    EveryDigit,
    /// in the samples that the text names
    InPart,
}

/// Samples after the first difference with which a mistake is tried, before all are.
const TRIAL: usize = 3_000;
/// More explanations of one recording are not named.
const MOST: usize = 3;

/// The mistakes each of which explains that the recording differs, the most likely ones first; and how many were tried. `first` is
/// the first sample that differs.
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
    /// The same with the first samples only.
    fn first(&self, count: usize) -> Self {
        let Self { designed, block, recording, others } = self;
        Case { designed, block, recording: recording.first(count), others: others.clone() }
    }

    /// What the reference answers to other inputs, as far as it was recorded.
    fn answers(&self, inputs: &Samples) -> Samples {
        answers(self.designed, self.block, inputs).only(&self.recording.recorded)
    }
}

/// What the reference answers.
fn answers(designed: &Designed, block: &Block, inputs: &Samples) -> Samples {
    engine::run(Engine::Reference, designed, block, inputs)
        .unwrap_or_else(|failure| panic!("a defect of axgen: {failure}"))
}
