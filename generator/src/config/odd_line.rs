//! Classifies a line without a parameter: text without a comment sign, a word of an NC program, a value alone, a path with
//! blanks. No message is made here.

use super::lines::{Content, Lines, Statement};
use super::path::{self, Path};
use super::{closest, value};
use crate::parameters::Name;

/// Whether the path before an illegal byte belongs to another function.
pub(super) fn is_of_another_function(before: &[u8]) -> bool {
    let before = before.trim_ascii_start();
    let end = before.iter().position(|byte| matches!(byte, b' ' | b'\t'));
    let path = end.and_then(|end| str::from_utf8(&before[..end]).ok());
    path.is_some_and(|path| match path::find(path) {
        Path::Foreign { structure, last, .. } => {
            !structure.is_some_and(closest::is_ours) && path::ending_with(last, path).is_none()
        }
        _ => false,
    })
}

/// Whether an indented line is text rather than a parameter: it has no path with a point, no index and no value sign.
pub(super) fn is_prose(line: &Statement<'_>) -> bool {
    if line.indent.is_empty() {
        return false;
    }
    let word = line.path.trim_end_matches('.');
    let has_path = word.split_once('.').is_some_and(|(first, _)| first.contains(|c: char| c.is_ascii_alphabetic()));
    !is_value(line)
        && !has_path
        && !line.path.contains(['[', ']', '='])
        && !line.value.starts_with('=')
        && joined(line).is_none()
        && !is_end_of_path(line)
}

/// Whether the first word is the end of a path and the rest a value of it: `kv 2000`.
fn is_end_of_path(line: &Statement<'_>) -> bool {
    let Some(known) = path::ending_with(line.path, line.path) else { return false };
    let Path::Known { name, .. } = path::find(&closest::with_indices_of(known, line.path)) else { return false };
    let spelled = value::spelled(name.parameter(), line.value);
    !line.value.is_empty() && !is_word(spelled.after) && value::of_text(name.parameter(), spelled.text).is_ok()
}

/// Whether `*/` is outside of a comment and of a string: it ends no comment, because that ends with its line.
pub(super) fn ends_no_comment(line: &Statement<'_>) -> bool {
    line.path.contains("*/") || line.value.rsplit('"').next().is_some_and(|text| text.contains("*/"))
}

/// The text after the end of a comment `/* ... */`, which belongs to the comment.
pub(super) fn text_after(comment: &[u8]) -> Option<usize> {
    let end = comment.strip_prefix(b"/*")?.windows(2).position(|two| two == b"*/")? + 4;
    let blanks = comment[end..].iter().position(|byte| !byte.is_ascii_whitespace())?;
    let after = &comment[end + blanks..];
    let is_comment = [&b"#"[..], b"(", b"/*", b";", b"//"].iter().any(|sign| after.starts_with(sign));
    (!is_comment).then_some(end + blanks)
}

/// The input that corresponds to a word of an NC program: `G135`, `S[G136=80]`.
pub(super) fn nc_word(path: &str) -> Option<&'static str> {
    let word = match path.as_bytes() {
        [b'S' | b's', ..] => path.split_once('[')?.1,
        _ => path,
    };
    let [b'G' | b'g', b'1', b'3', digit, rest @ ..] = word.as_bytes() else { return None };
    match (digit, rest) {
        (_, [b'0'..=b'9' | b'A'..=b'Z' | b'a'..=b'z' | b'_' | b'.', ..]) => None,
        (b'5' | b'7', _) => Some("feedforward_active"),
        (b'6', _) => Some("feedforward_percentage"),
        _ => None,
    }
}

/// Classifies a line without a path, and says what to write instead.
pub(super) fn malformed(line: &Statement<'_>) -> (String, Option<String>) {
    let written = value::shown(line.path);
    if is_value(line) {
        return (
            format!("{written} is a value without a path"),
            Some("the path before it, in the same line".to_owned()),
        );
    }
    if let Some((_, instead)) = joined(line) {
        return (format!("{written} is not a path: it ends at a blank"), Some(instead));
    }
    if let Some(path) = closest::of_id(line.path) {
        return (format!("{written} is the id of a parameter, no path"), Some(format!("{path} {}", line.value)));
    }
    let (path, rest) = line.path.split_once(['=', ':']).unwrap_or((line.path, ""));
    let value = format!("{rest} {}", line.value.trim_start_matches('='));
    let instead = matches!(path::find(path), Path::Known { .. }).then(|| format!("{path} {}", value.trim()));
    (format!("{written} is not a path"), instead)
}

/// A line whose path has blanks, without them: `weight fact denom 200`, `getriebe [0].kv 2000`; first what is wrong.
pub(super) fn joined(line: &Statement<'_>) -> Option<(&'static str, String)> {
    // A number after the path is its value.
    if !is_of_path(line.path, line.value) {
        return None;
    }
    let (_, path, rest) = known(line).filter(|(_, path, _)| path != line.path)?;
    let has_underscores = path.matches('_').count()
        > line.path.matches('_').count() + line.value.matches('_').count() - rest.matches('_').count();
    let what = match has_underscores {
        true => "not known: its name has `_` where the line has blanks",
        false => "not known: it has a blank in its path",
    };
    Some((what, format!("{path} {rest}").trim_ascii_end().to_owned()))
}

/// Whether a line is a number alone.
fn is_value(line: &Statement<'_>) -> bool {
    line.value.is_empty() && value::is_number(line.path)
}

fn is_word(text: &str) -> bool {
    text.starts_with(|letter: char| letter.is_ascii_alphabetic())
}

/// Whether a text after a blank may continue a path; by bytes, because it is asked of every parameter of another function.
fn is_of_path(path: &str, text: &str) -> bool {
    let Some(first) = text.as_bytes().first() else { return false };
    matches!(first, b'A'..=b'Z' | b'a'..=b'z' | b'_' | b'[' | b']' | b'.') || path.as_bytes().last() == Some(&b'[')
}

/// The name and the text of a path that may have blanks, also instead of underscores, and the rest of the line.
fn known<'l>(line: &Statement<'l>) -> Option<(Name, String, &'l str)> {
    if let Path::Known { name, .. } = path::find(line.path) {
        return Some((name, line.path.to_owned(), line.value));
    }
    if !is_of_path(line.path, line.value) {
        return None;
    }
    // axgen's names are shorter than the bound, which keeps a long line cheap.
    let (mut path, mut rest) = (line.path.to_owned(), line.value);
    while path.len() < 128 && is_of_path(&path, rest) {
        let word = &rest[..value::end_of_word(rest)];
        rest = rest[word.len()..].trim_ascii_start();
        let is_joined = path.ends_with(['_', '[', '.']) || word.starts_with(['_', '[', ']', '.']);
        path.extend([if is_joined { "" } else { "_" }, word]);
        if let Path::Known { name, .. } = path::find(&path) {
            return Some((name, path, rest));
        }
    }
    None
}

/// A path whose value is alone in the next line, as in text from a printed page: what was found, and both in one line.
pub(super) fn value_below(line: &Statement<'_>, below: &Lines<'_>) -> Option<(String, String)> {
    // The usual case: a value that cannot belong to the path.
    if !line.value.is_empty() && !is_word(line.value) {
        return None;
    }
    let Content::Statement(below) = below.clone().next()?.content else { return None };
    // The next line usually is a path.
    if below.path.contains('.') && below.path.starts_with(|c: char| c.is_ascii_alphabetic()) {
        return None;
    }
    let (name, path, "") = known(line)? else { return None };
    let words: Vec<&str> = std::iter::once(below.path).chain(below.value.split_ascii_whitespace()).collect();
    let value = words.join("_");
    value::of_text(name.parameter(), &value).ok()?;
    Some((format!("`{path}` has no value: it stands alone in the next line"), format!("{path} {value}")))
}

/// A character that is illegal outside of a comment: its name, and what is usually meant.
pub(super) fn bad_character(text: &[u8]) -> (String, &'static str) {
    const LONGEST: usize = 4;
    let start = &text[..text.len().min(LONGEST)];
    let letter = start.utf8_chunks().next().and_then(|chunk| chunk.valid().chars().next());
    let without = "the line without it, or a `#` before the comment";
    let Some(letter) = letter.filter(|letter| !letter.is_ascii()) else {
        return (format!("byte 0x{:02X}", text.first().copied().unwrap_or_default()), without);
    };
    let (name, instead) = match letter {
        '\u{a0}' | '\u{2007}' | '\u{202f}' => (", a no-break space,", "a blank"),
        '\u{ad}' => (", a soft hyphen,", "the line without it"),
        '\u{2010}'..='\u{2015}' | '\u{2212}' => (", a dash,", "-"),
        '\u{2018}'..='\u{201f}' => (", a typographic quote,", "\" around a string"),
        '\u{200b}'..='\u{200f}' | '\u{feff}' => (", which nobody sees,", "the line without it"),
        _ => ("", without),
    };
    (format!("the character U+{:04X}{name}", u32::from(letter)), instead)
}
