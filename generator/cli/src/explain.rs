//! `axgen explain`: what a code of a message, an error of the controller or an error id of a block means, and what to do.

use crate::exit::Exit;
use crate::output;
use generator::codes::{self, CODES, Code, error_id, explain, of_controller};

/// Runs the command; without a code it lists all.
pub fn run(code: Option<&str>) -> Result<Exit, Exit> {
    let Some(wanted) = code else {
        for code in CODES {
            output::line(format!("{} {}", code.code, code.title))?;
        }
        return Ok(Exit::Done);
    };
    let found = match number(wanted) {
        Some(number) => of_number(number),
        None => explain(wanted).into_iter().map(text).collect(),
    };
    if found.is_empty() {
        let wanted = wanted.escape_default();
        let found = format!("no code `{wanted}`; `axgen explain` lists all, from AX001 on");
        return Err(Exit::input(codes::NO_SUCH, "axgen explain", found));
    }
    output::line(found.join("\n\n"))?;
    Ok(Exit::Done)
}

/// The number in `70350`, `P-ERR-70350` or `error_id 12`.
fn number(wanted: &str) -> Option<u32> {
    let lower = wanted.to_ascii_lowercase();
    let digits = ["p-err-", "error_id"].iter().find_map(|mark| lower.strip_prefix(mark)).unwrap_or(&lower);
    digits.trim_start_matches([' ', '=', ':']).parse().ok()
}

fn text(code: &Code) -> String {
    format!("{}: {}\n\n{}", code.code, code.title, code.explanation)
}

/// What to do about an id that need not be a fault.
fn what_to_do(number: u32) -> &'static str {
    match number {
        4 => "\n\nWrite a number from 0 to 1 to each input that tunes: the part follows it again.",
        5 => {
            "\n\nTake a smaller weight or limit, then a reset, or the mode OFF or DRYRUN: the block is ready again (docs/improved-position-control.md)."
        }
        6 => {
            "\n\nMake the set for the block that runs there: `axgen params-of NEW --axis X --on OLD`, with OLD as the file that the block was \
             generated from; or generate the block anew (docs/parameter-sets.md)."
        }
        7 => {
            "\n\nMake the set again, with a limit that is not above the one of the block, or generate the block anew \
             (docs/parameter-sets.md)."
        }
        8 => {
            "\n\nThe set was changed, damaged, or read while somebody wrote it: write it again, all of it between two calls of the block \
             (docs/parameter-sets.md)."
        }
        47 => {
            "\n\nThe block waits, in position control that it has not taken up: let the spindle coast until it is slow enough."
        }
        48 => {
            "\n\nThe spindle brakes by itself, until a reset. Write a larger Kv (P-AXIS-00099) or a lower v_velocity_control_on; look for a \
             drive that does not follow (docs/spindle.md)."
        }
        49 => {
            "\n\nThe request is lost, and nothing else: with v_velocity_control_on 1 a drive with position control serves it."
        }
        _ => "",
    }
}

/// What the controller and the blocks mean by a number.
fn of_number(number: u32) -> Vec<String> {
    let of_block = error_id(number).map(|why| {
        format!(
            "error_id {number} of a block: {why}\n\nThe block cannot act in a cycle in which `fault` is TRUE. It starts anew in the \
             first cycle without the cause; the page of the block in docs says what it puts out until then.{}",
            what_to_do(number)
        )
    });
    let of_controller =
        of_controller(number).map(|code| format!("Error {number} of the controller.\n\n{}", text(code)));
    of_block.into_iter().chain(of_controller).collect()
}
