//! Reads XML with an existing library, and provides the text of an element with its positions in the file. No rule of a file
//! form.

use super::Mistake;
use super::source::Source;
use roxmltree::{Document, Node};

/// The elements of a file.
pub(crate) fn read(file: &str) -> Result<Document<'_>, Vec<Mistake>> {
    Document::parse(file).map_err(|error| {
        let place = error.pos();
        vec![Mistake {
            line: place.row as usize,
            column: place.col as usize,
            found: format!("XML that is broken ({error})"),
            instead: "well-formed XML".to_owned(),
        }]
    })
}

/// The first child element with a name.
pub(crate) fn child<'n, 'f>(element: Node<'n, 'f>, name: &str) -> Option<Node<'n, 'f>> {
    element.children().find(|child| child.tag_name().name() == name)
}

/// Appends the text of an element to a source. The library decodes the text; the file is read in parallel, so that every
/// letter has its position.
pub(crate) fn append_text(element: Node<'_, '_>, source: &mut Source) {
    let file = element.document().input_text();
    for part in element.children().filter(Node::is_text) {
        let (mut at, mut is_section) = (part.range().start, false);
        for letter in part.text().unwrap_or_default().chars() {
            let mark = |is_section| if is_section { "]]>" } else { "<![CDATA[" };
            while file[at..].starts_with(mark(is_section)) {
                at += mark(is_section).len();
                is_section = !is_section;
            }
            let rest = &file[at..];
            let reference = rest.find(';').filter(|_| !is_section && rest.starts_with('&'));
            let mut bytes = [0; 4];
            let text = letter.encode_utf8(&mut bytes);
            if let Some(end) = reference {
                source.make(text, at);
                at += end + 1;
            } else {
                source.copy(text, at);
                // Two bytes for one letter: the end of a line.
                at += if rest.starts_with("\r\n") { 2 } else { letter.len_utf8() };
            }
        }
    }
}
