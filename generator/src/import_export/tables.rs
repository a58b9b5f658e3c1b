//! The parameters of a list as tables of TOML, each with its comments: dotted keys, inline tables and headers as a person
//! would choose them. Values are not interpreted here.

use crate::parameters::path_with;
use toml_edit::{Array, ArrayOfTables, Decor, DocumentMut, InlineTable, Item, Key, Table, Value};

/// An array of tables whose line would be longer gets a header for each table.
const WIDTH: usize = 102;

/// Inserts a value at the path of a template with its indices; `above` contains the lines before it, `comment` the text after
/// it.
pub(super) fn insert(axis: &mut Table, template: &str, index: [u32; 2], mut value: Value, above: &str, comment: &str) {
    let path = path_with(template, index);
    let (tables, key) = path.rsplit_once('.').unwrap_or(("", &path));
    let table = tables.split('.').filter(|part| !part.is_empty()).fold(axis, below);
    *value.decor_mut() = Decor::new(" ", comment);
    table.insert(key, Item::Value(value));
    if let Some(mut key) = table.key_mut(key) {
        key.leaf_decor_mut().set_prefix(above);
    }
}

/// The table below a key such as `stage[1]` or `kenngr`. Without an index the first element of an array is meant: a list may
/// mix `filter.x` and `filter[0].x`, TOML may not.
fn below<'t>(table: &'t mut Table, part: &str) -> &'t mut Table {
    let (key, index) = part.split_once('[').map_or((part, None), |(key, index)| (key, Some(index)));
    let item = table.entry(key).or_insert_with(|| Item::Table(implicit()));
    if let (Item::Table(first), Some(_)) = (&mut *item, index) {
        *item = Item::ArrayOfTables(ArrayOfTables::from_iter([std::mem::take(first)]));
    }
    match item {
        Item::Table(table) => table,
        Item::ArrayOfTables(tables) => {
            let index = index.and_then(|index| index.trim_end_matches(']').parse().ok()).unwrap_or(0);
            while tables.len() <= index {
                tables.push(Table::new());
            }
            tables.get_mut(index).unwrap_or_else(|| panic!("tables: `{part}` was not made"))
        }
        _ => panic!("tables: `{part}` is a value and a table"),
    }
}

/// A table without its own header, unless it directly contains values.
fn implicit() -> Table {
    let mut table = Table::new();
    table.set_implicit(true);
    table
}

/// The text of an axis: its header, its values, then the tables below it.
pub(super) fn text(name: &str, mut axis: Table) -> String {
    fold(&mut axis, false);
    let mut axes = implicit();
    axes.insert(name, Item::Table(axis));
    let mut document = DocumentMut::new();
    document.insert("axis", Item::Table(axes));
    document.to_string().trim_start_matches('\n').to_owned()
}

/// Chooses the notation for the contents of a table. A table that only contains other tables gets neither a header nor
/// dotted keys, except an axis and an element of an array.
fn fold(table: &mut Table, may_be_way: bool) {
    let is_way = may_be_way && table.iter().all(|(_, item)| item.is_table());
    for (mut key, item) in table.iter_mut() {
        if let Some((above, array)) = item.as_array_of_tables().and_then(|tables| on_a_line(key.get(), tables)) {
            key.leaf_decor_mut().set_prefix(above);
            *item = Item::Value(array.into());
        }
        match item {
            Item::Table(below) if !is_way && below.iter().all(|(_, item)| item.is_value()) => below.set_dotted(true),
            Item::Table(below) => fold(below, true),
            Item::ArrayOfTables(tables) => tables.iter_mut().for_each(|table| fold(table, false)),
            _ => {}
        }
    }
    // The comment above the first value of a section usually describes the section.
    let above = take_above(table).unwrap_or_default();
    table.decor_mut().set_prefix(format!("\n{}", above.trim_start_matches('\n')));
}

/// Takes the lines above the first value below the header of a table, and removes them there.
fn take_above(table: &mut Table) -> Option<String> {
    table.iter_mut().find_map(|(mut key, item)| match item {
        Item::Value(_) => {
            let above = above(key.leaf_decor()).to_owned();
            key.leaf_decor_mut().clear();
            Some(above)
        }
        Item::Table(below) if below.is_dotted() => take_above(below),
        _ => None,
    })
}

/// An array of tables as the value of one key, and the lines above it: of values, and of tables of values, which get dotted
/// keys. A comment fits only next to a single value.
fn on_a_line(key: &str, tables: &ArrayOfTables) -> Option<(String, Array)> {
    let leaves = tables.iter().map(leaves).collect::<Option<Vec<_>>>()?.concat();
    let is_bare = |(key, value): &(&Key, &Value)| {
        above(key.leaf_decor()).trim_start_matches('\n').is_empty() && comment(value).is_empty()
    };
    let (first, value) = leaves.first()?;
    let mut array: Array = tables.iter().map(inline).collect();
    let fits = key.len() + array.to_string().len() <= WIDTH && (leaves.len() == 1 || leaves.iter().all(is_bare));
    *array.decor_mut() = Decor::new(" ", comment(value));
    fits.then(|| (above(first.leaf_decor()).to_owned(), array))
}

/// The values of a table, and of the tables below it; `None` if it contains anything else.
fn leaves(table: &Table) -> Option<Vec<(&Key, &Value)>> {
    let mut leaves = Vec::new();
    for (key, item) in table {
        match item {
            Item::Table(below) if below.iter().all(|(_, item)| item.is_value()) => leaves.extend(self::leaves(below)?),
            item => leaves.push((table.key(key)?, item.as_value()?)),
        }
    }
    Some(leaves)
}

fn inline(table: &Table) -> InlineTable {
    let mut inline = table.clone().into_inline_table();
    for (_, value) in inline.iter_mut() {
        if let Value::InlineTable(below) = value {
            below.set_dotted(true);
        }
    }
    inline
}

fn above(decor: &Decor) -> &str {
    decor.prefix().and_then(|lines| lines.as_str()).unwrap_or_default()
}

fn comment(value: &Value) -> &str {
    value.decor().suffix().and_then(|comment| comment.as_str()).unwrap_or_default()
}
