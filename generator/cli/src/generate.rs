//! `axgen generate`: reads the set, makes the files, writes them.

use crate::arguments::SetArguments;
use crate::compare_files::{self, Show};
use crate::emit;
use crate::exit::Exit;
use crate::input::{self, counted};
use crate::messages::Format;
use crate::output;
use crate::shared;
use compiler::pass::Defect;
use generator::diagnostics::{Diagnostic, Place, Slashes};
use generator::pipeline::Set;
use generator::target::{self, DEFAULT_TARGETS, File, TARGETS, Target};
use generator::write::{self, Refusal, Written};
use generator::{codes, generate, summary};
use std::borrow::Cow;
use std::path::PathBuf;
use std::slice;

/// Axes that are described one by one; of more, only their number is said.
const DESCRIBED_AXES: usize = 10;

/// What the command takes, beside the set.
pub struct Request {
    /// target languages; empty: the set's
    pub targets: Vec<String>,
    /// axes; empty: all
    pub axes: Vec<String>,
    /// how many samples the runners have that are written beside the blocks; none: no runners
    pub runner: Option<usize>,
    /// the folder for the files
    pub out: PathBuf,
    /// whether files that were changed by hand are overwritten
    pub force: bool,
    /// compares with what is on disk instead
    pub compare: Option<Show>,
    /// prints a stage of the pipeline instead
    pub emit: Option<String>,
}

/// Runs the command.
pub fn run(arguments: &SetArguments, format: Format, request: &Request) -> Result<Exit, Exit> {
    let Request { axes, out, .. } = request;
    let (mut set, warnings) = input::read(arguments, format)?;
    for name in axes {
        input::axis(&set, Some(name))?;
    }
    let mut targets = chosen(&request.targets, &set)?;
    if let Some(samples) = request.runner {
        targets = with_runners(targets, samples)?;
    }
    if let Some(stage) = &request.emit {
        return emit::run(set.axes.iter().filter(|of| axes.is_empty() || axes.contains(&of.axis.name)), stage);
    }
    if let Some(show) = request.compare {
        let named = shared::named(&set, axes, &targets, out);
        let compare = |file| compare_files::difference(&file, out, show);
        let blocks = files(&named, axes, &targets, compare);
        return compare_files::say(blocks.into_iter().chain(generate::pages(&set, axes, compare)).collect());
    }
    let folder = write::open(out).map_err(refused)?;
    let named = shared::named(&set, axes, &targets, out);
    let stage = |file| write::stage(&folder, &file);
    let mut staged = files(&named, axes, &targets, stage);
    staged.extend(generate::pages(&set, axes, stage));
    let paths: Vec<PathBuf> = staged.iter().flatten().map(|file| file.path.clone()).collect();
    let written = write::commit(folder, staged, request.force).map_err(refused)?;
    let left_out = named.iter().zip(&targets).filter_map(|(named, target)| shared::left_out(&set, named, target, out));
    let left_out: String = left_out.collect();
    set.axes.retain(|of| axes.is_empty() || axes.contains(&of.axis.name));
    say(&set, &paths, written, warnings)?;
    output::print(left_out)?;
    Ok(Exit::Done)
}

/// Why nothing was written: a file that was edited is the user's to judge, the rest is the environment.
pub fn refused(refusal: Refusal) -> Exit {
    match refusal {
        Refusal::Edited(_) => Exit::Input(refusal.report()),
        Refusal::Failed(..) | Refusal::Torn(..) => Exit::Environment(refusal.report()),
    }
}

/// Makes the files of the axes (all, if none is named) for each target, and those that the axes of its set share.
fn files<T: Send>(
    sets: &[Cow<'_, Set>],
    axes: &[String],
    targets: &[Target],
    take: impl Fn(File) -> T + Sync,
) -> Vec<T> {
    match sets {
        // All are the whole set: one design of each axis serves all targets.
        [set, ..] if sets.iter().all(|set| matches!(set, Cow::Borrowed(_))) => {
            made(generate::files(set, axes, targets, take))
        }
        _ => {
            let of =
                |(set, target): (&Cow<'_, Set>, _)| made(generate::files(set, axes, slice::from_ref(target), &take));
            sets.iter().zip(targets).flat_map(of).collect()
        }
    }
}

/// What was made; a defect is ours, and never anybody's input.
fn made<T>(result: Result<T, Defect>) -> T {
    result.unwrap_or_else(|defect| panic!("a defect of axgen: {defect}"))
}

/// The targets of the command line, else of the set, else the usual ones.
fn chosen(named: &[String], set: &Set) -> Result<Vec<Target>, Exit> {
    let usual = DEFAULT_TARGETS.map(str::to_owned);
    let names = [named, &set.targets, &usual].into_iter().find(|names| !names.is_empty()).unwrap_or_default();
    let mut targets: Vec<Target> = Vec::with_capacity(names.len());
    for name in names {
        let known = TARGETS.map(|target| target.name);
        let target = target::named(name).ok_or_else(|| Exit::no_such("--target", "target", name, &known))?;
        // A target that is named twice has its files once.
        if targets.iter().all(|chosen| chosen.name != target.name) {
            targets.push(target);
        }
    }
    Ok(targets)
}

/// The targets, those that have runners with them.
fn with_runners(targets: Vec<Target>, samples: usize) -> Result<Vec<Target>, Exit> {
    if targets.iter().all(|target| target.with_runners(samples).is_none()) {
        let names: Vec<&str> = targets.iter().map(|target| target.name).collect();
        let found = format!("no target with runners: {}", names.join(", "));
        let diagnostic = Diagnostic::error(codes::NO_SUCH, Place::whole("--runner"), found);
        return Err(Exit::Input(diagnostic.allowed("c").instead("--target c --runner").into()));
    }
    Ok(targets.into_iter().map(|target| target.with_runners(samples).unwrap_or(target)).collect())
}

fn say(set: &Set, paths: &[PathBuf], written: Written, warnings: usize) -> Result<(), Exit> {
    if set.axes.len() <= DESCRIBED_AXES {
        for designed in &set.axes {
            output::print(summary::text(designed))?;
        }
        for path in paths {
            output::line(path.slashes())?;
        }
    }
    output::line(format!(
        "{}: {} written, {} unchanged, {}",
        counted(set.axes.len(), "axe").replace("axe", "axis").replace("axiss", "axes"),
        counted(written.changed, "file"),
        written.unchanged,
        counted(warnings, "warning"),
    ))
}
