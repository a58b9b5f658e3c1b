//! An axis list as lines, each split into its parts. The parts of all lines together are the file, byte for byte, for any
//! file. No parameter, value or message is here.
//!
//! `#`, `(`, `/*`, `;` or `//` begins a comment, in which every byte is legal, to the end of the line. Within a string in
//! double quotes they do not begin a comment.

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Line<'a> {
    pub(crate) at: usize,
    pub(crate) content: Content<'a>,
    /// the end of the line: `\n` or `\r\n`; the last line may end with `\r`, or with nothing
    pub(crate) end: &'a [u8],
}

/// A comment begins with its sign; it is empty if there is none. `Unreadable`: a byte that is legal only in a comment is
/// outside of one, the first at `at`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Content<'a> {
    Remark { indent: &'a [u8], comment: &'a [u8] },
    Statement(Statement<'a>),
    Unreadable { text: &'a [u8], at: usize },
}

/// A line with a path, in the order of its parts.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Statement<'a> {
    pub(crate) indent: &'a str,
    pub(crate) path: &'a str,
    /// blanks between path and value; empty if there is no value
    pub(crate) gap: &'a str,
    /// the value, and what a controller treats as a comment after it
    pub(crate) value: &'a str,
    /// blanks before the comment, or before the end
    pub(crate) space: &'a str,
    pub(crate) comment: &'a [u8],
}

/// Splits a list into its byte order mark, which some editors write before the text, and its lines.
pub(crate) fn split(bytes: &[u8]) -> (&[u8], Lines<'_>) {
    let (mark, _) = bytes.split_at(if bytes.starts_with(b"\xEF\xBB\xBF") { 3 } else { 0 });
    // Without a branch, so that the processor can check many bytes at once.
    let is_plain = bytes.iter().fold(true, |plain, byte| plain & (is_legal(*byte) | matches!(byte, b'\n' | b'\r')));
    let text = if is_plain { str::from_utf8(bytes).ok() } else { None };
    (mark, Lines { bytes, text, next: mark.len() })
}

#[derive(Clone, Debug)]
pub(crate) struct Lines<'a> {
    bytes: &'a [u8],
    /// the file as text if every byte is legal outside of a comment: then no line needs a check of each of its bytes
    text: Option<&'a str>,
    next: usize,
}

impl<'a> Iterator for Lines<'a> {
    type Item = Line<'a>;

    fn next(&mut self) -> Option<Line<'a>> {
        let at = self.next;
        let rest = self.bytes.get(at..).filter(|rest| !rest.is_empty())?;
        self.next = at + memchr::memchr(b'\n', rest).map_or(rest.len(), |end| end + 1);
        let line = &self.bytes[at..self.next];
        let text = line.strip_suffix(b"\n").unwrap_or(line);
        let text = text.strip_suffix(b"\r").unwrap_or(text);
        let (text, end) = line.split_at(text.len());
        Some(Line { at, content: content(text, self.text.map(|whole| &whole[at..])), end })
    }
}

impl Statement<'_> {
    /// Whether the list ends here: a controller ignores everything after a line `Ende`.
    pub(crate) fn is_end(&self) -> bool {
        self.path.eq_ignore_ascii_case("ende") && self.value.is_empty()
    }

    pub(crate) fn path_at(&self) -> usize {
        self.indent.len()
    }

    pub(crate) fn comment_at(&self) -> usize {
        self.value_at() + self.value.len() + self.space.len()
    }

    /// The position in the line where the value begins, or would begin.
    pub(crate) fn value_at(&self) -> usize {
        self.indent.len() + self.path.len() + self.gap.len()
    }
}

fn is_legal(byte: u8) -> bool {
    matches!(byte, b' '..=b'~' | b'\t')
}

/// The parts of a line without its end. `plain` is the file from there on if all its bytes except line ends are legal.
fn content<'a>(line: &'a [u8], plain: Option<&'a str>) -> Content<'a> {
    let end = match comment_start(line) {
        Ok(end) => end,
        Err(at) => return Content::Unreadable { text: line, at: first_illegal(line).unwrap_or(at) },
    };
    let (text, comment) = line.split_at(end);
    let text = match plain {
        Some(plain) => &plain[..end],
        None => match (first_illegal(text), str::from_utf8(text)) {
            (None, Ok(text)) => text,
            (illegal, _) => return Content::Unreadable { text: line, at: illegal.unwrap_or(0) },
        },
    };
    let (statement, space) = text.split_at(text.trim_ascii_end().len());
    if statement.is_empty() {
        return Content::Remark { indent: space.as_bytes(), comment };
    }
    let (indent, statement) = statement.split_at(statement.len() - statement.trim_ascii_start().len());
    let path_end = memchr::memchr2(b' ', b'\t', statement.as_bytes()).unwrap_or(statement.len());
    let (path, rest) = statement.split_at(path_end);
    let (gap, value) = rest.split_at(rest.len() - rest.trim_ascii_start().len());
    Content::Statement(Statement { indent, path, gap, value, space, comment })
}

/// The position where the comment of a line begins, or its end. The error is the position of a return, which is legal only
/// in a comment.
fn comment_start(line: &[u8]) -> Result<usize, usize> {
    let mut from = 0;
    loop {
        let rest = &line[from..];
        let plain = memchr::memchr3(b'#', b'(', b';', rest).unwrap_or(rest.len());
        let Some(at) = memchr::memchr3(b'/', b'"', b'\r', &rest[..plain]) else { return Ok(from + plain) };
        let after = &rest[at + 1..];
        let string = memchr::memchr2(b'"', b'\r', after).filter(|end| after[*end] == b'"');
        from += match (rest[at], after.first(), string) {
            (b'\r', ..) => return Err(from + at),
            (b'/', Some(b'*' | b'/'), _) => return Ok(from + at),
            (b'"', _, Some(end)) => at + 1 + end + 1,
            _ => at + 1,
        };
    }
}

fn first_illegal(text: &[u8]) -> Option<usize> {
    text.iter().position(|byte| !is_legal(*byte))
}
