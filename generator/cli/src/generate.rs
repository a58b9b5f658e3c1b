//! `axgen generate`: reads the set, makes the files, writes them.

use crate::arguments::SetArguments;
use crate::compare_files::{self, Show};
use crate::emit;
use crate::exit::Exit;
use crate::input::{self, counted};
use crate::summary;
use generator::config::Set;
use generator::generate;
use generator::pass::Defect;
use generator::target::{self, DEFAULT_TARGETS, TARGETS, Target};
use generator::write::{self, Refusal, Written};
use std::path::PathBuf;

/// Axes that are described one by one; of more, only their number is said.
const DESCRIBED_AXES: usize = 10;

/// What the command takes, beside the set.
pub struct Request {
    /// target languages; empty: the set's
    pub targets: Vec<String>,
    /// axes; empty: all
    pub axes: Vec<String>,
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
pub fn run(arguments: &SetArguments, request: &Request) -> Result<Exit, Exit> {
    let Request { axes, out, .. } = request;
    let (mut set, warnings) = input::read(arguments)?;
    for name in axes {
        input::axis(&set, Some(name))?;
    }
    let targets = chosen(&request.targets, &set)?;
    if let Some(stage) = &request.emit {
        return emit::run(set.axes.iter().filter(|axis| axes.is_empty() || axes.contains(&axis.name)), stage);
    }
    if let Some(show) = request.compare {
        let compare = |file| compare_files::difference(&file, out, show);
        return compare_files::say(made(generate::files(&set, axes, &targets, compare)));
    }
    let folder = write::open(out).map_err(refused)?;
    let staged = made(generate::files(&set, axes, &targets, |file| write::stage(&folder, &file)));
    let paths: Vec<PathBuf> = staged.iter().flatten().map(|file| file.path.clone()).collect();
    let written = write::commit(folder, staged, request.force).map_err(refused)?;
    set.axes.retain(|axis| axes.is_empty() || axes.contains(&axis.name));
    say(&set, &paths, written, warnings);
    Ok(Exit::Done)
}

/// Why nothing was written: a file that was edited is the user's to judge, the rest is the environment.
fn refused(refusal: Refusal) -> Exit {
    match refusal {
        Refusal::Edited(_) => Exit::input(refusal),
        Refusal::Failed(..) | Refusal::Torn(..) => Exit::environment(refusal),
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
    let known = || TARGETS.iter().map(|target| target.name).collect::<Vec<_>>().join(", ");
    names
        .iter()
        .map(|name| {
            target::named(name)
                .ok_or_else(|| Exit::input(format!("no target `{}`; there is: {}", name.escape_default(), known())))
        })
        .collect()
}

#[expect(clippy::print_stdout, reason = "what the command has done")]
fn say(set: &Set, paths: &[PathBuf], written: Written, warnings: usize) {
    if set.axes.len() <= DESCRIBED_AXES {
        for axis in &set.axes {
            print!("{}", summary::of(axis));
        }
        for path in paths {
            println!("{}", path.display());
        }
    }
    println!(
        "{}: {} written, {} unchanged, {}",
        counted(set.axes.len(), "axe").replace("axe", "axis").replace("axiss", "axes"),
        counted(written.changed, "file"),
        written.unchanged,
        counted(warnings, "warning"),
    );
}
