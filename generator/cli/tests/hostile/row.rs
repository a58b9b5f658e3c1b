//! A row: its input is made, run twice, and must leave every file as it was; what is said must be what the document says.

use super::document;
use super::run::{axgen, files, read_result};
use crate::Run;
use generator::{digest::has_right_checksum, manifest::NAME as MANIFEST};
use std::path::{Path, PathBuf};
use std::sync::LazyLock;
use std::time::{Duration, SystemTime};
use std::{collections::BTreeMap, fs};
use tempfile::TempDir;

pub struct Row {
    /// what it is, for the document
    pub input: &'static str,
    /// makes it in a folder, and gives the arguments of `generate`
    pub given: fn(&Path) -> Vec<String>,
}

#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Seen {
    /// the first error; of a success the first line
    pub said: String,
    pub exit: i32,
}

/// A set, as the argument of `generate`.
pub fn set(folder: &Path, text: impl AsRef<[u8]>) -> Vec<String> {
    fs::write(folder.join("set.toml"), text).unwrap();
    vec!["set.toml".to_owned()]
}

/// An axis list with its cycle time, as the arguments of `generate`.
pub fn list(folder: &Path, text: impl AsRef<[u8]>) -> Vec<String> {
    fs::write(folder.join("x.lis"), text).unwrap();
    ["x.lis", "--cycle-time", "1ms"].map(str::to_owned).to_vec()
}

/// A set with the axis X and these lines.
pub fn axis(folder: &Path, lines: &str) -> Vec<String> {
    set(folder, format!("cycle_time = \"1ms\"\n[axis.X]\n{lines}\n"))
}

/// What improved position control's paths begin with.
pub const IPC: &str = "lr_param.improved_position_control";

/// Compares with the document, unless that is being written.
pub fn check(row: &Row) {
    let seen = see(row);
    if !document::is_written() {
        assert_eq!(
            Some(seen),
            document::read().remove(row.input),
            "{}: UPDATE_EXPECT=1 writes the document anew",
            row.input
        );
    }
}

/// Runs the row where there is no output folder, and where there is one.
pub fn see(row: &Row) -> Seen {
    let seen = beside_nothing(row);
    assert_eq!(beside_a_result(row), seen, "{}: an older result makes no difference", row.input);
    seen
}

fn beside_nothing(row: &Row) -> Seen {
    let folder = tempfile::tempdir().unwrap();
    let arguments = (row.given)(folder.path());
    let before = files(folder.path());
    let run = generate(folder.path(), &arguments);
    if run.code == 0 {
        assert_works(row, folder.path(), &arguments);
    } else {
        assert_eq!(files(folder.path()), before, "{}: nothing was made", row.input);
        assert!(!folder.path().join("out").exists(), "{}: nor the folder", row.input);
    }
    seen(row, &run)
}

fn beside_a_result(row: &Row) -> Seen {
    let folder = tempfile::tempdir().unwrap();
    let out = folder.path().join("out");
    let long_ago = SystemTime::UNIX_EPOCH + Duration::from_secs(1_000_000_000);
    fs::create_dir(&out).unwrap();
    for (name, content) in &*RESULT {
        fs::write(out.join(name), content).unwrap();
        fs::File::options().write(true).open(out.join(name)).unwrap().set_modified(long_ago).unwrap();
    }
    let arguments = (row.given)(folder.path());
    let run = generate(folder.path(), &arguments);
    let (mut before, mut after) = (RESULT.clone(), read_result(&out));
    if run.code == 0 {
        after.retain(|name, _| before.contains_key(name));
        // The manifest has the older lines next to the new ones.
        let lines = |of: &mut BTreeMap<PathBuf, Vec<u8>>| of.remove(Path::new(MANIFEST)).unwrap();
        let [before, after] = [&mut before, &mut after].map(|of| String::from_utf8(lines(of)).unwrap());
        assert!(before.lines().all(|line| after.lines().any(|kept| kept == line)), "{}: {after}", row.input);
    }
    let modified = |name: &PathBuf| fs::metadata(out.join(name)).unwrap().modified().unwrap();
    assert!(after.keys().all(|name| modified(name) == long_ago), "{}: no file is touched", row.input);
    assert!(after == before, "{}: every byte is kept", row.input);
    seen(row, &run)
}

/// An older result, of the example.
static RESULT: LazyLock<BTreeMap<PathBuf, Vec<u8>>> = LazyLock::new(|| {
    let folder: TempDir = tempfile::tempdir().unwrap();
    let example = concat!(env!("CARGO_MANIFEST_DIR"), "/../../examples/rack-and-pinion.lis");
    let run = generate(folder.path(), &[example, "--cycle-time", "1ms"].map(str::to_owned));
    assert_eq!(run.code, 0, "{}", run.err);
    read_result(&folder.path().join("out"))
});

fn generate(folder: &Path, arguments: &[String]) -> Run {
    let command = ["generate"].into_iter().chain(arguments.iter().map(String::as_str));
    axgen(folder, command.chain(["--out", "out"]))
}

/// The first error, or what the command ends with; of a success the first line. No message may steer a terminal.
fn seen(row: &Row, run: &Run) -> Seen {
    // What turns the order of letters, or ends a line for some readers only, is escaped too.
    let turns =
        |c: char| matches!(c, '\u{200e}' | '\u{200f}' | '\u{2028}'..='\u{202e}' | '\u{2066}'..='\u{2069}' | '\u{feff}');
    let is_plain = |text: &str| !text.contains(|c: char| (c.is_control() && c != '\n') || turns(c));
    assert!(is_plain(&run.err) && is_plain(&run.out), "{}: {:?}", row.input, run.err);
    assert!(run.code == 0 || run.out.is_empty(), "{}: {}", row.input, run.out);
    let said =
        if run.code == 0 { run.out.lines().next() } else { run.err.lines().find(|line| line.contains(": error[")) };
    let said = said.or_else(|| run.err.lines().last()).unwrap_or_default();
    Seen { said: said.to_owned(), exit: run.code }
}

/// What was made bears its checksum, has a name of its own kind, and the compilers and checkers of `verify` take it.
fn assert_works(row: &Row, folder: &Path, arguments: &[String]) {
    let result = read_result(&folder.join("out"));
    assert!(!result.is_empty(), "{}", row.input);
    for (name, content) in result.into_iter().filter(|(name, _)| name != Path::new(MANIFEST)) {
        let text = String::from_utf8(content).unwrap();
        assert_eq!(has_right_checksum(&text), Some(true), "{}: {}", row.input, name.display());
        let file = name.file_name().unwrap().to_string_lossy().into_owned();
        let shared = file.contains("axgen") || file.starts_with("IMPORT") || name.starts_with("rust");
        assert!(shared || file.contains("axis_"), "{}: {file}", row.input);
    }
    let set: Vec<&str> = arguments.iter().map(String::as_str).take_while(|argument| *argument != "--target").collect();
    let run = axgen(folder, ["verify"].into_iter().chain(set).chain(["--samples", "20"]));
    assert_eq!(run.code, 0, "{}: {}{}", row.input, run.out, run.err);
}
