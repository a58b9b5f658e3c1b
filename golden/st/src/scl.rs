//! An external source of SCL -> the text for the grammar: the header of a block, the quotes around its name, `BEGIN` and
//! each `#` become blanks, so that every position stays the same. Requirements of SCL only are checked here.

use super::mistake::{Lines, Mistake};
use super::names;
use super::source::Source;

/// The tokens between the name of a block and its sections.
const HEADER: [&str; 9] = ["{", "S7_Optimized_Access", ":", "=", "'TRUE'", "}", "VERSION", ":", "0.1"];

/// The sections in the order of TIA; each occurs at most once.
const SECTIONS: [&str; 5] = ["VAR_INPUT", "VAR_OUTPUT", "VAR", "VAR_TEMP", "VAR CONSTANT"];

pub(crate) fn read(file: &str) -> Result<Source, Vec<Mistake>> {
    let mut blank = Vec::new();
    let mut reading = Reading { file, tokens: tokens(file), next: 0, blank: &mut blank };
    let mut mistake = None;
    while mistake.is_none() && reading.next < reading.tokens.len() {
        let is_type = reading.peek().1 == "TYPE";
        mistake = if is_type { reading.structure().err() } else { reading.block().err() };
    }
    if let Some((at, found, instead)) = mistake {
        return Err(vec![Lines::new(file).mistake(at, found, instead)]);
    }
    let mut bytes = file.as_bytes().to_vec();
    for at in blank {
        bytes[at] = b' ';
    }
    let text = String::from_utf8(bytes).expect("engine: only ASCII became blank");
    Ok(Source::plain(&text))
}

/// A word with its `#`, a quoted text, or a mark; with its first byte. Comments are not tokens.
fn tokens(file: &str) -> Vec<(usize, &str)> {
    let (mut tokens, mut at) = (Vec::new(), 0);
    while let Some(first) = file[at..].chars().next() {
        let rest = &file[at..];
        let word = |text: &str| {
            text.find(|c: char| !(c.is_ascii_alphanumeric() || c == '_' || c == '.')).unwrap_or(text.len())
        };
        let length = match first {
            ' ' | '\n' => 0,
            '(' if rest.starts_with("(*") => {
                at += rest[2..].find("*)").map_or(rest.len(), |end| end + 4);
                continue;
            }
            '"' | '\'' => rest[1..].find([first, '\n']).map_or(1, |end| end + 2),
            '#' => 1 + word(&rest[1..]),
            _ => word(rest).max(first.len_utf8()),
        };
        if length > 0 {
            tokens.push((at, &rest[..length]));
        }
        at += length.max(1);
    }
    tokens
}

/// The text between quotes.
fn in_quotes(token: &str) -> Option<&str> {
    let inside = token.strip_prefix('"').and_then(|rest| rest.strip_suffix('"'));
    inside.filter(|inside| !inside.contains(['"', '\n']))
}

fn is_word(token: &str) -> bool {
    token.starts_with(|c: char| c.is_ascii_alphabetic() || c == '_')
}

/// An error: its place, what was found, what to write instead.
type Found = (usize, String, String);

struct Reading<'f, 'b> {
    file: &'f str,
    tokens: Vec<(usize, &'f str)>,
    next: usize,
    blank: &'b mut Vec<usize>,
}

impl<'f> Reading<'f, '_> {
    /// The next token; after the last one, an empty one.
    fn peek(&self) -> (usize, &'f str) {
        self.tokens.get(self.next).copied().unwrap_or((self.file.len(), ""))
    }

    fn take(&mut self, wanted: &str) -> Result<usize, Found> {
        let (at, token) = self.peek();
        if token != wanted {
            return Err(self.wrong(wanted));
        }
        self.next += 1;
        Ok(at)
    }

    fn wrong(&self, wanted: &str) -> Found {
        let (at, token) = self.peek();
        let shown = token.lines().next().map_or_else(|| "the end".to_owned(), |line| format!("`{line}`"));
        (at, shown, format!("`{wanted}`"))
    }

    /// The declared name, in quotes.
    fn name(&mut self) -> Result<(), Found> {
        let (at, name) = self.peek();
        if in_quotes(name).is_none() {
            return Err(self.wrong("\"name\""));
        }
        self.next += 1;
        self.blank.extend([at, at + name.len() - 1]);
        Ok(())
    }

    /// The type of a structure. The colon of its version is used as the one that the grammar requires.
    fn structure(&mut self) -> Result<(), Found> {
        self.take("TYPE")?;
        self.name()?;
        for (wanted, stays) in [("VERSION", false), (":", true), ("0.1", false)] {
            let at = self.take(wanted)?;
            self.blank.extend((at..at + wanted.len()).filter(|_| !stays));
        }
        self.take("STRUCT")?;
        let mut before = "";
        while self.peek().1 != "END_STRUCT" {
            if before == ":" {
                self.ty()?;
            }
            before = self.any("END_STRUCT")?;
        }
        for wanted in ["END_STRUCT", ";", "END_TYPE"] {
            self.take(wanted)?;
        }
        Ok(())
    }

    fn block(&mut self) -> Result<(), Found> {
        self.take("FUNCTION_BLOCK")?;
        self.name()?;
        for wanted in HEADER {
            let at = self.take(wanted)?;
            self.blank.extend(at..at + wanted.len());
        }
        let mut last = None;
        while self.peek().1 != "BEGIN" {
            let section = self.section(last)?;
            last = Some(section);
        }
        let begin = self.take("BEGIN")?;
        self.blank.extend(begin..begin + "BEGIN".len());
        self.body()
    }

    /// A section after another one; returns its index.
    fn section(&mut self, last: Option<usize>) -> Result<usize, Found> {
        let (_, first) = self.peek();
        let is_constant = first == "VAR" && self.tokens.get(self.next + 1).is_some_and(|(_, word)| *word == "CONSTANT");
        let header = if is_constant { "VAR CONSTANT" } else { first };
        let Some(section) = SECTIONS.iter().position(|known| *known == header) else { return Err(self.wrong("BEGIN")) };
        if last.is_some_and(|last| section <= last) {
            return Err(self.wrong("BEGIN"));
        }
        let mut before = "";
        while self.peek().1 != "END_VAR" {
            if before == ":" {
                self.ty()?;
            }
            before = self.any("END_VAR")?;
        }
        self.take("END_VAR")?;
        Ok(section)
    }

    /// A type: a word of the language, or the name of a block in quotes.
    fn ty(&mut self) -> Result<(), Found> {
        let (at, token) = self.peek();
        if let Some(name) = in_quotes(token) {
            if names::taken(name) {
                return Err(self.wrong(name));
            }
            self.blank.extend([at, at + token.len() - 1]);
        } else if is_word(token) && !names::taken(token) {
            return Err(self.wrong(&format!("\"{token}\"")));
        }
        self.capitals()
    }

    fn body(&mut self) -> Result<(), Found> {
        let mut before = "";
        while self.peek().1 != "END_FUNCTION_BLOCK" {
            let (at, token) = self.peek();
            let is_argument = self.is_argument(before);
            if let Some(name) = token.strip_prefix('#').filter(|name| !name.is_empty()) {
                if is_argument {
                    return Err(self.wrong(name));
                }
                self.blank.push(at);
            } else if is_word(token) && !is_argument && !names::taken(token) {
                return Err(self.wrong(&format!("#{token}")));
            }
            self.capitals()?;
            before = self.any("END_FUNCTION_BLOCK")?;
        }
        self.take("END_FUNCTION_BLOCK").map(|_| ())
    }

    /// Whether the next token is the name of an argument: a variable of an instance, not of the block.
    fn is_argument(&self, before: &str) -> bool {
        let mark = |at: usize| self.tokens.get(self.next + at).map_or("", |(_, mark)| *mark);
        matches!(before, "(" | ",") && matches!((mark(1), mark(2)), (":", "=") | ("=", ">"))
    }

    /// The next token, unless it is the end.
    fn any(&mut self, wanted: &str) -> Result<&'f str, Found> {
        let (_, token) = self.peek();
        if token.is_empty() {
            return Err(self.wrong(wanted));
        }
        self.next += 1;
        Ok(token)
    }

    /// Keywords, types and functions are in capital letters.
    fn capitals(&self) -> Result<(), Found> {
        let (_, token) = self.peek();
        let capitals = token.to_ascii_uppercase();
        if token != capitals && names::taken(token) { Err(self.wrong(&capitals)) } else { Ok(()) }
    }
}
