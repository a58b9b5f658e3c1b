//! Which known name an unknown one was probably meant to be; no message is made here.

use super::path;
use crate::parameters::path_with;

/// Longer names are not compared: the cost grows with the square.
const LONGEST: usize = 128;

/// The candidate with the fewest letters that differ, if they are few.
pub fn of<'c>(name: &str, candidates: impl Iterator<Item = &'c str>) -> Option<&'c str> {
    let few = 1 + name.len() / 4;
    let near = candidates.filter_map(|candidate| distance(name, candidate, few).map(|distance| (distance, candidate)));
    // The first of equals: the order of the candidates is the same on every host.
    near.min_by_key(|(distance, _)| *distance).map(|(_, name)| name)
}

/// The path that a path was probably meant to be: one that differs in a few letters, or ends alike.
#[must_use]
pub fn path(path: &str) -> Option<String> {
    among(path, path::templates()).or_else(|| among(path, path::structures()))
}

/// A template with the indices that a path has at the same parts.
#[must_use]
pub fn with_indices_of(template: &str, written: &str) -> String {
    let parts = template.split('.').zip(written.split('.'));
    let numbers = parts.filter(|(part, _)| part.contains('[')).map(|(_, written)| indices(written)[0]);
    let mut numbers = numbers.chain([0, 0]);
    path_with(template, std::array::from_fn(|_| numbers.next().unwrap_or(0)))
}

/// The structure that the name of a table was probably meant to be.
#[must_use]
pub fn structure(path: &str) -> Option<String> {
    among(path, path::structures())
}

/// The first parameter below a structure, with the indices that the structure is written with.
#[must_use]
pub fn first_below(written: &str) -> Option<String> {
    let start = path::without_indices(written) + ".";
    let below = path::templates().find(|template| path::without_indices(template).starts_with(&start));
    below.map(|template| path_with(template, indices(written)))
}

/// The structures that are ours: which part of a path names each, and how many letters may differ.
const OURS: [(usize, &str, usize); 3] =
    [(0, "vorsteuer", 2), (1, "improved_position_control", 3), (1, "sai_op_mode_change", 3)];

/// Whether a path lies in a structure that is ours, or nearly.
#[must_use]
pub fn is_ours(path: &str) -> bool {
    let is = |(part, name, most): (usize, &str, usize)| {
        let written = path.split('.').nth(part).unwrap_or("");
        path.contains('.') && distance(written, name, most).is_some()
    };
    OURS.into_iter().any(is)
}

fn among(written: &str, candidates: impl Iterator<Item = &'static str>) -> Option<String> {
    let plain = path::without_indices(written);
    let typo = 3.min(1 + plain.len() / 4);
    let end = last(&plain);
    let score = |template: &'static str| {
        let of_end = distance(end, last(template), 1 + end.len() / 4);
        let whole = distance(&plain, &path::without_indices(template), typo);
        (whole.is_some() || of_end.is_some()).then_some(((whole.unwrap_or(usize::MAX), of_end), template))
    };
    // The first of equals, which is a path rather than its aliases.
    let best = candidates.filter_map(score).min_by_key(|(score, _)| *score);
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
    if a.len() > LONGEST || b.len() > LONGEST || a.len().abs_diff(b.len()) > most {
        return None;
    }
    let mut row: Vec<usize> = (0..=b.len()).collect();
    for (i, x) in a.bytes().enumerate() {
        if row.iter().all(|distance| *distance > most) {
            return None;
        }
        let mut diagonal = row[0];
        row[0] = i + 1;
        for (j, y) in b.bytes().enumerate() {
            let changed = diagonal + usize::from(!x.eq_ignore_ascii_case(&y));
            diagonal = row[j + 1];
            row[j + 1] = changed.min(diagonal + 1).min(row[j] + 1);
        }
    }
    row.last().copied().filter(|distance| *distance <= most)
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
