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

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Content<'a> {
    Remark {
        indent: &'a [u8],
        /// the comment from its sign on; empty: none
        comment: &'a [u8],
    },
    Statement(Statement<'a>),
    /// a byte that only a comment may have stands outside of one
    Unreadable {
        text: &'a [u8],
        at: usize,
    },
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
    /// the comment from its sign on; empty: none
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

impl Line<'_> {
    pub(crate) fn append_to(&self, bytes: &mut Vec<u8>) {
        match self.content {
            Content::Remark { indent, comment } => bytes.extend([indent, comment].concat()),
            Content::Statement(statement) => {
                let Statement { indent, path, gap, value, space, comment } = statement;
                for part in [indent, path, gap, value, space] {
                    bytes.extend(part.as_bytes());
                }
                bytes.extend(comment);
            }
            Content::Unreadable { text, .. } => bytes.extend(text),
        }
        bytes.extend(self.end);
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

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn first(line: &[u8]) -> Content<'_> {
        split(line).1.next().map_or(Content::Remark { indent: b"", comment: b"" }, |line| line.content)
    }

    fn parts(line: &str) -> Option<(&str, &str)> {
        match first(line.as_bytes()) {
            Content::Statement(statement) => Some((statement.path, statement.value)),
            Content::Remark { .. } => None,
            Content::Unreadable { .. } => panic!("{line:?}"),
        }
    }

    fn bad(line: &[u8]) -> Option<usize> {
        match first(line) {
            Content::Unreadable { at, .. } => Some(at),
            _ => None,
        }
    }

    fn again(bytes: &[u8]) -> Vec<u8> {
        let (mark, lines) = split(bytes);
        let mut again = mark.to_vec();
        for line in lines {
            assert_eq!(line.at, again.len());
            line.append_to(&mut again);
        }
        again
    }

    #[test]
    fn statements_and_comments() {
        assert_eq!(parts("a.b 1"), Some(("a.b", "1")));
        assert_eq!(parts(" \ta.b\t 1 \t\r"), Some(("a.b", "1")));
        assert_eq!(parts("a.b 1#c"), Some(("a.b", "1")));
        assert_eq!(parts("a.b\t1\t( P-AXIS-00001 : x"), Some(("a.b", "1")));
        assert_eq!(parts("a.b"), Some(("a.b", "")));
        assert_eq!(parts("a.b VEL ACC"), Some(("a.b", "VEL ACC")));
        for comment in ["", "  ", "\r", "# a 1", "(a 1", "  ( a", "#\u{e4}"] {
            assert_eq!(parts(comment), None, "{comment:?}");
        }
    }

    #[test]
    fn every_part_has_its_place() {
        let Content::Statement(statement) = first(b"\ta  1 \t# c\r\n") else { panic!() };
        let Statement { indent, path, gap, value, space, comment } = statement;
        assert_eq!((indent, path, gap, value, space, comment), ("\t", "a", "  ", "1", " \t", &b"# c"[..]));
        assert_eq!((statement.path_at(), statement.value_at()), (1, 4));
        let Content::Statement(statement) = first(b"a  # c") else { panic!() };
        assert_eq!((statement.gap, statement.value_at(), statement.space), ("", 1, "  "));
    }

    #[test]
    fn bytes_that_only_a_comment_may_have() {
        assert_eq!(bad(b"a \xE4"), Some(2));
        assert_eq!(bad(b"a\0 1"), Some(1));
        assert_eq!(bad(b"a 1\r#"), Some(3));
        assert_eq!(bad(b"a\0 1\r#"), Some(1));
        assert_eq!(bad(b"a(\r# \xE4"), Some(2));
        assert_eq!(bad(b"a(b)( # \xE4"), None);
        assert_eq!(bad(b"a 1 # \xE4\0"), None);
        assert_eq!(bad(b"a 1 (\xB0"), None);
    }

    #[test]
    fn ends_of_lines() {
        let ends: Vec<_> = split(b"a\nb\r\n\r\n\n#\r\r\nc\r").1.map(|line| line.end).collect();
        assert_eq!(ends, [&b"\n"[..], b"\r\n", b"\r\n", b"\n", b"\r\n", b"\r"]);
    }

    /// The same line split on its own, and in a file that has other bytes elsewhere.
    fn is_split_alike(bytes: &[u8]) -> bool {
        let other = [bytes, b"\n#\xE4"].concat();
        let all = |bytes: &[u8]| split(bytes).1.map(|line| format!("{:?}", line.content)).collect::<Vec<_>>();
        all(&other).starts_with(&all(bytes))
    }

    proptest! {
        #[test]
        fn the_parts_of_any_bytes_are_the_bytes(bytes in prop::collection::vec(any::<u8>(), 0..400)) {
            prop_assert_eq!(again(&bytes), bytes);
        }

        #[test]
        fn the_parts_of_likely_bytes_are_the_bytes(bytes in prop::collection::vec(
            prop::sample::select(&b"\xEF\xBB\xBF\r\n\t a.b1#(\"\\\0\xE4"[..]), 0..200
        )) {
            prop_assert_eq!(again(&bytes), bytes);
        }

        #[test]
        fn what_stands_elsewhere_in_a_file_changes_no_line(bytes in prop::collection::vec(
            prop::sample::select(&b"\n\t a.b1#("[..]), 0..200
        )) {
            prop_assert!(is_split_alike(&bytes));
        }
    }
}
