//! The two streams: every text of the command is printed here. If standard output cannot be written, this is an error of the
//! environment and ends the command. An error on standard error cannot be reported.

use crate::exit::Exit;
use std::io::{self, Write};

/// Prints the result of the command.
pub fn print(text: impl AsRef<[u8]>) -> Result<(), Exit> {
    let mut out = io::stdout().lock();
    taken(out.write_all(text.as_ref()).and_then(|()| out.flush()))
}

/// Prints the result of the command with a line end.
pub fn line(text: impl std::fmt::Display) -> Result<(), Exit> {
    print(format!("{text}\n"))
}

/// The result of writing to standard output.
pub fn taken(written: io::Result<()>) -> Result<(), Exit> {
    written.map_err(|error| Exit::unwritable("standard output", error))
}

/// Prints a message.
pub fn say(text: &str) {
    let _ = io::stderr().write_all(text.as_bytes());
}
