//! From one generated folder to another: nothing of ours stays unsaid, nothing of the user's is lost.

mod folder;
mod ways;

use crate::{Run as Said, is_exhaustive};
use folder::{Folder, MINE, OUT};
use generator::digest::is_text;
use generator::manifest::{self, NAME};
use std::collections::{BTreeMap, BTreeSet};
use ways::{Way, ways};

/// The files of a folder that a command speaks of with these words.
fn named(said: &str, words: &str) -> BTreeSet<String> {
    let file =
        |line: &str| Some(line.split_once(words)?.0.trim_end_matches(": ").strip_prefix("generated/")?.to_owned());
    said.lines().filter_map(file).collect()
}

/// What is said of files that are generated no more, in the marks of the table.
fn left_over(said: &Said) -> BTreeSet<String> {
    let kept = named(&said.out, ": is no longer generated, but ");
    let all = named(&said.out, ": is no longer generated");
    let unlisted = named(&said.out, ": was generated, but not from this set");
    let mark =
        |mark: &'static str, files: BTreeSet<String>| files.into_iter().map(move |file| format!("{mark} {file}"));
    mark("-", &all - &kept).chain(mark("!", kept)).chain(mark("?", unlisted)).collect()
}

/// The files with one of these marks.
fn marked(way: &Way, marks: &str) -> BTreeSet<String> {
    let files = way.said.iter().filter(|said| marks.contains(&said[..1]));
    files.map(|said| said[2..].to_owned()).collect()
}

/// What the sets give in a folder of their own, one after the other.
fn fresh(folder: &Folder, way: &Way) -> BTreeMap<String, String> {
    for run in &way.whole {
        assert_eq!(folder.generate(run, "fresh").code, 0, "{}", way.way);
    }
    folder.content("fresh")
}

fn go(way: &Way) {
    let folder = Folder::new();
    way.steps.iter().for_each(|step| folder.happens(step));
    let before = folder.content(OUT);
    let check = || folder.generate(&format!("{} --check", way.run.trim_end_matches(" --force")), OUT);
    let checked = check();
    let run = folder.generate(&way.run, OUT);
    let after = folder.content(OUT);
    assert_eq!([checked.code, run.code], way.codes, "{}: {}{}", way.way, checked.out, run.err);
    assert_eq!(checked.code == 1, !checked.out.is_empty(), "{}: {}", way.way, checked.out);
    if run.code != 0 {
        assert!(way.said.iter().all(|said| run.err.contains(said)), "{}: {}", way.way, run.err);
        assert_eq!(after, before, "{}: nothing was written", way.way);
        return;
    }
    let said: BTreeSet<String> = way.said.iter().cloned().collect();
    assert_eq!(left_over(&checked), said, "{}: {}", way.way, checked.out);
    assert_eq!(named(&run.out, ": removed, no longer generated"), marked(way, "-"), "{}: {}", way.way, run.out);
    assert_eq!(named(&run.err, ": warning[AX490]: "), marked(way, "!"), "{}: {}", way.way, run.err);
    assert_eq!(named(&run.err, ": warning[AX491]: "), marked(way, "?"), "{}: {}", way.way, run.err);
    same_as_fresh(way, &fresh(&folder, way), &after);
    for (file, text) in before.iter().filter(|(_, text)| text.contains(MINE)) {
        assert_eq!(after.get(file), Some(text), "{}: {file} is lost", way.way);
    }
    let stays = marked(way, "!?");
    for run in &way.satisfied {
        let said = folder.generate(&format!("{run} --check"), OUT);
        assert_eq!(said.code, i32::from(!said.out.is_empty()), "{}: {}", way.way, said.err);
        let is_said =
            said.out.lines().all(|line| stays.iter().any(|file| line.starts_with(&format!("generated/{file}: "))));
        assert!(is_said, "{}: {run}: {}", way.way, said.out);
    }
    let left: BTreeSet<String> = said.into_iter().filter(|said| stays.contains(&said[2..])).collect();
    assert_eq!(left_over(&check()), left, "{}", way.way);
}

/// The folder has what a fresh one has, what stays, and what is somebody's; and the manifest names what stays of ours.
fn same_as_fresh(way: &Way, fresh: &BTreeMap<String, String>, after: &BTreeMap<String, String>) {
    let stays = marked(way, "!?");
    let mut more: BTreeSet<&String> = after.keys().filter(|file| !fresh.contains_key(*file)).collect();
    more.retain(|file| !stays.contains(*file));
    assert!(more.iter().all(|file| after[*file] == MINE), "{}: {more:?} stay unsaid", way.way);
    for (file, text) in fresh.iter().filter(|(file, _)| *file != NAME) {
        let is_there = after.get(file).is_some_and(|there| is_text(there.as_bytes(), text));
        assert!(is_there, "{}: {file} is not as in a fresh folder", way.way);
    }
    let [fresh, after] = [fresh, after].map(|of| manifest::read(&of[NAME], NAME).unwrap());
    let kept: BTreeSet<String> = (&after - &fresh).into_iter().map(|entry| entry.file).collect();
    assert!((&fresh - &after).is_empty() && kept == marked(way, "!"), "{}: {kept:?}", way.way);
}

#[test]
fn every_way_from_one_folder_to_another() {
    let mut ways = ways();
    assert!(ways.len() >= 30);
    if cfg!(not(unix)) {
        ways.retain(|way| !way.steps.iter().any(|step| step.starts_with("link ")));
    }
    ways.iter().for_each(go);
}

/// Wherever a run is killed, the manifest names every file of ours, and the next run ends as if nothing had happened.
#[test]
fn a_killed_run_leaves_a_manifest_that_names_every_file() {
    const SETS: [&str; 2] = ["X kv stage, Y stage, Z f32 stage", "X stage, Y1 stage, Z1 f32 kv"];
    let folder = Folder::new();
    let set = |axes| folder.happens(&format!("set axes.toml | c twincat codesys | {axes}"));
    let fresh = SETS.map(|axes| {
        set(axes);
        let out = if axes == SETS[0] { "first" } else { "second" };
        assert_eq!(folder.generate("axes.toml", out).code, 0);
        folder.content(out)
    });
    set(SETS[0]);
    folder.happens("run axes.toml");
    for number in 0..if is_exhaustive() { 20 } else { 10 } {
        let to = (number + 1) % 2;
        set(SETS[to]);
        // From the begin of a run to its end, in smaller steps in an exhaustive run.
        folder.happens(&format!("kill {} axes.toml", if is_exhaustive() { 27 * number } else { 54 * number }));
        let mut there = folder.content(OUT);
        let listed: BTreeSet<String> =
            manifest::read(&there[NAME], NAME).unwrap().into_iter().map(|entry| entry.file).collect();
        there.retain(|file, _| file != NAME && !file.contains(".axgen-"));
        let unlisted: Vec<&String> = there.keys().filter(|file| !listed.contains(*file)).collect();
        assert!(unlisted.is_empty(), "{number}: {unlisted:?}");
        folder.happens("run axes.toml");
        assert!(folder.content(OUT) == fresh[to], "{number}: all of the next run, and nothing else");
    }
}

/// Files of other sets are said, and so is whose files a run takes over.
#[test]
fn other_sets_are_named() {
    let folder = Folder::new();
    let set = |file, axes| folder.happens(&format!("set {file} | rust scl | {axes}"));
    set("axes.toml", "X stage");
    set("b.toml", "Y, Z");
    let said = |set: &str| folder.generate(set, OUT).out;
    let ends = |out: &str, end: &str| assert!(out.ends_with(end), "{out}");
    ends(&said("axes.toml"), "1 axis: 8 files written, 0 unchanged, 0 warnings\n");
    ends(&said("b.toml"), "2 warnings\ngenerated: also has 4 files of axes.toml\n");
    set("axes.toml", "X stage, Y");
    let taken = "generated: took over 4 files from b.toml\ngenerated: also has 4 files of b.toml\n";
    ends(&said("axes.toml"), taken);
    ends(&said("axes.toml"), "1 warning\ngenerated: also has 4 files of b.toml\n");
}
