//! An axis list to a set and back: to the byte, and with the same meaning; files are in memory.

mod comments;
mod edges;
mod edited;
mod examples;
mod large;
mod random;
mod spelling;
mod unread;

use generator::config::{ListOptions, Unreadable};
use generator::diagnostics::Report;
use generator::import_export;
use generator::pipeline::read_with;
use std::path::Path;

const IPC: &str = "lr_param.improved_position_control.";

type File<'f> = (&'f str, &'f [u8]);

fn load(files: &[File<'_>], path: &Path) -> Result<Vec<u8>, Unreadable> {
    let found = files.iter().find(|(name, _)| path == Path::new(name));
    found.map(|(_, bytes)| bytes.to_vec()).ok_or(Unreadable::System("there is no such file".to_owned()))
}

/// The set of a list `x.lis` at a cycle time of 1 ms.
fn import(list: impl AsRef<[u8]>) -> (Option<String>, Report) {
    import_at(Some("1ms"), list)
}

/// The same at another cycle time, or without.
fn import_at(cycle_time: Option<&str>, list: impl AsRef<[u8]>) -> (Option<String>, Report) {
    let options =
        ListOptions { cycle_time: cycle_time.map(str::to_owned), name: Some("X".to_owned()), ..ListOptions::default() };
    let files: [File<'_>; 1] = [("x.lis", list.as_ref())];
    let (set, report) = import_export::import(Path::new("x.lis"), &options, &|path| load(&files, path));
    assert_eq!(set.is_none(), report.has_errors(), "{report}");
    (set, report)
}

/// The same of a list in which nothing is wrong.
fn imported(list: impl AsRef<[u8]>) -> String {
    let (set, report) = import(list);
    set.unwrap_or_else(|| panic!("{report}"))
}

/// The list of the only axis of a set `set.toml`, next to other files.
fn export_beside(set: &str, others: &[File<'_>]) -> (Option<Vec<u8>>, Report) {
    let mut files: Vec<File<'_>> = others.to_vec();
    files.push(("set.toml", set.as_bytes()));
    let (list, report) = import_export::export(Path::new("set.toml"), None, &|path| load(&files, path));
    assert_eq!(list.is_none(), report.has_errors(), "{report}");
    (list, report)
}

/// The list of the only axis of a set in which nothing is wrong.
fn exported(set: &str) -> Vec<u8> {
    let (list, report) = export_beside(set, &[]);
    list.unwrap_or_else(|| panic!("{report}\n{set}"))
}

/// The same as text.
fn exported_text(set: &str) -> String {
    String::from_utf8(exported(set)).expect("the list is UTF-8")
}

/// What the blocks of an axis depend on, or what is said against them without the places.
fn meaning(name: &str, bytes: &[u8]) -> Result<String, Vec<(&'static str, String)>> {
    let cycle_time = (!name.ends_with("toml")).then(|| "1ms".to_owned());
    let options =
        ListOptions { name: cycle_time.is_some().then(|| "X".to_owned()), cycle_time, ..ListOptions::default() };
    let files: [File<'_>; 1] = [(name, bytes)];
    let (set, report) = read_with(Path::new(name), &options, &|path| load(&files, path));
    let said = || report.diagnostics.iter().map(|said| (said.code, said.found.clone())).collect();
    set.map(|mut set| set.axes.remove(0).axis.canonical).ok_or_else(said)
}

/// Imports and exports a list: the same bytes; the set says what the list said, to the reader and about the same axis.
fn round_trip(list: &[u8]) -> String {
    let set = imported(list);
    let again = exported(&set);
    assert_eq!(String::from_utf8_lossy(&again), String::from_utf8_lossy(list), "{set}");
    assert_eq!(again, list, "{set}");
    assert_eq!(imported(&again), set);
    set
}
