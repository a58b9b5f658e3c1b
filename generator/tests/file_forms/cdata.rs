//! Text inside CDATA sections: it stands there as it is. What marks become in it, `unit/twincat.rs` tests.

use super::{CASES, OBJECTS};

#[test]
fn the_objects_hold_their_text_unescaped() {
    for case in CASES.iter() {
        for (name, text) in case.with(&OBJECTS) {
            let mut rest = text.as_str();
            while let Some((_, inside)) = rest.split_once("<![CDATA[") {
                let (section, after) = inside.split_once("]]>").unwrap();
                assert!(!section.contains("&lt;") && !section.contains("&amp;"), "{name}: {section}");
                assert!(after.starts_with("</"), "{name}: one section for an element");
                rest = after;
            }
            assert!(!rest.contains("]]>"), "{name}");
        }
    }
}
