//! The command `verify`: every block of every axis in every engine against the reference, bit by bit, row by row.

use crate::refused;
use generator::blocks::{Block, Designed};
use generator::codes;
use generator::diagnostics::{Diagnostic, Place, Report};
use generator::digest::digest;
use golden::compare::{FirstDifference, compare};
use golden::engine::{self, ENGINES, Engine, Failure};
use golden::exercise::{self, coverage::coverage};
use golden::samples::Samples;
use serde::Serialize;
use std::collections::BTreeMap;
use std::convert::Infallible;

/// The engine of that name.
///
/// # Errors
/// There is none.
pub fn engine_named(name: &str) -> Result<Engine, Report> {
    let names = ENGINES.map(|engine| engine.to_string());
    let found = ENGINES.into_iter().find(|engine| engine.to_string() == name);
    found.ok_or_else(|| refused::no_such("--engine", "engine", name, &names.each_ref().map(String::as_str)))
}

/// The engines of these names, preceded by the reference; all if there is no name.
///
/// # Errors
/// There is no engine of a name.
pub fn engines(names: &[String]) -> Result<Vec<Engine>, Report> {
    let engines = names.iter().map(|name| engine_named(name)).collect::<Result<Vec<_>, _>>()?;
    let is_chosen = |engine: &Engine| *engine == Engine::Reference || engines.is_empty() || engines.contains(engine);
    Ok(ENGINES.into_iter().filter(is_chosen).collect())
}

/// The first line of the table.
#[must_use]
pub fn head() -> String {
    format!(
        "{:<20} {:<16} {:<10} {:>10} {:>15}  first difference",
        "axis", "block", "engine", "samples", "differing bits"
    )
}

/// A block in an engine.
#[derive(Clone, Debug, Serialize)]
pub struct Row {
    pub axis: String,
    pub block: &'static str,
    pub engine: String,
    pub samples: usize,
    /// `None` if the engine gave no samples
    pub differing_bits: Option<u64>,
    /// the first difference, or the reason why there are no samples; empty if every bit agrees
    pub first: String,
    /// whether the engine is missing: its compiler is not there, or does not work
    pub is_missing: bool,
    /// the digest of its outputs
    pub digest: Option<String>,
}

impl Row {
    /// Why it differs from the reference; `None` if it does not.
    #[must_use]
    pub fn failure(&self) -> Option<String> {
        let differs = !self.is_missing && (!self.first.is_empty() || self.differing_bits != Some(0));
        differs.then(|| format!("{} differing bits; {}", self.bits(), self.first))
    }

    pub(crate) fn bits(&self) -> String {
        self.differing_bits.map_or_else(|| "-".to_owned(), |bits| bits.to_string())
    }

    /// The line of the table.
    #[must_use]
    pub fn text(&self) -> String {
        let Self { axis, block, engine, samples, first, .. } = self;
        let bits = if *engine == Engine::Reference.to_string() { "(reference)".to_owned() } else { self.bits() };
        format!("{axis:<20} {block:<16} {engine:<10} {samples:>10} {bits:>15}  {first}")
    }
}

/// Why an engine whose block is broken does not work at all: what its compiler says of an empty program. `None`: it works.
pub type Broken<'a> = &'a dyn Fn(Engine, &str) -> Option<String>;

/// The runs of a verification.
pub struct Verification<'a> {
    engines: &'a [Engine],
    broken: Broken<'a>,
    /// the missing engines, and the reasons
    missing: BTreeMap<Engine, String>,
}

impl<'a> Verification<'a> {
    #[must_use]
    pub fn new(engines: &'a [Engine], broken: Broken<'a>) -> Self {
        Self { engines, broken, missing: BTreeMap::new() }
    }

    /// Runs a block in every engine. Passes each row to `take` when it is complete; returns the lines about the reached
    /// states.
    ///
    /// # Errors
    /// That of `take`.
    pub fn block<E>(
        &mut self,
        designed: &Designed,
        block: &Block,
        inputs: &Samples,
        mut take: impl FnMut(Row) -> Result<(), E>,
    ) -> Result<Vec<String>, E> {
        let (axis, of_block) = (&designed.axis.name, block.program.block);
        let mut expected: Option<Samples> = None;
        for &engine in self.engines {
            let is_missing = self.missing.contains_key(&engine);
            let found = (!is_missing).then(|| engine::run(engine, designed, block, inputs));
            let digest = found.as_ref().and_then(|found| Some(digest(&found.as_ref().ok()?.bytes)));
            let (differing_bits, first) = self.judge(engine, found, &mut expected);
            take(Row {
                axis: axis.clone(),
                block: of_block,
                engine: engine.to_string(),
                samples: inputs.len(),
                differing_bits,
                first,
                is_missing: self.missing.contains_key(&engine),
                digest,
            })?;
        }
        let Some(outputs) = expected else { return Ok(Vec::new()) };
        let reached = coverage(designed, block, inputs, &outputs);
        let line = format!("{axis:<20} {of_block:<16} reached: {reached}");
        let missing = reached.missing().map(|line| format!("{:<20} {:<16}   {line}", "", ""));
        Ok([line].into_iter().chain(missing).collect())
    }

    /// Runs these blocks of an axis with the inputs of the exercise. Returns all rows, and the lines about the reached states.
    pub fn blocks(&mut self, designed: &Designed, blocks: &[Block], samples: usize) -> (Vec<Row>, Vec<String>) {
        let (mut rows, mut reached) = (Vec::new(), Vec::new());
        for block in blocks {
            let inputs = exercise::inputs(designed, block, samples);
            let Ok(lines) = self.block(designed, block, &inputs, |row| {
                rows.push(row);
                Ok::<_, Infallible>(())
            });
            reached.extend(lines);
        }
        (rows, reached)
    }

    /// The number of differing bits of an engine, and the first difference. Without a result, the engine is missing.
    fn judge(
        &mut self,
        engine: Engine,
        found: Option<Result<Samples, Failure>>,
        expected: &mut Option<Samples>,
    ) -> (Option<u64>, String) {
        let why = match found {
            Some(Ok(found)) => {
                let difference = compare(expected.as_ref().unwrap_or(&found), &found);
                expected.get_or_insert(found);
                return (Some(difference.bits), difference.first.map(place).unwrap_or_default());
            }
            Some(Err(Failure::SelfTest(sample))) => return (None, format!("self-test, sample {sample}")),
            Some(Err(Failure::Broken(text))) => match (self.broken)(engine, &text) {
                None => return (None, text),
                why => why,
            },
            Some(Err(failure)) => Some(failure.to_string()),
            None => None,
        };
        why.map(|why| self.missing.insert(engine, why));
        (None, NOT_RUN.to_owned())
    }

    /// The messages about missing engines.
    pub fn missing(self) -> Report {
        let missing = self.missing.into_iter();
        let said = |(engine, why)| Diagnostic::error(codes::NO_ENGINE, Place::whole(format!("engine {engine}")), why);
        Report { diagnostics: missing.map(said).collect() }
    }
}

/// The text in the row of a missing engine.
const NOT_RUN: &str = "not run";

fn place(place: FirstDifference) -> String {
    let FirstDifference { sample, signal, expected, found } = place;
    format!("sample {sample}, {signal}: {expected:?} expected, {found:?} found")
}
