//! The reference page of all parameters as Markdown, generated from the table only.

use crate::parameters::others::{OTHERS, Other};
use crate::parameters::{Name, Parameter, Scope};
use std::fmt::Write;

pub fn text() -> String {
    let mut page = String::from(
        "# Parameters\n\nMade by `axgen params --markdown` from the one table of parameters. Parameters with an id are the vendor's; the \
         others are keys of axgen's own, for what no axis list holds. Types, builds, drives, axis types (T translatory, R rotary, S spindle) and dimensions \
         are those that the manuals print, with um and deg for the signs; `----` is printed too. A unit is the one that axgen \
         computes in. A default outside of the range means that the parameter \
         must be given where it is used.\n",
    );
    for (scope, title) in [
        (Scope::Set, "At the top of a set"),
        (Scope::Axis, "Below an axis of a set"),
        (Scope::List, "In an axis list, and below an axis of a set"),
    ] {
        let _ = write!(
            page,
            "\n## {title}\n\n| id | path | type | allowed | default | unit | dimension | axes | since | drives | meaning |\n\
             | --- | --- | --- | --- | --- | --- | --- | --- | --- | --- | --- |\n"
        );
        for parameter in Name::ALL.map(Name::parameter).into_iter().filter(|parameter| parameter.scope == scope) {
            row(parameter, &mut page);
        }
    }
    page.push_str(
        "\n## Named by the manuals, not read\n\n| name | meaning | why it is not read |\n| --- | --- | --- |\n",
    );
    for Other { name, meaning, unread } in &OTHERS {
        let _ = writeln!(page, "| {name} | {meaning} | {unread} |");
    }
    page
}

fn row(parameter: &Parameter, page: &mut String) {
    let quoted = |paths: &[&str]| paths.iter().map(|path| format!("`{path}`")).collect::<Vec<_>>().join(", ");
    let mut meaning = parameter.meaning.to_owned();
    for (what, text) in [
        ("also", quoted(parameter.aliases)),
        ("misprinted as", quoted(parameter.misprints)),
        ("printed:", parameter.printed.to_owned()),
    ] {
        if !text.is_empty() {
            let _ = write!(meaning, "; {what} {text}");
        }
    }
    let &Parameter { id, data_type, unit, dimension, axes, since, drives, .. } = parameter;
    let (path, allowed, default) = (quoted(&[parameter.path]), parameter.allowed(), parameter.default.join(", "));
    let cells =
        [id.unwrap_or(""), &path, data_type, &allowed, &default, unit, dimension, axes, since, drives, &meaning];
    // A bar would end the cell.
    let _ = writeln!(page, "| {} |", cells.map(|cell| cell.replace('|', "\\|")).join(" | "));
}
