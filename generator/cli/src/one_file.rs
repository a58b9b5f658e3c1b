//! Writing one file that a command was asked for, or standard output, and not over an input; what is in it does not matter.

use crate::exit::Exit;
use crate::output;
use generator::codes;
use std::fs::{self, OpenOptions};
use std::io::{self, ErrorKind, Write};
use std::path::Path;

/// Writes to the file; without one, or to `-`, to standard output. A file that is there is replaced only by force, and then as
/// a whole or not at all.
pub fn write(out: Option<&Path>, bytes: &[u8], force: bool) -> Result<(), Exit> {
    let Some(path) = out.filter(|path| path.as_os_str() != "-") else {
        return output::print(bytes);
    };
    let failed = |error: io::Error| match error.kind() {
        ErrorKind::AlreadyExists => Exit::input(
            codes::NOT_OURS,
            path.display(),
            "is there already; give another name, or --force to replace it",
        ),
        _ => Exit::unwritable(path.display(), format!("{error}; nothing was written")),
    };
    let mut name = path.file_name().unwrap_or_default().to_owned();
    name.push(format!(".axgen-staged-{}", std::process::id()));
    let staged = path.with_file_name(name);
    let target = if force { &staged } else { path };
    let mut file = OpenOptions::new().write(true).create_new(true).open(target).map_err(failed)?;
    let written = file.write_all(bytes).and_then(|()| file.sync_all());
    drop(file);
    let written = if force { written.and_then(|()| fs::rename(&staged, path)) } else { written };
    written.map_err(|error| {
        let _ = fs::remove_file(target); // of the two errors the first is the one to say
        failed(error)
    })
}

/// Refuses a file to write that the command reads itself.
pub fn kept_apart<'p>(out: &Path, mut inputs: impl Iterator<Item = &'p Path>) -> Result<(), Exit> {
    match inputs.any(|input| is_same(input, out)) {
        true => Err(Exit::input(codes::NOT_OURS, out.display(), "is an input of this run; give another name")),
        false => Ok(()),
    }
}

/// Whether two paths lead to one regular file, whatever its names are. Devices may be both.
fn is_same(one: &Path, other: &Path) -> bool {
    let (Ok(one), Ok(other)) = (fs::canonicalize(one), fs::canonicalize(other)) else { return false };
    let (Ok(found), Ok(of_other)) = (fs::metadata(&one), fs::metadata(&other)) else { return false };
    found.is_file() && (one == other || has_one_content(&found, &of_other))
}

#[cfg(unix)]
fn has_one_content(one: &fs::Metadata, other: &fs::Metadata) -> bool {
    use std::os::unix::fs::MetadataExt;
    (one.dev(), one.ino()) == (other.dev(), other.ino())
}

#[cfg(not(unix))]
fn has_one_content(_: &fs::Metadata, _: &fs::Metadata) -> bool {
    false
}
