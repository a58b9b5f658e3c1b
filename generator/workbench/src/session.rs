//! The files of the page, the set that was read last, and what was made from them.

use crate::request::{Response, Subject};
use commands::files::Files;
use generator::codes;
use generator::config::{ListOptions, OptionKey, Unreadable, is_set};
use generator::diagnostics::{Diagnostic, Place, Report, Severity, Slashes};
use generator::digest::digest;
use generator::parameters::Name;
use generator::pipeline::{self, Shown};
use golden::tune::Tuning;
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::sync::{Mutex, PoisonError};

#[derive(Default)]
pub struct Session {
    pub files: Files,
    pub set: Option<Open>,
    pub tuning: Option<Proposed>,
    /// its name and its bytes
    pub archive: Option<(String, Vec<u8>)>,
}

/// A set that was read.
pub struct Open {
    /// its file
    pub name: String,
    /// as far as it could be read, with the responses of the page
    pub shown: Shown,
    /// the set as the command reads it, if the page has responses: blocks are generated from it. `None` in it: refused.
    plain: Option<Option<Shown>>,
}

impl Open {
    /// The set from which blocks are generated, if it is free of errors, with and without the responses of the page.
    pub fn allowed(&self) -> Option<&Shown> {
        let plain = self.plain.as_ref().map_or(Some(&self.shown), Option::as_ref);
        plain.filter(|plain| plain.is_allowed && self.shown.is_allowed)
    }
}

/// Proposals, and what they were made from.
pub struct Proposed {
    pub of: Subject,
    pub axis: String,
    /// each file of the page with its digest
    pub files: Vec<(PathBuf, String)>,
    pub tuning: Tuning,
}

impl Session {
    /// Takes a set as the one that is open, and reads it once more without the responses of the page. What is refused without
    /// them is an error: the set does not contain them.
    pub fn open(&mut self, of: &Subject, shown: Option<Shown>, report: &mut Report) {
        let alone = Subject { responses: Vec::new(), ..of.clone() };
        let read = || pipeline::read_to_show(of.path(), &alone.options(), &load(&self.files));
        let plain = (!of.responses.is_empty()).then(read);
        if let Some((_, refused)) = plain.as_ref().filter(|(_, refused)| refused.has_errors() && !report.has_errors()) {
            let found = "is refused without the dropped response, which is not in the set: no block is generated";
            let instead = "drive.response = \"FILE\" in [axis.NAME] of the set; for a list, a set with list = \"FILE\"";
            let said = Diagnostic::error(codes::USAGE, Place::whole(&of.set), found).instead(instead);
            report.push(said);
            report
                .diagnostics
                .extend(refused.diagnostics.iter().filter(|said| said.severity == Severity::Error).cloned());
        }
        let plain = plain.map(|(plain, _)| plain);
        self.set = shown.map(|shown| Open { name: of.set.clone(), shown, plain });
    }

    /// The files of the page, each with its digest.
    pub fn digests(&self) -> Vec<(PathBuf, String)> {
        self.files.0.iter().map(|(path, bytes)| (path.clone(), digest(bytes))).collect()
    }

    /// Keeps another content of a file of the page; returns its name.
    pub fn put(&mut self, path: PathBuf, bytes: Vec<u8>) -> String {
        let is_known = self.files.0.contains_key(&path);
        let path = if is_known { path } else { path.file_name().map(PathBuf::from).unwrap_or(path) };
        let name = path.to_string_lossy().into_owned();
        self.files.0.insert(path, bytes);
        name
    }
}

/// Loads a file by its path, else by its name, in the first folder of the path or alone: a page has no folders but that of
/// an older version. Two paths must not lead to one file.
pub fn load(files: &Files) -> impl Fn(&Path) -> Result<Vec<u8>, Unreadable> + Sync + '_ {
    let paths = Mutex::new(BTreeMap::<PathBuf, PathBuf>::new());
    move |path: &Path| {
        let alone = Path::new(path.file_name().unwrap_or_default());
        let in_first = path.iter().next().map(|first| Path::new(first).join(alone)).unwrap_or_default();
        let name = [path, &in_first, alone].into_iter().find(|name| files.0.contains_key(*name)).unwrap_or(path);
        let bytes = files.load(name)?;
        let mut paths = paths.lock().unwrap_or_else(PoisonError::into_inner);
        let first = paths.entry(name.to_owned()).or_insert_with(|| path.to_owned());
        if first == path {
            return Ok(bytes);
        }
        let first = first.slashes();
        Err(Unreadable::System(format!(
            "the page has one file of this name, and takes it for {first}: rename one of both"
        )))
    }
}

impl Subject {
    /// What its list does not contain.
    pub fn options(&self) -> ListOptions {
        let given = |text: &Option<String>| text.clone().filter(|text| !text.trim().is_empty());
        let response = |of: &Response| OptionKey {
            axis: Some(of.axis.clone()),
            option: "response".to_owned(),
            name: Name::DriveResponse,
            index: [0, 0],
            text: of.file.clone(),
        };
        let is_list = !is_set(self.path());
        ListOptions {
            cycle_time: given(&self.cycle_time).filter(|_| is_list),
            name: given(&self.name).filter(|_| is_list),
            keys: self.responses.iter().map(response).collect(),
        }
    }

    pub fn path(&self) -> &Path {
        Path::new(&self.set)
    }
}
