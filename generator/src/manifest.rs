//! The manifest of an output folder: the set from which each of its files was generated. Text only; the disk is not accessed
//! here.
//!
//! One line for each file and set, sorted. Every line is independent: version control merges two versions by keeping the
//! lines of both. The manifest has no digests, which would change with every parameter: each file has its own.

use crate::codes;
use crate::diagnostics::{Diagnostic, Place, Report};
use std::collections::BTreeSet;
use std::fmt::Write;
use std::path::Path;

/// The manifest's name in its folder.
pub const NAME: &str = "axgen.manifest";

const HEAD: &str = "\
# Which set axgen has generated each file of this folder from. Keep this file with them, in version control too: by it
# `axgen generate` removes what a set no longer generates. Each line stands alone: to merge two versions, keep all lines.
# file target axis set
";

/// The placeholder for the axis of a file that all axes share.
const SHARED: &str = "-";

/// A file and its source.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Entry {
    /// below the folder, with `/` between its parts
    pub file: String,
    /// the name of its target; [`crate::generate::PAGE`] if no target prints it
    pub target: String,
    /// `None` if all axes share it
    pub axis: Option<String>,
    /// the name of the set, from [`set_name`]
    pub set: String,
}

/// All entries of a folder.
pub type Manifest = BTreeSet<Entry>;

/// The name of a set in a manifest: the file name without the folder, which differs from machine to machine.
pub fn set_name(set: &Path) -> String {
    Place::whole(set.file_name().unwrap_or(set.as_os_str()).to_string_lossy()).file
}

pub fn text(manifest: &Manifest) -> String {
    manifest.iter().fold(HEAD.to_owned(), |mut text, Entry { file, target, axis, set }| {
        let _ = writeln!(text, "{file} {target} {} {set}", axis.as_deref().unwrap_or(SHARED));
        text
    })
}

/// Reads a manifest; `path` is its name in messages.
///
/// # Errors
/// A line is not an entry: two versions were not merged, or the file was edited.
pub fn read(text: &str, path: &str) -> Result<Manifest, Report> {
    let (mut manifest, mut report) = (Manifest::new(), Report::default());
    for (number, line) in text.lines().enumerate().filter(|(_, line)| !line.is_empty() && !line.starts_with('#')) {
        match entry(line) {
            Some(entry) => {
                manifest.insert(entry);
            }
            None => report.push(not_an_entry(path, number + 1)),
        }
    }
    if report.has_errors() { Err(report.shortened()) } else { Ok(manifest) }
}

fn entry(line: &str) -> Option<Entry> {
    let mut words = line.splitn(4, ' ');
    let [file, target, axis, set] = [words.next()?, words.next()?, words.next()?, words.next()?];
    let is_entry = is_below(file) && ![target, axis, set].contains(&"");
    let axis = (axis != SHARED).then(|| axis.to_owned());
    is_entry.then(|| Entry { file: file.to_owned(), target: target.to_owned(), axis, set: set.to_owned() })
}

/// Whether a file of that name lies below the folder on every host.
fn is_below(file: &str) -> bool {
    let is_plain = |c: char| c.is_ascii_alphanumeric() || "_-.".contains(c);
    file.split('/').all(|part| !part.starts_with('.') && !part.is_empty() && part.chars().all(is_plain))
}

fn not_an_entry(path: &str, line: usize) -> Diagnostic {
    let place = Place { line, ..Place::whole(path) };
    Diagnostic::error(codes::MANIFEST, place, "the line is not an entry of a manifest")
        .allowed("FILE TARGET AXIS SET, separated by one space; a line that begins with #")
        .instead("all entries of both versions, if they were merged; else take the line out, or delete the file: it is written again")
}
