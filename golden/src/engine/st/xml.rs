//! XML as far as the two forms need it: elements, attributes, and text with its places.

use super::Mistake;
use super::mistake::Lines;
use super::source::Source;
use quick_xml::escape::resolve_predefined_entity;
use quick_xml::events::{BytesRef, BytesStart, Event};
use quick_xml::reader::Reader;

/// Elements inside each other, at most.
const DEPTH: usize = 100;

/// An element.
#[derive(Default)]
pub struct Element {
    /// its name without a prefix
    pub name: String,
    /// its first byte in the file
    pub at: usize,
    /// names and values
    attributes: Vec<(String, String)>,
    /// the elements inside it
    pub children: Vec<Self>,
    /// the text directly inside it
    text: Vec<Text>,
}

/// A part of a text.
struct Text {
    text: String,
    /// its first byte in the file
    from: usize,
    /// whether it stands there byte by byte
    copied: bool,
}

impl Element {
    /// An attribute.
    pub fn attribute(&self, name: &str) -> Option<&str> {
        self.attributes.iter().find(|(key, _)| key == name).map(|(_, value)| value.as_str())
    }

    /// The first element of a name inside this one.
    pub fn child(&self, name: &str) -> Option<&Self> {
        self.children.iter().find(|child| child.name == name)
    }

    /// All elements of a name, however deep.
    pub fn all<'e>(&'e self, name: &str, found: &mut Vec<&'e Self>) {
        for child in &self.children {
            if child.name == name {
                found.push(child);
            }
            child.all(name, found);
        }
    }

    /// Appends its text to a source.
    pub fn append_to(&self, source: &mut Source) {
        for part in &self.text {
            if part.copied {
                source.copy(&part.text, part.from);
            } else {
                source.make(&part.text, part.from);
            }
        }
    }
}

/// The outermost element of a file.
pub fn read(file: &str) -> Result<Element, Vec<Mistake>> {
    let lines = Lines::of(file);
    let bare = file.strip_prefix('\u{feff}').unwrap_or(file);
    let skipped = file.len() - bare.len();
    let mut reader = Reader::from_str(bare);
    let mut open = vec![Element::default()];
    let place = |reader: &Reader<&[u8]>| skipped + usize::try_from(reader.buffer_position()).unwrap_or_default();
    loop {
        let from = place(&reader);
        let fail = |found: String, instead: &str| Err(vec![lines.mistake(from, found, instead)]);
        let event = match reader.read_event() {
            Ok(event) => event,
            Err(error) => return fail(format!("XML that is broken ({error})"), "well-formed XML"),
        };
        let mut text = None;
        match event {
            Event::Start(start) => match element(&start, from) {
                Some(_) if open.len() > DEPTH => {
                    return fail(format!("more than {DEPTH} elements inside each other"), "fewer");
                }
                Some(element) => open.push(element),
                None => return fail(format!("the attributes of `<{}>`", &*start), "well-formed attributes"),
            },
            Event::Empty(start) => match element(&start, from) {
                Some(element) => close(&mut open, element),
                None => return fail(format!("the attributes of `<{}>`", &*start), "well-formed attributes"),
            },
            Event::End(_) => {
                if open.len() > 1
                    && let Some(element) = open.pop()
                {
                    close(&mut open, element);
                }
            }
            Event::Text(part) => text = Some(Text { text: part.to_string(), from, copied: true }),
            Event::CData(part) => {
                text = Some(Text { text: part.to_string(), from: from + "<![CDATA[".len(), copied: true });
            }
            Event::GeneralRef(part) => match letter(&part) {
                Some(letter) => text = Some(Text { text: letter, from, copied: false }),
                None => return fail(format!("`&{};`", &*part), "the letter itself"),
            },
            Event::DocType(_) => return fail("`<!DOCTYPE>`".to_owned(), "the elements alone"),
            Event::Comment(_) | Event::Decl(_) | Event::PI(_) => {}
            Event::Eof => break,
        }
        if let (Some(text), Some(element)) = (text, open.last_mut()) {
            element.text.push(text);
        }
    }
    if let [_, element, ..] = &open[..] {
        return Err(vec![lines.mistake(element.at, format!("`<{}>` without its end", element.name), "its end")]);
    }
    let root = open.pop().map(|mut outside| outside.children.drain(..).next());
    root.flatten().ok_or_else(|| vec![lines.mistake(0, "no XML", "the file form of the tool")])
}

fn close(open: &mut [Element], element: Element) {
    if let Some(parent) = open.last_mut() {
        parent.children.push(element);
    }
}

/// An element as its tag says it; `None`: an attribute is broken.
fn element(start: &BytesStart<'_>, at: usize) -> Option<Element> {
    let mut element = Element { name: start.local_name().as_ref().to_owned(), at, ..Element::default() };
    for attribute in start.attributes() {
        let attribute = attribute.ok()?;
        let value = quick_xml::escape::unescape(&attribute.value).ok()?;
        element.attributes.push((attribute.key.local_name().as_ref().to_owned(), value.into_owned()));
    }
    Some(element)
}

/// What a reference stands for.
fn letter(reference: &BytesRef<'_>) -> Option<String> {
    match reference.resolve_char_ref() {
        Ok(Some(letter)) => Some(letter.to_string()),
        Ok(None) => resolve_predefined_entity(reference).map(str::to_owned),
        Err(_) => None,
    }
}
