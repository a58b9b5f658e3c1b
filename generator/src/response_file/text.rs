//! Bytes -> text -> cells and numbers: encodings, separators, quotation marks, decimal commas. No quantity is known here.

/// The separator of the cells of a line.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Separator {
    Tab,
    Semicolon,
    Comma,
    /// one or several blanks or tabs
    Blanks,
}

/// The separators in the order in which they are tried.
pub(super) const SEPARATORS: [Separator; 4] =
    [Separator::Tab, Separator::Semicolon, Separator::Comma, Separator::Blanks];

/// A cell without the blanks and quotation marks around it.
#[derive(Clone, Copy, Debug)]
pub(super) struct Cell<'t> {
    /// column of its first character, from 1
    pub column: usize,
    pub text: &'t str,
}

/// UTF-8 with or without a byte order mark, UTF-16 with one; everything else is ISO 8859-1, as written by older programs for
/// Windows.
pub(super) fn decode(bytes: &[u8]) -> String {
    let wide = |from: fn([u8; 2]) -> u16| {
        let units: Vec<u16> = bytes[2..].chunks_exact(2).map(|pair| from([pair[0], pair[1]])).collect();
        String::from_utf16_lossy(&units)
    };
    match bytes {
        [0xff, 0xfe, ..] => wide(u16::from_le_bytes),
        [0xfe, 0xff, ..] => wide(u16::from_be_bytes),
        _ => match str::from_utf8(bytes) {
            Ok(text) => text.strip_prefix('\u{feff}').unwrap_or(text).to_owned(),
            Err(_) => bytes.iter().copied().map(char::from).collect(),
        },
    }
}

/// The cells of a line. Text in quotation marks is not separated.
pub(super) fn cells(line: &str, separator: Separator) -> Vec<Cell<'_>> {
    let separates = |letter: char| match separator {
        Separator::Tab => letter == '\t',
        Separator::Semicolon => letter == ';',
        Separator::Comma => letter == ',',
        Separator::Blanks => letter.is_whitespace(),
    };
    let (mut cells, mut is_quoted, mut start, mut column) = (Vec::new(), false, 0, 1);
    let mut from = column;
    for (at, letter) in line.char_indices() {
        is_quoted ^= letter == '"';
        column += 1;
        if separates(letter) && !is_quoted {
            cells.push(cell(&line[start..at], from));
            (start, from) = (at + letter.len_utf8(), column);
        }
    }
    cells.push(cell(&line[start..], from));
    if separator == Separator::Blanks {
        cells.retain(|cell| !cell.text.is_empty());
    }
    cells
}

fn cell(text: &str, from: usize) -> Cell<'_> {
    let blanks = text.chars().take_while(|letter| letter.is_whitespace()).count();
    let trimmed = text.trim();
    let bare = trimmed.strip_prefix('"').and_then(|text| text.strip_suffix('"')).map_or(trimmed, str::trim);
    // An empty cell begins at its own position.
    Cell { column: if trimmed.is_empty() { from } else { from + blanks }, text: bare }
}

/// A finite number, with a point or a comma before its decimals.
pub(super) fn number(text: &str) -> Option<f64> {
    let is_comma = text.contains(',') && !text.contains('.');
    let text = if is_comma { text.replacen(',', ".", 1) } else { text.to_owned() };
    let text = text.replace('\u{2212}', "-");
    text.parse().ok().filter(|value: &f64| value.is_finite())
}

/// Whether a cell marks a missing number: empty, a dash, `NaN` and similar.
pub(super) fn is_missing(text: &str) -> bool {
    let text = text.to_ascii_lowercase();
    let bare = text.trim_matches(['-', '+', '#', '.', ' ', '/', '!', '?']);
    ["", "nan", "na", "n/a", "nv", "inf", "infinity", "null", "none", "1.#qnan", "1.#ind", "1.#inf"].contains(&bare)
        || bare.starts_with("1.#")
}
