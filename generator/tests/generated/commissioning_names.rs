//! The names on commissioning pages: each signal, block and self-test that a page names for a target is declared in
//! the files that `generate` writes for it; what a page says of the example for TwinCAT is there. What the steps do
//! is tested elsewhere.

use generator::config::ListOptions;
use generator::generate::{files, pages};
use generator::pipeline::{Set, read};
use generator::target::{TARGETS, Target};
use std::collections::{BTreeMap, BTreeSet};
use std::path::{Path, PathBuf};

/// Sets with every kind of page: constants, inputs that tune, parameter sets, watch, a counter of calls, a whole
/// axis, a spindle.
const SETS: [&str; 10] = [
    "examples/rack-and-pinion.toml",
    "examples/twincat/axes.toml",
    "golden/cases/parameter-sets/set.toml",
    "golden/cases/watch-of-an-unstable-loop/set.toml",
    "golden/cases/call-rate/set.toml",
    "golden/cases/single-precision/set.toml",
    "golden/cases/position-control-in-the-drive/set.toml",
    "golden/cases/whole-spindle-in-the-cnc/set.toml",
    "golden/cases/excitation-in-single-precision/set.toml",
    "golden/cases/excitation/set.toml",
];

/// Names that only recordings have, outside of their tables.
const OF_RECORDINGS: [&str; 2] = ["a_load", "following_error"];

/// The page without the tables of what to record, and the names in them.
fn without_recordings(page: &str) -> (String, BTreeSet<String>) {
    let (mut rest, mut names, mut is_inside) = (String::new(), BTreeSet::new(), false);
    for line in page.lines() {
        is_inside = line == "| name | signal |" || is_inside && line.starts_with('|');
        match line.strip_prefix("| `").filter(|_| is_inside).and_then(|row| row.split_once('`')) {
            Some((name, _)) => _ = names.insert(name.to_owned()),
            None => rest += &format!("{line}\n"),
        }
    }
    (rest, names)
}

/// Keys of a set that a page names without their paths.
const KEYS: [&str; 6] = ["weight_fact_num", "weight_fact_denom", "v_add_max_fact", "q_factor", "order", "tunable"];

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("..")
}

fn set(name: &str) -> Set {
    let (set, report) = read(&root().join(name), &ListOptions::default());
    set.unwrap_or_else(|| panic!("{name}: {report}"))
}

/// The words of a text outside of its comments.
fn words(text: &str) -> BTreeSet<String> {
    let mut code = String::new();
    let mut rest = text;
    // XML escapes quotes only inside of statements; no name has one.
    while let Some((at, end)) = [("(*", "*)"), ("/*", "*/"), ("//", "\n"), ("<!--", "-->")]
        .into_iter()
        .filter_map(|(begin, end)| rest.find(begin).map(|at| (at, end)))
        .min_by_key(|(at, _)| *at)
    {
        code.push_str(&rest[..at]);
        code.push(' ');
        rest = rest[at..].split_once(end).map_or("", |(_, after)| after);
    }
    code.push_str(rest);
    let is_name = |letter: char| letter.is_ascii_alphanumeric() || letter == '_';
    code.split(|letter: char| !is_name(letter)).map(str::to_owned).collect()
}

/// What the files of an axis for a target declare and use. A file of Rust is a module, whose name nothing in it has.
fn known(set: &Set, axis: &str, target: Target) -> BTreeSet<String> {
    let of_file = |name: &str, text: &str| {
        let module = name.strip_suffix(".rs").map(str::to_owned);
        words(text).into_iter().chain(module).collect::<Vec<_>>()
    };
    let files = files(set, &[axis.to_owned()], &[target], |made| of_file(&made.file.name, &made.file.text)).unwrap();
    files.into_iter().flatten().collect()
}

const OTHERS: &str =
    "SET trial trial/SET trial/params.csv recorded.csv moves.csv excited.csv Ms recommended first excitation list";

/// What of the page's words in backquotes names no signal: files, commands, parameters of a set with their paths.
fn is_of_the_set(name: &str) -> bool {
    name.starts_with("axgen ")
        || name.starts_with("--")
        || name.starts_with("lr_param.")
        || name == "left at best"
        || OTHERS.split(' ').any(|other| other == name)
        || OF_RECORDINGS.contains(&name)
        || KEYS.contains(&name.split(" = ").next().unwrap())
        || name.chars().all(|letter| letter.is_ascii_hexdigit()) && name.len() > 8
}

/// A name of a page, and the targets that it is said for; none: all.
#[derive(Debug, Eq, Ord, PartialEq, PartialOrd)]
struct Named {
    name: String,
    targets: Vec<String>,
}

/// The names in backquotes of a page, outside of its commands.
fn named(page: &str) -> BTreeSet<Named> {
    let prose: String = page.split("```").step_by(2).collect();
    let mut found = BTreeSet::new();
    let pieces: Vec<&str> = prose.split('`').collect();
    for (at, piece) in pieces.iter().enumerate().filter(|(at, _)| at % 2 == 1) {
        // A column of a recording has the index in brackets.
        if is_of_the_set(piece) || piece.ends_with(']') {
            continue;
        }
        // Of `Enable := TRUE` the name is what stands before.
        let name = piece.split(" := ").next().unwrap();
        // Of `ErrorID` or `NoticeID` (twincat) the targets stand after the second one.
        let last = if pieces[at + 1] == " or " { at + 3 } else { at + 1 };
        let after = pieces[last].strip_prefix(" (").and_then(|after| after.split_once(')')).map(|(inside, _)| inside);
        let is_target = |word: &&str| TARGETS.iter().any(|target| target.name == *word);
        let inside =
            after.map(|after| after.strip_prefix("a block for ").unwrap_or(after).trim_end_matches(" has this input"));
        let targets: Vec<&str> = inside.map_or_else(Vec::new, |inside| inside.split(", ").collect());
        let targets = if targets.iter().all(is_target) { targets } else { Vec::new() };
        let targets = targets.into_iter().map(str::to_owned).collect();
        found.insert(Named { name: name.to_owned(), targets });
    }
    found
}

/// The names that are not there: for each target those that are said for it.
fn missing(page: &str, known: &BTreeMap<&str, BTreeSet<String>>, example: &BTreeSet<String>) -> Vec<String> {
    let mut said = Vec::new();
    for Named { name, targets } in named(page) {
        if let Some((_, variable)) = name.split_once('.').filter(|(list, _)| list.starts_with("GVL_axis_")) {
            if !(known.contains_key("twincat") && example.contains("GVL_axis_x") && example.contains(variable)) {
                said.push(name);
            }
            continue;
        }
        let is_asked = |target: &str| targets.is_empty() || targets.iter().any(|own| own == target);
        let asked: Vec<&str> = known.keys().copied().filter(|target| is_asked(target)).collect();
        // A page for several targets says which of them have a function as self-test: these two are those of a
        // function block.
        let is_of_block = ["done", "differing"].contains(&name.as_str());
        let blocks: Vec<&str> = asked.iter().copied().filter(|target| !["c", "rust"].contains(target)).collect();
        let asked = if is_of_block && !blocks.is_empty() { blocks } else { asked };
        let is_there = |target: &str| name.split("::").all(|part| known[target].contains(part));
        said.extend(asked.into_iter().filter(|target| !is_there(target)).map(|target| format!("{name} in {target}")));
    }
    said
}

fn example() -> BTreeSet<String> {
    let lists = root().join("examples/twincat/GVLs");
    let names = ["GVL_axis_x.TcGVL", "GVL_axis_z.TcGVL"];
    names.iter().flat_map(|name| words(&std::fs::read_to_string(lists.join(name)).unwrap())).collect()
}

#[test]
fn each_name_is_in_the_files_of_its_targets() {
    let example = example();
    let measured = std::fs::read_to_string(root().join("docs/measure.md")).unwrap();
    assert!(OF_RECORDINGS.iter().all(|name| measured.contains(&format!("`{name}`"))));
    let mut count = 0;
    for name in SETS {
        let set = set(name);
        let known_of = |axis: &str| TARGETS.map(|target| (target.name, known(&set, axis, target)));
        let all_known: BTreeMap<&str, _> =
            set.axes.iter().map(|of| (&*of.axis.name, known_of(&of.axis.name))).collect();
        for choice in TARGETS.map(|target| vec![target]).into_iter().chain([TARGETS.to_vec()]) {
            let pages = pages(&set, &[], &choice, |made| (made.axis.to_owned(), made.file.text));
            for (axis, page) in pages {
                let is_chosen = |known: &&(&str, _)| choice.iter().any(|target| target.name == known.0);
                let known: BTreeMap<&str, _> = all_known[&*axis].iter().filter(is_chosen).cloned().collect();
                let (page, recorded) = without_recordings(&page);
                let missing = missing(&page, &known, &example);
                let is_read = |name: &String| measured.contains(&format!("`{name}`"));
                assert!(recorded.len() > 4 && recorded.iter().all(is_read), "{name}: {recorded:?}");
                assert!(missing.is_empty(), "{name}, {:?}: {missing:#?}", known.keys());
                count += named(&page).len();
            }
        }
    }
    assert!(count > 500, "{count} names");
    let reference = generator::reference_page::text();
    assert!(KEYS.iter().all(|key| reference.contains(key)));
}

/// The page of one target is found out by the files of another.
#[test]
fn names_of_another_target_are_found() {
    let set = set(SETS[0]);
    let example = example();
    for (of, by, wrong) in
        [("c", "twincat", "fault in twincat"), ("twincat", "st", "Enable in st"), ("st", "rust", "done in rust")]
    {
        let [of, by] = [of, by].map(|name| *TARGETS.iter().find(|target| target.name == name).unwrap());
        let (axis, page) = pages(&set, &[], &[of], |made| (made.axis.to_owned(), made.file.text)).remove(0);
        let known = BTreeMap::from([(by.name, known(&set, &axis, by))]);
        assert!(missing(&page, &known, &example).contains(&wrong.to_owned()), "{:?}", missing(&page, &known, &example));
    }
}
