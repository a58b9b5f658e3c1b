//! Undoes changes that other programs make in a generated file when they check it out or save it. They are not edits by
//! hand.
//!
//! * Version control ends lines with CR LF (`core.autocrlf`).
//! * TwinCAT's development environment does so too when it saves an object. It adds the attribute `ProductVersion` to
//!   `TcPlcObject` and an element `LineIds` for each body, after all members of the object, and writes no line end after
//!   the last line. It keeps the GUIDs, the declarations and the statements.

use std::borrow::Cow;

/// The text without changes of other programs that do not affect its meaning.
pub(crate) fn taken_back(text: &str) -> Cow<'_, str> {
    let text: Cow<'_, str> = if text.contains('\r') { text.replace("\r\n", "\n").into() } else { text.into() };
    // A file that TwinCAT did not save is unchanged.
    if !text.contains("<TcPlcObject ") || text.ends_with("\n") && !text.contains(LINE_IDS) && !text.contains(VERSION) {
        return text;
    }
    without_line_ids(&without_version(&text)).into()
}

const VERSION: &str = " ProductVersion=\"";
const LINE_IDS: &str = "<LineIds ";
const LINE_IDS_END: &str = "</LineIds>";

/// The text without the version of TwinCAT in the tag of the object.
fn without_version(text: &str) -> String {
    let version = || {
        let tag = text.find("<TcPlcObject ")?;
        let end = tag + text[tag..].find('>')?;
        let start = tag + text[tag..end].find(VERSION)?;
        let value = start + VERSION.len();
        Some(start..value + text[value..end].find('"')? + 1)
    };
    let mut text_without = text.to_owned();
    version().into_iter().for_each(|range| text_without.replace_range(range, ""));
    text_without
}

/// The text without the elements after the last declaration or body that assign numbers to lines; it ends with a line end.
fn without_line_ids(text: &str) -> String {
    let (bodies, mut rest) = text.split_at(text.rfind("]]>").unwrap_or(0));
    let mut kept = bodies.to_owned();
    while let Some((before, after)) = rest.split_once(LINE_IDS)
        && let Some((_, after)) = after.split_once(LINE_IDS_END)
    {
        kept.push_str(before.trim_end());
        rest = after;
    }
    kept.push_str(rest.trim_end());
    kept.push('\n');
    kept
}
