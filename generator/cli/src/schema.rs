//! `axgen schema`: the JSON schema of a set, for completion and checks in editors.

use crate::exit::Exit;
use crate::output;
use generator::schema;

/// Runs the command.
pub fn run() -> Result<Exit, Exit> {
    output::line(schema::text())?;
    Ok(Exit::Done)
}
