//! What the documents show of the command is what it prints. A fenced block below a line that begins with the name of a file is
//! that file; a block that begins with `$ axgen` is a command and what it prints; below the README's first command stands
//! what that prints.

#![expect(clippy::unwrap_used, reason = "a test that cannot go on fails")]

use std::fs;
use std::path::Path;
use std::process::Command;

const ROOT: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../..");
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
    let output = Command::new(env!("CARGO_BIN_EXE_axgen"))
        .current_dir(folder)
        .args(command.split_whitespace())
        .output()
        .unwrap();
    let printed = String::from_utf8([output.stderr, output.stdout].concat()).unwrap();
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
    fs::create_dir(folder.path().join("examples")).unwrap();
    for entry in fs::read_dir(Path::new(ROOT).join("examples")).unwrap() {
        let from = entry.unwrap().path();
        if from.is_file() {
            fs::copy(&from, folder.path().join("examples").join(from.file_name().unwrap())).unwrap();
        }
    }
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
    commands
}

#[test]
fn the_documents_show_what_the_command_prints() {
    let docs = Path::new(ROOT).join("docs");
    let mut pages: Vec<_> = fs::read_dir(docs).unwrap().map(|entry| entry.unwrap().path()).collect();
    pages.retain(|page| page.extension().is_some_and(|end| end == "md"));
    assert!(pages.iter().map(|page| follow(page)).sum::<usize>() >= 9);
    assert_eq!(follow(&Path::new(ROOT).join("README.md")), 3);
}
