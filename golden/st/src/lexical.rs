//! The text character by character: the comments, pragmas and letters that a file form may contain, and the notation of
//! numbers.

use super::mistake::Mistakes;
use super::{Dialect, number};

/// The result for the parser.
pub(crate) struct Letters {
    /// positions of reported errors that may confuse the parser
    pub(crate) places: Vec<usize>,
    /// the end of the text: before an unclosed comment, whose end the parser would search again and again
    pub(crate) end: usize,
}

/// Reports lexical errors.
pub(crate) fn check(dialect: Dialect, text: &str, mistakes: &mut Mistakes<'_>) -> Letters {
    letters(dialect, text, mistakes);
    let mut scan = Scan { dialect, text, at: 0, mistakes, places: Vec::new(), end: text.len() };
    while scan.at < text.len() {
        scan.token();
    }
    Letters { places: scan.places, end: scan.end }
}

/// Reports one error for each run of letters that some compiler rejects.
fn letters(dialect: Dialect, text: &str, mistakes: &mut Mistakes<'_>) {
    let foreign = |letter: char| match dialect {
        Dialect::Plain => !letter.is_ascii() || control(letter),
        Dialect::TwinCat | Dialect::Codesys => control(letter),
        Dialect::Scl => !letter.is_ascii() || letter.is_control() && letter != '\n',
    };
    let mut rest = text;
    while let Some(start) = rest.find(foreign) {
        let at = text.len() - rest.len() + start;
        let found = &rest[start..];
        let end = found.find(|letter| !foreign(letter)).unwrap_or(found.len());
        let shown: String = found[..end].chars().take(20).collect();
        mistakes.push(at, format!("{shown:?}"), "ASCII");
        rest = &found[end..];
    }
}

fn control(letter: char) -> bool {
    letter.is_control() && !matches!(letter, '\n' | '\r' | '\t')
}

struct Scan<'a, 't> {
    dialect: Dialect,
    text: &'a str,
    at: usize,
    mistakes: &'a mut Mistakes<'t>,
    places: Vec<usize>,
    end: usize,
}

impl Scan<'_, '_> {
    fn token(&mut self) {
        let rest = &self.text[self.at..];
        let mut bytes = rest.bytes();
        match (bytes.next().unwrap_or_default(), bytes.next().unwrap_or_default()) {
            (b'(', b'*') => self.comment(rest),
            (b'/', b'/') => {
                if self.dialect != Dialect::TwinCat {
                    self.mistakes.push(self.at, "`//`", "`(* *)`");
                }
                self.at += rest.find('\n').unwrap_or(rest.len());
            }
            (b'{', _) => self.pragma(rest),
            (quote @ (b'\'' | b'"'), _) => {
                self.say("a string", "a number or a BOOL");
                let line = rest.find('\n').unwrap_or(rest.len());
                self.at += rest[1..line.max(1)].find(char::from(quote)).map_or(line.max(1), |end| end + 2);
            }
            (b'.', b'.') => self.at += 2,
            (b'%', _) => {
                self.at += rest
                    .find(|letter: char| !matches!(letter, '%' | '.' | '0'..='9' | 'A'..='Z' | 'a'..='z'))
                    .unwrap_or(rest.len())
            }
            (b'0'..=b'9', _) | (b'.', b'0'..=b'9') => self.number(rest),
            (b'A'..=b'Z' | b'a'..=b'z' | b'_', _) => self.word(rest),
            _ => self.at += rest.chars().next().map_or(1, char::len_utf8),
        }
    }

    /// Reports an error at this position; it may confuse the parser too.
    fn say(&mut self, found: impl Into<String>, instead: impl Into<String>) {
        self.mistakes.push(self.at, found, instead);
        self.places.push(self.at);
    }

    fn comment(&mut self, rest: &str) {
        let Some(end) = rest[2..].find("*)") else {
            self.say("a comment that does not end", "`*)`");
            self.end = self.at;
            self.at = self.text.len();
            return;
        };
        for (inner, _) in rest[2..2 + end].match_indices("(*") {
            self.mistakes.push(self.at + 2 + inner, "a comment inside a comment", "one comment");
        }
        self.at += end + 4;
    }

    fn pragma(&mut self, rest: &str) {
        let end = rest.find('}').map_or(rest.len(), |end| end + 1);
        if self.dialect != Dialect::TwinCat {
            self.say("a pragma", "nothing, or a comment");
        } else if !rest[..end].to_ascii_lowercase().starts_with("{attribute ") {
            self.say("a pragma", "`{attribute ...}`, or a comment");
        }
        self.at += end;
    }

    fn number(&mut self, rest: &str) {
        let digits = |text: &str| text.bytes().take_while(|byte| byte.is_ascii_digit() || *byte == b'_').count();
        let mut end = digits(rest);
        if rest[end..].starts_with('#') {
            end += 1;
            end += rest[end..].bytes().take_while(|byte| byte.is_ascii_hexdigit() || *byte == b'_').count();
        } else {
            if rest[end..].starts_with('.') && !rest[end..].starts_with("..") {
                end += 1;
                end += digits(&rest[end..]);
            }
            if let Some(exponent) = rest[end..].strip_prefix(['E', 'e']) {
                let sign = usize::from(exponent.starts_with(['+', '-']));
                let count = digits(&exponent[sign..]);
                end += if count > 0 { 1 + sign + count } else { 0 };
            }
        }
        if let Some((found, instead)) = number::mistake(&rest[..end]) {
            self.say(found, instead);
        }
        self.at += end.max(1);
    }

    fn word(&mut self, rest: &str) {
        let letter = |byte: &u8| byte.is_ascii_alphanumeric() || *byte == b'_';
        let mut end = rest.bytes().take_while(letter).count();
        if rest[end..].starts_with('#') {
            end += 1;
            let value = |byte: &u8| letter(byte) || matches!(byte, b'+' | b'-' | b'.' | b'#' | b':');
            end += rest[end..].bytes().take_while(value).count();
            self.say(format!("`{}`", &rest[..end]), "the number without a type");
        }
        self.at += end;
    }
}
