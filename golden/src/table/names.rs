//! The names of channels in a row whose cells are separated by blanks, where names have blanks themselves and no quotation marks.

use super::cells;

/// The names of so many channels, of each group of them: what stands between two keys. None: the row does not tell them apart.
///
/// Two things do: a channel that the user names, and that a scope calls a second channel of one name `NAME (1)`.
pub(super) fn of_groups<'t>(line: &'t str, key: &str, counts: &[usize], wanted: &[&str]) -> Option<Vec<&'t str>> {
    let mut words = Vec::new();
    cells::split(line, ' ', &mut words);
    words.retain(|word| !word.is_empty());
    let mut phrases: Vec<Vec<&str>> = wanted.iter().map(|name| name.split(' ').collect()).collect();
    phrases.extend(repeated(&words));
    phrases.retain(|phrase| phrase.len() > 1);
    phrases.sort_by_key(|phrase| std::cmp::Reverse(phrase.len()));
    let groups: Vec<&[&str]> = words.split(|word| *word == key).skip(1).collect();
    if groups.len() != counts.len() {
        return None;
    }
    let mut names = Vec::new();
    for (group, count) in groups.into_iter().zip(counts) {
        let before = names.len();
        let mut rest = group;
        while !rest.is_empty() {
            let is_next = |phrase: &&Vec<&str>| rest.starts_with(phrase);
            let length = if group.len() == *count { 1 } else { phrases.iter().find(is_next).map_or(1, Vec::len) };
            names.push(joined(line, rest[0], rest[length - 1]));
            rest = &rest[length..];
        }
        if names.len() - before != *count {
            return None;
        }
    }
    Some(names)
}

/// The names that stand there a second time, with `(1)` behind: both forms of each.
fn repeated<'t>(words: &[&'t str]) -> Vec<Vec<&'t str>> {
    let is_number = |word: &str| {
        let digits = word.strip_prefix('(').and_then(|word| word.strip_suffix(')'));
        digits.is_some_and(|digits| !digits.is_empty() && digits.bytes().all(|byte| byte.is_ascii_digit()))
    };
    let mut phrases = Vec::new();
    for end in (1..words.len()).filter(|at| is_number(words[*at])) {
        let stands_elsewhere = |from: usize| {
            let name = &words[from..end];
            words.windows(name.len()).enumerate().any(|(at, other)| at != from && other == name)
        };
        if let Some(from) = (0..end).find(|from| stands_elsewhere(*from)) {
            phrases.extend([words[from..end].to_vec(), words[from..=end].to_vec()]);
        }
    }
    phrases
}

/// From the first of these words to the last one.
fn joined<'t>(line: &'t str, first: &str, last: &str) -> &'t str {
    let offset = |word: &str| word.as_ptr() as usize - line.as_ptr() as usize;
    &line[offset(first)..offset(last) + last.len()]
}
