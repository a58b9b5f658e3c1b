//! Writes the generated files into their folder, with the manifest, and removes leftovers of earlier runs.
//!
//! The manifest is replaced first, and still names files that will be removed; they are deleted from it last. A run that is
//! killed at any point leaves a manifest that names every generated file, and at worst some files that do not exist.

use crate::exit::Exit;
use crate::generate::refused;
use crate::leftovers::{Leftovers, Scope};
use crate::recorded::Recorded;
use commands::plan::Plan;
use generator::digest::is_text;
use generator::manifest::{self, Manifest};
use generator::target::File;
use generator::write::{self, Folder, Written};
use std::path::{Path, PathBuf};

/// The result of writing.
pub struct Done {
    /// paths of the generated files
    pub paths: Vec<PathBuf>,
    pub written: Written,
    pub leftovers: Leftovers,
}

/// Locks a folder, and reads its manifest for a set. Files that a killed run was about to remove are restored, and judged
/// again.
pub fn open(out: &Path, set: &Path) -> Result<(Folder, Recorded), Exit> {
    let folder = write::open(out).map_err(refused)?;
    folder.path_of(manifest::NAME).map_err(refused)?;
    let recorded = Recorded::read(out, set)?;
    recorded.manifest.iter().try_for_each(|entry| folder.path_of(&entry.file).map(drop)).map_err(refused)?;
    Ok((folder, recorded))
}

/// Writes all files, or none.
pub fn write(
    folder: Folder,
    plan: &Plan<'_>,
    recorded: &Recorded,
    scope: &Scope<'_>,
    force: bool,
) -> Result<Done, Exit> {
    let files = plan.files(&recorded.set, |file| write::stage(&folder, file));
    let made = files.iter().map(|(name, entry, _)| (name.as_str(), entry.as_ref())).collect();
    let leftovers = Leftovers::new(recorded, scope, &made);
    let staged = files.into_iter().map(|(.., staged)| staged).collect::<Result<Vec<_>, _>>().map_err(refused)?;
    let paths = staged.iter().map(|file| file.path.clone()).collect();

    let record = |manifest: &Manifest, before: Option<&[u8]>| {
        let file = File { name: manifest::NAME.to_owned(), text: manifest::text(manifest) };
        let is_there = before.is_some_and(|before| is_text(before, &file.text));
        (!is_there).then(|| write::record(&folder, &file))
    };
    let first = record(&leftovers.meanwhile, recorded.text.as_deref());
    let removals = leftovers.removed.iter().map(|file| write::removal(&folder, file));
    let changes = first.into_iter().chain(staged.into_iter().map(Ok)).chain(removals).collect();
    let written = write::commit_in(&folder, changes, force).map_err(refused)?;
    let last = record(&leftovers.after, Some(manifest::text(&leftovers.meanwhile).as_bytes()));
    write::commit(folder, last.into_iter().collect(), force).map_err(refused)?;
    Ok(Done { paths, written, leftovers })
}
