//! Text for comments: broken into lines, and harmless in every language. No language's own marks.

use std::borrow::Cow;

/// Breaks a text at blanks into lines of at most `width` characters, where a word allows it.
#[must_use]
pub fn lines(text: &str, width: usize) -> Vec<String> {
    let mut lines: Vec<String> = Vec::new();
    for word in text.split_ascii_whitespace() {
        match lines.last_mut() {
            Some(line) if line.len() + 1 + word.len() <= width => {
                line.push(' ');
                line.push_str(word);
            }
            _ => lines.push(word.to_owned()),
        }
    }
    lines
}

/// Texts as the inside of one comment: harmless, in lines of at most `width` characters, joined by what begins a line.
#[must_use]
pub fn wrapped(texts: &[impl AsRef<str>], width: usize, next_line: &str) -> String {
    let all = texts.iter().flat_map(|text| lines(&harmless(text.as_ref()), width));
    all.collect::<Vec<_>>().join(next_line)
}

/// Keeps a text from ending the comment that it stands in: `*/` and `*)` are taken apart.
#[must_use]
pub fn harmless(text: &str) -> Cow<'_, str> {
    if !text.contains('*') {
        return Cow::Borrowed(text);
    }
    let apart = text.replace("*/", "* /").replace("*)", "* )").replace("/*", "/ *").replace("(*", "( *");
    Cow::Owned(apart)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lines_are_broken_at_blanks() {
        assert_eq!(lines("one two three", 7), ["one two", "three"]);
        assert_eq!(lines("a-long-word b", 3), ["a-long-word", "b"]);
        assert!(lines("", 10).is_empty());
    }

    #[test]
    fn a_comment_cannot_be_ended_from_inside() {
        assert_eq!(harmless("a */ b *) c /* d (* e"), "a * / b * ) c / * d ( * e");
    }
}
