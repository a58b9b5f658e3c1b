//! An axis list as lines, each split into its parts; the parts of all lines together are the file, byte for byte, whatever
//! the file is. No parameter, no value and no message is here.
//!
//! A `#`, or a `(` at the start of a line or behind a blank, begins a comment, in which every byte is legal.

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Line<'a> {
    pub(crate) at: usize,
    pub(crate) content: Content<'a>,
    /// its end: `\n` or `\r\n`; the last line may end with `\r`, or with nothing
    pub(crate) end: &'a [u8],
}

/// A comment begins with its sign, or is empty: none. What is `Unreadable` has a byte that only a comment may have outside of one,
/// the first at `at`.
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
    /// blanks between path and value; none if there is no value
    pub(crate) gap: &'a str,
    pub(crate) value: &'a str,
    /// blanks before the comment, or before the end
    pub(crate) space: &'a str,
    pub(crate) comment: &'a [u8],
}

/// Splits a list into its byte order mark, which some editors put before the text, and its lines.
pub(crate) fn split(bytes: &[u8]) -> (&[u8], Lines<'_>) {
    let (mark, _) = bytes.split_at(if bytes.starts_with(b"\xEF\xBB\xBF") { 3 } else { 0 });
    // Without a branch, so that a processor looks at many bytes at once.
    let is_plain = bytes.iter().fold(true, |plain, byte| plain & (is_legal(*byte) | matches!(byte, b'\n' | b'\r')));
    let text = if is_plain { str::from_utf8(bytes).ok() } else { None };
    (mark, Lines { bytes, text, next: mark.len() })
}

#[derive(Clone, Debug)]
pub(crate) struct Lines<'a> {
    bytes: &'a [u8],
    /// the same if every byte is legal outside of a comment: mostly, and then no line needs a look at each of its bytes
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
    pub(crate) fn path_at(&self) -> usize {
        self.indent.len()
    }

    /// Where the value begins in its line, or would begin.
    pub(crate) fn value_at(&self) -> usize {
        self.indent.len() + self.path.len() + self.gap.len()
    }
}

fn is_legal(byte: u8) -> bool {
    matches!(byte, b' '..=b'~' | b'\t')
}

/// The parts of a line without its end; `plain` is the file from there on if all of its bytes, but for ends of lines, are legal.
fn content<'a>(line: &'a [u8], plain: Option<&'a str>) -> Content<'a> {
    let is_blank = |byte: &u8| matches!(byte, b' ' | b'\t');
    let mut end = 0;
    loop {
        end += memchr::memchr3(b'#', b'(', b'\r', &line[end..]).unwrap_or(line.len() - end);
        match line.get(end) {
            Some(b'(') if end > 0 && !is_blank(&line[end - 1]) => end += 1,
            Some(b'\r') => return Content::Unreadable { text: line, at: first_illegal(line).unwrap_or(end) },
            _ => break,
        }
    }
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

fn first_illegal(text: &[u8]) -> Option<usize> {
    text.iter().position(|byte| !is_legal(*byte))
}
