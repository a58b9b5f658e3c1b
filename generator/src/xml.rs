//! XML of a file, parsed in bounded time: a text that would take a parser minutes is refused before. No element is known
//! here.

use crate::diagnostics::on_a_line;
use roxmltree::{Document, ParsingOptions};

/// The reason why a text is not read, at a position or for the whole text.
#[derive(Debug)]
pub(crate) struct Refused {
    pub(crate) found: String,
    /// line and column; `None` for the whole text
    pub(crate) place: Option<(usize, usize)>,
}

/// An element of a project has ten attributes, and a project three name spaces. The parser compares each attribute with
/// those of its element, and copies all name spaces of an element to each of its children.
const MOST_ATTRIBUTES: usize = 1000;
const MOST_NAME_SPACES: usize = 200;
/// Longest name of an attribute, with the blanks after it; only the end of a longer one is examined.
const LONGEST_NAME: usize = 200;

/// Parses a text.
pub(crate) fn parse(text: &str) -> Result<Document<'_>, Refused> {
    let bounds = Bounds::of(text.as_bytes());
    for (count, most, what) in [
        (bounds.attributes, MOST_ATTRIBUTES, "attributes in one element"),
        (bounds.name_spaces, MOST_NAME_SPACES, "declarations of name spaces"),
    ] {
        if count > most {
            let found = format!("the file is XML with {count} {what}, more than the {most} that any project has");
            return Err(Refused { found, place: None });
        }
    }
    let options = ParsingOptions { allow_dtd: false, nodes_limit: 10_000_000, ..ParsingOptions::default() };
    Document::parse_with_options(text, options).map_err(|error| {
        let place = Some((error.pos().row as usize, error.pos().col as usize));
        Refused { found: format!("the file is broken XML: {}", on_a_line(&error.to_string())), place }
    })
}

/// Counts that determine the time of a parser.
#[derive(Default)]
struct Bounds {
    /// of the element with the most attributes
    attributes: usize,
    /// of all elements
    name_spaces: usize,
}

impl Bounds {
    fn of(text: &[u8]) -> Self {
        let mut bounds = Self::default();
        let mut at = 0;
        while let Some(begin) = memchr::memchr(b'<', &text[at..]) {
            at += begin;
            let skipped = [("<![CDATA[", "]]>"), ("<!--", "-->"), ("<?", "?>")].into_iter();
            let skipped = skipped.filter(|(open, _)| text[at..].starts_with(open.as_bytes()));
            match skipped.map(|(_, close)| close).next() {
                Some(close) => {
                    at = memchr::memmem::find(&text[at..], close.as_bytes()).map_or(text.len(), |end| at + end)
                }
                None => at = bounds.tag(text, at + 1),
            }
        }
        bounds
    }

    /// Counts the attributes of a tag; returns the position of its end.
    fn tag(&mut self, text: &[u8], from: usize) -> usize {
        let mut count = 0;
        let mut at = from;
        while let Some(next) = memchr::memchr3(b'=', b'>', b'<', &text[at..]) {
            at += next;
            if text[at] != b'=' {
                break;
            }
            count += 1;
            let before = text[at.saturating_sub(LONGEST_NAME).max(from)..at].trim_ascii_end();
            let name = before.iter().rposition(u8::is_ascii_whitespace).map_or(before, |blank| &before[blank + 1..]);
            self.name_spaces += usize::from(name.starts_with(b"xmlns"));
            at = value_end(text, at + 1);
        }
        self.attributes = count.max(self.attributes);
        at.min(text.len())
    }
}

/// The end of a quoted value that begins here, optionally after blanks.
fn value_end(text: &[u8], from: usize) -> usize {
    let blanks = text[from..].iter().take_while(|byte| byte.is_ascii_whitespace()).count();
    match text.get(from + blanks) {
        Some(quote @ (b'"' | b'\'')) => {
            let inside = from + blanks + 1;
            memchr::memchr(*quote, &text[inside..]).map_or(text.len(), |end| inside + end + 1)
        }
        _ => from,
    }
}
