//! The files of a request, by their names, for requests that do not come from a disk.

use generator::config::{LARGEST, Unreadable};
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

/// Files with their contents. A set names its other files relative to itself.
#[derive(Clone, Debug, Default)]
pub struct Files(pub BTreeMap<PathBuf, Vec<u8>>);

impl Files {
    /// The content of a file, for [`generator::config::Load`].
    ///
    /// # Errors
    /// There is no such file, or it is too large.
    pub fn load(&self, path: &Path) -> Result<Vec<u8>, Unreadable> {
        match self.0.get(path) {
            None => Err(Unreadable::System("there is no such file".to_owned())),
            Some(bytes) if bytes.len() as u64 > LARGEST => Err(Unreadable::TooLarge),
            Some(bytes) => Ok(bytes.clone()),
        }
    }
}
