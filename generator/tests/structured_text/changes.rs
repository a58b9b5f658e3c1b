//! What changes in the files when something changes in the set: only what it means.

use super::{MACHINE, files, of_ipc};
use crate::set_of;
use generator::generate::pages;
use generator::target::TARGETS;
use std::collections::BTreeMap;

/// The set with one text replaced, which it must hold once.
fn with(from: &str, to: &str) -> String {
    assert_eq!(MACHINE.matches(from).count(), 1, "{from}");
    MACHINE.replace(from, to)
}

/// The names of the files that differ.
fn differing(a: &BTreeMap<String, String>, b: &BTreeMap<String, String>) -> Vec<String> {
    let names: std::collections::BTreeSet<&String> = a.keys().chain(b.keys()).collect();
    names.into_iter().filter(|name| a.get(*name) != b.get(*name)).cloned().collect()
}

#[test]
fn the_same_set_gives_the_same_bytes() {
    assert_eq!(differing(&files(MACHINE), &files(MACHINE)), [""; 0]);
}

#[test]
fn a_comment_changes_nothing() {
    let edited = with("# A small machine", "# Another word about the machine");
    assert_eq!(differing(&files(MACHINE), &files(&edited)), [""; 0]);
    let edited = with(": for the first look", "");
    assert_eq!(differing(&files(MACHINE), &files(&edited)), [""; 0]);
}

#[test]
fn an_axis_can_move_within_the_set() {
    let (head, axes) = MACHINE.split_once("[axis.X]").unwrap();
    let (x, rest) = axes.split_once("# Y has no list").unwrap();
    let moved = format!("{head}# Y has no list{rest}\n[axis.X]{x}");
    assert_eq!(differing(&files(MACHINE), &files(&moved)), [""; 0]);
}

#[test]
fn another_axis_changes_only_what_lists_all_axes() {
    let more = MACHINE.to_owned() + "\n[axis.Z]\nlist = \"rack-and-pinion.lis\"\nkopf.achs_nr = 9\n";
    let (before, after) = (files(MACHINE), files(&more));
    let changed: Vec<String> =
        differing(&before, &after).into_iter().filter(|name| before.contains_key(name)).collect();
    let shared =
        ["rust/Cargo.toml", "rust/lib.rs", "twincat/Tests/PRG_axgen_tests.TcPOU", "twincat/axgen.plcproj-fragment"];
    assert_eq!(changed, shared);
}

/// One weight: the lines that say it, what is certified of its effect, the two digests, and what a self-test expects, in the files of
/// the block that has it.
#[test]
fn a_weight_changes_its_own_lines_only() {
    let heavier = with("weight_fact_num = 80", "weight_fact_num = 82");
    let (before, after) = (files(MACHINE), files(&heavier));
    let changed = differing(&before, &after);
    assert_eq!(changed, of_ipc("y"));
    // The limit of the sum follows from the weight.
    let sum_limit = after["axis_y_ipc.c"].split_once(" sum_limit = ").and_then(|(_, text)| text.split(';').next());
    let sum_limit = sum_limit.expect("a constant of the block");
    for name in changed {
        let lines = changed_lines(&before[&name], &after[&name]);
        let digests = lines.iter().filter(|line| is_digest(line)).count();
        assert_eq!(digests, 2, "{name}: parameters and body");
        for line in lines {
            let says_the_weight =
                ["weight", "-0.82", "the stage adds", sum_limit].iter().any(|word| line.contains(word));
            let is_expected =
                line.trim_start().starts_with("0x") || line.contains("UINT32_C(0x") || line.contains("expected_");
            let is_certified =
                ["range:", "designed", "measured", "before the limit", " precision"].iter().any(|it| line.contains(it));
            let figures = ["PARAMETERS", "BOUND"];
            let begins = ["#define AXIS_Y_IPC_", "pub const "];
            let figure = begins.iter().find_map(|begin| line.strip_prefix(begin));
            let is_figure = figure.is_some_and(|line| figures.iter().any(|name| line.starts_with(name)));
            assert!(is_digest(line) || is_figure || says_the_weight || is_expected || is_certified, "{name}: {line}");
        }
    }
    // Of the commissioning page rows of its tables, and its digests.
    let pages = |set: &str| pages(&set_of(set), &["Y".to_owned()], &TARGETS, |made| made.file.text).remove(0);
    for line in changed_lines(&pages(MACHINE), &pages(&heavier)) {
        let begins = ["| ", "This page belongs to", "     checksum "];
        assert!(begins.iter().any(|begin| line.starts_with(begin)), "{line}");
    }
}

fn is_digest(line: &str) -> bool {
    let mut words = line.trim_start_matches([' ', '*', '/']).split_ascii_whitespace();
    matches!(words.next(), Some("parameters" | "checksum")) && words.next().is_some_and(|digest| digest.len() == 32)
}

/// The lines of the second text that differ from those of the first; no line is added and none goes.
fn changed_lines<'t>(before: &str, after: &'t str) -> Vec<&'t str> {
    assert_eq!(before.lines().count(), after.lines().count());
    before.lines().zip(after.lines()).filter(|(a, b)| a != b).map(|(_, b)| b).collect()
}
