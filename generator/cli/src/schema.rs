//! `axgen schema`: the JSON schema of a set, for editors that complete and check as one types.

use crate::exit::Exit;
use crate::output;
use generator::schema;

/// Runs the command.
pub fn run() -> Result<Exit, Exit> {
    output::line(schema::text())?;
    Ok(Exit::Done)
}
