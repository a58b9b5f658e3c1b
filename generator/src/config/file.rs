//! Reading a file as bytes, bounded; no content is looked at.

use super::value::shown;
use crate::codes;
use crate::diagnostics::{Diagnostic, Place};
use std::fs::File;
use std::io::{self, Read};
use std::path::Path;

/// How files are read.
pub type Load<'a> = &'a (dyn Fn(&Path) -> Result<Vec<u8>, Unreadable> + Sync);

/// Why a file cannot be read.
#[derive(Debug)]
pub enum Unreadable {
    /// it holds more bytes than any set or list
    TooLarge,
    /// what the system says
    System(String),
}

/// A set of 10,000 axes that are written out in full has 20 MB; what is larger is something else.
pub const LARGEST: u64 = 64 << 20;

/// Reads a file.
///
/// # Errors
/// If the system does not let us, or the file is too large.
pub fn load(path: &Path) -> Result<Vec<u8>, Unreadable> {
    let mut bytes = Vec::new();
    let file = File::open(path).map_err(of_system)?;
    let expected = file.metadata().map_or(0, |metadata| metadata.len());
    if expected > LARGEST {
        return Err(Unreadable::TooLarge);
    }
    bytes.reserve_exact(usize::try_from(expected).unwrap_or(0) + 1);
    // A device says that it is empty and never ends.
    file.take(LARGEST + 1).read_to_end(&mut bytes).map_err(of_system)?;
    if bytes.len() as u64 > LARGEST { Err(Unreadable::TooLarge) } else { Ok(bytes) }
}

/// The same words on every host, without the system's number.
fn of_system(error: io::Error) -> Unreadable {
    Unreadable::System(match error.kind() {
        io::ErrorKind::NotFound => "there is no such file".to_owned(),
        io::ErrorKind::PermissionDenied => "no permission to read it".to_owned(),
        io::ErrorKind::IsADirectory => "it is a folder".to_owned(),
        _ => error.to_string(),
    })
}

impl Unreadable {
    /// The message about a file, at the place where it is named.
    pub(super) fn diagnostic(self, file: &str, place: Place) -> Diagnostic {
        let file = shown(file);
        match self {
            Self::TooLarge => {
                let found = format!("{file} is too large for a set or an axis list");
                Diagnostic::error(codes::TOO_LARGE, place, found).allowed(format!("{} MiB", LARGEST >> 20))
            }
            Self::System(reason) => {
                Diagnostic::error(codes::UNREADABLE, place, format!("{file} cannot be read: {reason}"))
            }
        }
    }
}
