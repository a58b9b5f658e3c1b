//! From a file to its checked axes: a TOML set or one axis list. The only place that reads files; no rule is here.
//!
//! ```text
//! lines        a list's bytes <-> the parts of its lines
//! list, set    lines or tables -> (path, text)
//! path         path -> parameter and indices        closest  the name that was meant
//! value        text -> value of the parameter's kind
//! values       what was given, each with its place  source   byte -> line, column
//! ```
//! Then [`crate::check`] turns the values of an axis into an [`Axis`].

pub(crate) mod axis_name;
mod closest;
pub(crate) mod file;
pub(crate) mod lines;
pub(crate) mod list;
pub(crate) mod path;
pub(crate) mod set;
pub(crate) mod source;
pub(crate) mod value;
mod values;

pub use file::{Load, Unreadable};
pub use value::{Refused, of_text};
pub use values::{Key, Setting, Values};

use crate::axis::Axis;
use crate::check;
use crate::codes;
use crate::diagnostics::{Diagnostic, Place, Report, Severity};
use crate::parameters::Name;
use rayon::prelude::*;
use source::Source;
use std::path::Path;

/// The axes of a set, checked.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Set {
    /// what to generate when the command line names no target; empty: the set does not say
    pub targets: Vec<String>,
    /// the axes, in the order of the file
    pub axes: Vec<Axis>,
    /// how many parameters of other functions its lists hold; they were passed over
    pub foreign: usize,
}

/// What no axis list holds, for a list that stands alone.
#[derive(Clone, Debug, Default)]
pub struct ListOptions {
    /// `--cycle-time`
    pub cycle_time: Option<String>,
    /// `--name`; else the file's name is the axis's name
    pub name: Option<String>,
}

/// Reads and checks a TOML set (`.toml`) or one axis list (any other extension). The set is there if, and only if, no
/// message is an error.
#[must_use]
pub fn read(path: &Path, options: &ListOptions) -> (Option<Set>, Report) {
    read_with(path, options, &file::load)
}

/// The same with another source of files.
#[must_use]
pub fn read_with(path: &Path, options: &ListOptions, load: Load<'_>) -> (Option<Set>, Report) {
    let mut report = Report::default();
    let name = named(path);
    let set = match load(path) {
        Err(unreadable) => {
            report.push(unreadable.diagnostic(&name, Place::whole(&name)));
            Set::default()
        }
        Ok(bytes) if path.extension().is_some_and(|extension| extension.eq_ignore_ascii_case("toml")) => {
            report.extend(options_of_a_set(options));
            read_set(path, &Source::of(&name, &bytes), load, &mut report)
        }
        Ok(bytes) => read_list(path, &Source::of(&name, &bytes), options, &mut report),
    };
    (if report.has_errors() { None } else { Some(set) }, report.shortened())
}

/// How messages name a file: a line each, whatever its name is.
fn named(path: &Path) -> String {
    Place::whole(path.display()).file
}

fn read_set(path: &Path, source: &Source<'_>, load: Load<'_>, report: &mut Report) -> Set {
    let table = match set::parse(source) {
        Ok(table) => table,
        Err(faults) => {
            report.extend(faults);
            return Set::default();
        }
    };
    let top = set::top(source, table.get_ref(), report);
    let (cycle_time, said) = check::cycle_time(&top.values, || {
        let found = "the set has no cycle time";
        Diagnostic::error(codes::CYCLE_TIME, source.whole(), found)
            .instead("cycle_time = \"1ms\", if that is its cycle")
    });
    report.extend(said);
    let folder = path.parent().unwrap_or(Path::new(""));
    let read_axis = |axis: &set::AxisTable<'_>| read_axis(source, *axis, cycle_time, folder, load);
    let axes: Vec<_> = top.axes.par_iter().map(read_axis).collect();
    let mut set = Set { targets: check::targets(&top.values), ..Set::default() };
    let mut places = Vec::with_capacity(axes.len());
    for (axis, foreign, said) in axes {
        report.extend(said);
        set.axes.extend(axis.map(|(axis, place)| {
            places.push(place);
            axis
        }));
        set.foreign += foreign;
    }
    if !report.has_errors() {
        check::gantry::couple(&mut set.axes, &places, report);
    }
    set
}

fn read_axis(
    source: &Source<'_>,
    axis: set::AxisTable<'_>,
    cycle_time: Option<u32>,
    folder: &Path,
    load: Load<'_>,
) -> (Option<(Axis, Place)>, usize, Report) {
    let mut report = Report::default();
    let keys = set::values_of(source, axis, &mut report);
    let home = source.place(axis.name_at);
    let Some(list) = set::text_of(&keys, Name::List) else {
        return (checked(axis.name, cycle_time, &keys, home, &mut report), 0, report);
    };
    let path = folder.join(list);
    let name = named(&path);
    let bytes = match load(&path) {
        Ok(bytes) => bytes,
        Err(unreadable) => {
            let place = keys.get((Name::List, [0, 0])).map_or(home, Setting::value_place);
            report.push(unreadable.diagnostic(&name, place));
            return (None, 0, report);
        }
    };
    let list_source = Source::of(&name, &bytes);
    let list = list::read(&list_source);
    report.extend(list.report);
    if !list.complete {
        return (None, 0, report);
    }
    let mut values = list.values;
    values.override_with(keys);
    (checked(axis.name, cycle_time, &values, home, &mut report), list.foreign, report)
}

/// The axis, and where it names the master of its gantry.
fn checked(
    name: &str,
    cycle_time: Option<u32>,
    values: &Values<'_>,
    home: Place,
    report: &mut Report,
) -> Option<(Axis, Place)> {
    let place = values.get((Name::GantryMaster, [0, 0])).map_or_else(|| home.clone(), Setting::value_place);
    let (axis, mut said) = check::axis(name, cycle_time, values, home);
    let unread = values.unread(&said);
    said.diagnostics.extend(unread);
    if report.has_errors() {
        // What could not be read is missing: advice about what is there would mislead.
        said.diagnostics.retain(|diagnostic| diagnostic.severity == Severity::Error);
    }
    report.extend(said);
    axis.map(|axis| (axis, place))
}

fn read_list(path: &Path, source: &Source<'_>, options: &ListOptions, report: &mut Report) -> Set {
    let (cycle_time, said) = cycle_time_of(options, source);
    report.extend(said);
    let stem = path.file_stem().map(|stem| stem.to_string_lossy().into_owned()).unwrap_or_default();
    let name = options.name.clone().unwrap_or_else(|| axis_name::of_stem(&stem));
    if !axis_name::is_allowed(&name) {
        let of_option = options.name.is_some();
        let place = if of_option { of_command_line("--name") } else { source.whole() };
        let found = format!("{} is no name for an axis", value::shown(&name));
        let diagnostic = Diagnostic::error(codes::AXIS_NAME, place, found).allowed(axis_name::ALLOWED);
        report.push(if of_option { diagnostic } else { diagnostic.instead("--name NAME") });
    }
    let list = list::read(source);
    report.extend(list.report);
    if !list.complete {
        return Set::default();
    }
    let axis = checked(&name, cycle_time, &list.values, source.whole(), report);
    if let Some((axis, place)) = &axis {
        check::gantry::alone(axis, place.clone(), report);
    }
    Set { targets: Vec::new(), axes: axis.into_iter().map(|(axis, _)| axis).collect(), foreign: list.foreign }
}

fn cycle_time_of(options: &ListOptions, list: &Source<'_>) -> (Option<u32>, Report) {
    const OPTION: &str = "--cycle-time";
    let mut values = Values::default();
    let mut report = Report::default();
    let text = options.cycle_time.as_deref().unwrap_or_default();
    let source = Source::of(OPTION, text.as_bytes());
    if options.cycle_time.is_some() {
        let value = match of_text(Name::CycleTime.parameter(), text) {
            Ok(value) => Some(value),
            Err(refused) => {
                report.push(refused.diagnostic(Name::CycleTime, OPTION, of_command_line(OPTION)));
                None
            }
        };
        let spelling = Name::CycleTime.parameter().path;
        values.insert(
            (Name::CycleTime, [0, 0]),
            Setting { value, refused: None, spelling, source: &source, path_at: 0, value_at: 0 },
        );
    }
    let (cycle_time, said) = check::cycle_time(&values, || {
        let found = "no axis list holds the cycle time of the position controller";
        Diagnostic::error(codes::CYCLE_TIME, list.whole(), found).instead("--cycle-time 1ms, if that is its cycle")
    });
    let of_option = options.cycle_time.is_some();
    let at_option = |diagnostic| Diagnostic { place: of_command_line(OPTION), ..diagnostic };
    report.diagnostics.extend(said.diagnostics.into_iter().map(|said| if of_option { at_option(said) } else { said }));
    (cycle_time, report)
}

/// Options that a set does not need.
fn options_of_a_set(options: &ListOptions) -> Report {
    let mut report = Report::default();
    let given = [
        ("--cycle-time", options.cycle_time.is_some(), "the key `cycle_time` of the set"),
        ("--name", options.name.is_some(), "the name in [axis.NAME]"),
    ];
    for (option, _, instead) in given.into_iter().filter(|(_, given, _)| *given) {
        let found = format!("{option} is for a single axis list; this is a set");
        report.push(Diagnostic::error(codes::OPTION, of_command_line(option), found).instead(instead));
    }
    report
}

fn of_command_line(option: &str) -> Place {
    Place { file: option.to_owned(), line: 0, column: 0 }
}
