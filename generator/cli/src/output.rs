//! The two streams: every text of the command goes through here. A standard output that takes no more is the environment,
//! and ends the command; nobody can be told that standard error takes no more.

use crate::exit::Exit;
use std::io::{self, Write};

/// Prints what was asked for, found or done.
pub fn print(text: impl AsRef<[u8]>) -> Result<(), Exit> {
    let mut out = io::stdout().lock();
    taken(out.write_all(text.as_ref()).and_then(|()| out.flush()))
}

/// The same with the end of a line.
pub fn line(text: impl std::fmt::Display) -> Result<(), Exit> {
    print(format!("{text}\n"))
}

/// What came of writing to standard output.
pub fn taken(written: io::Result<()>) -> Result<(), Exit> {
    written.map_err(|error| Exit::unwritable("standard output", error))
}

/// Says a message.
pub fn say(text: &str) {
    let _ = io::stderr().write_all(text.as_bytes());
}
