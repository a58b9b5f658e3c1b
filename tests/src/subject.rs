//! The block `ipc` of a set or a list, run by its reference, signal by signal: what a program on a controller would be. A name that the
//! block does not have is a mistake of the test.

use compiler::program::Type;
use generator::blocks::Designed;
use generator::config::ListOptions;
use generator::pipeline;
use golden::case::named_block;
use golden::subject;
use machine::closed_loop::Signals;
use std::path::Path;

/// The block `ipc` of an axis between two cycles.
pub struct Subject(subject::Subject);

impl Subject {
    /// Before the first cycle, with the start values of its inputs.
    ///
    /// # Panics
    /// If the axis has no block `ipc`.
    #[must_use]
    pub fn new(designed: &Designed) -> Self {
        let block = named_block(designed, "ipc").unwrap_or_else(|error| panic!("subject: {error}"));
        Self(subject::Subject::start(designed, &block))
    }

    /// The block of the only axis of a set or a list.
    ///
    /// # Panics
    /// If it cannot be read, with the message; if it has several axes.
    #[must_use]
    pub fn of(path: &Path, cycle_time: Option<&str>) -> Self {
        let options = ListOptions { cycle_time: cycle_time.map(str::to_owned), ..ListOptions::default() };
        let (set, report) = pipeline::read_to_look_at(path, &options, &generator::config::load);
        let set = set.unwrap_or_else(|| panic!("subject: {report}"));
        assert_eq!(set.axes.len(), 1, "subject: {}", path.display());
        Self::new(&set.axes[0])
    }

    /// Writes an input.
    ///
    /// # Panics
    /// If there is no such input, or the number does not fit it.
    pub fn set(&mut self, input: &str, value: f64) {
        assert!(self.0.set(input, value), "subject: no input `{input}`");
        let is_real = self.0.inputs.shape.signals.iter().any(|of| of.name == input && of.ty == Type::Real);
        assert!(is_real || self.input(input).to_bits() == value.to_bits(), "subject: {value} is no value of {input}");
    }

    /// An input as it is.
    ///
    /// # Panics
    /// If there is no such input.
    #[must_use]
    pub fn input(&self, input: &str) -> f64 {
        self.0.input(input).unwrap_or_else(|| panic!("subject: no input `{input}`"))
    }

    /// An output of the last cycle, FALSE and TRUE as 0 and 1.
    ///
    /// # Panics
    /// If there is no such output.
    #[must_use]
    pub fn get(&self, output: &str) -> f64 {
        self.0.output(output).unwrap_or_else(|| panic!("subject: no output `{output}`"))
    }

    /// One cycle; gives `v_add` [um/s].
    pub fn step(&mut self, signals: &Signals) -> f64 {
        self.0.cycle(signals)
    }

    /// What went in and came out so far is forgotten.
    pub fn record_anew(&mut self) {
        self.0.record_anew();
    }

    /// What went in and what came out since then, or since the start, as CSV.
    #[must_use]
    pub fn csv(&self) -> String {
        self.0.csv()
    }
}
