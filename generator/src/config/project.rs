//! The axis lists of a file: the file is a list, or a project of TwinCAT (`.xti`, `.tsproj`), whose elements `AchsMds`
//! contain one list for each axis of the CNC as CDATA. Axes of the NC have no list; `nc_axis` makes one. No line of a list
//! is read.

use super::nc_axis::{self, NcAxis};
use super::{axis_name, source::Source, value::shown};
use crate::codes;
use crate::diagnostics::{Diagnostic, Place, Report};
use crate::xml;
use roxmltree::{Document, Node};
use std::{ops::Range, sync::Arc};

/// The list of an axis, and its place in the file.
#[derive(Debug)]
pub(crate) struct AxisList {
    pub(crate) source: Arc<Source>,
    pub(crate) range: Range<usize>,
    /// the name of the axis in a project, if it is an allowed name
    pub(crate) name: Option<String>,
    /// for an axis of the NC: the sources of its list
    pub(crate) said: Option<Diagnostic>,
}

/// The element that contains a list.
const ELEMENT: &str = "AchsMds";

/// The lists of a file, at least one.
pub(crate) fn lists(source: &Arc<Source>) -> Result<Vec<AxisList>, Report> {
    let of = |range, name| AxisList { source: Arc::clone(source), range, name, said: None };
    let text = source.bytes.strip_prefix(b"\xEF\xBB\xBF").unwrap_or(&source.bytes);
    if !text.trim_ascii_start().starts_with(b"<") {
        return Ok(vec![of(0..source.bytes.len(), None)]);
    }
    let refused = |found: &str| refused(source, found);
    let shift = source.bytes.len() - text.len();
    let text = str::from_utf8(text).map_err(|_| Report::from(refused("the file is XML, and not UTF-8")))?;
    let document = xml::parse(text).map_err(|xml::Refused { found, place }| {
        let said = refused(&found);
        let (line, column) = place.unwrap_or((said.place.line, said.place.column));
        let place = Place { line, column, ..said.place };
        Report::from(Diagnostic { place, ..said })
    })?;
    let elements = document.descendants().filter(|node| node.has_tag_name(ELEMENT) && node.text().is_some());
    let found: Vec<AxisList> = elements
        .map(|element| {
            let range = list_in(element, text).ok_or_else(|| {
                let said = refused(&format!("the element {ELEMENT} has its list in another form than one CDATA"));
                Report::from(Diagnostic { place: source.place(shift + element.range().start), ..said })
            })?;
            Ok(of(range.start + shift..range.end + shift, name_of(element)))
        })
        .collect::<Result<_, Report>>()?;
    if !found.is_empty() {
        return Ok(found);
    }
    let list =
        |NcAxis { source, name, said }| AxisList { range: 0..source.bytes.len(), source, name, said: Some(said) };
    let of_nc: Vec<AxisList> = nc_axis::lists(&document, source).into_iter().map(list).collect();
    if of_nc.is_empty() { Err(refused(&without_list(&document)).into()) } else { Ok(of_nc) }
}

fn refused(source: &Source, found: &str) -> Diagnostic {
    Diagnostic::error(codes::PROJECT, source.whole(), found)
        .allowed("an axis list, or a project of TwinCAT with the element AchsMds of an axis, or with an axis of the NC")
}

fn without_list(document: &Document<'_>) -> String {
    let found = format!("the file is XML, and no element {ELEMENT} of it holds an axis list");
    let files = nc_axis::files(document);
    let Some(first) = files.first() else { return found };
    let (count, first) = (files.len(), shown(first));
    format!("{found}; its {count} axes of TwinCAT NC are in files of their own, the first in {first}")
}

/// The text of the only CDATA section of an element.
fn list_in(element: Node<'_, '_>, text: &str) -> Option<Range<usize>> {
    let range = element.range();
    let (open, close) = ("<![CDATA[", "]]>");
    let inside = &text[range.clone()];
    let start = inside.find(open)? + open.len();
    let end = inside.find(close)?;
    let is_alone = inside[end + close.len()..].trim_start().starts_with("</")
        && inside[..start - open.len()].trim_end().ends_with('>');
    is_alone.then_some(range.start + start..range.start + end)
}

/// The name of the innermost element around a list that has one for an axis.
fn name_of(element: Node<'_, '_>) -> Option<String> {
    let mut names = element.ancestors().filter_map(|above| {
        let mut inside = above.children().filter(|child| child.has_tag_name("ItemName") || child.has_tag_name("Name"));
        inside.find_map(|name| name.text())
    });
    names.find_map(axis_name::of_tree_item)
}

/// The list of the axis with this name, or the only one.
pub(crate) fn of_axis(mut lists: Vec<AxisList>, name: Option<&str>) -> Result<AxisList, Report> {
    let is_it = |list: &AxisList| name.zip(list.name.as_deref()).is_some_and(|(a, b)| a.eq_ignore_ascii_case(b));
    let matching: Vec<usize> = (0..lists.len()).filter(|at| lists.len() == 1 || is_it(&lists[*at])).collect();
    match matching[..] {
        [only] => Ok(lists.swap_remove(only)),
        [first, second, ..] => Err(lists[second].twice(&lists[first], name.unwrap_or_default()).into()),
        [] => {
            let found = match name {
                Some(name) => format!("the project has several axes, and none is called {}", shown(name)),
                None => "the project has several axes".to_owned(),
            };
            let names: Vec<&str> = lists.iter().filter_map(|list| list.name.as_deref()).collect();
            let said = Diagnostic::error(codes::NO_AXIS, lists[0].source.whole(), found);
            Err(match names[..] {
                [] => said.instead("a file for each axis: none of them has a name in this one"),
                _ => said.allowed(format!("the name of one of them: {}", names.join(", "))),
            }
            .into())
        }
    }
}

impl AxisList {
    /// The line of the project in which the list begins; the whole file, if it is a list.
    pub(crate) fn place(&self) -> Place {
        let of_list = || match self.range.start {
            0 => self.source.whole(),
            start => self.source.place(start),
        };
        Place { column: 0, ..self.said.as_ref().map_or_else(of_list, |said| said.place.clone()) }
    }

    /// Refuses a list whose axis has the name of another one.
    pub(crate) fn twice(&self, first: &Self, name: &str) -> Diagnostic {
        let found = format!("the project has two axes {}; the first is in line {}", shown(name), first.place().line);
        Diagnostic::error(codes::AXIS_TWICE, self.place(), found).instead("another name for one of them in the project")
    }

    pub(crate) fn bytes(&self) -> &[u8] {
        &self.source.bytes[self.range.clone()]
    }

    /// The bytes of the file before the list, and after it.
    pub(crate) fn around(&self) -> [&[u8]; 2] {
        [&self.source.bytes[..self.range.start], &self.source.bytes[self.range.end..]]
    }
}
