//! The files of the page, and the set that was read last.

use crate::request::Subject;
use commands::files::Files;
use generator::config::{ListOptions, OptionKey, Unreadable, is_set};
use generator::parameters::Name;
use generator::pipeline::Shown;
use golden::tune::Tuning;
use std::path::{Path, PathBuf};

#[derive(Default)]
pub struct Session {
    pub files: Files,
    /// the name of its file, and the set as far as it could be read
    pub set: Option<(String, Shown)>,
    pub tuning: Option<Tuning>,
}

impl Session {
    /// Keeps another content of a file of the page; returns its name.
    pub fn put(&mut self, path: PathBuf, bytes: Vec<u8>) -> String {
        let is_known = self.files.0.contains_key(&path);
        let path = if is_known { path } else { path.file_name().map(PathBuf::from).unwrap_or(path) };
        let name = path.to_string_lossy().into_owned();
        self.files.0.insert(path, bytes);
        name
    }
}

/// Loads a file by its path, else by its name alone: a page has no folders.
pub fn load(files: &Files) -> impl Fn(&Path) -> Result<Vec<u8>, Unreadable> + Sync + '_ {
    |path: &Path| {
        files.load(path).or_else(|missing| match path.file_name() {
            Some(name) if Path::new(name) != path => files.load(Path::new(name)),
            _ => Err(missing),
        })
    }
}

impl Subject {
    /// What its list does not contain.
    pub fn options(&self) -> ListOptions {
        let given = |text: &Option<String>| text.clone().filter(|text| !text.trim().is_empty());
        let response = given(&self.response).map(|text| OptionKey {
            option: "response".to_owned(),
            name: Name::DriveResponse,
            index: [0, 0],
            text,
        });
        let is_list = !is_set(self.path());
        ListOptions {
            cycle_time: given(&self.cycle_time).filter(|_| is_list),
            name: given(&self.name).filter(|_| is_list),
            keys: response.into_iter().collect(),
        }
    }

    pub fn path(&self) -> &Path {
        Path::new(&self.set)
    }
}
