//! A line, cut into words and comments: where each word stands, and which characters it may have. Not what a word says.

use super::mistake::{Mistakes, shown};

/// A word, or what stands in its place.
#[derive(Clone, Copy)]
pub(crate) struct Piece<'t> {
    /// character of the line, from 1
    pub(crate) column: usize,
    pub(crate) text: &'t str,
}

/// The words of a line.
pub(crate) fn pieces<'t>(line: &'t str, mistakes: &mut Mistakes) -> Vec<Piece<'t>> {
    let mut found = Vec::new();
    let (mut rest, mut column) = (line, 1);
    while let Some(first) = rest.chars().next() {
        let end = match first {
            ' ' | '\t' => 1,
            // A comment need not be closed: programs with open ones are about, and no word can follow in the line.
            '(' => rest.find(')').map_or(rest.len(), |end| end + 1),
            ';' => {
                mistakes.push(column, shown(rest), "comments in `( )`", "`( )` around the comment");
                rest.len()
            }
            _ => word_end(rest),
        };
        let (text, behind) = rest.split_at(end);
        if !matches!(first, ' ' | '\t' | '(' | ';') && is_plain(text, column, mistakes) {
            found.push(Piece { column, text });
        }
        column += text.chars().count();
        rest = behind;
    }
    found
}

/// The first blank or comment outside of brackets.
fn word_end(text: &str) -> usize {
    let mut inside = false;
    for (at, letter) in text.char_indices() {
        match letter {
            '[' => inside = true,
            ']' => inside = false,
            ' ' | '\t' | '(' | ';' if !inside => return at,
            _ => {}
        }
    }
    text.len()
}

/// Whether a word has the characters of words only; says where it has not.
fn is_plain(text: &str, column: usize, mistakes: &mut Mistakes) -> bool {
    let foreign = |letter: char| !(letter.is_ascii_graphic() || matches!(letter, ' ' | '\t'));
    let Some(at) = text.find(foreign) else { return true };
    let run: String = text[at..].chars().take_while(|&letter| foreign(letter)).take(20).collect();
    let column = column + text[..at].chars().count();
    mistakes.push(column, format!("{run:?}"), "printable ASCII outside of comments", "ASCII, or `( )` around the text");
    false
}
