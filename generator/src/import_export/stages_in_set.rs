//! Other stages in the text of a TOML set: where they stand there, and what is written in their place. No file.

use super::keys_of_stage::{Given, keys};
use crate::axis::Stage;
use crate::parameters::{
    Name,
    words::{Enable, Words},
};
use std::ops::Range;
use toml_edit::{ArrayOfTables, Document, Item, Table, TableLike, Value};

/// A replacement of a part of the text.
type Edit = (Range<usize>, String);

/// Where improved position control stands in an axis.
const IPC: [&str; 2] = ["lr_param", "improved_position_control"];

/// The set with other stages of an axis, and the mode DRYRUN.
///
/// # Errors
/// It has them in a form that is not edited.
pub(super) fn edited(text: &str, axis: &str, stages: &[Stage]) -> Result<String, String> {
    let document = Document::parse(text).map_err(|error| error.message().to_owned())?;
    let end = if text.contains("\r\n") { "\r\n" } else { "\n" };
    let set = Set { text, axis };
    let no_table = || format!("axis.{axis} is not a table");
    let table = document.as_table().get("axis").and_then(Item::as_table_like).and_then(|axes| axes.get(axis));
    let table = table.and_then(Item::as_table).ok_or_else(no_table)?;
    let mut edits = match below(table, &IPC) {
        Some(Item::Table(ipc)) if ipc.is_dotted() => set.in_keys(ipc, stages),
        Some(Item::Table(ipc)) => set.in_table(ipc, stages),
        Some(Item::Value(Value::InlineTable(ipc))) => {
            let at = ipc.span().ok_or_else(no_table)?;
            set.in_values(ipc, at.end - 1, stages)
        }
        Some(_) => Err(format!("{} is not a table", IPC.join("."))),
        None => set.anew(table, stages),
    }?;
    edits.sort_by_key(|(range, _)| std::cmp::Reverse((range.start, range.end)));
    let mut edited = text.to_owned();
    for (range, new) in edits {
        edited.replace_range(range, &new.replace('\n', end));
    }
    Ok(edited)
}

fn below<'i>(table: &'i Table, path: &[&str]) -> Option<&'i Item> {
    let (last, first) = path.split_last()?;
    let mut table: &dyn TableLike = table;
    for part in first {
        table = table.get(part)?.as_table_like()?;
    }
    table.get(last)
}

/// The largest end of anything in an item.
fn end_of(item: &Item) -> usize {
    let below = match item {
        Item::Table(table) => end_of_table(table),
        Item::ArrayOfTables(tables) => tables.iter().map(end_of_table).max().unwrap_or(0),
        Item::Value(_) | Item::None => 0,
    };
    item.span().map_or(0, |span| span.end).max(below)
}

fn end_of_table(table: &Table) -> usize {
    let below = table.iter().map(|(_, item)| end_of(item)).max().unwrap_or(0);
    table.span().map_or(0, |span| span.end).max(below)
}

/// A set, of which one axis is edited. New lines have `\n` until they are put in.
struct Set<'t> {
    text: &'t str,
    axis: &'t str,
}

impl Set<'_> {
    /// The end of the line at a place, with its line end.
    fn line_end(&self, at: usize) -> usize {
        self.text[at..].find('\n').map_or(self.text.len(), |end| at + end + 1)
    }

    fn line_start(&self, at: usize) -> usize {
        self.text[..at].rfind('\n').map_or(0, |end| end + 1)
    }

    /// Lines after the line of a place; the file may end without a line end.
    fn after_line(&self, at: usize, lines: &str) -> Edit {
        let at = self.line_end(at);
        let is_open = at == self.text.len() && !self.text.ends_with('\n');
        (at..at, if is_open { format!("\n{lines}") } else { lines.to_owned() })
    }

    /// The full name of improved position control of the axis.
    fn name(&self) -> String {
        format!("axis.{}.{}", self.axis, IPC.join("."))
    }

    /// The stages instead of `[[...stage]]`, after the lines above them.
    fn in_tables(&self, old: &ArrayOfTables, above: &str, stages: &[Stage]) -> Result<Vec<Edit>, String> {
        let spans: Option<Vec<Range<usize>>> =
            old.iter().map(|table| Some(table.span()?.start..end_of_table(table))).collect();
        let spans = spans.ok_or("a stage has no place")?;
        let edit = |(k, span): (usize, &Range<usize>)| {
            let mut lines = self.line_start(span.start)..self.line_end(span.end);
            // Blank lines between two stages go with the second one.
            let before = k.checked_sub(1).map(|k| self.line_end(spans[k].end));
            if let Some(before) = before.filter(|at| self.text[*at..lines.start].trim().is_empty()) {
                lines.start = before;
            }
            let new = if k == 0 { above.to_owned() + &self.tables(&self.name(), stages) } else { String::new() };
            let new = if self.text[lines.clone()].ends_with('\n') { new } else { new.trim_end().to_owned() };
            (lines, new)
        };
        Ok(spans.iter().enumerate().map(edit).collect())
    }

    /// In a table of its own: `[axis.X.lr_param.improved_position_control]`, and `[[...stage]]`.
    fn in_table(&self, ipc: &Table, stages: &[Stage]) -> Result<Vec<Edit>, String> {
        let mut edits = Vec::new();
        let header = ipc.span().filter(|_| !ipc.is_implicit());
        // Its own last line, before the tables below it.
        let own = |(_, item): (&str, &Item)| (!item.is_array_of_tables()).then(|| end_of(item));
        let last = header.as_ref().map(|header| ipc.iter().filter_map(own).fold(header.end, usize::max));
        let name = self.name();
        let above = match (ipc.get("enable"), last) {
            (Some(enable), _) => {
                edits.extend(dry_run(enable)?);
                String::new()
            }
            (None, Some(last)) => {
                edits.push(self.after_line(last, "enable = \"DRYRUN\"\n"));
                String::new()
            }
            (None, None) => format!("[{name}]\nenable = \"DRYRUN\"\n\n"),
        };
        match ipc.get("stage") {
            Some(Item::ArrayOfTables(old)) => edits.extend(self.in_tables(old, &above, stages)?),
            Some(Item::Value(Value::Array(old))) => edits.push(self.array(old.span(), stages)?),
            Some(_) => return Err("stage is not an array".to_owned()),
            None => {
                let last = last.ok_or("the table has no place")?;
                let lines = format!("\n{}", self.tables(&name, stages));
                edits.push(self.after_line(last, &lines));
            }
        }
        // What stands at one place is one edit, in the order of its lines.
        if let [(first, enable), (second, tables)] = edits.as_slice()
            && first == second
        {
            return Ok(vec![(first.clone(), enable.clone() + tables)]);
        }
        Ok(edits)
    }

    /// As dotted keys of a table above it.
    fn in_keys(&self, ipc: &Table, stages: &[Stage]) -> Result<Vec<Edit>, String> {
        let (first, item) = ipc.iter().next().ok_or("the table is empty")?;
        let at = ipc.key(first).and_then(toml_edit::Key::span).ok_or("a key has no place")?.start;
        let path = self.text[self.line_start(at)..at].to_owned();
        if item.is_table() || path.contains(['{', '[', ',', '=']) {
            return Err(format!("{} is written in a form that is not edited", IPC.join(".")));
        }
        let last = ipc.iter().map(|(_, item)| end_of(item)).max().unwrap_or(at);
        let (mut edits, new) = self.values(ipc, stages)?;
        if !new.is_empty() {
            let lines: String = new.iter().map(|assignment| format!("{path}{assignment}\n")).collect();
            edits.push(self.after_line(last, &lines));
        }
        Ok(edits)
    }

    /// As one value, whose bracket closes at a place.
    fn in_values(&self, ipc: &dyn TableLike, close: usize, stages: &[Stage]) -> Result<Vec<Edit>, String> {
        let (mut edits, new) = self.values(ipc, stages)?;
        if !new.is_empty() {
            let at = ipc.iter().map(|(_, item)| end_of(item)).max();
            let before = if at.is_some() { ", " } else { " " };
            let at = at.unwrap_or(close);
            edits.push((at..at, before.to_owned() + &new.join(", ")));
        }
        Ok(edits)
    }

    /// What is edited where `enable` and `stage` are values, and the assignments that are missing.
    fn values(&self, ipc: &dyn TableLike, stages: &[Stage]) -> Result<(Vec<Edit>, Vec<String>), String> {
        let (mut edits, mut new) = (Vec::new(), Vec::new());
        match ipc.get("enable") {
            Some(enable) => edits.extend(dry_run(enable)?),
            None => new.push("enable = \"DRYRUN\"".to_owned()),
        }
        match ipc.get("stage") {
            Some(Item::Value(Value::Array(old))) => edits.push(self.array(old.span(), stages)?),
            Some(_) => return Err("stage is not an array".to_owned()),
            None => new.push(format!("stage = {}", array(stages, ""))),
        }
        Ok((edits, new))
    }

    /// Where the axis has none of it yet: after all that it has.
    fn anew(&self, axis: &Table, stages: &[Stage]) -> Result<Vec<Edit>, String> {
        let name = self.name();
        let lines = format!("\n[{name}]\nenable = \"DRYRUN\"\n\n{}", self.tables(&name, stages));
        Ok(vec![self.after_line(end_of_table(axis), &lines)])
    }

    /// A table for each stage.
    fn tables(&self, name: &str, stages: &[Stage]) -> String {
        let table = |stage: &Stage| format!("[[{name}.stage]]\n{}filter = {}\n", own_keys(stage, "\n"), filters(stage));
        stages.iter().map(table).collect::<Vec<_>>().join("\n")
    }

    /// An array instead of another one.
    fn array(&self, old: Option<Range<usize>>, stages: &[Stage]) -> Result<Edit, String> {
        let old = old.ok_or("the array has no place")?;
        let line = &self.text[self.line_start(old.start)..old.start];
        let indent: String = line.chars().take_while(|letter| matches!(letter, ' ' | '\t')).collect();
        Ok((old, array(stages, &indent)))
    }
}

/// The mode DRYRUN, unless it is that.
fn dry_run(enable: &Item) -> Result<Option<Edit>, String> {
    let word = Enable::DryRun.name();
    let is_it = enable.as_str() == Some(word);
    let at = enable.span().filter(|_| enable.is_value()).ok_or("enable has no place")?;
    Ok((!is_it).then(|| (at, format!("\"{word}\""))))
}

/// Stages as the elements of an array.
fn array(stages: &[Stage], indent: &str) -> String {
    let element = |stage: &Stage| {
        let own = own_keys(stage, ", ");
        format!("\n{indent}    {{ {own}filter = {} }},", filters(stage))
    };
    format!("[{}\n{indent}]", stages.iter().map(element).collect::<String>())
}

fn own_keys(stage: &Stage, after: &str) -> String {
    let is_own = |key: &Given| key.is_needed && !is_of_filter(key.name);
    keys(stage).iter().filter(|key| is_own(key)).map(|key| format!("{}{after}", assignment(key))).collect()
}

fn filters(stage: &Stage) -> String {
    let keys = keys(stage);
    let of = |k: u32| {
        let is_of = |key: &&Given| key.filter == k && is_of_filter(key.name);
        let needed: Vec<String> = keys.iter().filter(is_of).filter(|key| key.is_needed).map(assignment).collect();
        (!needed.is_empty()).then(|| format!("{{ {} }}", needed.join(", ")))
    };
    format!("[{}]", (0..2).filter_map(of).collect::<Vec<_>>().join(", "))
}

fn is_of_filter(name: Name) -> bool {
    name.parameter().path.contains(".filter[")
}

/// `fg_f0 = 53.0`: a real has a point.
fn assignment(key: &Given) -> String {
    let path = key.name.parameter().path;
    let last = path.rsplit('.').next().unwrap_or(path);
    let is_real = matches!(key.name, Name::FilterF0 | Name::FilterQ | Name::OscDamping);
    let value = match key.name {
        Name::Mode | Name::DirectSource | Name::FilterType | Name::FilterPrototype => format!("\"{}\"", key.text),
        _ if is_real && !key.text.contains('.') => format!("{}.0", key.text),
        _ => key.text.clone(),
    };
    format!("{last} = {value}")
}
