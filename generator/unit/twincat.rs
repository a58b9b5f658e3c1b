//! Tests of the inside of the target `twincat`: its GUIDs, and text inside a CDATA section.

use super::project::TcProgram;
use super::{NAMESPACE, guid};
use askama::Template;
use uuid::Uuid;

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
    let program = TcProgram { id: "{0}".to_owned(), suites: vec![HOSTILE.to_owned()] };
    let text = program.render().expect("the template is filled");
    let (_, rest) = text.split_once("<Declaration>").expect("there is a declaration");
    let (declaration, count) = read(rest.split_once("</Declaration>").expect("it ends").0);
    assert!(declaration.contains(&format!("    test_{HOSTILE} : {HOSTILE};\n")), "{declaration}");
    assert_eq!(count, 1 + 2 * HOSTILE.matches("]]>").count());
}

#[test]
fn text_that_ends_no_section_is_not_touched() {
    let program = TcProgram { id: "{0}".to_owned(), suites: vec!["A < B & C ]] >".to_owned()] };
    let text = program.render().expect("the template is filled");
    assert!(text.contains("\n    test_A < B & C ]] > : A < B & C ]] >;\n"), "{text}");
}

/// Figures of Python's module `uuid`: `uuid5(NAMESPACE_URL, "axgen")`, and `uuid5` of that.
#[test]
fn others_derive_the_same() {
    assert_eq!(Uuid::new_v5(&Uuid::NAMESPACE_URL, b"axgen"), NAMESPACE);
    assert_eq!(guid("POU", "PRG_axgen_tests"), "{ebd13820-5460-597f-88e6-b9a2a6e8e69d}");
}
