//! Which known name an unknown one was probably meant to be; no message is made here.

use super::path;
use crate::parameters::path_with;
use std::sync::LazyLock;

/// Longer names are not compared: the cost grows with the square.
const LONGEST: usize = 128;

/// The candidate with the fewest letters that differ, if they are few.
pub(crate) fn of<'c>(name: &str, candidates: impl Iterator<Item = &'c str>) -> Option<&'c str> {
    let few = 1 + name.len() / 4;
    let near = candidates.filter_map(|candidate| distance(name, candidate, few).map(|distance| (distance, candidate)));
    // The first of equals: the order of the candidates is the same on every host.
    near.min_by_key(|(distance, _)| *distance).map(|(_, name)| name)
}

/// The path that a path was probably meant to be: one that differs in a few letters, or ends alike.
pub(crate) fn path(path: &str) -> Option<String> {
    among(path, &TEMPLATES).or_else(|| among(path, &STRUCTURES))
}

/// A template with the indices that a path has at the same parts.
pub(crate) fn with_indices_of(template: &str, written: &str) -> String {
    let parts = template.split('.').zip(written.split('.'));
    let numbers = parts.filter(|(part, _)| part.contains('[')).map(|(_, written)| indices(written)[0]);
    let mut numbers = numbers.chain([0, 0]);
    path_with(template, std::array::from_fn(|_| numbers.next().unwrap_or(0)))
}

/// The structure that the name of a table was probably meant to be.
pub(crate) fn structure(path: &str) -> Option<String> {
    among(path, &STRUCTURES)
}

/// The first parameter below a structure, with the indices that the structure is written with.
pub(crate) fn first_below(written: &str) -> Option<String> {
    let start = path::without_indices(written) + ".";
    let below = path::templates().find(|template| path::without_indices(template).starts_with(&start));
    below.map(|template| path_with(template, indices(written)))
}

/// The structures that are ours: which part of a path names each, the letters in it, and how many of them may differ.
const OURS: [(usize, &str, u32, usize); 3] =
    [of_ours(0, "vorsteuer", 2), of_ours(1, "improved_position_control", 3), of_ours(1, "sai_op_mode_change", 3)];

const fn of_ours(part: usize, name: &str, most: usize) -> (usize, &str, u32, usize) {
    (part, name, letters(name.as_bytes()), most)
}

/// Whether a path lies in a structure that is ours, or nearly.
pub(crate) fn is_ours(path: &str) -> bool {
    let Some(dot) = memchr::memchr(b'.', path.as_bytes()) else { return false };
    let (first, rest) = (&path[..dot], &path[dot + 1..]);
    let parts = [first, memchr::memchr(b'.', rest.as_bytes()).map_or(rest, |dot| &rest[..dot])];
    // Most paths of a real list are told by their lengths and letters.
    OURS.into_iter().any(|(part, name, letters_of_name, most)| {
        let written = parts[part];
        written.len().abs_diff(name.len()) <= most
            && at_least(letters(written.as_bytes()), letters_of_name) <= most
            && distance(written, name, most).is_some()
    })
}

/// A name that may have been meant.
struct Candidate {
    template: &'static str,
    /// the template with `[]` for an index
    plain: String,
}

static TEMPLATES: LazyLock<Vec<Candidate>> = LazyLock::new(|| candidates(path::templates()));
static STRUCTURES: LazyLock<Vec<Candidate>> = LazyLock::new(|| candidates(path::structures()));

fn candidates(templates: impl Iterator<Item = &'static str>) -> Vec<Candidate> {
    templates.map(|template| Candidate { template, plain: path::without_indices(template) }).collect()
}

fn among(written: &str, candidates: &'static [Candidate]) -> Option<String> {
    let plain = path::without_indices(written);
    let typo = 3.min(1 + plain.len() / 4);
    let end = last(&plain);
    let score = |candidate: &'static Candidate| {
        let of_end = distance(end, last(candidate.template), 1 + end.len() / 4);
        let whole = distance(&plain, &candidate.plain, typo);
        (whole.is_some() || of_end.is_some()).then_some(((whole.unwrap_or(usize::MAX), of_end), candidate.template))
    };
    // The first of equals, which is a path rather than its aliases.
    let best = candidates.iter().filter_map(score).min_by_key(|(score, _)| *score);
    best.map(|(_, template)| path_with(template, indices(written)))
}

fn last(path: &str) -> &str {
    path.rsplit('.').next().unwrap_or(path)
}

/// The indices of a path, as far as they are numbers.
fn indices(path: &str) -> [u32; 2] {
    let mut numbers =
        path.split('[').skip(1).map(|rest| rest.split(']').next().and_then(|n| n.parse().ok()).unwrap_or(0));
    std::array::from_fn(|_| numbers.next().unwrap_or(0))
}

/// How many letters must be changed, added or left out (Levenshtein), whatever their case; none: more than `most`.
fn distance(a: &str, b: &str, most: usize) -> Option<usize> {
    let (mut a, mut b) = (a.as_bytes(), b.as_bytes());
    if a.len() > LONGEST || b.len() > LONGEST || a.len().abs_diff(b.len()) > most {
        return None;
    }
    // What both begin and end with needs no comparing.
    let is_alike = |(x, y): &(&u8, &u8)| x.eq_ignore_ascii_case(y);
    let start = a.iter().zip(b).take_while(is_alike).count();
    (a, b) = (&a[start..], &b[start..]);
    let end = a.iter().rev().zip(b.iter().rev()).take_while(is_alike).count();
    (a, b) = (&a[..a.len() - end], &b[..b.len() - end]);
    if at_least(letters(a), letters(b)) > most {
        return None;
    }
    let distance = strsim::generic_levenshtein(&a.to_ascii_lowercase(), &b.to_ascii_lowercase());
    Some(distance).filter(|distance| *distance <= most)
}

/// The letters of a name, a bit each, whatever their case. Digits and signs share the bits of letters.
const fn letters(name: &[u8]) -> u32 {
    let (mut letters, mut at) = (0, 0);
    while at < name.len() {
        letters |= 1 << (name[at] & 31);
        at += 1;
    }
    letters
}

/// So many letters differ at least: each that only one of two names has takes a change of its own.
fn at_least(a: u32, b: u32) -> usize {
    (a & !b).count_ones().max((b & !a).count_ones()) as usize
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn words() {
        assert_eq!(of("INDIRCT", ["DIRECT", "INDIRECT"].into_iter()), Some("INDIRECT"));
        assert_eq!(of("PERHAPS", ["DIRECT", "INDIRECT"].into_iter()), None);
    }

    #[test]
    fn paths() {
        let ipc = "lr_param.improved_position_control";
        let close = |written: &str, meant: &str| assert_eq!(path(written), Some(format!("{ipc}.{meant}")), "{written}");
        close(&format!("{ipc}.enabel"), "enable");
        close("lr_param.improved_postion_control.enable", "enable");
        close(&format!("{ipc}.stage[2].wieght_fact_num"), "stage[2].weight_fact_num");
        close(&format!("{ipc}.stage[1].fg_f0"), "stage[1].filter[0].fg_f0");
        close(&format!("{ipc}.stage[1].filter[1].qfactor"), "stage[1].filter[1].q_factor");
        assert_eq!(path(&format!("{ipc}.stage[0].colour")), None);
        assert_eq!(path(&"x".repeat(10_000)), None);
        assert!(TEMPLATES.iter().all(|candidate| candidate.plain.len() < LONGEST));
    }

    /// Beside the definition: no filter refuses what is near.
    #[test]
    fn distances() {
        let of = |a: &[u8], b: &[u8]| strsim::generic_levenshtein(&a.to_vec(), &b.to_vec());
        let mut random = 1u64;
        let mut draw = |below: u64| {
            random = random.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            (random >> 33) % below
        };
        for _ in 0..20_000 {
            let mut name = || (0..draw(9)).map(|_| b"abAB_1q"[usize::try_from(draw(7)).unwrap()]).collect::<Vec<_>>();
            let (a, b) = (String::from_utf8(name()).unwrap(), String::from_utf8(name()).unwrap());
            let expected = of(a.to_ascii_lowercase().as_bytes(), b.to_ascii_lowercase().as_bytes());
            for most in 0..9 {
                assert_eq!(distance(&a, &b, most), Some(expected).filter(|d| *d <= most), "{a} {b} {most}");
            }
        }
    }

    #[test]
    fn indices_of_the_same_parts() {
        let other = |template: &str, written: &str| with_indices_of(template, written);
        assert_eq!(other("getriebe[i].kv", "getriebe.kv"), "getriebe[0].kv");
        assert_eq!(
            other("a.stage[i].filter[k].order", "a[7].stage[2].filter[1].order[9]"),
            "a.stage[2].filter[1].order"
        );
    }

    #[test]
    fn ours() {
        assert!(is_ours("lr_param.improved_postion_control.enable"));
        assert!(is_ours("LR_PARAM.IMPROVED_POSITION_CONTROL.ENABLE"));
        assert!(!is_ours("lr_param.suppress_pos_lag_error"));
        assert!(!is_ours("lr_param"));
    }
}
