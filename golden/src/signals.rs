//! Assigns the columns of a table to the signals of a block.

use crate::mistake::Mistake;
use crate::samples::Shape;
use crate::table::{Column, Table, listed};

/// Names of columns and of signals, from the user's map.
pub type Map = [(String, String)];

/// The signal that leaves a column out.
const LEFT_OUT: &str = "-";

/// The signal of each column: from the map of column names and signal names, else the signal with the column's name. In an
/// export the name is the channel's or its symbol's, as a whole or after its last point. `None` if the column is left out:
/// because the map assigns `-` or a signal of the `other` side of the block, or because it belongs to an export and is not a
/// signal.
///
/// # Errors
/// All errors: unknown and repeated columns.
pub(crate) fn of_columns(
    table: &Table<'_>,
    shape: &Shape,
    other: &[&str],
    map: &Map,
) -> Result<Vec<Option<usize>>, Vec<Mistake>> {
    if table.is_empty() {
        return Err(vec![Mistake::new([1, 1], "an empty file", "a line of names, and a line for each sample")]);
    }
    if table.has_blanks() {
        return Err(vec![Mistake::new([1, 1], "blanks between the cells", "semicolons, tabs or commas")]);
    }
    let mut mistakes = Vec::new();
    let mut signals: Vec<Option<usize>> = Vec::new();
    for column in &table.columns {
        let mapped = mapped(table, column, map);
        let (signal, is_left_out) = match mapped {
            Some(signal) => (shape.place(signal), signal == LEFT_OUT || other.contains(&signal)),
            None => (named(column.name, shape, table.is_export), table.is_export || other.contains(&column.name)),
        };
        if signal.is_some() && signals.contains(&signal) || signal.is_none() && !is_left_out {
            mistakes.push(wrong(column, mapped, signal.is_some(), shape));
        }
        signals.push(signal);
    }
    if table.is_export {
        mistakes.extend(find_by_symbol(table, shape, map, &mut signals));
    }
    mistakes.extend(ambiguous(table, map));
    if mistakes.is_empty() { Ok(signals) } else { Err(mistakes) }
}

/// Finds the signals of an export's columns that only their symbol names; returns the errors: repeated columns.
fn find_by_symbol(table: &Table<'_>, shape: &Shape, map: &Map, signals: &mut [Option<usize>]) -> Vec<Mistake> {
    let mut mistakes = Vec::new();
    for (at, column) in table.columns.iter().enumerate() {
        let by_name = signals[at].is_some() || mapped(table, column, map).is_some();
        let Some(signal) = named(column.symbol, shape, true).filter(|_| !by_name) else { continue };
        let by_symbol = |holder: usize| {
            let holder = &table.columns[holder];
            named(holder.name, shape, true) != Some(signal) && mapped(table, holder, map).is_none()
        };
        match signals.iter().position(|other| *other == Some(signal)) {
            None => signals[at] = Some(signal),
            Some(holder) if by_symbol(holder) => {
                let remedy = format!("--map \"{}=-\", or another channel of this symbol", column.called());
                mistakes.push(wrong(column, None, true, shape).instead(remedy));
            }
            Some(_) => {}
        }
    }
    mistakes
}

/// The names in the map that are the symbol of several columns, and the name of none.
fn ambiguous(table: &Table<'_>, map: &Map) -> Vec<Mistake> {
    let mistake = |(name, _): &(String, String)| {
        let by_symbol: Vec<_> = table.columns.iter().filter(|column| column.symbol == name).collect();
        let is_name = table.columns.iter().any(|column| column.name == name);
        let [first, _, ..] = by_symbol.as_slice() else { return None };
        let found = format!("{} channels show `{}`, which --map names", by_symbol.len(), name.escape_default());
        let names = listed(by_symbol.iter().map(|column| column.name));
        (!is_name).then(|| Mistake::new(first.place, found, names))
    };
    map.iter().filter_map(mistake).collect()
}

/// The map's entry for a column, by its name, or by its symbol if no other channel shows it.
fn mapped<'m>(table: &Table<'_>, column: &Column<'_>, map: &'m Map) -> Option<&'m str> {
    let of = |name: &str| map.iter().find(|(key, _)| key == name).map(|(_, signal)| signal.as_str());
    let is_alone = |_: &&str| table.columns.iter().filter(|other| other.symbol == column.symbol).count() == 1;
    of(column.name).or_else(|| of(column.symbol).filter(is_alone))
}

/// The signal of that name; in an export also by its last part.
fn named(name: &str, shape: &Shape, is_export: bool) -> Option<usize> {
    let last = name.rsplit('.').next().filter(|_| is_export);
    shape.place(name).or_else(|| last.and_then(|last| shape.place(last)))
}

fn wrong(column: &Column<'_>, mapped: Option<&str>, is_again: bool, shape: &Shape) -> Mistake {
    let again = if is_again { " a second time" } else { "" };
    let name = column.called().escape_default();
    let found = match mapped {
        Some(signal) => format!("the column `{name}` for `{signal}`{again}"),
        None => format!("the column `{name}`{again}"),
    };
    let allowed = shape.signals.iter().map(|signal| signal.name.as_str()).collect::<Vec<_>>().join(", ");
    Mistake::new(column.place, found, allowed)
}

/// The names in the map that none of the tables has.
#[must_use]
pub fn unknown(map: &Map, tables: &[&Table<'_>]) -> Vec<Mistake> {
    let Some(table) = tables.last() else { return Vec::new() };
    let is_unknown = |name: &&str| tables.iter().all(|table| !table.has(name));
    let mistake = |name: &str| {
        let place = [table.columns.first().map_or(1, |column| column.place[0]), 1];
        let found = format!("no column `{}`, which --map names", name.escape_default());
        let mistake = Mistake::new(place, found, listed(table.columns.iter().map(Column::called)));
        let is_named = table.columns.iter().all(|column| !column.name.is_empty());
        let remedy =
            "the names have blanks, which separate them too: give the channel's SymbolName, or export with tabs";
        if is_named { mistake } else { mistake.instead(remedy) }
    };
    map.iter().map(|(name, _)| name.as_str()).filter(is_unknown).map(mistake).collect()
}
