//! The manifest of an output folder, and the folder itself, before a run: the owners of its files.

use crate::exit::Exit;
use generator::config;
use generator::diagnostics::Slashes;
use generator::manifest::{self, Entry, Manifest};
use generator::pipeline::Set;
use generator::target::{FOLDERS, Target, Unit, head};
use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::{Path, PathBuf};

/// The manifest of a folder, as found by a set.
#[derive(Debug)]
pub struct Recorded {
    pub out: PathBuf,
    /// the name of the set
    pub set: String,
    pub manifest: Manifest,
    /// the text of the file; `None` if it does not exist
    pub text: Option<Vec<u8>>,
}

impl Recorded {
    /// Reads the manifest of a folder for a set.
    pub fn read(out: &Path, set: &Path) -> Result<Self, Exit> {
        let path = out.join(manifest::NAME);
        let text = match config::load(&path) {
            Ok(bytes) => Some(bytes),
            Err(_) if fs::symlink_metadata(&path).is_err() => None,
            Err(unreadable) => return Err(Exit::Environment(unreadable.diagnostic(path.slashes()).into())),
        };
        let manifest = text.as_deref().map_or(Ok(Manifest::new()), |bytes| {
            manifest::read(&String::from_utf8_lossy(bytes), &path.slashes()).map_err(Exit::Input)
        })?;
        Ok(Self { out: out.to_owned(), set: manifest::set_name(set), manifest, text })
    }

    /// The targets of the set's files in the folder.
    pub fn targets(&self) -> BTreeSet<&str> {
        self.manifest.iter().filter(|entry| entry.set == self.set).map(|entry| entry.target.as_str()).collect()
    }

    /// The axes of other sets in the folder for a target, if all their files exist.
    pub fn units_of_others(&self, set: &Set, target: &Target) -> Vec<Unit<'_>> {
        let own: BTreeSet<String> = set.axes.iter().map(|of| of.axis.name.to_ascii_lowercase()).collect();
        let mut of_axes: BTreeMap<&str, BTreeSet<&str>> = BTreeMap::new();
        for Entry { file, target: of, axis, set } in &self.manifest {
            if let Some(axis) = axis
                && *set != self.set
                && of == target.name
                && !own.contains(&axis.to_ascii_lowercase())
            {
                of_axes.entry(axis).or_default().insert(file);
            }
        }
        of_axes.into_iter().filter_map(|(axis, files)| self.unit(axis, &files)).collect()
    }

    fn unit<'r>(&'r self, axis: &'r str, files: &BTreeSet<&str>) -> Option<Unit<'r>> {
        let files = files.iter().map(|file| Some((*file, self.content(file)?))).collect::<Option<Vec<_>>>()?;
        head::unit(axis, &files)
    }

    /// The generated files of the folder that the manifest does not list and that the run does not generate.
    pub fn unlisted(&self, made: &BTreeSet<&str>) -> Vec<String> {
        let listed: BTreeSet<&str> = self.manifest.iter().map(|entry| entry.file.as_str()).collect();
        let mut unlisted: Vec<String> = FOLDERS.iter().flat_map(|folder| self.names(folder)).collect();
        unlisted.retain(|file| {
            !listed.contains(file.as_str())
                && !made.contains(file.as_str())
                && self.content(file).is_some_and(|text| head::is_generated(file, &text))
        });
        unlisted.sort();
        unlisted
    }

    /// The regular files of a folder below the output folder, by name, that may be generated ones.
    fn names(&self, folder: &str) -> Vec<String> {
        const ENDS: [&str; 12] =
            ["c", "h", "a2l", "rs", "toml", "st", "scl", "xml", "md", "TcPOU", "TcDUT", "plcproj-fragment"];
        let entries = fs::read_dir(self.out.join(folder)).into_iter().flatten().flatten();
        let files = entries.filter(|entry| entry.file_type().is_ok_and(|found| found.is_file()));
        let names = files.filter_map(|entry| entry.file_name().into_string().ok());
        let names = names.filter(|name| name.rsplit_once('.').is_some_and(|(_, end)| ENDS.contains(&end)));
        names.map(|name| format!("{folder}{name}")).collect()
    }

    /// The text of a file of the folder, if it can be read.
    fn content(&self, file: &str) -> Option<String> {
        config::load(&self.out.join(file)).ok().map(|bytes| String::from_utf8_lossy(&bytes).into_owned())
    }
}
