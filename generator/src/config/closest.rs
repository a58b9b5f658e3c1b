//! The known name that an unknown one was probably meant to be. No message is made here.

use super::path;
use crate::parameters::{Name, Parameter, path_with};
use std::sync::LazyLock;

/// Longer names are not compared: the cost grows with the square.
const LONGEST: usize = 128;

/// The candidate with the fewest differing letters, if they are few.
pub(crate) fn nearest<'c>(name: &str, candidates: impl Iterator<Item = &'c str>) -> Option<&'c str> {
    let few = 1 + name.len() / 4;
    let name = Letters::new(name);
    let near = candidates.filter_map(|candidate| Some((distance(name, Letters::new(candidate), few)?, candidate)));
    // The first of equals: the order of the candidates does not depend on the host.
    near.min_by_key(|(distance, _)| *distance).map(|(_, name)| name)
}

/// The path that a path was probably meant to be: it differs in a few letters, or has the same end; for a table usually a
/// structure.
pub(crate) fn path(path: &str, is_table: bool) -> Option<String> {
    let [first, second] = if is_table { [&STRUCTURES, &TEMPLATES] } else { [&TEMPLATES, &STRUCTURES] };
    among(path, first).or_else(|| among(path, second))
}

/// The path of the parameter with an id: `P-AXIS-00758`.
pub(crate) fn of_id(written: &str) -> Option<String> {
    let is_it = |parameter: &&Parameter| parameter.id.is_some_and(|id| id.eq_ignore_ascii_case(written));
    Name::ALL.map(Name::parameter).into_iter().find(is_it).map(|parameter| path_with(parameter.path, [0, 0]))
}

/// A template with the indices that a path has at the same parts.
pub(crate) fn with_indices_of(template: &str, written: &str) -> String {
    let parts = template.split('.').zip(written.split('.'));
    let numbers = parts.filter(|(part, _)| part.contains('[')).map(|(_, written)| indices(written)[0]);
    let mut numbers = numbers.chain([0, 0]);
    path_with(template, std::array::from_fn(|_| numbers.next().unwrap_or(0)))
}

/// The first parameter below a structure, with the indices of the written structure.
pub(crate) fn first_below(written: &str) -> Option<String> {
    let start = path::without_indices(written) + ".";
    let below = path::templates().find(|template| path::without_indices(template).starts_with(&start));
    below.map(|template| path_with(template, indices(written)))
}

/// The structures that axgen reads: the part of a path that names each, and the number of letters that may differ.
static OURS: [(usize, Letters<'_>, usize); 3] = [
    (0, Letters::new("vorsteuer"), 2),
    (1, Letters::new("improved_position_control"), 3),
    (1, Letters::new("sai_op_mode_change"), 3),
];

/// Whether a path with these first parts lies in one of axgen's structures, or nearly.
pub(crate) fn is_ours(parts: [&str; 2]) -> bool {
    OURS.iter().any(|&(part, name, most)| {
        let written = parts[part];
        // Most paths of a real list are recognised by their lengths, or by their first letters.
        let strange = written.bytes().filter(|byte| name.counts[usize::from(byte & 31)] == 0);
        written.len().abs_diff(name.text.len()) <= most
            && strange.take(most + 1).count() <= most
            && distance(Letters::new(written), name, most).is_some()
    })
}

/// The path of axgen's that differs from a path of another function in a letter, or in two of a long name, and in nothing else.
/// `length`: that of the path without the numbers of its indices; `end`: the name of its last part.
pub(crate) fn nearly(written: &str, length: usize, end: &str) -> Option<String> {
    let most = match end.len() {
        0..SHORT => return None,
        SHORT..LONG => 1,
        LONG.. => 2,
    };
    let drawer = &BY_FIRST_LETTERS[first_letters(written, end)];
    let mut alike = drawer.iter().filter(|of| of.whole.text.len().abs_diff(length) <= most).peekable();
    alike.peek()?;
    // Each letter of difference changes the set by two letters at most.
    let letters = set_of_letters(end);
    let mut alike = alike.filter(|of| (of.letters ^ letters).count_ones() as usize <= 2 * most).peekable();
    alike.peek()?;
    let plain = path::without_indices(written);
    let near = alike.filter_map(|of| Some((distance(Letters::new(&plain), of.whole, most)?, of.template)));
    near.min_by_key(|(distance, _)| *distance).map(|(_, template)| with_indices_of(template, written))
}

/// Shorter names of other functions have one letter other than one of axgen's: `kp` and `kv`.
const SHORT: usize = 4;
/// Shorter ones have two: `a_max` and `vb_max`.
const LONG: usize = 8;

/// The paths by the first letters of the whole and of its last name, which are seldom mistyped: a list has many paths of other
/// functions, and comparing letters is slow.
static BY_FIRST_LETTERS: LazyLock<Vec<Vec<&Candidate>>> = LazyLock::new(|| {
    let mut all = vec![Vec::new(); 32 * 32];
    TEMPLATES.iter().for_each(|of| all[first_letters(of.whole.text, of.end.text)].push(of));
    all
});

fn first_letters(path: &str, end: &str) -> usize {
    let [path, end] = [path, end].map(|name| usize::from(name.as_bytes().first().unwrap_or(&0) & 31));
    path * 32 + end
}

/// A bit for each letter of a name, regardless of case.
fn set_of_letters(name: &str) -> u32 {
    name.bytes().fold(0, |set, letter| set | 1 << (letter & 31))
}

struct Candidate {
    template: &'static str,
    whole: Letters<'static>,
    end: Letters<'static>,
    /// those of the end
    letters: u32,
}

static TEMPLATES: LazyLock<Vec<Candidate>> = LazyLock::new(|| candidates(path::templates()));
static STRUCTURES: LazyLock<Vec<Candidate>> = LazyLock::new(|| candidates(path::structures()));

fn candidates(templates: impl Iterator<Item = &'static str>) -> Vec<Candidate> {
    let candidate = |template| {
        let whole = path::without_indices(template).leak();
        let end = last(whole);
        Candidate { template, whole: Letters::new(whole), end: Letters::new(end), letters: set_of_letters(end) }
    };
    templates.map(candidate).collect()
}

fn among(written: &str, candidates: &'static [Candidate]) -> Option<String> {
    let plain = path::without_indices(written);
    let typo = 3.min(1 + plain.len() / 4);
    let end = Letters::new(last(&plain));
    let whole = Letters::new(&plain);
    let score = |candidate: &'static Candidate| {
        let of_end = distance(end, candidate.end, 1 + end.text.len() / 4);
        let of_whole = distance(whole, candidate.whole, typo);
        // A beginning of a name comes last.
        let of_end = of_end.or_else(|| begins(candidate.whole, &plain).then_some(usize::MAX));
        let is_near = of_whole.is_some() || of_end.is_some();
        is_near.then_some(((of_whole.unwrap_or(usize::MAX), of_end), candidate.template))
    };
    // The first of equals, which is a path rather than one of its aliases.
    let best = candidates.iter().filter_map(score).min_by_key(|(score, _)| *score);
    best.map(|(_, template)| path_with(template, indices(written)))
}

/// Whether a path continues another one within the last name of that: `v_add_max_fact` and `v_add_max`.
fn begins(whole: Letters<'_>, start: &str) -> bool {
    let rest = whole.text.strip_prefix(start);
    last(start).len() > 2 && rest.is_some_and(|rest| !rest.is_empty() && !rest.contains(['.', '[']))
}

fn last(path: &str) -> &str {
    path.rsplit('.').next().unwrap_or(path)
}

/// The indices of a path that are numbers.
fn indices(path: &str) -> [u32; 2] {
    let mut numbers =
        path.split('[').skip(1).map(|rest| rest.split(']').next().and_then(|n| n.parse().ok()).unwrap_or(0));
    std::array::from_fn(|_| numbers.next().unwrap_or(0))
}

/// A name, and the count of each letter, regardless of case.
#[derive(Clone, Copy)]
struct Letters<'n> {
    text: &'n str,
    counts: [u8; 32],
}

impl<'n> Letters<'n> {
    const fn new(text: &'n str) -> Self {
        let (mut counts, mut at) = ([0_u8; 32], 0);
        while at < text.len() {
            let place = (text.as_bytes()[at] & 31) as usize; // digits and signs share the slots of letters
            counts[place] = counts[place].saturating_add(1);
            at += 1;
        }
        Self { text, counts }
    }
}

/// Number of letters to change, add or remove (Levenshtein), regardless of case; `None` if it is above `most`.
fn distance(a: Letters<'_>, b: Letters<'_>, most: usize) -> Option<usize> {
    let lengths = [a.text.len(), b.text.len()];
    let is_far = lengths[0].abs_diff(lengths[1]) > most || lengths.iter().any(|length| *length > LONGEST);
    if is_far || at_least(&a.counts, &b.counts) as usize > most {
        return None;
    }
    // A common beginning and a common end need no comparison.
    let (a, b) = (a.text.as_bytes(), b.text.as_bytes());
    let is_alike = |(x, y): &(&u8, &u8)| x.eq_ignore_ascii_case(y);
    let start = a.iter().zip(b).take_while(is_alike).count();
    let (a, b) = (&a[start..], &b[start..]);
    let end = a.iter().rev().zip(b.iter().rev()).take_while(is_alike).count();
    let (a, b) = (&a[..a.len() - end], &b[..b.len() - end]);
    let distance = strsim::generic_levenshtein(&a.to_ascii_lowercase(), &b.to_ascii_lowercase());
    Some(distance).filter(|distance| *distance <= most)
}

/// A lower bound of the number of differing letters: each letter that only one name has, or has more often, takes one
/// change.
fn at_least(a: &[u8; 32], b: &[u8; 32]) -> u32 {
    let more = |a: &[u8; 32], b: &[u8; 32]| a.iter().zip(b).map(|(a, b)| u32::from(a.saturating_sub(*b))).sum::<u32>();
    more(a, b).max(more(b, a))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::unit::sets::Random;

    /// Compares random names with the definition: no filter may reject a near name.
    #[test]
    fn distances() {
        let mut random = Random(1);
        for _ in 0..20_000 {
            let [a, b] = [(); 2].map(|()| {
                let length = random.below(9);
                (0..length).map(|_| char::from(b"abAB_1q"[random.below(7)])).collect::<String>()
            });
            let small = [&a, &b].map(|name| name.to_ascii_lowercase().into_bytes());
            let expected = strsim::generic_levenshtein(&small[0], &small[1]);
            for most in 0..9 {
                let found = distance(Letters::new(&a), Letters::new(&b), most);
                assert_eq!(found, Some(expected).filter(|d| *d <= most), "{a} {b} {most}");
            }
        }
    }
}
