//! The values that were given for one axis, each with its place; no default, no range and no rule.

use super::source::Source;
use crate::diagnostics::{Diagnostic, Place, Report, Severity};
use crate::parameters::{Name, Value};
use std::collections::BTreeMap;
use std::collections::btree_map::Entry;

/// A parameter with its indices; an index that the parameter lacks is 0.
pub type Key = (Name, [u32; 2]);

/// What was given for one parameter.
#[derive(Clone, Debug)]
pub struct Setting<'a> {
    /// the value; none: it could not be read, and that has been said, or is said where the value is used
    pub value: Option<Value>,
    /// what is to be said where the value is used
    pub refused: Option<Diagnostic>,
    /// the path template that was used: the parameter's path, or an alias
    pub spelling: &'static str,
    /// the file
    pub source: &'a Source<'a>,
    /// where the path begins
    pub path_at: usize,
    /// where the value begins
    pub value_at: usize,
}

impl Setting<'_> {
    /// Place of the path.
    #[must_use]
    pub fn path_place(&self) -> Place {
        self.source.place(self.path_at)
    }

    /// Place of the value.
    #[must_use]
    pub fn value_place(&self) -> Place {
        self.source.place(self.value_at)
    }
}

/// A value of a list, or why it is none: said at once, unless that can wait until something uses it.
pub(super) fn read(
    can_wait: bool,
    read: Result<Value, Diagnostic>,
    report: &mut Report,
) -> (Option<Value>, Option<Diagnostic>) {
    match read {
        Ok(value) => (Some(value), None),
        Err(refused) if can_wait => (None, Some(refused)),
        Err(refused) => {
            report.push(refused);
            (None, None)
        }
    }
}

/// What was given for one axis, in the order of the table.
#[derive(Clone, Debug, Default)]
pub struct Values<'a> {
    settings: BTreeMap<Key, Setting<'a>>,
}

impl<'a> Values<'a> {
    /// What was given for a parameter.
    #[must_use]
    pub fn get(&self, key: Key) -> Option<&Setting<'a>> {
        self.settings.get(&key)
    }

    /// Takes a value, unless there is one: then gives that one.
    pub fn insert(&mut self, key: Key, setting: Setting<'a>) -> Option<&Setting<'a>> {
        match self.settings.entry(key) {
            Entry::Vacant(vacant) => {
                vacant.insert(setting);
                None
            }
            Entry::Occupied(occupied) => Some(occupied.into_mut()),
        }
    }

    /// Why values of a list could not be read, but for those of which that has been said as an error where they are used: warnings,
    /// for a real machine's list may have them for other functions.
    pub fn unread(&self, said: &Report) -> Vec<Diagnostic> {
        let refusals = self.settings.values().filter_map(|setting| setting.refused.as_ref());
        let unsaid = refusals.filter(|refused| !said.diagnostics.contains(refused));
        unsaid.map(|refused| Diagnostic { severity: Severity::Warning, ..refused.clone() }).collect()
    }

    /// The same with those that have been said as errors.
    pub fn refused(&self, said: &Report) -> Vec<Diagnostic> {
        let refusals = self.settings.values().filter_map(|setting| setting.refused.clone());
        let of_use = refusals.filter(|refused| said.diagnostics.contains(refused));
        of_use.chain(self.unread(said)).collect()
    }

    /// Lets the values of a set take the place of those of its list.
    pub fn override_with(&mut self, other: Self) {
        self.settings.extend(other.settings);
    }

    /// All that was given.
    pub fn iter(&self) -> impl Iterator<Item = (Key, &Setting<'a>)> {
        self.settings.iter().map(|(key, setting)| (*key, setting))
    }
}
