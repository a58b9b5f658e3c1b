//! Text for comments: broken into lines, and harmless in every language. Comment marks of a language are not known here.

use std::borrow::Cow;

/// Texts as the contents of one comment: harmless, each broken at blanks into lines of at most `width` characters, unless a
/// word is longer; lines are joined by `next_line`.
pub fn wrapped(texts: &[impl AsRef<str>], width: usize, next_line: &str) -> String {
    let mut wrapped = String::new();
    for text in texts {
        let mut column = width;
        for word in harmless(text.as_ref()).split_ascii_whitespace() {
            column += 1 + word.len();
            if column <= width {
                wrapped.push(' ');
            } else {
                wrapped.push_str(if wrapped.is_empty() { "" } else { next_line });
                column = word.len();
            }
            wrapped.push_str(word);
        }
    }
    wrapped
}

/// Prevents a text from ending its comment: `*/` and `*)` are split.
pub fn harmless(text: &str) -> Cow<'_, str> {
    if !text.contains('*') {
        return Cow::Borrowed(text);
    }
    let apart = text.replace("*/", "* /").replace("*)", "* )").replace("/*", "/ *").replace("(*", "( *");
    Cow::Owned(apart)
}
