//! The reference page of all parameters as Markdown, from the table. Nothing is said here that the table does not say.

use crate::parameters::{Name, Parameter, Scope};
use std::fmt::Write;

/// The page.
#[must_use]
pub fn text() -> String {
    let mut page = String::from(
        "# Parameters\n\nMade by `axgen params --markdown` from the one table of parameters. Parameters with an id are the vendor's; the \
         others are keys of axgen's own, for what no axis list holds. Types, builds and drives are those that the manuals print; `----` is \
         printed too. A default outside of the range means that the parameter \
         must be given where it is used.\n",
    );
    for (scope, title) in [
        (Scope::Set, "At the top of a set"),
        (Scope::Axis, "Below an axis of a set"),
        (Scope::List, "In an axis list, and below an axis of a set"),
    ] {
        let _ = write!(
            page,
            "\n## {title}\n\n| id | path | type | allowed | default | unit | since | drives | meaning |\n| --- | --- | --- | --- | --- | --- | --- | --- | --- |\n"
        );
        for parameter in Name::ALL.map(Name::parameter).into_iter().filter(|parameter| parameter.scope == scope) {
            row(parameter, &mut page);
        }
    }
    page
}

fn row(parameter: &Parameter, page: &mut String) {
    let mut meaning = parameter.meaning.to_owned();
    if !parameter.aliases.is_empty() {
        let also: Vec<String> = parameter.aliases.iter().map(|alias| format!("`{alias}`")).collect();
        let _ = write!(meaning, "; also {}", also.join(", "));
    }
    if !parameter.misprints.is_empty() {
        let misprints: Vec<String> = parameter.misprints.iter().map(|misprint| format!("`{misprint}`")).collect();
        let _ = write!(meaning, "; misprinted as {}", misprints.join(", "));
    }
    if !parameter.printed.is_empty() {
        let _ = write!(meaning, "; printed: {}", parameter.printed);
    }
    let _ = writeln!(
        page,
        "| {} | `{}` | {} | {} | {} | {} | {} | {} | {} |",
        parameter.id.unwrap_or(""),
        parameter.path,
        parameter.data_type,
        cell(&parameter.allowed()),
        cell(&parameter.default.join(", ")),
        parameter.unit,
        parameter.since,
        parameter.drives,
        cell(&meaning),
    );
}

/// A text that does not end its cell.
fn cell(text: &str) -> String {
    text.replace('|', "\\|")
}
