//! Unique identifiers from paths. The reserved words are in the description of a language.

use super::language::Language;
use std::collections::BTreeSet;

/// The identifier of a path: `stage[0].filter[1].y` becomes `stage0_filter1_y`.
pub fn identifier(path: &str) -> String {
    let mut name = path.replace('.', "_");
    name.retain(|character| !matches!(character, '[' | ']'));
    name
}

/// The names of one scope: they differ in more than the case of their letters, and within the significant characters of the
/// language.
pub(super) struct Names {
    is_reserved: fn(&str) -> bool,
    significant: usize,
    taken: BTreeSet<String>,
    /// names of signals, memory and constants, in the scope of the intermediate values
    fixed: BTreeSet<String>,
}

impl Names {
    /// An empty scope, in a language with reserved words.
    pub(super) fn new(language: &Language) -> Self {
        let significant = language.significant.unwrap_or(usize::MAX);
        Self { is_reserved: language.is_reserved, significant, taken: BTreeSet::new(), fixed: BTreeSet::new() }
    }

    /// From now on a name is that of an intermediate value, of this cycle.
    pub(super) fn begin_locals(&mut self) {
        self.fixed = std::mem::take(&mut self.taken);
    }

    /// A name for a path that differs from all previous names: another value of the same path gets a number. The path of an
    /// intermediate value can be that of a signal or of a part of the memory.
    pub(super) fn take(&mut self, path: &str) -> String {
        let mut name = identifier(path);
        if name.len() > self.significant
            && let Some(short) = self.take_short(path)
        {
            return short;
        }
        if (self.is_reserved)(&name) {
            name.push_str("_value");
        }
        if self.claim(&name) {
            return name;
        }
        if self.fixed.contains(&self.key(&name)) {
            return self.take(&format!("{path}_now"));
        }
        let mut number = 2;
        loop {
            let end = format!("_{number}");
            name = identifier(path);
            // The distinguishing part must be within the significant characters.
            name.truncate(self.significant.saturating_sub(end.len()));
            name.push_str(&end);
            if self.claim(&name) {
                return name;
            }
            number += 1;
        }
    }

    /// For a path whose name is too long: the name of its first part and of as much of its end as fits. `None` if nothing of
    /// it can be left out.
    fn take_short(&mut self, path: &str) -> Option<String> {
        let (first, mut rest) = path.split_once('.')?;
        while let Some((_, shorter)) = rest.split_once('.') {
            rest = shorter;
            let name = identifier(&format!("{first}.{rest}"));
            if name.len() <= self.significant && self.claim(&name) {
                return Some(name);
            }
        }
        None
    }

    /// Takes the name if no other one is equal to it within the significant characters.
    fn claim(&mut self, name: &str) -> bool {
        let key = self.key(name);
        !self.fixed.contains(&key) && self.taken.insert(key)
    }

    /// What makes a name differ from others.
    fn key(&self, name: &str) -> String {
        name.get(..self.significant).unwrap_or(name).to_ascii_lowercase()
    }
}
