//! Text inside a CDATA section: only the mark that ends it has to be taken apart.

use askama::filters::Escaper;
use std::fmt::{self, Write};

/// The escaper of TwinCAT's files.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Cdata;

impl Escaper for Cdata {
    fn write_escaped_str<W: Write>(&self, mut to: W, text: &str) -> fmt::Result {
        let mut pieces = text.split("]]>");
        to.write_str(pieces.next().unwrap_or_default())?;
        pieces.try_for_each(|piece| {
            to.write_str("]]]]><![CDATA[>")?;
            to.write_str(piece)
        })
    }
}

#[cfg(test)]
mod tests {
    use super::super::project::{TcGuide, TcProgram};
    use askama::Template;

    /// Everything that XML could take for its own.
    const HOSTILE: &str = "]]> & < > \" ' ]]]]>> <![CDATA[ ]] > &amp; <!-- --> ]]>";

    /// The text of an element's sections, and how many there are.
    fn read(sections: &str) -> (String, usize) {
        let (mut text, mut count, mut rest) = (String::new(), 0, sections);
        while let Some(section) = rest.strip_prefix("<![CDATA[") {
            let (inside, behind) = section.split_once("]]>").unwrap_or((section, ""));
            text.push_str(inside);
            (count, rest) = (count + 1, behind);
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
        let guide = TcGuide { damping: HOSTILE, axis: "A" };
        assert!(guide.render().expect("the template is filled").contains(HOSTILE), "no file of XML");
    }
}
