//! Lines of code: text is written as if it fitted into its line, and a line that is too long is broken when it ends.

/// Characters in a line of code, where it can be broken.
const WIDTH: usize = 120;
/// A level of indentation.
const INDENTATION: &str = "    ";

#[derive(Default)]
pub(super) struct Lines {
    text: String,
    /// the position at which the present line begins
    begin: usize,
    /// the levels before the next line
    pub(super) level: usize,
    /// the parts of the present line that may begin a new line, outer ones first
    parts: Vec<Part>,
}

/// A part of a line: it begins a new line unless it fits into the present one, with all up to the next part.
struct Part {
    /// the position of the blank before it
    blank: usize,
    end: usize,
    /// the levels before a new line
    level: usize,
}

/// A place in the present line.
pub(super) struct Place {
    text: usize,
    parts: usize,
}

impl Lines {
    pub(super) fn text(&mut self, text: &str) {
        if self.begin == self.text.len() {
            indent(&mut self.text, self.level);
        }
        self.text.push_str(text);
    }

    /// Ends the line.
    pub(super) fn end(&mut self) {
        if self.text.len() > self.begin + WIDTH && !self.parts.is_empty() {
            self.fold();
        }
        self.parts.clear();
        self.text.push('\n');
        self.begin = self.text.len();
    }

    /// The position at which the present line begins.
    pub(super) fn begin(&self) -> usize {
        self.begin
    }

    /// Joins the lines from a position on, if they fit into one.
    pub(super) fn join(&mut self, begin: usize) {
        let mut lines = self.text[begin..].lines();
        let mut joined = lines.next().unwrap_or_default().to_owned();
        lines.for_each(|line| {
            joined.push(' ');
            joined.push_str(line.trim_start());
        });
        if joined.len() <= WIDTH {
            self.text.truncate(begin);
            self.text.push_str(&joined);
            self.end();
        }
    }

    /// A blank, or a new line if the part that begins here does not fit into the present one.
    pub(super) fn begin_part(&mut self) -> usize {
        let blank = self.text.len();
        self.parts.push(Part { blank, end: blank, level: self.level });
        self.text.push(' ');
        self.parts.len() - 1
    }

    pub(super) fn end_part(&mut self, part: usize) {
        self.parts[part].end = self.text.len();
    }

    pub(super) fn place(&self) -> Place {
        Place { text: self.text.len(), parts: self.parts.len() }
    }

    /// Encloses what was written since a place in parentheses; lines that begin in it are indented by more levels.
    pub(super) fn enclose(&mut self, since: &Place, levels: usize) {
        self.text.insert(since.text, '(');
        self.text.push(')');
        for part in &mut self.parts[since.parts..] {
            part.blank += 1;
            part.end += 1;
            part.level += levels;
        }
    }

    /// Breaks the present line.
    fn fold(&mut self) {
        let line = self.text.split_off(self.begin);
        // What is written already, the column after that, and the end of a part that fits: those inside it do, too.
        let (mut written, mut column, mut fits_until) = (0, 0, 0);
        for (index, part) in self.parts.iter().enumerate() {
            let [blank, end] = [part.blank, part.end].map(|position| position - self.begin);
            let next = self.parts[index..].iter().map(|next| next.blank - self.begin).find(|next| *next >= end);
            if blank < fits_until {
                continue;
            }
            if column + next.unwrap_or(line.len()) - written <= WIDTH {
                fits_until = end;
                continue;
            }
            self.text.push_str(&line[written..blank]);
            self.text.push('\n');
            indent(&mut self.text, part.level);
            (written, column) = (blank + 1, part.level * INDENTATION.len());
        }
        self.text.push_str(&line[written..]);
    }

    /// All lines.
    pub(super) fn into_text(self) -> String {
        self.text
    }
}

fn indent(text: &mut String, levels: usize) {
    (0..levels).for_each(|_| text.push_str(INDENTATION));
}
