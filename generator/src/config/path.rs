//! From a written path (`stage[0].filter.order`) to the parameter and its indices. No value or message is here.

use super::shape::Shape;
use crate::parameters::{Name, Parameter, Scope, TABLE};
use std::{collections::BTreeSet, sync::LazyLock};

/// A parameter; a parameter of the table with an index that does not exist; well-formed, but not in the table; not a path.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Path<'p> {
    Known {
        name: Name,
        index: [u32; 2],
        spelling: &'static str,
        misprint: bool,
    },
    OutOfRange {
        name: Name,
        spelling: &'static str,
    },
    /// its first two parts, if it has a point, its length without the numbers of its indices, and the name of its last part
    Foreign {
        structure: Option<[&'p str; 2]>,
        length: usize,
        last: &'p str,
    },
    Malformed,
}

struct Spelling {
    name: Name,
    template: &'static str,
    misprint: bool,
    /// the pieces between the numbers of its indices
    pieces: Vec<String>,
}

impl Spelling {
    /// Whether a well-formed path, which is as long without the numbers of its indices, is this one.
    fn is(&self, path: &str) -> bool {
        let mut rest = path;
        for piece in &self.pieces {
            let Some(after) = rest.strip_prefix(piece.as_str()) else { return false };
            rest = after.trim_start_matches(|letter: char| letter.is_ascii_digit());
        }
        true
    }
}

/// Every spelling of every parameter, by its path with `[]` for an index.
static SPELLINGS: LazyLock<Vec<Vec<Spelling>>> = LazyLock::new(|| {
    let spellings = Name::ALL.into_iter().flat_map(|name| {
        let parameter = name.parameter();
        let proper = std::iter::once(&parameter.path).chain(parameter.aliases).map(|template| (template, false));
        let misprints = parameter.misprints.iter().map(|template| (template, true));
        proper.chain(misprints).map(move |(template, misprint)| {
            let plain = without_indices(template);
            let pieces = plain.split_inclusive('[').map(str::to_owned).collect();
            (drawer(plain.len(), &plain), Spelling { name, template, misprint, pieces })
        })
    });
    in_drawers(spellings)
});

/// Names that manuals print instead of others.
const TAKEN_FOR: [(&str, &str); 4] = [
    ("antr.v_time_bae", "antr.v_time_base"),
    ("getriebe.mulit_gain_n", "getriebe[i].multi_gain_n"),
    ("getriebe.mulit_gain_z", "getriebe[i].multi_gain_z"),
    ("vorsteuer.feedforward", "vorsteuer.vorsteuerung"),
];

/// The vendor's paths and aliases, and the names in `TAKEN_FOR`, by their last parts; each without its indices:
/// `getriebe.kv`. The first of equals is a path.
static BARE: LazyLock<Vec<Vec<(String, &'static str)>>> = LazyLock::new(|| {
    let vendors = Name::ALL.map(Name::parameter).into_iter().filter(|parameter| parameter.scope == Scope::List);
    let templates = vendors.flat_map(|parameter| std::iter::once(&parameter.path).chain(parameter.aliases));
    let names = templates.map(|template| (*template, *template)).chain(TAKEN_FOR);
    in_drawers(names.map(|(name, template)| {
        let end = last_name(name);
        (drawer(end.len(), end), (letters(name, false).map(look).collect(), template))
    }))
});

/// The slot of a name: length, first and last letter, in any case, distinguish most names.
fn drawer(length: usize, name: &str) -> usize {
    let of = |letter: Option<&u8>| look(char::from(*letter.unwrap_or(&0))) as usize;
    length * 32 + ((of(name.as_bytes().first()) + of(name.as_bytes().last())) & 31)
}

/// One letter for those that look alike: small and capital, `I`, `1` and `l`, `0` and `O`.
fn look(letter: char) -> char {
    match letter.to_ascii_lowercase() {
        'i' | '1' => 'l',
        '0' => 'o',
        small => small,
    }
}

fn in_drawers<T>(all: impl Iterator<Item = (usize, T)>) -> Vec<Vec<T>> {
    let mut drawers = Vec::new();
    for (drawer, one) in all {
        drawers.resize_with(drawers.len().max(drawer + 1), Vec::new);
        drawers[drawer].push(one);
    }
    drawers
}

/// Every prefix of a path below an axis that ends before a point: the structures of a set's tables, with `[]` for an index.
static STRUCTURES: LazyLock<BTreeSet<String>> = LazyLock::new(|| {
    let prefixes = |path: String| path.match_indices('.').map(|(at, _)| path[..at].to_owned()).collect::<Vec<_>>();
    templates().map(without_indices).flat_map(prefixes).collect()
});

/// The template of a path with other indices, with letters that look alike, or without the structures before it:
/// `getriebe[i].kv` for `getriebe.kv` and for `kv`.
pub(super) fn with_other_indices(path: &str) -> Option<&'static str> {
    ending_with(last_name(path), path)
}

/// The same for a path whose last name is known.
pub(super) fn ending_with(end: &str, path: &str) -> Option<&'static str> {
    let drawer = BARE.get(drawer(end.len(), end)).filter(|drawer| !drawer.is_empty())?;
    let length = letters(path, false).count();
    // The command filters of an axis have similar names: `filter[0].fg_f0` (P-AXIS-00067).
    let is_others = path.starts_with("filter");
    let is_end = |bare: &str| {
        let start = bare.len().checked_sub(length);
        let is_part = |start: usize| start == 0 || !is_others && bare.as_bytes()[start - 1] == b'.';
        start.is_some_and(|start| is_part(start) && letters(path, false).map(look).eq(bare[start..].chars()))
    };
    drawer.iter().find(|(bare, _)| is_end(bare)).map(|(_, template)| *template)
}

/// The last part of a path without its index.
fn last_name(path: &str) -> &str {
    let last = memchr::memrchr(b'.', path.as_bytes()).map_or(path, |dot| &path[dot + 1..]);
    memchr::memchr(b'[', last.as_bytes()).map_or(last, |bracket| &last[..bracket])
}

/// The letters of a path without its indices, with or without their brackets.
fn letters(path: &str, brackets: bool) -> impl Iterator<Item = char> {
    let mut is_inside = false;
    path.chars().filter(move |letter| {
        is_inside &= *letter != ']';
        let is_kept = !is_inside && (brackets || !matches!(letter, '[' | ']'));
        is_inside |= *letter == '[';
        is_kept
    })
}

pub(crate) fn find(path: &str) -> Path<'_> {
    let Some(Shape { index, length, ends: [first, second], last }) = Shape::of(path.as_bytes()) else {
        return Path::Malformed;
    };
    let mut alike = SPELLINGS.get(drawer(length, path)).into_iter().flatten();
    let Some(&Spelling { name, template, misprint, .. }) = alike.find(|spelling| spelling.is(path)) else {
        return Path::Foreign {
            structure: path.get(first + 1..second).map(|second| [&path[..first], second]),
            length,
            last: &path[last],
        };
    };
    let within = name.parameter().indices.iter().zip(index).all(|(size, index)| index < *size);
    if within {
        Path::Known { name, index, spelling: template, misprint }
    } else {
        Path::OutOfRange { name, spelling: template }
    }
}

/// Whether this path has parameters below it in a set: `lr_param`, `lr_param.improved_position_control.stage[0]`.
pub(crate) fn is_structure(path: &str) -> bool {
    STRUCTURES.contains(&without_indices(path))
}

pub(crate) fn structures() -> impl Iterator<Item = &'static str> {
    STRUCTURES.iter().map(String::as_str)
}

/// All path templates below an axis.
pub(crate) fn templates() -> impl Iterator<Item = &'static str> {
    TABLE.iter().filter(|parameter| parameter.scope != Scope::Set).flat_map(Parameter::paths)
}

/// Whether a name is that of an array: `stage`.
pub(super) fn is_array(name: &str) -> bool {
    let of_array = |part: &str| part.strip_prefix(name).is_some_and(|index| index.starts_with('['));
    !name.is_empty() && templates().any(|template| template.split('.').any(of_array))
}

/// `stage[0].mode` and `stage[i].mode` as `stage[].mode`.
pub(crate) fn without_indices(path: &str) -> String {
    letters(path, true).collect()
}
