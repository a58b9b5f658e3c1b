//! The part of a line that is the value of a parameter in the set. The value is not read.

use crate::config::lines::{Content, Line};
use crate::config::path::{self, Path};
use crate::config::{Key, own_key, spelled};
use crate::parameters::{Parameter, Scope};
use std::ops::Range;

/// The placeholder of a value that is in the set: `=`, or `=` and the spelling in the list.
pub(super) const HOLE: char = '=';

pub(super) struct Slot<'a> {
    pub(super) key: Key,
    /// the path template by which it was found; for a misprint the correct one
    pub(super) template: &'static str,
    pub(super) text: &'a str,
    pub(super) range: Range<usize>,
    /// whether it is one of axgen's own keys, in a comment
    pub(super) own: bool,
}

pub(super) fn in_line<'a>(line: &Line<'a>) -> Option<Slot<'a>> {
    match line.content {
        Content::Statement(statement) => {
            let Path::Known { name, index, spelling, misprint } = path::find(statement.path) else { return None };
            let template = if misprint { name.parameter().path } else { spelling };
            let (text, at) = value(name.parameter(), statement.value);
            let at = statement.value_at() + at;
            let slot = Slot { key: (name, index), template, text, range: at..at + text.len(), own: false };
            (name.parameter().scope == Scope::List).then_some(slot)
        }
        Content::Remark { indent, comment } => {
            let own = own_key::in_comment(comment)?;
            let ((key, template), text) = own.key().zip(own.text)?;
            let at = indent.len() + own.text_at;
            Some(Slot { key, template, text, range: at..at + text.len(), own: true })
        }
        Content::Unreadable { .. } => None,
    }
}

/// The value or its placeholder at the start of the text after a path, and its position there.
fn value<'t>(parameter: &Parameter, line: &'t str) -> (&'t str, usize) {
    match line.strip_prefix(HOLE) {
        Some(spelling) if spelling.starts_with([' ', '\t']) => (&line[..1], 0),
        Some(spelling) => (&line[..=spelled(parameter, spelling).text.len()], 0),
        None => {
            let spelled = spelled(parameter, line);
            (spelled.text, spelled.at)
        }
    }
}
