//! Running the command with limits of time and memory; looking at folders.

use crate::Run;
use crate::limited::{self, Limits};
use std::path::{Path, PathBuf};
use std::{collections::BTreeMap, fs};
use std::{process::Stdio, time::Duration};

/// No input may keep the command busy for longer.
const LIMITS: Limits = Limits { time: Duration::from_secs(10), memory: 1_048_576 };

pub fn axgen<'a>(folder: &Path, arguments: impl IntoIterator<Item = &'a str>) -> Run {
    let output = limited::run(folder, arguments, Stdio::null(), &LIMITS);
    let err = String::from_utf8(output.stderr).unwrap();
    let code = output.status.code().unwrap_or_else(|| panic!("{}: {err}", output.status));
    Run { code, out: String::from_utf8(output.stdout).unwrap(), err }
}

pub fn files(folder: &Path) -> Vec<PathBuf> {
    let mut found: Vec<PathBuf> = Vec::new();
    for entry in fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        if fs::symlink_metadata(&path).unwrap().is_dir() {
            found.extend(files(&path));
        }
        found.push(path);
    }
    found.sort();
    found
}

/// The files below a folder with what is in them.
pub fn read_result(folder: &Path) -> BTreeMap<PathBuf, Vec<u8>> {
    let regular = files(folder).into_iter().filter(|path| path.is_file());
    regular.map(|path| (path.strip_prefix(folder).unwrap().to_owned(), fs::read(&path).unwrap())).collect()
}
