//! The command `explain`: meaning and remedy of a message code, an error of the controller or an error id of a block, or the
//! meaning of a word.

use crate::params;
use crate::refused;
use generator::blocks;
use generator::codes::{self, CODES, Code, explain, of_controller};
use generator::diagnostics::Report;
use generator::error_ids::{self, ErrorId};
use generator::target;

/// The meanings of a code, a number or a word; all codes, if there is none.
///
/// # Errors
/// It has no meaning.
pub fn text(code: Option<&str>) -> Result<String, Report> {
    let Some(wanted) = code else {
        return Ok(CODES.iter().map(|code| format!("{} {}\n", code.code, code.title)).collect());
    };
    let found = match number(wanted) {
        Some(number) => of_number(number),
        None => explain(wanted).map_or_else(|| of_word(wanted), |code| vec![of_code(code)]),
    };
    if found.is_empty() {
        let is_code = number(wanted).is_some() || wanted.to_ascii_uppercase().starts_with("AX");
        let wanted = wanted.escape_default();
        let found = match is_code {
            true => format!("no code `{wanted}`; `axgen explain` lists all, from AX001 on"),
            false => format!(
                "no code, signal, parameter or word `{wanted}`; `axgen explain` lists all codes, and `axgen params` all parameters"
            ),
        };
        return Err(refused::input(codes::NO_SUCH, "axgen explain", found));
    }
    Ok(found.join("\n\n") + "\n")
}

/// The number in `70350`, `P-ERR-70350` or `error_id 12`.
fn number(wanted: &str) -> Option<u32> {
    let lower = wanted.to_ascii_lowercase();
    let digits = ["p-err-", "error_id"].iter().find_map(|mark| lower.strip_prefix(mark)).unwrap_or(&lower);
    digits.trim_start_matches([' ', '=', ':']).parse().ok()
}

fn of_code(code: &Code) -> String {
    format!("{}: {}\n\n{}", code.code, code.title, code.explanation)
}

/// The meanings of a word: the name of a signal, of a number in Structured Text, a parameter, or a value of one.
fn of_word(wanted: &str) -> Vec<String> {
    let signals = blocks::signals(wanted).into_iter().map(|(block, is_output, doc)| {
        let kind = if is_output { "output" } else { "input" };
        format!("{kind} `{wanted}` of the block {block}: {doc}")
    });
    let mut found: Vec<String> = signals.chain(target::meanings(wanted)).collect();
    let parameters = [params::of_name(wanted), params::of_word(wanted)].concat();
    found.extend(parameters.iter().map(|text| text.trim_end().to_owned()));
    found
}

/// The meanings of a number for the controller and the blocks.
fn of_number(number: u32) -> Vec<String> {
    let of_block = error_ids::all().find(|known| known.id == number).map(|ErrorId { why, does, remedy, .. }| {
        format!("error_id {number} of a block: {why}\n\nWhat the block does: {does}\n\nWhat to do: {remedy}")
    });
    let of_controller =
        of_controller(number).map(|code| format!("Error {number} of the controller.\n\n{}", of_code(code)));
    of_block.into_iter().chain(of_controller).collect()
}
