//! Identifiers from paths, each given once. Which words a language keeps for itself is the language's business.

use super::Language;
use std::collections::HashSet;
use std::sync::OnceLock;

/// The identifier of a path: `stage[0].filter[1].y` becomes `stage0_filter1_y`.
#[must_use]
pub fn identifier(path: &str) -> String {
    let mut name = String::with_capacity(path.len());
    for character in path.chars() {
        match character {
            '[' | ']' => {}
            '.' => name.push('_'),
            other => name.push(other),
        }
    }
    name
}

/// Words of a language, in small letters.
pub(super) struct Words {
    text: &'static str,
    words: OnceLock<HashSet<&'static str>>,
}

impl Words {
    /// The words of a text, between blanks.
    pub(super) const fn new(text: &'static str) -> Self {
        Self { text, words: OnceLock::new() }
    }

    /// Whether a word is one of them.
    pub(super) fn have(&self, word: &str) -> bool {
        self.words.get_or_init(|| self.text.split_ascii_whitespace().collect()).contains(word)
    }
}

/// The names of one scope, unlike each other in more than the case of their letters.
#[derive(Clone, Debug)]
pub struct Names {
    is_reserved: fn(&str) -> bool,
    taken: HashSet<String>,
}

impl Names {
    /// No names yet, in a language that keeps some words for itself.
    #[must_use]
    pub fn new(language: &Language) -> Self {
        Self { is_reserved: language.is_reserved, taken: HashSet::new() }
    }

    /// A name for what stands at the path, unlike every name given before.
    pub fn take(&mut self, path: &str) -> String {
        let plain = identifier(path);
        let mut name = if (self.is_reserved)(&plain) { format!("{plain}_value") } else { plain.clone() };
        let mut number = 2;
        while !self.taken.insert(name.to_ascii_lowercase()) {
            name = format!("{plain}_{number}");
            number += 1;
        }
        name
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_name_is_given_once() {
        let mut names = Names { is_reserved: |name| name == "limit", taken: HashSet::new() };
        let taken = ["a[0].b", "limit", "A0_B", "limit", "a[0].b"].map(|path| names.take(path));
        assert_eq!(taken, ["a0_b", "limit_value", "A0_B_2", "limit_2", "a0_b_3"]);
    }
}
