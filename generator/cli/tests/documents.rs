//! What the documents show of the command is what it prints, and their links lead somewhere. A fenced block below a line
//! that begins with the name of a file is that file; a block that begins with `$ axgen` is a command and what it prints;
//! below the README's first command stands what that prints.

use crate::{ROOT, words};
use std::path::{Path, PathBuf};
use std::{collections::BTreeSet, fs};

const FROM_SOURCE: &str = "cargo run --release -p axgen -- ";

/// A fenced block, with the last line of text before it.
struct Block {
    before: String,
    lines: Vec<String>,
}

fn blocks(page: &str) -> Vec<Block> {
    let (mut blocks, mut before, mut open) = (Vec::new(), String::new(), None::<Vec<String>>);
    for line in page.lines() {
        match (line.starts_with("```"), open.take()) {
            (true, None) => open = Some(Vec::new()),
            (true, Some(lines)) => blocks.push(Block { before: std::mem::take(&mut before), lines }),
            (false, Some(mut lines)) => {
                lines.push(line.to_owned());
                open = Some(lines);
            }
            (false, None) if !line.is_empty() => before = line.to_owned(),
            (false, None) => {}
        }
    }
    blocks
}

/// The file that a line of text begins with.
fn file_of(before: &str) -> Option<&str> {
    let name = before.strip_prefix('`')?.split('`').next()?;
    [".toml", ".lis", ".csv", ".nc"].iter().any(|end| name.ends_with(end)).then_some(name)
}

/// Runs the command; what it prints must have all the lines that a page shows, in their order: a page may leave some out.
fn assert_printed(folder: &Path, command: &str, shown: &[String]) {
    let (_, out, err) = words(folder, command);
    let printed = err + &out;
    let mut rest = printed.lines();
    for line in shown {
        assert!(rest.any(|found| found == line), "axgen {command}\nshown: {line}\nprinted:\n{printed}");
    }
    // Of a run nothing is left out.
    assert!(!command.starts_with("run ") || rest.next().is_none(), "axgen {command}\nprinted:\n{printed}");
}

/// A folder with the examples, as a user has it who follows a page.
fn folder() -> tempfile::TempDir {
    let folder = tempfile::tempdir().unwrap();
    crate::pipeline::copy(Path::new(crate::EXAMPLES), &folder.path().join("examples"));
    folder
}

/// How many commands a page shows.
fn follow(page: &Path) -> usize {
    let (folder, mut commands) = (folder(), 0);
    let blocks = blocks(&fs::read_to_string(page).unwrap());
    for (block, next) in blocks.iter().zip(blocks.iter().skip(1).map(Some).chain([None])) {
        let first = block.lines.first().map_or("", String::as_str);
        let (command, shown) = if let Some(command) = first.strip_prefix("$ axgen ") {
            (command, &block.lines[1..])
        } else if let Some((command, next)) = first.strip_prefix(FROM_SOURCE).zip(next) {
            (command, &next.lines[..])
        } else {
            if let Some(name) = file_of(&block.before) {
                fs::write(folder.path().join(name), block.lines.join("\n") + "\n").unwrap();
            }
            continue;
        };
        assert_printed(folder.path(), command, shown);
        commands += 1;
    }
    assert_drawn(page, folder.path());
    commands
}

/// The pictures `walk-NAME.svg` of a page are the files `NAME.svg` that its commands have drawn; `UPDATE_EXPECT=1` keeps these.
fn assert_drawn(page: &Path, folder: &Path) {
    for link in links(&fs::read_to_string(page).unwrap()) {
        let Some(name) = link.strip_prefix("pictures/walk-") else { continue };
        let (kept, drawn) = (page.parent().unwrap().join(&link), folder.join(name));
        if std::env::var_os("UPDATE_EXPECT").is_some() {
            fs::copy(&drawn, &kept).unwrap();
        }
        assert!(fs::read(&kept).unwrap() == fs::read(&drawn).unwrap(), "{link} is not what the page's command draws");
    }
}

/// The pages of a folder below the root.
fn pages(folder: &str) -> Vec<PathBuf> {
    let mut pages: Vec<_> =
        fs::read_dir(Path::new(ROOT).join(folder)).unwrap().map(|entry| entry.unwrap().path()).collect();
    pages.retain(|page| page.extension().is_some_and(|end| end == "md"));
    pages.sort();
    pages
}

/// The targets of a page's links to files, without those in fenced blocks and in code.
fn links(page: &str) -> Vec<String> {
    let (mut links, mut fenced) = (Vec::new(), false);
    for line in page.lines() {
        if line.starts_with("```") {
            fenced = !fenced;
        }
        if !fenced {
            let text: String = line.split('`').step_by(2).collect();
            links.extend(text.split("](").skip(1).filter_map(|rest| Some(rest.split_once(')')?.0.to_owned())));
        }
    }
    links.retain(|link| !link.contains("://"));
    links
}

/// The anchors of a page: its headings, as GitHub and mdBook name them.
fn anchors(page: &str) -> BTreeSet<String> {
    let headings = page.lines().filter(|line| line.starts_with('#')).map(|line| line.trim_start_matches('#').trim());
    let kept = |c: &char| c.is_alphanumeric() || matches!(c, ' ' | '-' | '_');
    headings.map(|heading| heading.to_lowercase().chars().filter(kept).collect::<String>().replace(' ', "-")).collect()
}

#[test]
fn the_documents_show_what_the_command_prints() {
    let part = if crate::is_exhaustive() { 1 } else { 4 };
    assert!(pages("docs").iter().step_by(part).map(|page| follow(page)).sum::<usize>() >= 10 / part);
    assert_eq!(follow(&Path::new(ROOT).join("README.md")), 2);
}

#[test]
fn links_lead_to_a_page_and_a_heading() {
    let mut broken = Vec::new();
    for page in [pages(""), pages("tests"), pages("docs"), pages("docs/decisions")].concat() {
        for link in links(&fs::read_to_string(&page).unwrap()) {
            let (path, anchor) = link.split_once('#').unwrap_or((&link, ""));
            let target = if path.is_empty() { page.clone() } else { page.parent().unwrap().join(path) };
            let found = target.exists()
                && (anchor.is_empty() || anchors(&fs::read_to_string(&target).unwrap()).contains(anchor));
            if !found {
                broken.push(format!("{}: {link}", page.file_name().unwrap().display()));
            }
        }
    }
    assert!(broken.is_empty(), "{broken:#?}");
}

/// The files and folders below a folder, with their paths from there.
fn everything(folder: &Path, path: &str, found: &mut Vec<String>) {
    for entry in fs::read_dir(folder).unwrap().map(Result::unwrap) {
        let name = entry.file_name().into_string().unwrap();
        let path = format!("{path}/{name}");
        if ["/.git", "/target"].contains(&path.as_str()) {
            continue;
        }
        if entry.path().is_dir() {
            everything(&entry.path(), &path, found);
        }
        found.push(path);
    }
}

/// A path may begin at a folder that the text before it names: it is the end of a path that exists, with or without `.rs`.
#[test]
fn the_paths_in_the_architecture_exist() {
    let page = fs::read_to_string(Path::new(ROOT).join("ARCHITECTURE.md")).unwrap();
    let text: String = page.split("```").step_by(2).collect();
    let mut there = Vec::new();
    everything(Path::new(ROOT), "", &mut there);
    let is_path = |word: &&str| {
        let is_plain = word.chars().all(|c| c.is_ascii_alphanumeric() || "./_-".contains(c)) && !word.contains("NAME");
        is_plain && (word.trim_end_matches('/').contains('/') || word.ends_with(".rs") || word.ends_with(".toml"))
    };
    let paths: BTreeSet<&str> = text.split('`').skip(1).step_by(2).filter(is_path).collect();
    let exists = |path: &&&str| {
        let ends = [format!("/{}", path.trim_end_matches('/')), format!("/{path}.rs")];
        there.iter().any(|there| ends.iter().any(|end| there.ends_with(end.as_str())))
    };
    assert!(paths.len() > 80, "{paths:?}");
    assert_eq!(paths.iter().filter(|path| !exists(path)).collect::<Vec<_>>(), [&""; 0]);
}

#[test]
fn the_summary_lists_every_page_once() {
    let docs = Path::new(ROOT).join("docs");
    let mut listed = links(&fs::read_to_string(docs.join("SUMMARY.md")).unwrap());
    listed.sort();
    let below = |page: PathBuf| page.strip_prefix(&docs).unwrap().to_str().unwrap().replace('\\', "/");
    let mut there: Vec<_> = [pages("docs"), pages("docs/decisions")].concat().into_iter().map(below).collect();
    there.retain(|page| page != "SUMMARY.md");
    there.sort();
    assert_eq!(listed, there);
}
