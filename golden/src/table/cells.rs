//! Splits a line into cells, and normalises the text of a number. Their meaning is not known here.

use std::borrow::Cow;

/// The cells of a line, without the blanks and the quotation marks around them. Text in quotation marks is not split.
pub(crate) fn split<'t>(line: &'t str, separator: char, cells: &mut Vec<&'t str>) {
    cells.clear();
    if !line.contains('"') {
        cells.extend(line.split(separator).map(str::trim));
        return;
    }
    let mut rest = line;
    loop {
        let (cell, end) = first_cell(rest, separator);
        cells.push(cell);
        match end {
            Some(end) => rest = &rest[end..],
            None => return,
        }
    }
}

/// The cells of a line of samples. A scope writes a blank for a missing sample, even if blanks separate the cells.
pub(crate) fn split_samples<'t>(line: &'t str, separator: char, cells: &mut Vec<&'t str>) {
    if separator != ' ' {
        return split(line, separator, cells);
    }
    cells.clear();
    let mut rest = line;
    loop {
        let content = usize::from(rest.starts_with(' '));
        let end = rest[content..].find(' ').map(|at| at + content);
        cells.push(rest[..end.unwrap_or(rest.len())].trim());
        match end {
            Some(end) => rest = &rest[end + 1..],
            None => return,
        }
    }
}

/// The first cell, and the position of the next one.
fn first_cell(text: &str, separator: char) -> (&str, Option<usize>) {
    let quoted = text.trim_start_matches(|letter| letter == ' ' && separator != ' ').strip_prefix('"');
    let quoted = quoted.and_then(|inner| Some((inner, inner.find('"')?)));
    let (cell, from) = match quoted {
        Some((inner, end)) => (&inner[..end], text.len() - inner.len() + end + 1),
        None => ("", 0),
    };
    let end = text[from..].find(separator).map(|at| from + at);
    let cell = if quoted.is_some() { cell } else { text[..end.unwrap_or(text.len())].trim() };
    (cell, end.map(|end| end + separator.len_utf8()))
}

/// The column of a cell in its line, in characters, from 1.
pub(crate) fn column_of(line: &str, cell: &str) -> usize {
    let offset = (cell.as_ptr() as usize).saturating_sub(line.as_ptr() as usize);
    line.get(..offset).map_or(1, |before| before.chars().count() + 1)
}

/// A decimal comma as a point, if commas do not separate cells.
pub(crate) fn number(cell: &str, separator: char) -> Cow<'_, str> {
    let has_comma = separator != ',' && cell.contains(',') && !cell.contains('.');
    if has_comma { Cow::Owned(cell.replace(',', ".")) } else { Cow::Borrowed(cell) }
}

/// Whether a cell is a number, with a decimal point or comma.
pub(crate) fn is_number(cell: &str) -> bool {
    cell.replace(',', ".").parse::<f64>().is_ok()
}
