//! Identifiers from paths, each given once. Which words a language keeps for itself is the language's business.

use std::collections::BTreeSet;

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

/// The names of one scope, unlike each other in more than the case of their letters.
#[derive(Clone, Debug)]
pub struct Names {
    is_reserved: fn(&str) -> bool,
    taken: BTreeSet<String>,
}

impl Names {
    /// No names yet, for a language that keeps some words for itself.
    #[must_use]
    pub fn without(is_reserved: fn(&str) -> bool) -> Self {
        Self { is_reserved, taken: BTreeSet::new() }
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
        let mut names = Names::without(|name| name == "limit");
        let taken = ["a[0].b", "limit", "A0_B", "limit", "a[0].b"].map(|path| names.take(path));
        assert_eq!(taken, ["a0_b", "limit_value", "A0_B_2", "limit_2", "a0_b_3"]);
    }
}
