//! Many random programs at once: made, run, counted; the first that differs is shrunk and shown.

use super::batch::{self, Answer, Batch, Difference};
use super::choices::Choices;
use super::rng::Rng;
use super::syntax::Program;
use super::{coverage, generate, print, shrink};
use crate::environment::by_depth;
use inside::defect::Defect;
use inside::judge::INVALID;
use std::collections::BTreeMap;
use std::fmt::Write;
use std::path::Path;

/// The seed of a plain test run.
const SEED: u64 = 2026;
/// Programs that are built together.
const TOGETHER: usize = 1_000;

/// What a campaign does.
#[derive(Clone, Copy, Debug)]
pub struct Settings<'s> {
    /// where crates and C are built; kept from run to run
    pub folder: &'s Path,
    /// what the crates are called
    pub name: &'s str,
    /// what the programs are made from
    pub seed: u64,
    /// how many
    pub programs: usize,
    /// what is planted
    pub defect: Option<Defect>,
}

impl<'s> Settings<'s> {
    /// Those of a test run: `AXGEN_RANDOM_SEED` and `AXGEN_RANDOM_PROGRAMS` change them.
    ///
    /// # Panics
    /// If one of the two is not a number.
    #[must_use]
    pub fn from_environment(folder: &'s Path, name: &'s str) -> Self {
        let seed = number("AXGEN_RANDOM_SEED").unwrap_or(SEED);
        let programs = number("AXGEN_RANDOM_PROGRAMS").and_then(|programs| usize::try_from(programs).ok());
        Self { folder, name, seed, programs: programs.unwrap_or(by_depth(10, 25, 1_000)), defect: None }
    }
}

fn number(variable: &str) -> Option<u64> {
    let text = std::env::var(variable).ok()?;
    Some(text.parse().unwrap_or_else(|_| panic!("{variable} is a number, and not `{text}`")))
}

/// What came of a campaign.
#[derive(Clone, Debug, Default)]
pub struct Report {
    /// in how many programs each construct and each fact of a run occurs
    pub shares: BTreeMap<String, usize>,
    /// how many programs were run
    pub programs: usize,
    /// the programs that differ, by their number
    pub different: Vec<usize>,
    /// the smallest one, shrunk
    pub shrunk: Option<Shrunk>,
}

/// A small program that differs.
#[derive(Clone, Debug)]
pub struct Shrunk {
    /// the program
    pub program: Program,
    /// its text, with what its engines say
    pub text: String,
}

/// Runs a campaign.
///
/// # Errors
/// A program does not compile, breaks off as Rust, or something is not about one program at all.
pub fn run(settings: &Settings<'_>) -> Result<Report, String> {
    let mut report = Report::default();
    let numbers: Vec<usize> = (0..settings.programs).collect();
    for numbers in numbers.chunks(TOGETHER) {
        let programs: Vec<Program> =
            numbers.iter().map(|number| generate::program(&mut choices(settings, *number))).collect();
        let answers = batch::run(&together(settings, numbers, &programs))?;
        report.programs += programs.len();
        let mut different = Vec::new();
        for ((number, program), answer) in numbers.iter().zip(&programs).zip(answers) {
            refuse(*number, program, &answer)?;
            for occurs in coverage::collect(program).into_iter().chain(answer.facts.iter().cloned()) {
                *report.shares.entry(occurs).or_default() += 1;
            }
            if let Some(difference) = answer.differences.first() {
                different.push((print::lines(program), *number, difference.clone()));
            }
        }
        report.different.extend(different.iter().map(|(_, number, ..)| *number));
        if let Some((_, number, difference)) = different.into_iter().min_by_key(|(lines, ..)| *lines) {
            report.shrunk = Some(small(settings, number, &difference)?);
            return Ok(report);
        }
    }
    Ok(report)
}

fn together<'p>(settings: &Settings<'p>, numbers: &[usize], programs: &'p [Program]) -> Batch<'p> {
    let named = |(number, program): (&usize, &'p Program)| (name(*number), program);
    Batch {
        folder: settings.folder,
        name: settings.name,
        programs: numbers.iter().zip(programs).map(named).collect(),
        reals: &["f64", "f32"],
        defect: settings.defect,
        with_text: true,
    }
}

/// What a program is made of.
fn choices(settings: &Settings<'_>, number: usize) -> Choices {
    Choices::by_chance(Rng::numbered(settings.seed, number))
}

fn name(number: usize) -> String {
    format!("program{number}")
}

/// A program that rustc does not take, or that breaks off as Rust, is a mistake of the harness.
fn refuse(number: usize, program: &Program, answer: &Answer) -> Result<(), String> {
    let broken = answer.differences.iter().find(|difference| difference.engine == INVALID);
    match answer.rejected.as_ref().or(broken.map(|difference| &difference.message)) {
        Some(message) => Err(format!("program {number}: {message}\n{}", print::module(program, &name(number)))),
        None => Ok(()),
    }
}

/// Shrinks a program that differs, in the one engine and the one real type that differ.
fn small(settings: &Settings<'_>, number: usize, difference: &Difference) -> Result<Shrunk, String> {
    let mut made = choices(settings, number);
    generate::program(&mut made);
    let reals: &[&str] = if difference.real == "f64" { &["f64"] } else { &["f32"] };
    let crates = format!("{}-shrink", settings.name);
    let is_c = |difference: &Difference| difference.engine.starts_with("c ");
    let is_text = |difference: &Difference| is_c(difference) || ["rust -O", "st"].contains(&&*difference.engine);
    let batch = |programs: Vec<(String, &Program)>| -> Result<Vec<Answer>, String> {
        let (folder, defect) = (settings.folder, settings.defect);
        batch::run(&Batch { folder, name: &crates, programs, reals, defect, with_text: is_text(difference) })
    };
    let same = |found: &Difference| found.engine == difference.engine || is_c(found) && is_c(difference);
    let shrunk = shrink::shrink(&made.made(), |candidates| {
        let candidates = candidates.iter().map(|candidate| (name(number), candidate)).collect();
        Ok(batch(candidates)?.iter().map(|answer| answer.differences.iter().any(same)).collect())
    })?;
    let answers = batch(vec![(name(number), &shrunk)])?;
    let mut text = format!("{}\n", print::module(&shrunk, &name(number)));
    let _ = writeln!(text, "Program {number} of seed {}, shrunk to {} lines:", settings.seed, print::lines(&shrunk));
    for difference in answers.iter().flat_map(|answer| &answer.differences) {
        let _ = writeln!(text, "  {}, {}: {}", difference.real, difference.engine, difference.message);
    }
    Ok(Shrunk { program: shrunk, text })
}
