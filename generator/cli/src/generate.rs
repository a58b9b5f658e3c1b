//! `axgen generate`: reads the set, makes the files, writes them.

use crate::SetArguments;
use crate::exit::Exit;
use crate::input::{self, counted};
use crate::summary;
use generator::config::Set;
use generator::generate;
use generator::target::{self, DEFAULT_TARGETS, TARGETS, Target};
use generator::write::{self, Refusal, Written};
use std::fs;
use std::path::{Path, PathBuf};

/// Axes that are described one by one; of more, only their number is said.
const DESCRIBED_AXES: usize = 10;

/// Runs the command.
pub fn run(
    arguments: &SetArguments,
    targets: &[String],
    axes: &[String],
    out: &Path,
    force: bool,
) -> Result<Exit, Exit> {
    let (mut set, warnings) = input::read(arguments)?;
    for name in axes {
        input::axis(&set, Some(name))?;
    }
    let targets = chosen(targets, &set)?;
    fs::create_dir_all(out)
        .map_err(|error| Exit::environment(format!("{}: {error}; nothing was written", out.display())))?;
    let staged = generate::files(&set, axes, &targets, |file| write::stage(out, &file));
    let staged = staged.unwrap_or_else(|defect| panic!("a defect of axgen: {defect}"));
    let paths: Vec<PathBuf> = staged.iter().flatten().map(|file| file.path.clone()).collect();
    let written = write::commit(staged, force).map_err(|refusal| match refusal {
        Refusal::Edited(_) => Exit::input(refusal),
        Refusal::Failed(..) => Exit::environment(refusal),
    })?;
    set.axes.retain(|axis| axes.is_empty() || axes.contains(&axis.name));
    say(&set, &paths, written, warnings);
    Ok(Exit::Done)
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
