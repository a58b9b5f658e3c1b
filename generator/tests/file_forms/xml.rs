//! XML as a tree of elements, read back by a parser that is not ours; what is not well-formed is an error.

use quick_xml::XmlVersion;
use quick_xml::escape::resolve_predefined_entity;
use quick_xml::events::{BytesStart, Event};
use quick_xml::reader::Reader;

/// An element.
#[derive(Debug, Default)]
pub struct Element {
    /// its name
    pub name: String,
    /// names and values, in their order
    pub attributes: Vec<(String, String)>,
    /// the elements inside it
    pub children: Vec<Self>,
    /// the text directly inside it, without what only separates elements
    pub text: String,
    /// how many CDATA sections the text has
    pub sections: usize,
}

impl Element {
    /// An attribute.
    pub fn attribute(&self, name: &str) -> &str {
        let found = self.attributes.iter().find(|(key, _)| key == name);
        found.map_or_else(|| panic!("<{}> has no {name}", self.name), |(_, value)| value)
    }

    /// The elements of a name inside this one.
    pub fn all<'e>(&'e self, name: &str) -> impl Iterator<Item = &'e Self> {
        self.children.iter().filter(move |child| child.name == name)
    }

    /// The element that a path of names leads to, each of which is there once.
    pub fn at<'e>(&'e self, path: &str) -> &'e Self {
        path.split('/').fold(self, |element, name| {
            let found: Vec<&Self> = element.all(name).collect();
            assert_eq!(found.len(), 1, "<{name}> in <{}>", element.name);
            found[0]
        })
    }
}

/// The outermost element.
pub fn read(file: &str) -> Result<Element, String> {
    let mut reader = Reader::from_str(file.strip_prefix('\u{feff}').unwrap_or(file));
    reader.config_mut().check_comments = true;
    let mut open = vec![Element::default()];
    loop {
        let event = reader.read_event().map_err(|error| error.to_string())?;
        let top = open.last_mut().ok_or("more ends than starts")?;
        match event {
            Event::Start(start) => open.push(element(&start)?),
            Event::Empty(start) => top.children.push(element(&start)?),
            Event::End(_) => {
                let element = open.pop().ok_or("more ends than starts")?;
                open.last_mut().ok_or("more ends than starts")?.children.push(element);
            }
            Event::Text(text) => {
                if text.contains("]]>") {
                    return Err("`]]>` in a text".to_owned());
                }
                top.text.push_str(&text);
            }
            Event::CData(text) => {
                top.sections += 1;
                top.text.push_str(&text);
            }
            Event::GeneralRef(reference) => match reference.resolve_char_ref().map_err(|error| error.to_string())? {
                Some(letter) => top.text.push(letter),
                None => top.text.push_str(resolve_predefined_entity(&reference).ok_or("an unknown entity")?),
            },
            Event::Decl(_) | Event::Comment(_) => {}
            Event::PI(_) | Event::DocType(_) => return Err("more than elements and comments".to_owned()),
            Event::Eof => break,
        }
    }
    let [outside] = <[Element; 1]>::try_from(open).map_err(|open| format!("<{}> without end", open[1].name))?;
    if !outside.text.trim().is_empty() {
        return Err(format!("text outside the elements: {}", outside.text.trim()));
    }
    let [root] = <[Element; 1]>::try_from(outside.children).map_err(|roots| format!("{} roots", roots.len()))?;
    Ok(root)
}

fn element(start: &BytesStart<'_>) -> Result<Element, String> {
    let mut element = Element { name: start.name().as_ref().to_owned(), ..Element::default() };
    for attribute in start.attributes() {
        let attribute = attribute.map_err(|error| error.to_string())?;
        if attribute.value.contains('<') {
            return Err(format!("`<` in an attribute of <{}>", element.name));
        }
        let value = attribute.normalized_value(XmlVersion::Explicit1_0).map_err(|error| error.to_string())?;
        element.attributes.push((attribute.key.as_ref().to_owned(), value.into_owned()));
    }
    Ok(element)
}

#[test]
fn what_is_not_well_formed_is_refused() {
    let broken = [
        "",
        "<a>",
        "</a>",
        "<a></b>",
        "<a/><b/>",
        "x<a/>",
        "<a/>x",
        "<a b='1' b='2'/>",
        "<a b=1/>",
        "<a b='<'/>",
        "<a>&x;</a>",
        "<a>&</a>",
        "<a>]]></a>",
        "<a><![CDATA[</a>",
        "<a><!-- -- --></a>",
        "<a b='&'/>",
    ];
    let taken: Vec<&str> = broken.into_iter().filter(|text| read(text).is_ok()).collect();
    assert_eq!(taken, [""; 0]);
}

#[test]
fn what_is_well_formed_is_read() {
    let root = read("<?xml version=\"1.0\"?><!-- c --><a x='&lt;1'>t&amp;<b/><![CDATA[<&]]>&#65;</a>").unwrap();
    assert_eq!((root.attribute("x"), root.text.as_str(), root.sections), ("<1", "t&<&A", 1));
    assert_eq!(root.at("b").children.len(), 0);
}
