//! Text for comments: broken into lines, and harmless in every language. Comment marks of a language are not known here.

use std::borrow::Cow;

/// Texts as the contents of one comment: harmless, each broken at blanks into lines of at most `width` characters, unless a
/// word is longer; lines are joined by `next_line`.
pub fn wrapped(texts: &[impl AsRef<str>], width: usize, next_line: &str) -> String {
    let mut wrapped = String::new();
    for text in texts {
        let text = spaced(harmless(text.as_ref()));
        let mut rest = text.trim_ascii();
        while !rest.is_empty() {
            let line;
            (line, rest) = rest.split_at(end_of_line(rest, width));
            wrapped.extend([if wrapped.is_empty() { "" } else { next_line }, line]);
            rest = rest.trim_ascii_start();
        }
    }
    wrapped
}

/// The words of a text with one blank between two of them.
fn spaced(text: Cow<'_, str>) -> Cow<'_, str> {
    let is_spaced = text.as_bytes().windows(2).all(|pair| pair[1] > b' ' || pair[1] == b' ' && pair[0] != b' ');
    if is_spaced { text } else { text.split_ascii_whitespace().collect::<Vec<_>>().join(" ").into() }
}

/// The length of the words that fit into a line, at least one.
fn end_of_line(words: &str, width: usize) -> usize {
    let Some(start) = words.as_bytes().get(..=width) else { return words.len() };
    start.iter().rposition(|byte| *byte == b' ').or_else(|| words.find(' ')).unwrap_or(words.len())
}

/// Prevents a text from ending its comment: `*/` and `*)` are split.
pub fn harmless(text: &str) -> Cow<'_, str> {
    if !text.contains('*') {
        return Cow::Borrowed(text);
    }
    let apart = text.replace("*/", "* /").replace("*)", "* )").replace("/*", "/ *").replace("(*", "( *");
    Cow::Owned(apart)
}
