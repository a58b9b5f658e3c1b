//! The command `params`: the description of a parameter, from the table.

use crate::refused;
use generator::codes;
use generator::diagnostics::Report;
use generator::parameters::others::{OTHERS, Other};
use generator::parameters::{Name, Parameter, Scope};

/// The descriptions of the parameters that a text names; all parameters in short, if there is none.
///
/// # Errors
/// There is no such parameter.
pub fn text(wanted: Option<&str>) -> Result<String, Report> {
    let Some(wanted) = wanted else {
        let parameters = Name::ALL.map(Name::parameter).into_iter();
        let read = parameters.map(|of| format!("{:<13} {}\n", of.id.unwrap_or("-"), of.path));
        let others = OTHERS.iter().map(|other| format!("{:<13} (named by the manuals, not read)\n", other.name));
        return Ok(read.chain(others).collect());
    };
    let texts = of_name(wanted);
    if texts.is_empty() {
        let wanted = wanted.escape_default();
        let found = format!("no parameter `{wanted}`; `axgen params` lists all, by id and path");
        return Err(refused::input(codes::NO_SUCH, "axgen params", found));
    }
    Ok(texts.join("\n"))
}

/// The descriptions of the parameters that a text names, including parameters in the manuals that axgen does not read.
pub(crate) fn of_name(wanted: &str) -> Vec<String> {
    let unread =
        |Other { name, meaning, unread }: &Other| format!("{name}\n  meaning   {meaning}\n  not read  {unread}\n");
    let others = OTHERS.iter().filter(|other| other.is(wanted)).map(unread);
    let parameters = Name::ALL.map(Name::parameter).into_iter().filter(|parameter| is(parameter, wanted));
    parameters.map(describe).chain(others).collect()
}

/// The descriptions of the parameters that accept a word.
pub(crate) fn of_word(word: &str) -> Vec<String> {
    Name::ALL.map(Name::parameter).into_iter().filter(|parameter| parameter.takes(word)).map(describe).collect()
}

/// Whether a text names a parameter: by its id (or the id's digits), its path with letters or numbers as indices, one of
/// its older paths, or the end of a path.
fn is(parameter: &Parameter, wanted: &str) -> bool {
    let plain = |path: &str| -> String {
        let mut text = String::new();
        let mut inside = false;
        for character in path.chars().filter(|character| !character.is_whitespace()) {
            inside = (inside || character == '[') && character != ']';
            if !inside && character != ']' {
                text.push(character.to_ascii_lowercase());
            }
        }
        text
    };
    let wanted_path = plain(wanted);
    let by_id = parameter.id.is_some_and(|id| {
        id.eq_ignore_ascii_case(wanted) || id.rsplit('-').next().is_some_and(|digits| digits == wanted)
    });
    let paths = [parameter.path].into_iter().chain(parameter.aliases.iter().chain(parameter.misprints).copied());
    by_id || paths.map(plain).any(|path| path == wanted_path || path.ends_with(&format!(".{wanted_path}")))
}

/// The full description in the table.
fn describe(parameter: &Parameter) -> String {
    let mut lines = vec![format!("{} {}", parameter.path, parameter.id.map_or(String::new(), |id| format!("({id})")))];
    lines[0] = lines[0].trim_end().to_owned();
    let mut line = |name: &str, text: String| {
        if !text.is_empty() {
            lines.push(format!("  {name:<9} {text}"));
        }
    };
    line("meaning", parameter.meaning.to_owned());
    line("type", parameter.data_type.to_owned());
    line("allowed", parameter.allowed());
    line("printed", parameter.printed.to_owned());
    line("unit", parameter.unit.to_owned());
    line("default", parameter.default.join(", "));
    line("since", parameter.since.to_owned());
    line("drives", parameter.drives.to_owned());
    line("axes", parameter.axes.to_owned());
    line("dimension", parameter.dimension.to_owned());
    line("also", parameter.aliases.join(", "));
    line("misprint", parameter.misprints.join(", "));
    line(
        "stands in",
        match parameter.scope {
            Scope::List => "an axis list, and below an axis of a set",
            Scope::Axis => "a set, below an axis",
            Scope::Set => "a set, before the first table",
        }
        .to_owned(),
    );
    lines.join("\n") + "\n"
}
