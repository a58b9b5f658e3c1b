//! The tree of a list's parameters as TOML: dotted keys, tables and arrays of tables as a person would choose them.

use super::tree::{Leaf, Node, Table};
use std::fmt::Write;

/// A line that is longer than this becomes a table of its own.
const WIDTH: usize = 100;

/// Prints the table of an axis: its header, its values, then what is below it.
#[must_use]
pub fn axis(name: &str, axis: &Table) -> String {
    let mut text = String::new();
    section(&format!("axis.{name}"), "[]", axis, &mut text);
    text
}

/// A header, the values that stand directly below it, then the sections below them.
fn section(path: &str, brackets: &str, table: &Table, text: &mut String) {
    let is_axis = !path["axis.".len()..].contains('.');
    let is_table = |(_, node): &(String, Node)| matches!(node, Node::Table(_));
    let is_way = brackets == "[]" && !is_axis && !table.entries.is_empty() && table.entries.iter().all(is_table);
    let is_here = |(key, node): &&(String, Node)| !is_way && here(key, node).is_some();
    let (values, sections): (Vec<_>, Vec<_>) = table.entries.iter().partition(is_here);
    // A table that only holds tables needs no header of its own, but for an axis and an element of an array.
    if !values.is_empty() || brackets != "[]" || is_axis {
        if !text.is_empty() {
            text.push('\n');
        }
        // The comment above the first value of a section is mostly about the section.
        let first = values.first().and_then(|(_, node)| node.leaves().first().copied());
        above(first, text);
        let (open, close) = brackets.split_at(brackets.len() / 2);
        let _ = writeln!(text, "{open}{path}{close}");
    }
    for (position, (key, node)) in values.into_iter().enumerate() {
        entry(key, node, position > 0, text);
    }
    for (key, node) in sections {
        let path = format!("{path}.{key}");
        match node {
            Node::Array(tables) => tables.iter().for_each(|table| section(&path, "[[]]", table, text)),
            Node::Table(table) => section(&path, "[]", table, text),
            Node::Leaf(_) => {}
        }
    }
}

/// A key below the header of its table, with the comments of its first value unless they stand above that header.
fn entry(key: &str, node: &Node, comments: bool, text: &mut String) {
    if let Node::Table(table) = node {
        for (position, (below, node)) in table.entries.iter().enumerate() {
            entry(&format!("{key}.{below}"), node, comments || position > 0, text);
        }
        return;
    }
    let leaves = node.leaves();
    let first = leaves.first().copied();
    if comments {
        if first.is_some_and(|leaf| leaf.apart) {
            text.push('\n');
        }
        above(first, text);
    }
    let beside = first.and_then(|leaf| leaf.beside.as_deref()).map_or(String::new(), |comment| format!(" {comment}"));
    let _ = writeln!(text, "{key} = {}{beside}", here(key, node).unwrap_or_default());
}

fn above(leaf: Option<&Leaf>, text: &mut String) {
    for line in leaf.into_iter().flat_map(|leaf| &leaf.above) {
        let _ = writeln!(text, "{line}");
    }
}

/// What stands behind the key if the node needs no header; of a table nothing that counts. A comment has its place only
/// beside a value that stands alone.
fn here(key: &str, node: &Node) -> Option<String> {
    let value = match node {
        Node::Leaf(leaf) => return Some(leaf.value.clone()),
        Node::Table(table) => {
            let is_leaf = |(_, node): &(String, Node)| matches!(node, Node::Leaf(_));
            return table.entries.iter().all(is_leaf).then(String::new);
        }
        Node::Array(tables) => tables.iter().map(inline).collect::<Option<Vec<_>>>()?.join(", "),
    };
    let leaves = node.leaves();
    let is_bare = |leaf: &&Leaf| leaf.above.is_empty() && leaf.beside.is_none();
    let fits = key.len() + value.len() <= WIDTH && (leaves.len() == 1 || leaves.iter().all(is_bare));
    fits.then(|| format!("[{value}]"))
}

/// A table within a line: values, and tables of values as dotted keys.
fn inline(table: &Table) -> Option<String> {
    let mut keys = Vec::new();
    for (key, node) in &table.entries {
        match node {
            Node::Leaf(leaf) => keys.push(format!("{key} = {}", leaf.value)),
            Node::Table(below) => {
                for (end, node) in &below.entries {
                    let Node::Leaf(leaf) = node else { return None };
                    keys.push(format!("{key}.{end} = {}", leaf.value));
                }
            }
            Node::Array(_) => return None,
        }
    }
    Some(if keys.is_empty() { "{}".to_owned() } else { format!("{{ {} }}", keys.join(", ")) })
}
