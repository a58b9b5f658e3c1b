//! Text for comments: broken into lines, and harmless in every language. No language's own marks.

use std::borrow::Cow;

/// Breaks a text at blanks into lines of at most `width` characters, where a word allows it.
pub(super) fn lines(text: &str, width: usize) -> Vec<String> {
    let mut lines: Vec<String> = Vec::new();
    for word in text.split_ascii_whitespace() {
        match lines.last_mut() {
            Some(line) if line.len() + 1 + word.len() <= width => {
                line.push(' ');
                line.push_str(word);
            }
            _ => {
                let mut line = String::with_capacity(width.max(word.len()));
                line.push_str(word);
                lines.push(line);
            }
        }
    }
    lines
}

/// Texts as the inside of one comment: harmless, in lines of at most `width` characters, joined by what begins a line.
pub fn wrapped(texts: &[impl AsRef<str>], width: usize, next_line: &str) -> String {
    let all = texts.iter().flat_map(|text| lines(&harmless(text.as_ref()), width));
    all.collect::<Vec<_>>().join(next_line)
}

/// Keeps a text from ending the comment that it stands in: `*/` and `*)` are taken apart.
pub fn harmless(text: &str) -> Cow<'_, str> {
    if !text.contains('*') {
        return Cow::Borrowed(text);
    }
    let apart = text.replace("*/", "* /").replace("*)", "* )").replace("/*", "/ *").replace("(*", "( *");
    Cow::Owned(apart)
}
