//! The given values of one axis, each with its place. No default, no range, no rule.

use super::source::Source;
use crate::diagnostics::{Diagnostic, Place, Report, Severity};
use crate::parameters::{Name, Value, words::Words};
use std::collections::{BTreeMap, btree_map::Entry};
use std::sync::Arc;

/// A parameter with its indices; an index that the parameter lacks is 0.
pub(crate) type Key = (Name, [u32; 2]);

/// The key of a parameter without indices.
pub(crate) fn key(name: Name) -> Key {
    (name, [0, 0])
}

#[derive(Clone, Debug)]
pub(crate) struct Setting {
    /// the value; `None` if it could not be read, which is reported at once or where the value is used
    pub(crate) value: Option<Value>,
    /// the message to report where the value is used
    pub(crate) refused: Option<Diagnostic>,
    /// the path template that was used: the parameter's path, or an alias
    pub(crate) spelling: &'static str,
    pub(crate) source: Arc<Source>,
    pub(crate) path_at: usize,
    pub(crate) value_at: usize,
}

impl Setting {
    pub(crate) fn path_place(&self) -> Place {
        self.source.place(self.path_at)
    }

    pub(crate) fn value_place(&self) -> Place {
        self.source.place(self.value_at)
    }
}

#[derive(Clone, Debug, Default)]
pub(crate) struct Values {
    settings: BTreeMap<Key, Setting>,
}

impl Values {
    pub(crate) fn get(&self, key: Key) -> Option<&Setting> {
        self.settings.get(&key)
    }

    pub(crate) fn is_empty(&self) -> bool {
        self.settings.is_empty()
    }

    /// Inserts a value if there is none yet; otherwise returns the existing one.
    pub(crate) fn insert(&mut self, key: Key, setting: Setting) -> Option<&Setting> {
        match self.settings.entry(key) {
            Entry::Vacant(vacant) => {
                vacant.insert(setting);
                None
            }
            Entry::Occupied(occupied) => Some(occupied.into_mut()),
        }
    }

    /// The messages about unreadable values of a list, except those already reported as errors: warnings, because a real
    /// machine's list may contain such values for other functions.
    pub(crate) fn unread(&self, said: &Report) -> Vec<Diagnostic> {
        let refusals = self.settings.values().filter_map(|setting| setting.refused.as_ref());
        let unsaid = refusals.filter(|refused| !said.diagnostics.contains(refused));
        unsaid.map(|refused| Diagnostic { severity: Severity::Warning, ..refused.clone() }).collect()
    }

    /// The messages about unreadable values of a list, including those already reported as errors.
    pub(crate) fn refused(&self, said: &Report) -> Vec<Diagnostic> {
        let refusals = self.settings.values().filter_map(|setting| setting.refused.clone());
        let of_use = refusals.filter(|refused| said.diagnostics.contains(refused));
        of_use.chain(self.unread(said)).collect()
    }

    pub(crate) fn word<T: Words>(&self, name: Name) -> Option<T> {
        match self.get(key(name))?.value {
            Some(Value::Word(word)) => T::named(word),
            _ => None,
        }
    }

    pub(crate) fn text(&self, name: Name) -> Option<(&str, &Setting)> {
        let setting = self.get(key(name))?;
        match &setting.value {
            Some(Value::Text(text)) => Some((text, setting)),
            _ => None,
        }
    }

    /// Keeps those of some keys only.
    pub(crate) fn retain(&mut self, is_kept: impl Fn(Key) -> bool) {
        self.settings.retain(|key, _| is_kept(*key));
    }

    /// The values of a list; those of its set take their place.
    pub(crate) fn overridden_by(mut self, other: Self) -> Self {
        self.settings.extend(other.settings);
        self
    }

    pub(crate) fn iter(&self) -> impl Iterator<Item = (Key, &Setting)> {
        self.settings.iter().map(|(key, setting)| (*key, setting))
    }
}
