//! `axgen generate`: reads the set, makes the files, writes them.

use crate::SetArguments;
use crate::exit::Exit;
use crate::input::{self, counted};
use crate::summary;
use generator::config::Set;
use generator::target::{self, TARGETS, Target};
use generator::{generate, write};
use std::path::Path;

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
    set.axes.retain(|axis| axes.is_empty() || axes.contains(&axis.name));
    let targets = chosen(targets, &set)?;
    let files = generate::files(&set, &targets).unwrap_or_else(|defect| panic!("a defect of axgen: {defect}"));
    let written = match write::write(out, &files, force) {
        Ok(written) => written,
        Err(refusal @ write::Refusal::Edited(_)) => return Err(Exit::input(refusal)),
        Err(refusal @ write::Refusal::Failed(..)) => return Err(Exit::environment(refusal)),
    };
    say(&set, &files, written, out, warnings);
    Ok(Exit::Done)
}

/// The targets of the command line, else of the set, else all.
fn chosen(named: &[String], set: &Set) -> Result<Vec<Target>, Exit> {
    let names = if named.is_empty() { &set.targets } else { named };
    if names.is_empty() {
        return Ok(TARGETS.to_vec());
    }
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
fn say(set: &Set, files: &[target::File], written: write::Written, out: &Path, warnings: usize) {
    if set.axes.len() <= DESCRIBED_AXES {
        for axis in &set.axes {
            print!("{}", summary::of(axis));
        }
        for file in files {
            println!("{}", out.join(&file.name).display());
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
