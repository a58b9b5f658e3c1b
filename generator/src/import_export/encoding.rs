//! The text of a file, around and in a list, as texts of TOML. The contents of the lines are not known here.

use crate::config::{Encoding, latin_1};
use crate::parameters::words::ListEncoding;

/// The text before a list in its file, the list, and the text after it.
pub(super) struct Encoded {
    /// with `\n` at the end of each line
    pub(super) text: [String; 3],
    pub(super) encoding: ListEncoding,
    /// whether `\n` represents `\r\n`
    pub(super) crlf: bool,
}

/// The parts of a file as texts: in UTF-8 if they are valid, else each byte as the character of its number (latin-1).
pub(super) fn encoded(parts: [&[u8]; 3], file: Encoding) -> Encoded {
    let is_utf_8 = parts.iter().all(|part| str::from_utf8(part).is_ok());
    let encoding = match file {
        Encoding::Plain if is_utf_8 => ListEncoding::Utf8,
        Encoding::Plain | Encoding::Latin1 => ListEncoding::Latin1,
        Encoding::Utf16LittleEnd => ListEncoding::Utf16LittleEnd,
        Encoding::Utf16BigEnd => ListEncoding::Utf16BigEnd,
    };
    let text =
        parts.map(|part| str::from_utf8(part).ok().filter(|_| is_utf_8).map_or_else(|| latin_1(part), str::to_owned));
    let count = |end| text.iter().map(|text| text.matches(end).count()).sum::<usize>();
    let crlf = count("\n") > 0 && count("\r\n") == count("\n");
    Encoded { text: if crlf { text.map(|text| text.replace("\r\n", "\n")) } else { text }, encoding, crlf }
}

/// A text as a multi-line string of TOML. Characters that an editor could change unnoticed are escaped: control characters,
/// a byte order mark, a blank at the end of a line.
pub(super) fn toml_string(text: &str) -> String {
    let mut string = String::with_capacity(text.len() + text.len() / 8 + 8);
    string.push_str("\"\"\"\n");
    let mut characters = text.chars().peekable();
    while let Some(character) = characters.next() {
        let next = characters.peek().copied();
        match character {
            '\\' => string.push_str("\\\\"),
            '"' if matches!(next, None | Some('"')) => string.push_str("\\\""),
            '\r' => string.push_str("\\r"),
            '\t' | ' ' if !matches!(next, None | Some('\n' | '\r')) => string.push(character),
            '\t' => string.push_str("\\t"),
            '\n' => string.push('\n'),
            ' ' | '\u{feff}' | '\u{2028}' | '\u{2029}' | '\0'..='\u{1f}' | '\u{7f}'..='\u{9f}' => {
                string.push_str(&format!("\\u{:04X}", u32::from(character)));
            }
            other => string.push(other),
        }
    }
    string.push_str("\"\"\"");
    string
}
