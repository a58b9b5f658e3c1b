//! The emitted C under MISRA C:2012, as cppcheck and its addon see it, next to the record in `docs/misra.md`; and under
//! clang-tidy.

#![expect(clippy::unwrap_used, reason = "a test that cannot go on fails")]

use axgen_tests::cases::in_both_real_types;
use axgen_tests::environment::{has, is_every_level, is_exhaustive};
use generator::blocks::Designed;
use generator::config::ListOptions;
use generator::generate::axis_files;
use generator::target::{File, TARGETS};
use std::collections::{BTreeMap, BTreeSet};
use std::path::Path;
use std::process::Command;
use tempfile::TempDir;

const RECORD: &str = include_str!("../../docs/misra.md");

/// Sets with the blocks of one axis of each that are looked at: double and single precision, all kinds of blocks.
const SUBJECTS: [(&str, &str, &[&str]); 6] = [
    ("examples/feedforward.toml", "X", &["ipc", "axis"]),
    ("examples/feedforward.toml", "T", &["feedforward", "position_control"]),
    ("tests/bench/spindles.toml", "S", &["spindle_axis"]),
    ("tests/bench/single.toml", "one", &["ipc"]),
    ("tests/coverage.toml", "P", &["ipc"]),
    ("tests/bench/design.toml", "small", &["ipc", "set_design"]),
];

/// The files in a folder, and the names of the sources.
fn written() -> (TempDir, Vec<String>) {
    let (folder, mut sources) = (tempfile::tempdir().unwrap(), Vec::new());
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
    for (path, name, blocks) in SUBJECTS {
        let (set, report) = generator::pipeline::read(&root.join(path), &ListOptions::default());
        let axes = set.unwrap_or_else(|| panic!("{report}")).axes;
        let axis = axes.iter().find(|of| of.axis.name.eq_ignore_ascii_case(name)).unwrap();
        let wanted: Vec<String> = blocks.iter().map(|block| format!("axis_{}_{block}", name.to_lowercase())).collect();
        for File { name, text } in axis_files(axis, &TARGETS[..1]).unwrap() {
            let (stem, extension) = name.rsplit_once('.').unwrap();
            if wanted.iter().any(|wanted| stem == wanted || stem == format!("{wanted}_self_test")) {
                std::fs::write(folder.path().join(&name), text).unwrap();
                sources.extend((extension == "c").then(|| name.clone()));
            }
        }
    }
    assert_eq!(sources.len(), 18, "{sources:?}");
    (folder, sources)
}

/// The first cells of the table below a heading of the record.
fn recorded(heading: &str) -> BTreeSet<&'static str> {
    let section = RECORD.split("\n## ").find(|section| section.starts_with(heading)).unwrap();
    let cells = section.lines().filter_map(|line| line.strip_prefix("| ")?.split(" | ").next());
    cells.filter(|cell| cell.starts_with(|c: char| c.is_ascii_digit())).collect()
}

/// The command line of the record, in the words of a shell.
fn command() -> Vec<String> {
    let line = RECORD.split("```\n").nth(1).unwrap().replace("\\\n", " ");
    line.split_whitespace().map(|word| word.trim_matches('\'').to_owned()).filter(|word| word != "*.c").collect()
}

#[test]
fn cppcheck_finds_what_is_recorded() {
    // It takes longest of all checks that need no build: an exhaustive run has it.
    if !is_exhaustive() || !has("cppcheck", "Cppcheck", "cppcheck") {
        return;
    }
    let (folder, sources) = written();
    let command = command();
    assert_eq!(command[0], "cppcheck");
    let output =
        Command::new(&command[0])
            .args(&command[1..])
            .args(["-j2", "--template=FOUND {id} in {file}:{line}: {message}"])
            // It takes a minute for that one; axis_small_ipc has statements of the same kinds. Self-tests are alike.
            .args(sources.iter().filter(|source| !source.starts_with("axis_p_ipc")).filter(|source| {
                is_every_level() || !source.ends_with("_self_test.c") || source.starts_with("axis_one")
            }))
            .current_dir(folder.path())
            .output()
            .unwrap();
    let said = String::from_utf8_lossy(&output.stderr);
    let found: Vec<&str> = said.lines().filter_map(|line| line.strip_prefix("FOUND ")).collect();
    let (deviations, others) = (recorded("Deviations"), recorded("Findings of cppcheck"));
    let mut rules = BTreeSet::new();
    for line in found {
        let id = line.split(' ').next().unwrap();
        let rule = id.strip_prefix("misra-c2012-").unwrap_or_else(|| panic!("{line}"));
        assert!(deviations.contains(rule) || others.contains(rule), "not recorded: {line}");
        rules.insert(rule);
    }
    let gone: Vec<&&str> = deviations.iter().filter(|rule| !rules.contains(**rule)).collect();
    assert!(gone.is_empty(), "recorded, and not found: {gone:?}\n{said}");
}

/// Rule 5.2: C99 tells names apart by their first 63 characters.
const SIGNIFICANT: usize = 63;

/// A spindle with the longest name that `docs/misra.md` allows an axis.
const LONGEST_NAME: &str = include_str!("misra.toml");

/// The names in a text, without its comments, that are equal where they count to another one.
fn equal_names(text: &str) -> BTreeSet<&str> {
    let mut first: BTreeMap<String, &str> = BTreeMap::new();
    let mut equal = BTreeSet::new();
    for piece in text
        .split("/*")
        .enumerate()
        .filter_map(|(n, piece)| if n == 0 { Some(piece) } else { piece.split("*/").nth(1) })
    {
        for name in piece.split(|c: char| !c.is_ascii_alphanumeric() && c != '_') {
            let counts: String = name.chars().take(SIGNIFICANT).collect();
            if let Some(other) = first.insert(counts, name).filter(|other| *other != name) {
                equal.extend([other, name]);
            }
        }
    }
    equal
}

/// The axes of a set.
fn read(set: &str) -> Vec<Designed> {
    let load = |_: &Path| Ok(set.as_bytes().to_vec());
    let (read, report) = generator::pipeline::read_with(Path::new("set.toml"), &ListOptions::default(), &load);
    read.unwrap_or_else(|| panic!("{report}")).axes
}

#[test]
fn names_differ_in_their_first_63_characters() {
    let planted = format!("int {0}a; /* {0}c */ int {0}b;", "x".repeat(SIGNIFICANT));
    assert_eq!(equal_names(&planted).len(), 2);
    let mut axes: Vec<Designed> = in_both_real_types().into_iter().map(|case| case.axis).collect();
    axes.extend(read(LONGEST_NAME));
    let mut longest = 0;
    for axis in axes {
        for File { name, text } in axis_files(&axis, &TARGETS[..1]).unwrap() {
            assert_eq!(equal_names(&text), BTreeSet::new(), "{name}");
            longest =
                longest.max(text.split(|c: char| !c.is_ascii_alphanumeric() && c != '_').map(str::len).max().unwrap());
        }
    }
    assert!(longest > SIGNIFICANT, "no name is that long");
}

#[test]
fn clang_tidy_finds_nothing() {
    if !is_exhaustive() || !has("clang-tidy", "LLVM version", "clang-tidy") {
        return;
    }
    let (folder, sources) = written();
    let section = RECORD.split("\n## ").find(|section| section.starts_with("clang-tidy")).unwrap();
    let checks = section.split('\'').nth(1).unwrap();
    let output = Command::new("clang-tidy")
        .args(["--quiet", "--warnings-as-errors=*", &format!("--checks={checks}")])
        .args(&sources)
        .args(["--", "-std=c99"])
        .current_dir(folder.path())
        .output()
        .unwrap();
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stdout));
}
