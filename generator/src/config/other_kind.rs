//! The probable kind of a file that is named as a list or a set and is not one. No parameter is read.

use super::lines::{self, Content, Statement};
use super::path::{self, Path};
use super::{list::List, project::AxisList, source::Source};
use crate::codes;
use crate::diagnostics::Diagnostic;

/// What a file seems to be, and what to do.
type FileKind = (&'static str, &'static str);

const SET: FileKind = ("seems to be a set in TOML", "the name of an axis list; the name of a set ends with .toml");

/// The only message about a file that is not a list; `None` if it is one, or nearly.
pub(crate) fn instead_of_a_list(list: &AxisList, read: &List) -> Option<Diagnostic> {
    let said = |(what, instead): FileKind| {
        let found = format!("no parameter of an axis is in the file: it {what}");
        Diagnostic::error(codes::NO_LIST, list.place(), found).allowed("an axis list").instead(instead)
    };
    let has_odd_lines = read.report.diagnostics.iter().any(|said| said.code == codes::LINE);
    // In a project the name of the file is right.
    let is_file = list.range.start == 0;
    if is_file
        && has_odd_lines
        && statements(list.bytes()).any(|line| line.path.starts_with("[axis.") || line.path.starts_with("[[axis."))
    {
        return Some(said(SET));
    }
    // If axgen has recognised something in the list, right or wrong, it reports line by line.
    let is_unknown =
        |code: &str| [codes::LINE, codes::BYTE, codes::NO_LIST, codes::NC_WORD, codes::WRAPPED].contains(&code);
    if !read.values.is_empty() || !read.report.diagnostics.iter().all(|said| is_unknown(said.code)) {
        return None;
    }
    if contents(list.bytes()).any(is_of_an_axis) {
        return None;
    }
    Some(said(match seems(list.bytes()) {
        SET if !is_file => ("is of another kind", "the list of an axis"),
        kind => kind,
    }))
}

/// Whether a list without a parameter of an axis contains a block of an NC program.
pub(crate) fn is_nc_program(list: &AxisList) -> bool {
    statements(list.bytes()).any(is_nc_block)
}

/// The only message about a set that is not TOML; `None` if its kind is not recognised.
pub(super) fn instead_of_a_set(source: &Source) -> Option<Diagnostic> {
    let is_parameter = |line: Statement<'_>| {
        matches!(path::find(line.path), Path::Known { .. }) && !line.value.is_empty() && !line.value.starts_with('=')
    };
    let is_list = statements(&source.bytes).any(is_parameter) && !statements(&source.bytes).any(is_toml);
    let said = Diagnostic::error(
        codes::NO_LIST,
        source.whole(),
        "the file seems to be an axis list, and is named as a set in TOML",
    );
    is_list.then(|| said.instead("a name that does not end with .toml, such as x.lis"))
}

fn contents(bytes: &[u8]) -> impl Iterator<Item = Content<'_>> {
    lines::split(bytes).1.map(|line| line.content)
}

fn statements(bytes: &[u8]) -> impl Iterator<Item = Statement<'_>> {
    contents(bytes).filter_map(|line| match line {
        Content::Statement(statement) => Some(statement),
        _ => None,
    })
}

/// Whether the path of a line lies in a structure of axis lists with parameters that axgen reads: `kenngr`, `getriebe[0]`.
fn is_of_an_axis(line: Content<'_>) -> bool {
    let path = match line {
        Content::Statement(statement) => statement.path.as_bytes(),
        Content::Unreadable { text, .. } => text.trim_ascii_start(),
        Content::Remark { .. } => return false,
    };
    let first = path.split(|byte| matches!(byte, b'.' | b'[')).next().unwrap_or_default();
    first.len() < path.len() && path::structures().any(|structure| structure.trim_end_matches("[]").as_bytes() == first)
}

fn seems(bytes: &[u8]) -> FileKind {
    let of_list = |first: &[&str]| {
        let is = |line: Statement<'_>| first.contains(&line.path.split(['.', '[']).next().unwrap_or_default());
        statements(bytes).any(is)
    };
    let is_unreadable = |line| matches!(line, Content::Unreadable { .. });
    match () {
        () if bytes.contains(&0) => ("is not text, or UTF-16 without its byte order mark", "the list saved as UTF-8"),
        () if statements(bytes).next().is_none() && !contents(bytes).any(is_unreadable) => {
            ("is empty, or has nothing but comments", "the name of an axis list")
        }
        () if statements(bytes).any(is_toml) => SET,
        () if statements(bytes).any(is_nc_block) => (
            "seems to be an NC program",
            "the axis list; G135, G136 and G137 are inputs of the blocks feedforward and axis",
        ),
        () if of_list(&[
            "gruppe",
            "spindel",
            "hauptspindel_ax_nr",
            "synchro_data",
            "trafo",
            "decoder",
            "kanal_bez",
        ]) =>
        {
            ("seems to be a channel list", "the list of an axis")
        }
        () if of_list(&["kanal", "kanal_anzahl", "achse", "achs_anzahl", "konfiguration", "listen"]) => {
            ("seems to be a start-up list", "the list of an axis, which it names")
        }
        () => ("is of another kind", "the name of an axis list"),
    }
}

fn is_toml(line: Statement<'_>) -> bool {
    let is_header = line.path.starts_with('[') && line.path.ends_with(']') && line.value.is_empty();
    is_header || line.value.starts_with('=') || line.path.contains('=') && !is_nc_block(line)
}

/// Whether a line is a block of an NC program: `%name`, `N10 G1`, `G136 X80`, `S[G135]`, `M30`.
fn is_nc_block(line: Statement<'_>) -> bool {
    let mut letters = line.path.trim_start_matches(['N', 'n']).chars();
    let first = line.path.chars().next().unwrap_or_default().to_ascii_uppercase();
    let is_number = |letter: Option<char>| letter.is_some_and(|letter| letter.is_ascii_digit());
    match first {
        '%' => true,
        'N' => is_number(letters.next()),
        'G' | 'M' | 'S' | 'T' | 'F' | 'X' | 'Y' | 'Z' => {
            let second = letters.nth(1);
            is_number(second) || second == Some('[') && line.path.to_ascii_uppercase().contains("[G")
        }
        _ => false,
    }
}
