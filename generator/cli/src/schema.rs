//! `axgen schema`: the JSON schema of a set, for editors that complete and check as one types.

use crate::exit::Exit;
use generator::schema;

/// Runs the command.
#[expect(clippy::print_stdout, reason = "what was asked for")]
pub fn run() -> Result<Exit, Exit> {
    println!("{}", schema::text());
    Ok(Exit::Done)
}
