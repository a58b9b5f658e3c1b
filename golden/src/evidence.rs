//! The evidence in a recording: signals that moved, the part with mode ON, and assumptions.

use crate::recording::Recording;
use crate::samples::Samples;
use crate::subject::number;
use portable::Literal;
use reference::ipc::{mode_off, mode_on};

/// The evidence in a recording.
#[derive(Clone, Debug, PartialEq)]
pub struct Evidence {
    /// the number of samples
    pub samples: usize,
    /// the signals that have a column, inputs first
    pub signals: Vec<Span>,
    /// the inputs without a column, and their assumed values
    pub taken: Vec<(String, f64)>,
    /// samples in which a signal with a column differs from the previous sample
    pub moving: usize,
    /// for a block with a mode
    pub mode: Option<Mode>,
}

/// The range of a signal.
#[derive(Clone, Debug, PartialEq)]
pub struct Span {
    pub name: String,
    pub is_input: bool,
    pub least: f64,
    pub greatest: f64,
}

/// The modes in a recording.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Mode {
    /// samples with mode ON
    pub on: usize,
    /// the moving samples among them
    pub moving_on: usize,
    /// samples with mode OFF
    pub off: usize,
}

/// The reason why a recording proves nothing.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Lack {
    NoSample,
    NoInputMoves,
    NoOutputMoves,
    ModeOff,
}

impl Span {
    #[must_use]
    pub fn moves(&self) -> bool {
        self.least < self.greatest
    }
}

/// The evidence of a recording for a block with these inputs; `given` are the recorded ones, `used` those that its axis has: the
/// others do not show whether it acts.
#[must_use]
pub fn of(inputs: &Samples, given: &[usize], used: &[usize], recording: &Recording) -> Evidence {
    let samples = inputs.len().min(recording.outputs.len());
    let start = |position: &usize| &inputs.shape.signals[*position];
    let taken = (0..inputs.shape.signals.len()).filter(|position| !given.contains(position));
    let taken = taken.map(|position| (start(&position).name.clone(), number(start(&position).start.at_run_time())));
    let recorded = inputs.only(given);
    let at = inputs.shape.place("mode").filter(|at| used.contains(at));
    let mut evidence = Evidence {
        samples,
        signals: [spans(&recorded, samples, true), spans(&recording.outputs, samples, false)].concat(),
        taken: taken.collect(),
        moving: 0,
        mode: at.map(|_| Mode { on: 0, moving_on: 0, off: 0 }),
    };
    let mut values = Vec::new();
    for sample in 0..samples {
        let moves = sample > 0 && [&recorded, &recording.outputs].iter().any(|run| run.differs(sample - 1, sample));
        evidence.moving += usize::from(moves);
        if let (Some(mode), Some(at)) = (&mut evidence.mode, at) {
            inputs.read(sample, &mut values);
            let is_on = values[at] == Literal::I32(mode_on());
            mode.on += usize::from(is_on);
            mode.moving_on += usize::from(is_on && moves);
            mode.off += usize::from(values[at] == Literal::I32(mode_off()));
        }
    }
    evidence
}

/// The range of each signal of a run.
fn spans(run: &Samples, samples: usize, is_input: bool) -> Vec<Span> {
    let span = |name: &str| Span { name: name.to_owned(), is_input, least: f64::INFINITY, greatest: f64::NEG_INFINITY };
    let mut spans: Vec<Span> = run.shape.signals.iter().map(|signal| span(&signal.name)).collect();
    let mut values = Vec::new();
    for sample in 0..samples {
        run.read(sample, &mut values);
        for (span, value) in spans.iter_mut().zip(&values) {
            let value = number(*value);
            if value < span.least {
                span.least = value;
            }
            if value > span.greatest {
                span.greatest = value;
            }
        }
    }
    spans
}

impl Evidence {
    /// All reasons why it proves nothing.
    #[must_use]
    pub fn lacks(&self) -> Vec<Lack> {
        if self.samples == 0 {
            return vec![Lack::NoSample];
        }
        let moves = |is_input: bool| self.signals.iter().any(|span| span.is_input == is_input && span.moves());
        let lacks = [
            (Lack::NoInputMoves, !moves(true)),
            (Lack::NoOutputMoves, !moves(false)),
            (Lack::ModeOff, self.mode.is_some_and(|mode| mode.off == self.samples)),
        ];
        lacks.into_iter().filter(|(_, is_lacking)| *is_lacking).map(|(lack, _)| lack).collect()
    }
}
