//! The command `generate`: its targets, and what it reports. The files are in `plan`.

use crate::refused;
use crate::words::counted;
use generator::codes;
use generator::diagnostics::{Diagnostic, Place, Report};
use generator::target::{self, DEFAULT_TARGETS, TARGETS, Target};

/// The targets of these names, else of the set, else the default ones and those of the set's files in the folder: these were
/// requested earlier, and would become outdated.
///
/// # Errors
/// There is no such target.
pub fn targets<'n>(
    named: &[String],
    of_set: &[String],
    there: impl IntoIterator<Item = &'n str>,
) -> Result<Vec<Target>, Report> {
    let there = there.into_iter().filter(|name| target::named(name).is_some());
    let usual: Vec<String> = DEFAULT_TARGETS.into_iter().chain(there).map(str::to_owned).collect();
    let names = [named, of_set, &usual].into_iter().find(|names| !names.is_empty()).unwrap_or_default();
    let mut targets: Vec<Target> = Vec::with_capacity(names.len());
    for name in names {
        let known = TARGETS.map(|target| target.name);
        let target = target::named(name).ok_or_else(|| refused::no_such("--target", "target", name, &known))?;
        // A target that is named twice is generated once.
        if targets.iter().all(|chosen| chosen.name != target.name) {
            targets.push(target);
        }
    }
    Ok(targets)
}

/// The targets, with runners where the language has them.
///
/// # Errors
/// No target has any.
pub fn with_runners(targets: Vec<Target>, samples: usize) -> Result<Vec<Target>, Report> {
    each_with(targets, ["runners", "--runner"], |target| target.with_runners(samples))
}

/// The targets, with descriptions for calibration tools where the language has them.
///
/// # Errors
/// No target has any.
pub fn with_descriptions(targets: Vec<Target>) -> Result<Vec<Target>, Report> {
    each_with(targets, ["descriptions", "--a2l"], Target::with_descriptions)
}

/// The targets, with the files that an option adds.
fn each_with(
    targets: Vec<Target>,
    [files, option]: [&'static str; 2],
    with: impl Fn(Target) -> Option<Target>,
) -> Result<Vec<Target>, Report> {
    if targets.iter().all(|target| with(*target).is_none()) {
        let names: Vec<&str> = targets.iter().map(|target| target.name).collect();
        let found = format!("no target with {files}: {}", names.join(", "));
        let diagnostic = Diagnostic::error(codes::NO_SUCH, Place::whole(option), found);
        return Err(diagnostic.allowed("c").instead(format!("--target c {option}")).into());
    }
    Ok(targets.into_iter().map(|target| with(target).unwrap_or(target)).collect())
}

/// The numbers of a run.
#[derive(Clone, Copy, Debug)]
pub struct Count {
    pub axes: usize,
    pub written: usize,
    pub unchanged: usize,
    pub removed: usize,
    pub warnings: usize,
}

/// The last line.
#[must_use]
pub fn last_line(of: Count) -> String {
    format!(
        "{}: {} written, {} unchanged, {}{}",
        counted(of.axes, "axe").replace("axe", "axis").replace("axiss", "axes"),
        counted(of.written, "file"),
        of.unchanged,
        if of.removed == 0 { String::new() } else { format!("{} removed, ", of.removed) },
        counted(of.warnings, "warning"),
    )
}
