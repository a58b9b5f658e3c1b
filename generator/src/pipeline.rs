//! From a file to its designed axes: read, check, design, feasibility. The one place that drives these steps.

use crate::blocks::designed::Designed;
use crate::check::{self, Checked, gantry};
use crate::config::given::{self, GivenAxis};
use crate::config::values::{Setting, key};
use crate::config::{ListOptions, Load, file};
use crate::diagnostics::{Place, Report, Severity};
use crate::feasibility;
use crate::parameters::Name;
use rayon::prelude::*;
use std::path::Path;

/// The axes of a set, checked and designed.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Set {
    /// what to generate when the command line names no target; empty: the set does not say
    pub targets: Vec<String>,
    /// the axes, in the order of the file
    pub axes: Vec<Designed>,
    /// how many parameters of other functions its lists hold; they were passed over
    pub foreign: usize,
}

/// Reads, checks and designs a TOML set (`.toml`) or one axis list (any other extension). The set is there if, and only if, no
/// message is an error.
#[must_use]
pub fn read(path: &Path, options: &ListOptions) -> (Option<Set>, Report) {
    read_with(path, options, &file::load)
}

/// The same with another source of files.
#[must_use]
pub fn read_with(path: &Path, options: &ListOptions, load: Load<'_>) -> (Option<Set>, Report) {
    let given = match given::read(path, options, load) {
        Ok(given) => given,
        Err(report) => return (None, report.shortened()),
    };
    let mut report = given.report;
    let cycle_time = check::cycle_time(&given.top, given.no_cycle_time, &mut report);
    let mut axes: Vec<Axis<'_>> = given.axes.par_iter().map(|axis| Axis::check(axis, cycle_time)).collect();
    // Masters decide what their slaves are designed for.
    let coupling = couple(&mut axes, given.is_list, &report);
    let designed: Vec<(Option<Designed>, Report)> = axes.into_par_iter().map(Axis::design).collect();
    let mut set = Set { targets: check::targets(&given.top), ..Set::default() };
    set.foreign = given.axes.iter().map(|axis| axis.foreign).sum();
    for (designed, said) in designed {
        report.extend(said);
        set.axes.extend(designed);
    }
    if !report.has_errors() {
        report.extend(coupling);
    }
    (if report.has_errors() { None } else { Some(set) }, report.shortened())
}

/// An axis on its way.
struct Axis<'g> {
    given: &'g GivenAxis,
    /// none: its values cannot be read
    checked: Option<Checked<'g>>,
}

impl<'g> Axis<'g> {
    fn check(given: &'g GivenAxis, cycle_time: Option<u32>) -> Self {
        let checked = given.values.as_ref();
        let checked = checked.map(|values| check::axis(&given.name, cycle_time, values, given.home.clone()));
        Self { given, checked }
    }

    /// Where it names the master of its gantry.
    fn place_of_master(&self) -> Place {
        let setting = self.given.values.as_ref().and_then(|values| values.get(key(Name::GantryMaster)));
        setting.map_or_else(|| self.given.home.clone(), Setting::value_place)
    }

    fn has_errors(&self) -> bool {
        self.given.report.has_errors() || self.checked.as_ref().is_none_or(|checked| checked.axis.is_none())
    }

    /// Designs the axis, and says all that is to be said of it.
    fn design(self) -> (Option<Designed>, Report) {
        let mut report = self.given.report.clone();
        let (Some(Checked { axis, gear, mut effective }), Some(values)) = (self.checked, &self.given.values) else {
            return (None, report);
        };
        let designed = axis.map(Designed::of);
        if let Some(designed) = &designed {
            feasibility::validate(designed, gear, &mut effective);
        }
        let mut said = effective.report;
        let designed = designed.filter(|_| !said.has_errors());
        let unread = values.unread(&said);
        said.diagnostics.extend(unread);
        if report.has_errors() {
            // What could not be read is missing: advice about what is there would mislead.
            said.diagnostics.retain(|diagnostic| diagnostic.severity == Severity::Error);
        }
        report.extend(said);
        (designed, report)
    }
}

/// Couples gantry slaves to their masters, where all axes are there; gives what is to be said of that.
fn couple(axes: &mut [Axis<'_>], is_list: bool, report: &Report) -> Report {
    let mut coupling = Report::default();
    if report.has_errors() || axes.iter().any(Axis::has_errors) {
        return coupling;
    }
    let places: Vec<Place> = axes.iter().map(Axis::place_of_master).collect();
    let mut checked: Vec<_> = axes.iter_mut().filter_map(|axis| axis.checked.as_mut()?.axis.as_mut()).collect();
    match checked.as_mut_slice() {
        [axis] if is_list => gantry::alone(axis, places[0].clone(), &mut coupling),
        axes => gantry::couple(axes, &places, &mut coupling),
    }
    coupling
}
