//! Writing one file that a command was asked for, or standard output; what is in it does not matter.

use crate::exit::Exit;
use std::fs::{self, OpenOptions};
use std::io::{self, ErrorKind, Write};
use std::path::Path;

/// Writes to the file; without one, or to `-`, to standard output. A file that is there is replaced only by force, and then as
/// a whole or not at all.
pub fn write(out: Option<&Path>, bytes: &[u8], force: bool) -> Result<(), Exit> {
    let Some(path) = out.filter(|path| path.as_os_str() != "-") else {
        let written = io::stdout().write_all(bytes).and_then(|()| io::stdout().flush());
        return written.map_err(|error| Exit::environment(format!("standard output: {error}")));
    };
    let failed = |error: io::Error| match error.kind() {
        ErrorKind::AlreadyExists => {
            Exit::input(format!("{}: is there already; give another name, or --force to replace it", path.display()))
        }
        _ => Exit::environment(format!("{}: {error}; nothing was written", path.display())),
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
