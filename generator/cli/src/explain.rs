//! `axgen explain`: what a code of a message means, and what to do.

use crate::exit::Exit;
use generator::codes::{CODES, explain};

/// Runs the command; without a code it lists all.
#[expect(clippy::print_stdout, reason = "what was asked for")]
pub fn run(code: Option<&str>) -> Result<Exit, Exit> {
    let Some(wanted) = code else {
        for code in CODES {
            println!("{} {}", code.code, code.title);
        }
        return Ok(Exit::Done);
    };
    let Some(code) = explain(wanted) else {
        let wanted = wanted.escape_default();
        return Err(Exit::input(format!("no code `{wanted}`; `axgen explain` lists all, from AX001 on")));
    };
    println!("{}: {}\n\n{}", code.code, code.title, code.explanation);
    Ok(Exit::Done)
}
