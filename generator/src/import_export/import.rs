//! An axis list as a TOML set: each known value once, as TOML, with its comments; and the lines themselves for the export.

use super::encoding::{Encoded, encoded, toml_string};
use super::slot::{self, HOLE};
use super::{spelling, tables};
use crate::check;
use crate::config::lines::{self, Content};
use crate::config::{
    AxisList, ListOptions, Load, Values, file, given, key, latin_1, list, other_kind, own_key, project,
};
use crate::diagnostics::Report;
use crate::parameters::words::{ListEncoding, Words};
use crate::parameters::{Name, Parameter, Value};
use std::path::Path;
use toml_edit::Table;

/// The axis list of a file as a TOML set. The set is `Some` if and only if no message is an error. It has no cycle time
/// unless the options, or a list that [`super::export`] wrote, give one.
pub fn import(path: &Path, options: &ListOptions, load: Load<'_>) -> (Option<String>, Report) {
    let mut report = Report::default();
    let source = match file::read(path, None, load) {
        Ok(source) => source,
        Err(unreadable) => return (None, unreadable),
    };
    let of_axis = |lists| project::of_axis(lists, options.name.as_deref());
    let list_of_axis = match project::lists(&source).and_then(of_axis) {
        Ok(list) => list,
        Err(refused) => return (None, refused),
    };
    let name = given::name_of(path, &list_of_axis, options, &mut report);
    let top = given::cycle_time_of(options, &mut report);
    let list = list::read(&list_of_axis);
    let other_kind = other_kind::instead_of_a_list(&list_of_axis, &list);
    let is_refused = list.report.has_errors() || other_kind::is_nc_program(&list_of_axis);
    if let Some(said) = other_kind.filter(|_| is_refused) {
        return (None, said.into());
    }
    report.extend(list.report);
    report.diagnostics.extend(own_key::other_cycle_time(&list.own, top.get(key(Name::CycleTime))));
    // Without a cycle time, a usual one: the check of a list without errors does not depend on it.
    let cycle_time = match top.get(key(Name::CycleTime)).and_then(|setting| setting.value.as_ref()) {
        Some(Value::Duration(ns @ 1..)) => u32::try_from(*ns).unwrap_or(1_000_000),
        _ => 1_000_000,
    };
    // Without a value that the axis uses, the set would have another meaning. An unused value is treated like one of another
    // function: its line is kept.
    let values = list.values.overridden_by(list.own);
    let said = check::axis(&name, Some(cycle_time), &values, source.whole(), false).effective.report;
    report.diagnostics.extend(values.refused(&said));
    if report.has_errors() {
        return (None, report);
    }
    let file = path.file_name().unwrap_or_default().to_string_lossy();
    let taken = Taken::from_list(&list_of_axis, &values);
    (Some(taken.set(&name, &file, options.cycle_time.clone())), report)
}

struct Taken {
    axis: Table,
    /// the lines, with a hole for each known value
    lines: Encoded,
    /// the value of axgen's own comment
    cycle_time: Option<toml_edit::Value>,
}

impl Taken {
    fn from_list(list: &AxisList, values: &Values) -> Self {
        let bytes = list.bytes();
        let (mark, lines) = lines::split(bytes);
        let mut left = mark.to_vec();
        let mut axis = Table::new();
        let mut cycle_time = None;
        let mut above = Vec::new();
        for (line, text) in lines.zip(bytes[mark.len()..].split_inclusive(|byte| *byte == b'\n')) {
            let slot = slot::in_line(&line);
            let value = slot.as_ref().and_then(|slot| values.get(slot.key)?.value.clone());
            let mut text = text.to_vec();
            match (slot, value) {
                (Some(slot), Some(value)) => {
                    let parameter = slot.key.0.parameter();
                    let toml = spelling::in_toml(parameter, slot.text, &value);
                    let same = spelling::in_list(slot.key.0, toml.to_string().as_bytes(), &value) == slot.text;
                    let hole = format!("{HOLE}{}", if same { "" } else { slot.text });
                    text.splice(slot.range, hole.bytes());
                    if slot.key.0 == Name::CycleTime {
                        cycle_time = Some(toml);
                    } else {
                        let above = comments_above(std::mem::take(&mut above));
                        let comment = comment_after(parameter, line.content);
                        tables::insert(&mut axis, slot.template, slot.key.1, toml, &above, comment.trim_end());
                    }
                }
                _ => match line.content {
                    Content::Remark { comment, .. } => above.push(comment_text(comment)),
                    _ => above.clear(),
                },
            }
            left.extend(text);
        }
        let [before, after] = list.around();
        Self { axis, lines: encoded([before, &left, after], list.source.encoding), cycle_time }
    }

    /// The text of the set, with the cycle time of the command line.
    fn set(self, name: &str, file: &str, cycle_time: Option<String>) -> String {
        let cycle_time = match cycle_time.map(toml_edit::Value::from).or(self.cycle_time) {
            Some(value) => {
                format!("# Cycle of the position controller; no axis list holds it.\ncycle_time = {value}\n")
            }
            None => "# Cycle of the position controller: no axis list holds it. Write yours, without the first `#`.\n\
                     # cycle_time = \"1ms\"\n"
                .to_owned(),
        };
        let Encoded { text: [before, lines, after], encoding, crlf } = self.lines;
        let axis = tables::text(name, self.axis);
        let encoding = match encoding {
            ListEncoding::Utf8 => String::new(),
            ListEncoding::Latin1 => {
                format!("encoding = \"{}\" # a character is the byte of its number\n", encoding.name())
            }
            ListEncoding::Utf16LittleEnd | ListEncoding::Utf16BigEnd => format!("encoding = \"{}\"\n", encoding.name()),
        };
        let line_end = if crlf { "line_end = \"CRLF\"\n" } else { "" };
        let lines = toml_string(&lines);
        let part = |key, text: &str| match text.is_empty() {
            true => String::new(),
            false => format!("{key} = {}\n", toml_string(text)),
        };
        let (before, after) = (part("before", &before), part("after", &after));
        let file = comment_text(format!("# {file}").as_bytes());
        format!(
            "{file}, imported by axgen\n{cycle_time}\n{axis}\n\
             # The list, line by line; `axgen export` writes it back. `=` stands for a value that stands above, `=0X1` for one that was\n\
             # spelled so. Change values above. Parameters of other functions stand here, and all comments: those above are copies.\n\
             [axis.{name}.imported_list]\n{encoding}{line_end}{before}lines = {lines}\n{after}"
        )
    }
}

/// The comments above a value, one per line. Several blank lines become one, also before them.
fn comments_above(mut comments: Vec<String>) -> String {
    comments.dedup_by(|next, last| next.is_empty() && last.is_empty());
    comments.into_iter().map(|comment| comment + "\n").collect()
}

/// The comment after a value, with a blank before it.
fn comment_after(parameter: &Parameter, content: Content<'_>) -> String {
    let Content::Statement(statement) = content else { return String::new() };
    format!(" {}{}", spelling::after(parameter, statement.value), comment_text(statement.comment))
}

/// A comment in TOML: any other sign becomes `#`, bytes that are not UTF-8 are read as latin-1, and control characters are
/// replaced.
fn comment_text(comment: &[u8]) -> String {
    let text = str::from_utf8(comment).map_or_else(|_| latin_1(comment), str::to_owned);
    let text: String =
        text.chars().map(|c| if c.is_control() && c != '\t' { char::REPLACEMENT_CHARACTER } else { c }).collect();
    let sign = if text.is_empty() || text.starts_with('#') { "" } else { "# " };
    format!("{sign}{}", text.trim_end())
}
