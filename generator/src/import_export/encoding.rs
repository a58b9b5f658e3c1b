//! The lines of a list, arbitrary bytes, as a text of TOML, and back; which lines they are does not matter.

/// Lines that a text of TOML can hold.
pub(super) struct Encoded {
    /// the lines, with `\n` where a line ends
    pub(super) text: String,
    /// a character stands for the byte of its number (latin-1); else for its bytes in UTF-8
    pub(super) latin_1: bool,
    /// a `\n` stands for `\r\n`
    pub(super) crlf: bool,
}

/// Bytes as text: in UTF-8 if they are that.
pub(super) fn encoded(bytes: &[u8]) -> Encoded {
    let (text, latin_1) = match str::from_utf8(bytes) {
        Ok(text) => (text.to_owned(), false),
        Err(_) => (latin_1(bytes), true),
    };
    let ends = text.matches('\n').count();
    let crlf = ends > 0 && text.matches("\r\n").count() == ends;
    Encoded { text: if crlf { text.replace("\r\n", "\n") } else { text }, latin_1, crlf }
}

/// Each byte as the character of its number.
pub(super) fn latin_1(bytes: &[u8]) -> String {
    bytes.iter().copied().map(char::from).collect()
}

impl Encoded {
    /// The bytes, or the first character that is none of latin-1.
    pub(super) fn bytes(&self) -> Result<Vec<u8>, char> {
        let text = if self.crlf { self.text.replace('\n', "\r\n") } else { self.text.clone() };
        if self.latin_1 {
            text.chars().map(|character| u8::try_from(u32::from(character)).map_err(|_| character)).collect()
        } else {
            Ok(text.into_bytes())
        }
    }
}

/// A text as a string of TOML over several lines. What an editor could change unseen is written as an escape: control
/// characters, a byte order mark, a blank at the end of a line.
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
