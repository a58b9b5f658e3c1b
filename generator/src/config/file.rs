//! Reads a file up to a limit; only the encoding of its content is examined.

use super::{encoding, encoding::Encoding, source::Source, value::shown, values::Setting};
use crate::codes;
use crate::diagnostics::{Diagnostic, Place, Report, Slashes};
use std::fmt::Display;
use std::fs::{self, File};
use std::io::{self, ErrorKind, Read};
use std::{path::Path, sync::Arc};

pub type Load<'a> = &'a (dyn Fn(&Path) -> Result<Vec<u8>, Unreadable> + Sync);

#[derive(Debug)]
pub enum Unreadable {
    /// larger than any file of its kind
    TooLarge,
    /// the system's message
    System(String),
}

impl Unreadable {
    /// The code of the message, and its text after the name of the file.
    pub fn said(&self) -> (&'static str, String) {
        match self {
            Self::TooLarge => (codes::TOO_LARGE, "is too large".to_owned()),
            Self::System(reason) => (codes::UNREADABLE, format!("cannot be read: {reason}")),
        }
    }

    /// The message about the file.
    pub fn diagnostic(&self, file: impl Display) -> Diagnostic {
        let (code, found) = self.said();
        Diagnostic::error(code, Place::whole(file), found)
    }
}

/// A set of 10,000 axes written out in full has 20 MB; a larger file is something else.
pub const LARGEST: u64 = 64 << 20;

/// The limit for a file of samples: an hour of four signals at 1 ms.
pub const LARGEST_SAMPLES: u64 = 256 << 20;

/// The bytes of a set, of a list, or of a generated file on this host.
pub fn load(path: &Path) -> Result<Vec<u8>, Unreadable> {
    load_up_to(path, LARGEST)
}

/// The bytes of a regular file with at most `most` bytes.
pub fn load_up_to(path: &Path, most: u64) -> Result<Vec<u8>, Unreadable> {
    // Opening a pipe waits for a writer, and a device never ends: both are refused before.
    let metadata = fs::metadata(path).map_err(of_system)?;
    if metadata.is_dir() {
        return Err(of_system(ErrorKind::IsADirectory.into()));
    }
    if !metadata.is_file() {
        return Err(Unreadable::System("it is not a regular file, but a device, a pipe or a socket".to_owned()));
    }
    if metadata.len() > most {
        return Err(Unreadable::TooLarge);
    }
    let file = File::open(path).map_err(of_system)?;
    // Some regular files of the system report a size of 0, and others grow.
    load_from(file, Vec::with_capacity(usize::try_from(metadata.len()).unwrap_or(0) + 1), most)
}

/// The given bytes and all bytes of an open file or of standard input, at most `most`.
pub fn load_from(source: impl Read, mut bytes: Vec<u8>, most: u64) -> Result<Vec<u8>, Unreadable> {
    source.take(most + 1).read_to_end(&mut bytes).map_err(of_system)?;
    if bytes.len() as u64 > most { Err(Unreadable::TooLarge) } else { Ok(bytes) }
}

/// The message in the same words on every host, without the system's error number.
fn of_system(error: io::Error) -> Unreadable {
    Unreadable::System(match error.kind() {
        ErrorKind::NotFound => "there is no such file".to_owned(),
        ErrorKind::PermissionDenied => "no permission to read it".to_owned(),
        ErrorKind::IsADirectory => "it is a folder".to_owned(),
        ErrorKind::NotADirectory => "a part of its path is not a folder".to_owned(),
        ErrorKind::InvalidInput => "no file can have this name".to_owned(),
        _ => error.to_string(),
    })
}

/// Whether a file is a TOML set; any other is an axis list.
pub fn is_set(path: &Path) -> bool {
    path.extension().is_some_and(|extension| extension.eq_ignore_ascii_case("toml"))
}

/// A file, by its name in messages. If it cannot be read, the place of the message is where the file is named; for a file on
/// the command line, the file itself.
pub(crate) fn read(path: &Path, named_at: Option<&Setting>, load: Load<'_>) -> Result<Arc<Source>, Report> {
    let bytes = bytes(path, "a set or an axis list", named_at, load)?;
    // TOML, and so a set, is always UTF-8.
    let (text, encoding) = if is_set(path) { (bytes, Encoding::Plain) } else { encoding::decoded(bytes) };
    Ok(Source::new(&Place::whole(path.slashes()).file, text, encoding))
}

/// The bytes of a file; `kind` is the expected kind of file.
pub(crate) fn bytes(path: &Path, kind: &str, named_at: Option<&Setting>, load: Load<'_>) -> Result<Vec<u8>, Report> {
    load(path).map_err(|unreadable| {
        let whole = Place::whole(path.slashes());
        let file = shown(&whole.file);
        let (code, found) = unreadable.said();
        let error = |found| Diagnostic::error(code, named_at.map_or(whole, Setting::value_place), found);
        Report::from(match unreadable {
            Unreadable::TooLarge => {
                error(format!("{file} {found} for {kind}")).allowed(format!("{} MiB", LARGEST >> 20))
            }
            Unreadable::System(_) if named_at.is_some() => error(format!("{file} {found}"))
                .allowed("a file that can be read; its path begins at the folder of the set"),
            Unreadable::System(_) => error(format!("{file} {found}")),
        })
    })
}
