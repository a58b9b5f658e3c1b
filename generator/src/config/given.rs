//! What a set or a list gives: the values of its top and of each of its axes. Files are read here; nothing is validated.

use super::file::Load;
use super::set::AxisTable;
use super::source::Source;
use super::value::{self, shown};
use super::values::{Setting, Values, key};
use super::{axis_name, list, set};
use crate::codes;
use crate::diagnostics::{Diagnostic, Place, Report};
use crate::parameters::Name;
use rayon::prelude::*;
use std::path::Path;
use std::sync::Arc;

/// What no axis list holds, for a list that stands alone.
#[derive(Clone, Debug, Default)]
pub struct ListOptions {
    /// `--cycle-time`
    pub cycle_time: Option<String>,
    /// `--name`; else the file's name is the axis's name
    pub name: Option<String>,
}

#[derive(Debug)]
pub(crate) struct Given {
    /// `cycle_time`, `targets`
    pub(crate) top: Values,
    pub(crate) no_cycle_time: Diagnostic,
    pub(crate) is_list: bool,
    pub(crate) axes: Vec<GivenAxis>,
    /// what is to be said of the file, but for its axes
    pub(crate) report: Report,
}

#[derive(Debug)]
pub(crate) struct GivenAxis {
    pub(crate) name: String,
    /// where the set names it; of a list the whole file
    pub(crate) home: Place,
    /// none: its list cannot be read, which has been said
    pub(crate) values: Option<Values>,
    /// how many parameters of other functions its list holds; they were passed over
    pub(crate) foreign: usize,
    /// what is to be said of its lines
    pub(crate) report: Report,
}

/// Reads a TOML set (`.toml`) or one axis list (any other extension).
pub(crate) fn read(path: &Path, options: &ListOptions, load: Load<'_>) -> Result<Given, Report> {
    let name = named(path);
    let bytes = load(path).map_err(|unreadable| unreadable.diagnostic(&name, Place::whole(&name)))?;
    let source = Source::of(&name, bytes);
    if path.extension().is_some_and(|extension| extension.eq_ignore_ascii_case("toml")) {
        of_set(path, &source, options, load)
    } else {
        Ok(of_list(path, &source, options))
    }
}

impl Given {
    fn nothing(place: &Place) -> Self {
        let no_cycle_time = Diagnostic::error(codes::CYCLE_TIME, place.clone(), "the set has no cycle time")
            .instead("cycle_time = \"1ms\", if that is its cycle");
        Self { top: Values::default(), no_cycle_time, is_list: false, axes: Vec::new(), report: Report::default() }
    }
}

/// How messages name a file: a line each, whatever its name is.
fn named(path: &Path) -> String {
    Place::whole(path.display()).file
}

fn of_set(path: &Path, source: &Arc<Source>, options: &ListOptions, load: Load<'_>) -> Result<Given, Report> {
    let mut given = Given::nothing(&source.whole());
    given.report = options_of_a_set(options);
    let table = match set::parse(source) {
        Ok(table) => table,
        Err(faults) => {
            given.report.extend(faults);
            return Err(given.report);
        }
    };
    let top = set::top(source, table.get_ref(), &mut given.report);
    let folder = path.parent().unwrap_or(Path::new(""));
    given.axes = top.axes.par_iter().map(|axis| of_axis(source, *axis, folder, load)).collect();
    given.top = top.values;
    Ok(given)
}

/// The keys of an axis over the values of its list.
fn of_axis(source: &Arc<Source>, axis: AxisTable<'_>, folder: &Path, load: Load<'_>) -> GivenAxis {
    let mut report = Report::default();
    let keys = set::values_of(source, axis, &mut report);
    let home = source.place(axis.name_at);
    let mut given = GivenAxis { name: axis.name.to_owned(), home, values: None, foreign: 0, report };
    let Some(list) = keys.text(Name::List) else { return GivenAxis { values: Some(keys), ..given } };
    let path = folder.join(list);
    let name = named(&path);
    match load(&path) {
        Ok(bytes) => {
            let list = list::read(&Source::of(&name, bytes));
            given.report.extend(list.report);
            given.foreign = list.foreign;
            let mut values = list.values;
            values.override_with(keys);
            given.values = Some(values).filter(|_| list.complete);
        }
        Err(unreadable) => {
            let place = keys.get(key(Name::List)).map_or(given.home.clone(), Setting::value_place);
            given.report.push(unreadable.diagnostic(&name, place));
        }
    }
    given
}

fn of_list(path: &Path, source: &Arc<Source>, options: &ListOptions) -> Given {
    let mut given = Given::nothing(&source.whole());
    given.is_list = true;
    given.no_cycle_time.found = "no axis list holds the cycle time of the position controller".to_owned();
    given.no_cycle_time.instead = Some("--cycle-time 1ms, if that is its cycle".to_owned());
    given.top = cycle_time_of(options, &mut given.report);
    let name = list_name(path, options, &mut given.report);
    let list = list::read(source);
    given.axes.push(GivenAxis {
        name,
        home: source.whole(),
        foreign: list.foreign,
        report: list.report,
        values: Some(list.values).filter(|_| list.complete),
    });
    given
}

/// The name of a list's axis: that of the option, else that of the file.
pub(crate) fn list_name(path: &Path, options: &ListOptions, report: &mut Report) -> String {
    let stem = path.file_stem().map(|stem| stem.to_string_lossy().into_owned()).unwrap_or_default();
    let name = options.name.clone().unwrap_or_else(|| axis_name::of_stem(&stem));
    if !axis_name::is_allowed(&name) {
        let of_option = options.name.is_some();
        let place = if of_option { Place::whole("--name") } else { Place::whole(path.display()) };
        let found = format!("{} is no name for an axis", shown(&name));
        let diagnostic = Diagnostic::error(codes::AXIS_NAME, place, found).allowed(axis_name::ALLOWED);
        report.push(if of_option { diagnostic } else { diagnostic.instead("--name NAME") });
    }
    name
}

/// The cycle time of the command line, as if it were a key.
fn cycle_time_of(options: &ListOptions, report: &mut Report) -> Values {
    const OPTION: &str = "--cycle-time";
    let mut values = Values::default();
    if let Some(text) = &options.cycle_time {
        let refused = |refused: value::Refused| {
            report.push(refused.diagnostic(Name::CycleTime, OPTION, Place::whole(OPTION)));
        };
        let value = value::of_text(Name::CycleTime.parameter(), text).map_err(refused).ok();
        let spelling = Name::CycleTime.parameter().path;
        let source = Source::option(OPTION, text);
        let setting = Setting { value, refused: None, spelling, source, path_at: 0, value_at: 0 };
        values.insert(key(Name::CycleTime), setting);
    }
    values
}

fn options_of_a_set(options: &ListOptions) -> Report {
    let mut report = Report::default();
    let given = [
        ("--cycle-time", options.cycle_time.is_some(), "the key `cycle_time` of the set"),
        ("--name", options.name.is_some(), "the name in [axis.NAME]"),
    ];
    for (option, _, instead) in given.into_iter().filter(|(_, given, _)| *given) {
        let found = format!("{option} is for a single axis list; this is a set");
        report.push(Diagnostic::error(codes::OPTION, Place::whole(option), found).instead(instead));
    }
    report
}
