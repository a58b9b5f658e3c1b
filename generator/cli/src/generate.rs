//! `axgen generate`: reads the set, generates the files, writes them.

use crate::arguments::GenerateArguments;
use crate::compare_files::{self, Show};
use crate::exit::Exit;
use crate::input;
use crate::into_folder::{self, Done};
use crate::leftovers::Scope;
use crate::messages::{self, Format};
use crate::output;
use crate::plan;
use crate::recorded::Recorded;
use commands::emit;
use commands::generate::{self, Count};
use generator::config;
use generator::diagnostics::Slashes;
use generator::generate::PAGE;
use generator::pipeline::Set;
use generator::summary;
use generator::target::Target;
use generator::write::Refusal;
use std::path::Path;

/// Largest number of axes that are described one by one; of more, only the number is printed.
const DESCRIBED_AXES: usize = 10;

/// Runs the command.
pub fn run(of: &GenerateArguments, format: Format) -> Result<Exit, Exit> {
    let GenerateArguments { set: arguments, axes, out, .. } = of;
    let (mut set, warnings) = input::read(arguments, format)?;
    axes.iter().try_for_each(|name| commands::axis(&set, Some(name)).map(drop))?;
    if let Some(stage) = &of.emit {
        let axes = set.axes.iter().filter(|axis| axes.is_empty() || axes.contains(&axis.axis.name));
        output::print(emit::text(axes, stage)?)?;
        return Ok(Exit::Done);
    }
    let (folder, recorded) = match of.check || of.diff {
        true => (None, Recorded::read(out, &arguments.set)?),
        false => into_folder::open(out, &arguments.set).map(|(folder, recorded)| (Some(folder), recorded))?,
    };
    let targets = targets(of, &set, &recorded)?;
    // One axis that `--name` selects from a project is one of several, as with `--axis`.
    let of_project = arguments.list.name.as_ref().map(|_| config::axes_of_project(&arguments.set, &config::load));
    let others = of_project.unwrap_or_default();
    let selected = match others.is_empty() {
        true => axes.clone(),
        false => set.axes.iter().map(|of| of.axis.name.clone()).collect(),
    };
    let scope = Scope::new(&set, &selected, &of.targets, &others);
    let dropped = scope.dropped(&recorded, |name| name == PAGE || targets.iter().any(|target| target.name == name));
    let plan = plan::for_folder((&set, axes, &targets), &recorded, &dropped, out);
    let Some(folder) = folder else {
        let show = if of.diff { Show::Lines } else { Show::Names };
        return compare_files::run(&plan, &recorded, &scope, show);
    };
    let done = into_folder::write(folder, &plan, &recorded, &scope, of.force)?;
    let left_out = plan::left_out(&plan, out);
    set.axes.retain(|axis| axes.is_empty() || axes.contains(&axis.axis.name));
    let report = done.leftovers.report(out);
    output::say(&messages::text(&report, format));
    say(&set, &done, out, warnings + report.warnings())?;
    output::print(left_out + &done.leftovers.of_other_sets(out))?;
    Ok(Exit::Done)
}

/// The targets, with the files that options add.
fn targets(of: &GenerateArguments, set: &Set, recorded: &Recorded) -> Result<Vec<Target>, Exit> {
    let mut targets = generate::targets(&of.targets, &set.targets, recorded.targets())?;
    if let Some(samples) = of.runner {
        targets = generate::with_runners(targets, samples)?;
    }
    Ok(if of.a2l { generate::with_descriptions(targets)? } else { targets })
}

/// The exit for a refusal: an edited file is an error of the input, everything else of the environment.
pub fn refused(refusal: Refusal) -> Exit {
    match refusal {
        Refusal::Edited(_) => Exit::Input(refusal.report()),
        Refusal::Failed(..) | Refusal::Torn(..) => Exit::Environment(refusal.report()),
    }
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
    output::line(generate::last_line(Count {
        axes: set.axes.len(),
        written: written.changed,
        unchanged: written.unchanged,
        removed: leftovers.removed.len(),
        warnings,
    }))
}
