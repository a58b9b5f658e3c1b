//! `axgen explain`: what a code of a message means, and what to do.

use crate::exit::Exit;
use crate::output;
use generator::codes::{self, CODES, explain};

/// Runs the command; without a code it lists all.
pub fn run(code: Option<&str>) -> Result<Exit, Exit> {
    let Some(wanted) = code else {
        for code in CODES {
            output::line(format!("{} {}", code.code, code.title))?;
        }
        return Ok(Exit::Done);
    };
    let Some(code) = explain(wanted) else {
        let wanted = wanted.escape_default();
        let found = format!("no code `{wanted}`; `axgen explain` lists all, from AX001 on");
        return Err(Exit::input(codes::NO_SUCH, "axgen explain", found));
    };
    output::line(format!("{}: {}\n\n{}", code.code, code.title, code.explanation))?;
    Ok(Exit::Done)
}
