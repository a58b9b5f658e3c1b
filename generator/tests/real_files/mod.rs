//! Files as machines, manuals and people have them: what is read from them, what is said of them, and that they come
//! back to the byte. `UPDATE_EXPECT=1 cargo test -p axgen-generator --test all real_files` writes the transcripts anew;
//! read their difference.

mod encodings;
mod ends;
mod kinds;
mod listings;
mod mistakes;
mod nc_axes;
mod projects;
mod signs;

use generator::config::{ListOptions, Unreadable};
use generator::diagnostics::Report;
use generator::import_export;
use generator::pipeline::{Set, read_with};
use std::path::Path;

const IPC: &str = "lr_param.improved_position_control.";

/// A list about which nothing is said.
const VALID: &str = include_str!("valid.lis");

type File<'f> = (&'f str, &'f [u8]);

fn load(files: &[File<'_>], path: &Path) -> Result<Vec<u8>, Unreadable> {
    let found = files.iter().find(|(name, _)| path == Path::new(name));
    found.map(|(_, bytes)| bytes.to_vec()).ok_or(Unreadable::System("there is no such file".to_owned()))
}

/// What `check` makes of the first of some files; of a list at a cycle time of 1 ms.
fn read(files: &[File<'_>]) -> (Option<Set>, Report) {
    read_named(files, None)
}

fn read_named(files: &[File<'_>], name: Option<&str>) -> (Option<Set>, Report) {
    let path = Path::new(files[0].0);
    let is_set = path.extension().is_some_and(|extension| extension == "toml");
    let cycle_time = (!is_set).then(|| "1ms".to_owned());
    read_with(path, &ListOptions { cycle_time, name: name.map(str::to_owned), ..ListOptions::default() }, &|path| {
        load(files, path)
    })
}

/// What the axis of a list in which nothing is wrong depends on.
fn canonical(file: File<'_>) -> String {
    let (set, report) = read(&[file]);
    set.unwrap_or_else(|| panic!("{report}")).axes.remove(0).axis.canonical
}

/// Imports and exports a file: the same bytes, and the set means what the file means.
fn round_trip(file: File<'_>) -> String {
    let options =
        ListOptions { cycle_time: Some("1ms".to_owned()), name: Some("X".to_owned()), ..ListOptions::default() };
    let (set, report) = import_export::import(Path::new(file.0), &options, &|path| load(&[file], path));
    let set = set.unwrap_or_else(|| panic!("{report}"));
    assert_eq!(exported(&[("set.toml", set.as_bytes())]), file.1, "{set}");
    assert_eq!(canonical(("set.toml", set.as_bytes())), canonical(file), "{set}");
    set
}

/// The list of the only axis of the first of some files.
fn exported(files: &[File<'_>]) -> Vec<u8> {
    let (list, report) = import_export::export(Path::new(files[0].0), None, &|path| load(files, path));
    list.unwrap_or_else(|| panic!("{report}"))
}

/// Compares with a transcript next to these tests.
fn assert_transcript(name: &str, said: &str) {
    transcript::equals(Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/real_files").join(name), said);
}
