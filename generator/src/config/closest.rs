//! The known name that an unknown one was probably meant to be. No message is made here.

use super::path;
use crate::parameters::{Name, Parameter, path_with};
use std::sync::LazyLock;

/// Longer names are not compared: the cost grows with the square.
const LONGEST: usize = 128;

/// The candidate with the fewest differing letters, if they are few: the first of equals.
pub(crate) fn nearest<'c>(name: &str, candidates: impl Iterator<Item = &'c str>) -> Option<&'c str> {
    all_nearest(name, candidates).into_iter().next()
}

/// The candidates with the fewest differing letters, if they are few, in their order.
pub fn all_nearest<'c>(name: &str, candidates: impl Iterator<Item = &'c str>) -> Vec<&'c str> {
    let few = 1 + name.len() / 4;
    let name = Letters::new(name);
    let near = candidates.filter_map(|candidate| Some((distance(name, Letters::new(candidate), few)?, candidate)));
    of_least_distance(near.collect())
}

/// Those that differ least. Their order does not depend on the host.
fn of_least_distance(near: Vec<(usize, &str)>) -> Vec<&str> {
    let least = near.iter().map(|(distance, _)| *distance).min();
    near.into_iter().filter(|(distance, _)| Some(*distance) == least).map(|(_, name)| name).collect()
}

/// The path that a path was probably meant to be: it differs in a few letters, or has the same end; for a table usually a
/// structure.
pub(crate) fn path(written: &str, is_table: bool) -> Option<String> {
    let path = &indexed(written);
    let [first, second] = if is_table { [&STRUCTURES, &TEMPLATES] } else { [&TEMPLATES, &STRUCTURES] };
    among(path, first).or_else(|| among(path, second))
}

/// A path with each index in brackets: `stage1.x`, `stage_1.x` and `stage.1.x` are `stage[1].x`.
fn indexed(written: &str) -> String {
    let mut path = String::new();
    for part in written.split('.') {
        let name = part.trim_end_matches(|of: char| of.is_ascii_digit());
        let digits = &part[name.len()..];
        let name = name.trim_end_matches('_');
        if !digits.is_empty() && name.is_empty() && path.ends_with(|of: char| of.is_ascii_alphabetic() || of == '_') {
            path.extend(["[", digits, "]"]);
            continue;
        }
        path.extend((!path.is_empty()).then_some("."));
        if !digits.is_empty() && path::is_array(name) {
            path.extend([name, "[", digits, "]"]);
        } else {
            path += part;
        }
    }
    path
}

/// The path of the parameter with an id: `P-AXIS-00758`.
pub(crate) fn of_id(written: &str) -> Option<String> {
    let is_it = |parameter: &&Parameter| parameter.id.is_some_and(|id| id.eq_ignore_ascii_case(written));
    Name::ALL.map(Name::parameter).into_iter().find(is_it).map(|parameter| path_with(parameter.path, [0, 0]))
}

/// A template with the indices that a path has at the same parts, counted from its end: the parts before may be missing.
pub(crate) fn with_indices_of(template: &str, written: &str) -> String {
    let written = indexed(written);
    let parts = template.rsplit('.').zip(written.rsplit('.'));
    let mut index = [0; 2];
    let places = (0..template.matches('[').count()).rev();
    for (place, (_, of)) in places.zip(parts.filter(|(part, _)| part.contains('['))) {
        index[place] = indices(of)[0];
    }
    path_with(template, index)
}

/// A path in the form of a set, at the place of a wrong path: what is below the tables that both have.
pub(crate) fn in_a_set(known: &str, written: &str) -> String {
    let above: Vec<&str> = written.rsplit_once('.').map_or(vec![], |(above, _)| above.split('.').collect());
    let parts: Vec<&str> = known.split('.').collect();
    let is_here = parts.len() > above.len() && parts.starts_with(&above);
    match is_here {
        true => keys(&parts[above.len()..]),
        false => format!("{}, below the axis itself", keys(&parts)),
    }
}

/// No array of a set has more.
const ELEMENTS: u32 = 16;

/// `filter = [{ fg_f0 = ... }]` for `filter[0].fg_f0`; a key alone is written without a value.
fn keys(parts: &[&str]) -> String {
    let name = |part: &str| part.split('[').next().unwrap_or_default().to_owned();
    let [part, below @ ..] = parts else { return String::new() };
    match (indices(part)[0], part.contains('['), below) {
        (_, _, []) => name(part),
        (_, false, _) => format!("{}.{}", part, keys(below)),
        (index, true, _) => {
            let value = if below.iter().any(|part| part.contains('[')) { "" } else { " = ..." };
            // The index is as written, and can be any number.
            let before = if index < ELEMENTS { "{}, ".repeat(index as usize) } else { "..., ".to_owned() };
            format!("{} = [{before}{{ {}{value} }}]", name(part), keys(below))
        }
    }
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

/// The paths of axgen's that differ from a path of another function in a letter, or in two of a long name, and in nothing else:
/// those that differ least. `length`: that of the path without the numbers of its indices; `end`: the name of its last part.
pub(crate) fn nearly(written: &str, length: usize, end: &str) -> Vec<String> {
    let most = if end.len() < LONG { 1 } else { MOST };
    let [first, last] = &*DRAWERS;
    let drawers = [&first[first_letters(written, end)], &last[last_letters(written)]];
    // The usual case, tested first.
    let bit = u32::try_from(length).ok().and_then(|length| 1_u128.checked_shl(length)).unwrap_or(0);
    if drawers.iter().all(|drawer| drawer.lengths & bit == 0) {
        return Vec::new();
    }
    let paths = drawers.into_iter().flat_map(|drawer| &drawer.paths);
    let alike = paths.filter(|of| of.whole.text.len().abs_diff(length) <= most);
    // Each letter of difference changes the set by two letters at most.
    let letters = set_of_letters(written);
    let mut alike = alike.filter(|of| (of.letters ^ letters).count_ones() as usize <= 2 * most).peekable();
    if alike.peek().is_none() {
        return Vec::new();
    }
    let plain = path::without_indices(written);
    let is_comparable = |of: &&&Candidate| end.len() >= SHORT || end == of.end.text || is_doubled(end, of.end.text);
    let near = alike.filter(is_comparable);
    let near = near.filter_map(|of| Some((distance(Letters::new(&plain), of.whole, most)?, of.template)));
    of_least_distance(near.collect()).into_iter().map(|template| with_indices_of(template, written)).collect()
}

/// The path of axgen's that a path without its first part is, or that has the same stage below `lr_param`:
/// `achs[0].lr_param.improved_position_control.enable`, `lr_param.ipc.stage[0].mode`, `lr_param.stage[0].mode`.
pub(crate) fn below_another(written: &str, [first, second]: [&str; 2]) -> Option<String> {
    let below = &written[first.len() + 1..];
    let meant = if matches!(second, "lr_param" | "vorsteuer") {
        below.to_owned()
    } else if first == "lr_param" {
        let stage = if second.starts_with("stage[") { Some(below) } else { below[second.len()..].strip_prefix('.') };
        format!("lr_param.improved_position_control.{}", stage.filter(|stage| stage.starts_with("stage["))?)
    } else {
        return None;
    };
    matches!(path::find(&meant), path::Path::Known { .. }).then_some(meant)
}

/// Shorter names of other functions have one letter other than one of axgen's, `kp` and `kv`, but not one of its letters twice.
const SHORT: usize = 4;
/// Shorter ones have two: `a_max` and `vb_max`.
const LONG: usize = 8;

/// Whether a name is another one with one of its letters doubled.
fn is_doubled(name: &str, other: &str) -> bool {
    let bytes = name.as_bytes();
    (1..bytes.len()).any(|at| bytes[at] == bytes[at - 1] && [&name[..at], &name[at + 1..]].concat() == other)
}

/// Letters that may differ.
const MOST: usize = 2;

/// Some of axgen's paths, and a bit for each length that is near that of one of them.
#[derive(Clone, Default)]
struct Drawer {
    paths: Vec<&'static Candidate>,
    lengths: u128,
}

/// The paths by the first letters of the whole and of its last name, and by the last two letters: one wrong letter is not in
/// both. A list has many paths of other functions, and comparing letters is slow.
static DRAWERS: LazyLock<[Vec<Drawer>; 2]> = LazyLock::new(|| {
    let by = |drawer: fn(&Candidate) -> usize| {
        let mut all = vec![Drawer::default(); 32 * 32];
        for of in TEMPLATES.iter() {
            let (drawer, length) = (&mut all[drawer(of)], of.whole.text.len());
            drawer.paths.push(of);
            (length - MOST..=length + MOST).for_each(|length| drawer.lengths |= 1 << length);
        }
        all
    };
    [by(|of| first_letters(of.whole.text, of.end.text)), by(|of| last_letters(of.whole.text))]
});

fn first_letters(path: &str, end: &str) -> usize {
    drawer([path, end].map(|name| name.as_bytes().first()))
}

fn last_letters(path: &str) -> usize {
    let mut letters = path.as_bytes().iter().rev();
    drawer([letters.next(), letters.next()])
}

/// The number of two letters, regardless of case.
fn drawer(letters: [Option<&u8>; 2]) -> usize {
    let [first, second] = letters.map(|letter| usize::from(letter.unwrap_or(&0) & 31));
    first * 32 + second
}

/// A bit for each letter of a path, regardless of case; without digits, which are mostly indices.
fn set_of_letters(path: &str) -> u32 {
    path.bytes().fold(0, |set, letter| if letter.is_ascii_digit() { set } else { set | 1 << (letter & 31) })
}

struct Candidate {
    template: &'static str,
    whole: Letters<'static>,
    end: Letters<'static>,
    /// those of the whole
    letters: u32,
}

static TEMPLATES: LazyLock<Vec<Candidate>> = LazyLock::new(|| candidates(path::templates()));
static STRUCTURES: LazyLock<Vec<Candidate>> = LazyLock::new(|| candidates(path::structures()));

fn candidates(templates: impl Iterator<Item = &'static str>) -> Vec<Candidate> {
    let candidate = |template| {
        // An array of tables is written without brackets.
        let whole = path::without_indices(template).leak().trim_end_matches("[]");
        let end = last(whole);
        Candidate { template, whole: Letters::new(whole), end: Letters::new(end), letters: set_of_letters(whole) }
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

/// Number of letters to change, add, remove or exchange with their neighbours (optimal string alignment), regardless of case;
/// `None` if it is above `most`.
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
    let [a, b] = [a, b].map(|name| String::from_utf8_lossy(&name.to_ascii_lowercase()).into_owned());
    let distance = strsim::osa_distance(&a, &b);
    Some(distance).filter(|distance| *distance <= most)
}

/// A lower bound of the number of differing letters: each letter that only one name has, or has more often, takes one
/// change.
fn at_least(a: &[u8; 32], b: &[u8; 32]) -> u32 {
    let more = |a: &[u8; 32], b: &[u8; 32]| a.iter().zip(b).map(|(a, b)| u32::from(a.saturating_sub(*b))).sum::<u32>();
    more(a, b).max(more(b, a))
}
