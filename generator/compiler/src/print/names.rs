//! Identifiers from paths, each given once. The reserved words are part of a language's description.

use super::language::Language;
use std::collections::HashSet;

/// The identifier of a path: `stage[0].filter[1].y` becomes `stage0_filter1_y`.
pub fn identifier(path: &str) -> String {
    let mut name = String::with_capacity(path.len());
    let kept = path.chars().filter(|character| !matches!(character, '[' | ']'));
    name.extend(kept.map(|character| if character == '.' { '_' } else { character }));
    name
}

/// The names of one scope, unlike each other in more than the case of their letters.
pub(super) struct Names {
    is_reserved: fn(&str) -> bool,
    taken: HashSet<String>,
}

impl Names {
    /// No names yet, in a language that keeps some words for itself.
    pub(super) fn new(language: &Language) -> Self {
        Self { is_reserved: language.is_reserved, taken: HashSet::new() }
    }

    /// A name for what stands at the path, unlike every name given before.
    pub(super) fn take(&mut self, path: &str) -> String {
        let mut name = identifier(path);
        if (self.is_reserved)(&name) {
            name.push_str("_value");
        }
        // Mostly a new value of what has a name already.
        let words = ["_next", "_last"].map(str::to_owned).into_iter();
        let mut ends = words.chain((2..).map(|number| format!("_{number}")));
        while !self.taken.insert(name.to_ascii_lowercase()) {
            name = identifier(path) + &ends.next().unwrap_or_default();
        }
        name
    }
}
