//! The parameters of other functions in a list that axgen looks at: its name, its command filters, and names that are nearly
//! one of axgen's. No rule.

use super::lines::Statement;
use super::path::{self, Path};
use super::source::Source;
use super::value;
use super::values::Values;
use crate::codes;
use crate::diagnostics::{Diagnostic, Place};
use std::collections::BTreeMap;

/// Parameters of other functions in a list.
#[derive(Clone, Debug, Default)]
pub(crate) struct OtherFunctions {
    /// the number of skipped parameters
    pub(crate) count: usize,
    looked_at: BTreeMap<String, Found>,
    /// paths that differ in a letter or two, or by the structures above, from some of axgen's, which follow
    pub(super) nearly: Vec<(String, Vec<String>, Place)>,
}

/// The value of a skipped parameter.
#[derive(Clone, Debug)]
pub(crate) struct Found {
    pub(crate) text: String,
    pub(crate) place: Place,
}

/// The parameter with the name of the axis.
pub(crate) const NAME: &str = "kopf.log_achs_name";

impl OtherFunctions {
    /// Counts a line, and keeps it if it is used. `last`: the name of the last part of its path.
    pub(super) fn pass_over(&mut self, line: &Statement<'_>, last: &str, source: &Source, start: usize) {
        self.count += 1;
        const STARTS: [&str; 3] = [NAME, "filter[", "filter_fir."];
        // Of the drive and of a gear step, among many others.
        let is_read = matches!(last, "vz_istw" | "vz_stellgr" | "reverse" | "dyn_kv_active");
        if is_read || STARTS.iter().any(|start| line.path.starts_with(start)) {
            let found = Found { text: line.value.to_owned(), place: source.place(start + line.value_at()) };
            self.looked_at.insert(line.path.to_owned(), found);
        }
    }

    /// Warnings of paths that are nearly those of parameters without a value. Other functions have similar names: where the
    /// parameter is given, its neighbour is none that was mistyped.
    pub(crate) fn mistyped(&self, values: &Values) -> Vec<Diagnostic> {
        let is_missing = |known: &&String| match path::find(known) {
            Path::Known { name, index, .. } => values.get((name, index)).is_none(),
            _ => false,
        };
        let said = self.nearly.iter().filter_map(|(written, known, place)| {
            let known = known.iter().find(is_missing)?;
            let found = format!("{} is passed over, and `{known}` is not given", value::shown(written));
            Some(Diagnostic::warning(codes::NEARLY, place.clone(), found).instead(format!("{known}, if it is meant")))
        });
        said.collect()
    }

    pub(crate) fn get(&self, path: &str) -> Option<&Found> {
        self.looked_at.get(path)
    }

    /// Those whose path begins and ends so.
    pub(crate) fn all(&self, start: &'static str, end: &'static str) -> impl Iterator<Item = (&String, &Found)> {
        self.looked_at.iter().filter(move |(path, _)| path.starts_with(start) && path.ends_with(end))
    }
}
