//! The names of channels in a row whose cells are separated by blanks, although names may contain blanks, without quotation
//! marks.

use super::cells;
use std::collections::{BTreeMap, BTreeSet};

/// The largest number of words of a name that occurs twice.
const LONGEST: usize = 8;

/// The names of these numbers of channels, group by group, each between two keys. `None` if the row is ambiguous.
///
/// Two hints help: names given by the user, and that a scope calls a second channel of one name `NAME (1)`.
pub(super) fn of_groups<'t>(line: &'t str, key: &str, counts: &[usize], wanted: &[&str]) -> Option<Vec<&'t str>> {
    let mut words = Vec::new();
    cells::split(line, ' ', &mut words);
    words.retain(|word| !word.is_empty());
    let mut phrases: BTreeSet<Vec<&str>> = wanted.iter().map(|name| name.split(' ').collect()).collect();
    phrases.extend(repeated(&words));
    let longest = phrases.iter().map(Vec::len).max().unwrap_or(1);
    let groups: Vec<&[&str]> = words.split(|word| *word == key).skip(1).collect();
    if groups.len() != counts.len() {
        return None;
    }
    let mut names = Vec::new();
    for (group, count) in groups.into_iter().zip(counts) {
        let before = names.len();
        let mut rest = group;
        while !rest.is_empty() {
            let is_next = |length: &usize| rest.get(..*length).is_some_and(|words| phrases.contains(words));
            let is_clear = group.len() == *count;
            let length = if is_clear { 1 } else { (2..=longest).rev().find(is_next).unwrap_or(1) };
            names.push(joined(line, rest[0], rest[length - 1]));
            rest = &rest[length..];
        }
        if names.len() - before != *count {
            return None;
        }
    }
    Some(names)
}

/// The names that occur a second time, followed by `(1)`: both forms of each.
fn repeated<'t>(words: &[&'t str]) -> Vec<Vec<&'t str>> {
    let is_number = |word: &str| {
        let digits = word.strip_prefix('(').and_then(|word| word.strip_suffix(')'));
        digits.is_some_and(|digits| !digits.is_empty() && digits.bytes().all(|byte| byte.is_ascii_digit()))
    };
    let mut counts: BTreeMap<&[&str], usize> = BTreeMap::new();
    for length in 1..=LONGEST {
        words.windows(length).for_each(|name| *counts.entry(name).or_default() += 1);
    }
    let mut phrases = Vec::new();
    for end in (1..words.len()).filter(|at| is_number(words[*at])) {
        let stands_elsewhere = |from: &usize| counts.get(&words[*from..end]).is_some_and(|count| *count > 1);
        if let Some(from) = (end.saturating_sub(LONGEST)..end).find(stands_elsewhere) {
            phrases.extend([words[from..end].to_vec(), words[from..=end].to_vec()]);
        }
    }
    phrases
}

/// The text from the first of these words to the last one.
fn joined<'t>(line: &'t str, first: &str, last: &str) -> &'t str {
    let offset = |word: &str| word.as_ptr() as usize - line.as_ptr() as usize;
    &line[offset(first)..offset(last) + last.len()]
}
