//! The parameters of other functions in a list that axgen uses: its name, its command filters. No rule.

use super::lines::Statement;
use super::source::Source;
use crate::diagnostics::Place;
use std::collections::BTreeMap;

/// Parameters of other functions in a list.
#[derive(Clone, Debug, Default)]
pub(crate) struct OtherFunctions {
    /// the number of skipped parameters
    pub(crate) count: usize,
    looked_at: BTreeMap<String, Found>,
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
    /// Counts a line, and keeps it if it is used.
    pub(super) fn pass_over(&mut self, line: &Statement<'_>, source: &Source, start: usize) {
        self.count += 1;
        if line.path == NAME || line.path.starts_with("filter[") || line.path.starts_with("filter_fir.") {
            let found = Found { text: line.value.to_owned(), place: source.place(start + line.value_at()) };
            self.looked_at.insert(line.path.to_owned(), found);
        }
    }

    pub(crate) fn get(&self, path: &str) -> Option<&Found> {
        self.looked_at.get(path)
    }
}
