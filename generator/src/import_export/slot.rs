//! The part of a line that is the value of a parameter in the set. The value is not read.

use crate::config::lines::{Content, Line};
use crate::config::path::{self, Path};
use crate::config::{Key, of_text, spelled};
use crate::parameters::{Name, Parameter, Scope, Value};
use std::ops::Range;

/// The beginning of a comment with one of axgen's own keys, which a controller does not know: `# axgen: fade 200ms`.
pub(super) const OWN: &str = "# axgen: ";

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
            let (path, text) = str::from_utf8(comment).ok()?.strip_prefix(OWN)?.split_once(' ')?;
            let Path::Known { name, index, spelling: template, misprint: false } = path::find(path) else {
                return None;
            };
            let is_plain = !text.is_empty() && text.bytes().all(|byte| byte.is_ascii_graphic());
            let at = indent.len() + OWN.len() + path.len() + 1;
            let slot = Slot { key: (name, index), template, text, range: at..at + text.len(), own: true };
            (is_plain && is_own(name)).then_some(slot)
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

/// Whether a list can contain the key only in a comment: axgen's own keys, except those for the source of an axis.
pub(super) fn is_own(name: Name) -> bool {
    match name {
        Name::List
        | Name::ImportedBefore
        | Name::ImportedLines
        | Name::ImportedAfter
        | Name::ImportedEncoding
        | Name::ImportedLineEnd => false,
        Name::CycleTime => true,
        _ => name.parameter().scope == Scope::Axis,
    }
}

/// The value in one of axgen's own comments; `None` if it contains none and is an ordinary comment.
pub(super) fn own_value(key: Key, text: &str) -> Option<Value> {
    let parameter = key.0.parameter();
    of_text(parameter, text).ok().filter(|value| parameter.contains(value))
}
