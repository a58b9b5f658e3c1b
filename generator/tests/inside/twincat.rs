//! Tests of the inside of the target `twincat`: its GUIDs, and text inside a CDATA section.

use askama::filters::Escaper;
use generator::target::{Cdata, guid};

/// Everything that XML could take for its own.
const HOSTILE: &str = "]]> & < > \" ' ]]]]>> <![CDATA[ ]] > &amp; <!-- --> ]]>";

/// The text of an element's sections, and how many there are.
fn read(sections: &str) -> (String, usize) {
    let (mut text, mut count, mut rest) = (String::new(), 0, sections);
    while let Some(section) = rest.strip_prefix("<![CDATA[") {
        let (inside, after) = section.split_once("]]>").unwrap_or((section, ""));
        text.push_str(inside);
        (count, rest) = (count + 1, after);
    }
    assert_eq!(rest, "", "nothing stands between the sections");
    (text, count)
}

#[test]
fn hostile_text_comes_back() {
    for (text, sections) in [(HOSTILE, 1 + HOSTILE.matches("]]>").count()), ("A < B & C ]] >", 1)] {
        let mut section = "<![CDATA[".to_owned();
        Cdata.write_escaped_str(&mut section, text).expect("a text takes what is written");
        assert_eq!(read(&(section + "]]>")), (text.to_owned(), sections));
    }
}

/// A figure of Python's module `uuid`: `uuid5(uuid5(NAMESPACE_URL, "axgen"), "POU PRG_axgen_tests")`.
#[test]
fn others_derive_the_same() {
    assert_eq!(guid("POU", "PRG_axgen_tests"), "{ebd13820-5460-597f-88e6-b9a2a6e8e69d}");
}
