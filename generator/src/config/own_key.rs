//! axgen's own keys in the comments of a list, `# axgen: fade 200ms`: no controller knows them. No message is pushed here.

use super::closest;
use super::path::{self, Path};
use super::value::{self, Refused, shown};
use super::values::{Key, Setting, Values, key};
use crate::codes;
use crate::diagnostics::{Diagnostic, Place, Report};
use crate::parameters::{Name, Parameter, Scope, Value, path_with};

/// The beginning of such a comment; its blanks may be more or none.
pub(crate) const OWN: &str = "# axgen: ";

/// Such a comment: its path and the text of its value, each with its position.
#[derive(Clone, Copy)]
pub(crate) struct OwnKey<'l> {
    pub(crate) path: &'l str,
    pub(crate) path_at: usize,
    /// `None` if it is not UTF-8
    pub(crate) text: Option<&'l str>,
    pub(crate) text_at: usize,
}

pub(crate) fn in_comment(comment: &[u8]) -> Option<OwnKey<'_>> {
    let rest = comment.strip_prefix(b"#")?.trim_ascii_start().strip_prefix(b"axgen:")?.trim_ascii_start();
    let path = rest.split(u8::is_ascii_whitespace).next().unwrap_or_default();
    let text = rest[path.len()..].trim_ascii_start();
    let [path_at, text_at] = [rest, text].map(|part| comment.len() - part.len());
    let path = str::from_utf8(path).unwrap_or_default();
    Some(OwnKey { path, path_at, text: str::from_utf8(text.trim_ascii_end()).ok(), text_at })
}

impl OwnKey<'_> {
    /// The key and its path template.
    pub(crate) fn key(&self) -> Option<(Key, &'static str)> {
        match path::find(self.path) {
            Path::Known { name, index, spelling, misprint: false } if is_own(name) => Some(((name, index), spelling)),
            _ => None,
        }
    }

    /// The key, its path template and its value, or the message about the comment; `places`: those of the path and of the value.
    pub(super) fn read(&self, places: [Place; 2]) -> Result<(Key, &'static str, Value), Report> {
        let [place, value_place] = places;
        let Some((key, spelling)) = self.key() else {
            let keys = || Name::ALL.into_iter().filter(|name| is_own(*name)).map(|name| name.parameter().path);
            let known = closest::nearest(self.path, keys()).map(|known| closest::with_indices_of(known, self.path));
            let found = format!("{} is not a key that a comment `# axgen:` can have", shown(self.path));
            let said = Diagnostic::error(codes::UNKNOWN, place, found).allowed(keys().collect::<Vec<_>>().join(", "));
            return Err(said.instead(known.unwrap_or_else(|| "a comment with another beginning".to_owned())).into());
        };
        let parameter = key.0.parameter();
        let found = || "is not UTF-8".to_owned();
        let no_text = || Refused { code: codes::BYTE, found: found(), allowed: parameter.allowed(), instead: None };
        let value = self.text.ok_or_else(no_text).and_then(|text| value_of(parameter, text));
        match value.and_then(|value| fit(key.0, value)) {
            Ok(value) => Ok((key, spelling, value)),
            Err(refused) => Err(refused.diagnostic(key.0, self.path, value_place).into()),
        }
    }
}

/// The messages of a reader that takes only the parameters of a list: its own keys that nothing else gives, and another cycle
/// time than the given one.
pub(super) fn unread(own: &Values, given: &Values, cycle_time: Option<&Setting>) -> Vec<Diagnostic> {
    let mut said = Vec::new();
    let is_unread = |(key, _): &(Key, &Setting)| key.0 != Name::CycleTime && given.get(*key).is_none();
    let unread: Vec<_> = own.iter().filter(is_unread).collect();
    if let Some(first) = unread.iter().map(|(_, setting)| setting).min_by_key(|setting| setting.path_at) {
        let names: Vec<_> = unread.iter().map(|(key, of)| format!("`{}`", path_with(of.spelling, key.1))).collect();
        let found =
            format!("the list has keys of axgen in comments, which only `axgen import` reads: {}", names.join(", "));
        said.push(
            Diagnostic::warning(codes::OWN_KEYS, first.path_place(), found).instead(
                "`axgen import`, which makes a set with them, or the keys in the set whose axis names the list",
            ),
        );
    }
    said.extend(other_cycle_time(own, cycle_time));
    said
}

/// The message if another cycle time is given than the one that a list was written for.
pub(crate) fn other_cycle_time(own: &Values, given: Option<&Setting>) -> Option<Diagnostic> {
    let of_list = own.get(key(Name::CycleTime))?;
    let [listed, other] = [of_list.value.as_ref()?, given?.value.as_ref()?].map(Value::text);
    let found = format!("the list was written for `cycle_time` {listed}, and {other} is given");
    let instead = format!("{listed}, or the list without this comment");
    (listed != other).then(|| Diagnostic::error(codes::OWN_KEYS, of_list.value_place(), found).instead(instead))
}

/// A value that can stand in a list: a text of a set could end its line, or the list in a project.
pub(super) fn fit(name: Name, value: Value) -> Result<Value, Refused> {
    match &value {
        Value::Text(text) if is_own(name) && (text.contains(char::is_control) || text.contains("]]>")) => {
            let allowed = "a text without control characters and without `]]>`".to_owned();
            Err(Refused { code: codes::UNFIT_TEXT, found: format!("is {}", shown(text)), allowed, instead: None })
        }
        _ => Ok(value),
    }
}

/// Whether a list can contain the key only in a comment: axgen's own keys, except those for the source of an axis.
pub(crate) fn is_own(name: Name) -> bool {
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

/// The value of such a comment. Its range is validated where the value is used.
pub(crate) fn value_of(parameter: &Parameter, text: &str) -> Result<Value, Refused> {
    let quoted = text.strip_prefix('"').and_then(|text| text.strip_suffix('"'));
    let text = quoted.unwrap_or(text);
    let refused = |code, found: String| Err(Refused { code, found, allowed: parameter.allowed(), instead: None });
    match () {
        () if quoted.is_none() && text.is_empty() => refused(codes::NO_VALUE, "has no value".to_owned()),
        () if quoted.is_none() && text.starts_with('=') => {
            refused(codes::LINE, format!("is {}: such a comment has no `=`", shown(text)))
        }
        () => value::of_text(parameter, text),
    }
}

/// The text of such a comment: nothing, and a text that could be read as another one, is in quotes.
pub(crate) fn text_of(value: &Value, text: String) -> String {
    let is_ambiguous = text.trim_ascii() != text || text.starts_with(['"', '=']);
    match value {
        Value::Text(_) if is_ambiguous => format!("\"{text}\""),
        _ if text.is_empty() => "\"\"".to_owned(),
        _ => text,
    }
}
