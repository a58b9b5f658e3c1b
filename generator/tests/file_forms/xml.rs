//! XML as a tree of elements, read back by a library; what is not well-formed is an error. No rule of a file form.

use roxmltree::{Document, Node};

#[derive(Debug, Default)]
pub struct Element {
    pub name: String,
    /// names and values, in their order
    pub attributes: Vec<(String, String)>,
    pub children: Vec<Self>,
    /// the text directly inside it, without what only separates elements
    pub text: String,
}

impl Element {
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

pub fn read(file: &str) -> Result<Element, String> {
    let document = Document::parse(file).map_err(|error| error.to_string())?;
    if document.descendants().any(|node| node.is_pi()) {
        return Err("more than elements and comments".to_owned());
    }
    Ok(element(document.root_element()))
}

fn element(node: Node<'_, '_>) -> Element {
    let own = |pair: (&str, &str)| (pair.0.to_owned(), pair.1.to_owned());
    // The library keeps a namespace apart from the attributes; here it is the attribute that it is in the file.
    let outside = node.parent().and_then(|parent| parent.default_namespace());
    let space = node.default_namespace().filter(|space| Some(*space) != outside);
    let attributes = node.attributes().map(|attribute| (attribute.name(), attribute.value()));
    let texts = node.children().filter(Node::is_text);
    Element {
        name: node.tag_name().name().to_owned(),
        attributes: space.map(|space| ("xmlns", space)).into_iter().chain(attributes).map(own).collect(),
        text: texts.filter_map(|text| text.text()).collect(),
        children: node.children().filter(Node::is_element).map(element).collect(),
    }
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
    assert_eq!((root.attribute("x"), root.text.as_str()), ("<1", "t&<&A"));
    assert_eq!(root.at("b").children.len(), 0);
}
