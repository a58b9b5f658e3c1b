//! Splits a line into words and comments: the place of each word, and the characters that it may have. Not the meaning of a
//! word.

use super::mistake::{Mistakes, shown};

/// A word, or a text instead of one.
#[derive(Clone, Copy)]
pub(crate) struct Piece<'t> {
    /// character of the line, from 1
    pub(crate) column: usize,
    pub(crate) text: &'t str,
}

/// The beginning and the end of a comment over several lines, as words of a command.
const BLOCK_COMMENT: [&str; 2] = ["BEGIN", "END"];

/// The state between lines: a comment over several lines.
#[derive(Default)]
pub(crate) struct Comment {
    /// within a comment over several lines: line and column of `#COMMENT BEGIN`
    pub(crate) begin: Option<(usize, usize)>,
}

impl Comment {
    /// The words of a line.
    pub(crate) fn pieces<'t>(&mut self, line: &'t str, mistakes: &mut Mistakes) -> Vec<Piece<'t>> {
        let mut found = Vec::new();
        let (mut rest, mut column) = (line, 1);
        while let Some(first) = rest.chars().next() {
            let end = match self.comment_end(rest, column, mistakes.line) {
                Some(end) => end,
                None if is_blank(first) => 1,
                None => {
                    let end = word_end(rest);
                    let text = rest[..end].trim_end();
                    if is_plain(text, column, mistakes) {
                        found.push(Piece { column, text });
                    }
                    end
                }
            };
            let (text, after) = rest.split_at(end);
            column += text.chars().count();
            rest = after;
        }
        found
    }

    /// The end of the comment that begins here; `None` if no comment begins here.
    fn comment_end(&mut self, rest: &str, column: usize, line: usize) -> Option<usize> {
        let command = |word| block_comment(rest, word);
        if self.begin.is_some() {
            let end = rest
                .char_indices()
                .find_map(|(at, _)| block_comment(&rest[at..], BLOCK_COMMENT[1]).map(|end| at + end));
            if end.is_some() {
                self.begin = None;
            }
            return Some(end.unwrap_or(rest.len()));
        }
        match rest.as_bytes() {
            [b'(', ..] => Some(parenthesis_end(rest)),
            [b';', ..] | [b'/', b'/', ..] | [b'#', b' ' | b'\t', ..] => Some(rest.len()),
            [b'#', ..] => command(BLOCK_COMMENT[0]).inspect(|_| self.begin = Some((line, column))),
            _ => None,
        }
    }
}

/// Blanks, and the control characters of tapes and serial lines.
fn is_blank(letter: char) -> bool {
    matches!(letter, ' ' | '\t' | '\r' | '\0'..='\u{4}' | '\u{11}'..='\u{14}' | '\u{1a}')
}

/// The end of `#COMMENT` and this word, if they are here.
fn block_comment(rest: &str, word: &str) -> Option<usize> {
    const COMMAND: &str = "#COMMENT";
    let after =
        rest.get(..COMMAND.len()).filter(|text| text.eq_ignore_ascii_case(COMMAND)).map(|_| &rest[COMMAND.len()..])?;
    let blanks = after.len() - after.trim_start().len();
    let found = after.get(blanks..blanks + word.len())?;
    (blanks > 0 && found.eq_ignore_ascii_case(word)).then_some(COMMAND.len() + blanks + word.len())
}

/// The end of a comment. It may be unclosed, because such programs exist: then it continues to the end of its line. A nested
/// comment belongs to it if both are closed.
fn parenthesis_end(rest: &str) -> usize {
    /// No comment is longer [characters].
    const LONGEST: usize = 1000;
    let mut depth = 0_usize;
    for (at, letter) in rest.char_indices().take(LONGEST) {
        match letter {
            '(' => depth += 1,
            ')' => depth -= 1,
            _ => {}
        }
        if depth == 0 {
            return at + 1;
        }
    }
    rest.find(')').map_or(rest.len(), |end| end + 1)
}

/// The end of the word that begins here: a letter and its number, with or without a blank between; a name with brackets or
/// `=`; a command.
fn word_end(rest: &str) -> usize {
    let bytes = rest.as_bytes();
    let run = |from: usize, is: fn(u8) -> bool| from + bytes.iter().skip(from).take_while(|byte| is(**byte)).count();
    let next = |at: usize| bytes.get(at).copied().unwrap_or_default();
    let is_name = |byte: u8| byte.is_ascii_alphabetic() || byte == b'_';
    let of_number = |byte: u8| byte.is_ascii_digit() || matches!(byte, b'.' | b'+' | b'-' | b',');
    match bytes[0] {
        // An assignment, whose right side is not read either.
        b'#' => command_end(rest),
        b'O' | b'o' if next(1) == b'<' => rest.find('>').map_or(rest.len(), |end| end + 1),
        _ if matches!(next(1), b'#' | b'<') || matches!((next(1), next(2)), (b'+' | b'-', b'#')) => blank(rest),
        b'/' => run(1, |byte| byte.is_ascii_digit()),
        first if of_number(first) => run(0, of_number),
        first if is_name(first) => {
            let letters = run(0, is_name);
            let digits = run(letters, |byte| byte.is_ascii_digit());
            let is_name_with_more = letters > 1 || matches!(next(digits), b'[' | b'=');
            // S.POS=180, V.E.NAME; but X20.Y10. are two words.
            let is_angle = rest[digits..].get(..4).is_some_and(|text| text.eq_ignore_ascii_case(".POS"));
            let has_point = digits == letters && next(digits) == b'.' && next(digits + 1).is_ascii_alphabetic();
            if is_name_with_more || is_angle || has_point {
                return blank(rest);
            }
            let blanks = run(letters, |byte| matches!(byte, b' ' | b'\t'));
            if matches!(next(blanks), b'#' | b'[')
                || matches!((next(blanks), next(blanks + 1)), (b'+' | b'-', b'#' | b'['))
            {
                return blanks + blank(&rest[blanks..]);
            }
            let from = if of_number(next(blanks)) { blanks } else { letters };
            let end = run(from, of_number);
            // An exponent is part of its number, so that it is refused there.
            let is_power = end > from && !b"GMNTgmnt".contains(&first) && is_exponent(&bytes[end..]);
            if is_power || next(end) == b'[' { blank(rest) } else { end }
        }
        _ => blank(rest),
    }
}

/// Whether an exponent begins here.
fn is_exponent(text: &[u8]) -> bool {
    let digits = text.iter().skip(1).find(|byte| !matches!(byte, b'+' | b'-'));
    matches!(text, [b'e' | b'E', ..]) && digits.is_some_and(u8::is_ascii_digit)
}

/// The first blank or comment outside of brackets, or the end of the brackets.
fn blank(text: &str) -> usize {
    let mut depth = 0_usize;
    for (at, letter) in text.char_indices() {
        match letter {
            '[' => depth += 1,
            ']' if depth == 1 => return at + 1,
            ']' => depth = depth.saturating_sub(1),
            '(' | ';' if depth == 0 && at > 0 => return at,
            _ if is_blank(letter) && depth == 0 && at > 0 => return at,
            _ => {}
        }
    }
    text.len()
}

/// The end of a command: it has its arguments up to a comment. A comment sign in a quoted text does not begin a comment.
fn command_end(text: &str) -> usize {
    let mut is_quoted = false;
    for (at, letter) in text.char_indices() {
        match letter {
            '"' => is_quoted = !is_quoted,
            '(' | ';' if !is_quoted => return at,
            _ => {}
        }
    }
    text.len()
}

/// Whether a word contains only valid characters; reports the first invalid one.
fn is_plain(text: &str, column: usize, mistakes: &mut Mistakes) -> bool {
    let foreign = |letter: char| !(letter.is_ascii_graphic() || matches!(letter, ' ' | '\t'));
    let is_text_of_command = text.starts_with('#') && text.contains('"');
    let Some(at) = text.find(foreign).filter(|_| !is_text_of_command) else { return true };
    let run: String = text[at..].chars().take_while(|&letter| foreign(letter)).take(20).collect();
    let column = column + text[..at].chars().count();
    mistakes.push(column, format!("{run:?}"), "printable ASCII outside of comments", "ASCII, or `( )` around the text");
    false
}

/// Reports a comment without an end.
pub(crate) fn open_comment(comment: &Comment, mistakes: &mut Mistakes) {
    if let Some((line, column)) = comment.begin {
        mistakes.line = line;
        mistakes.push(column, shown("#COMMENT BEGIN"), "a comment with its end", "`#COMMENT END` in a line of its own");
    }
}
