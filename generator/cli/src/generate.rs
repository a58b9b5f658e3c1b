//! `axgen generate`: reads the set, generates the files, writes them.

use crate::arguments::GenerateArguments;
use crate::compare_files::{self, Show};
use crate::emit;
use crate::exit::Exit;
use crate::input::{self, counted};
use crate::into_folder::{self, Done};
use crate::leftovers::Scope;
use crate::messages::{self, Format};
use crate::output;
use crate::plan::Plan;
use crate::recorded::Recorded;
use generator::diagnostics::{Diagnostic, Place, Slashes};
use generator::generate::PAGE;
use generator::pipeline::Set;
use generator::target::{self, DEFAULT_TARGETS, TARGETS, Target};
use generator::write::{Folder, Refusal};
use generator::{codes, summary};
use std::path::Path;

/// Largest number of axes that are described one by one; of more, only the number is printed.
const DESCRIBED_AXES: usize = 10;

/// The purpose of generating the files.
enum Purpose {
    Compare(Show),
    Write(Folder),
}

/// Runs the command.
pub fn run(of: &GenerateArguments, format: Format) -> Result<Exit, Exit> {
    let GenerateArguments { set: arguments, axes, out, .. } = of;
    let (mut set, warnings) = input::read(arguments, format)?;
    for name in axes {
        input::axis(&set, Some(name))?;
    }
    if let Some(stage) = &of.emit {
        return emit::run(set.axes.iter().filter(|axis| axes.is_empty() || axes.contains(&axis.axis.name)), stage);
    }
    let compare = if of.diff { Some(Show::Lines) } else { of.check.then_some(Show::Names) };
    let (purpose, recorded) = match compare {
        Some(show) => (Purpose::Compare(show), Recorded::read(out, &arguments.set)?),
        None => {
            let (folder, recorded) = into_folder::open(out, &arguments.set)?;
            (Purpose::Write(folder), recorded)
        }
    };
    let mut targets = chosen(&of.targets, &set, &recorded)?;
    if let Some(samples) = of.runner {
        targets = each_with(targets, ["runners", "--runner"], |target| target.with_runners(samples))?;
    }
    if of.a2l {
        targets = each_with(targets, ["descriptions", "--a2l"], Target::with_descriptions)?;
    }
    let scope = Scope::new(&set, axes, &of.targets);
    let dropped = scope.dropped(&recorded, |name| name == PAGE || targets.iter().any(|target| target.name == name));
    let plan = Plan::new((&set, axes, &targets), &recorded, &dropped, out);
    let folder = match purpose {
        Purpose::Compare(show) => return compare_files::run(&plan, &recorded, &scope, show),
        Purpose::Write(folder) => folder,
    };
    let done = into_folder::write(folder, &plan, &recorded, &scope, of.force)?;
    let left_out = plan.left_out(out);
    set.axes.retain(|axis| axes.is_empty() || axes.contains(&axis.axis.name));
    let report = done.leftovers.report(out);
    output::say(&messages::text(&report, format));
    say(&set, &done, out, warnings + report.warnings())?;
    output::print(left_out + &done.leftovers.of_other_sets(out))?;
    Ok(Exit::Done)
}

/// The exit for a refusal: an edited file is an error of the input, everything else of the environment.
pub fn refused(refusal: Refusal) -> Exit {
    match refusal {
        Refusal::Edited(_) => Exit::Input(refusal.report()),
        Refusal::Failed(..) | Refusal::Torn(..) => Exit::Environment(refusal.report()),
    }
}

/// The targets of the command line, else of the set, else the default ones and those of the set's files in the folder: these
/// were requested earlier, and would become outdated.
fn chosen(named: &[String], set: &Set, recorded: &Recorded) -> Result<Vec<Target>, Exit> {
    let there = recorded.targets().into_iter().filter(|name| target::named(name).is_some());
    let usual: Vec<String> = DEFAULT_TARGETS.into_iter().chain(there).map(str::to_owned).collect();
    let names = [named, &set.targets, &usual].into_iter().find(|names| !names.is_empty()).unwrap_or_default();
    let mut targets: Vec<Target> = Vec::with_capacity(names.len());
    for name in names {
        let known = TARGETS.map(|target| target.name);
        let target = target::named(name).ok_or_else(|| Exit::no_such("--target", "target", name, &known))?;
        // A target that is named twice is generated once.
        if targets.iter().all(|chosen| chosen.name != target.name) {
            targets.push(target);
        }
    }
    Ok(targets)
}

/// The targets with files that an option adds, where the language has them.
fn each_with(
    targets: Vec<Target>,
    [files, option]: [&'static str; 2],
    with: impl Fn(Target) -> Option<Target>,
) -> Result<Vec<Target>, Exit> {
    if targets.iter().all(|target| with(*target).is_none()) {
        let names: Vec<&str> = targets.iter().map(|target| target.name).collect();
        let found = format!("no target with {files}: {}", names.join(", "));
        let diagnostic = Diagnostic::error(codes::NO_SUCH, Place::whole(option), found);
        return Err(Exit::Input(diagnostic.allowed("c").instead(format!("--target c {option}")).into()));
    }
    Ok(targets.into_iter().map(|target| with(target).unwrap_or(target)).collect())
}

fn say(set: &Set, done: &Done, out: &Path, warnings: usize) -> Result<(), Exit> {
    let Done { paths, written, leftovers } = done;
    if set.axes.len() <= DESCRIBED_AXES {
        for designed in &set.axes {
            output::print(summary::text(designed))?;
        }
        for path in paths {
            output::line(path.slashes())?;
        }
    }
    for file in &leftovers.removed {
        output::line(format!("{}: removed, no longer generated", out.join(file).slashes()))?;
    }
    let removed = leftovers.removed.len();
    output::line(format!(
        "{}: {} written, {} unchanged, {}{}",
        counted(set.axes.len(), "axe").replace("axe", "axis").replace("axiss", "axes"),
        counted(written.changed, "file"),
        written.unchanged,
        if removed == 0 { String::new() } else { format!("{removed} removed, ") },
        counted(warnings, "warning"),
    ))
}
