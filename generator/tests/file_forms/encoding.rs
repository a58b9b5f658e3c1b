//! The bytes of every file: ASCII after TwinCAT's byte order mark, LF, a final newline; and the XML declaration.

use super::{CASES, OBJECTS, xml};

#[test]
fn every_file_is_ascii_with_line_feeds_and_a_last_one() {
    let mut count = 0;
    for case in CASES.iter() {
        for (name, text) in &case.files {
            let is_object = OBJECTS.iter().any(|ending| name.ends_with(ending));
            let bare = text.strip_prefix('\u{feff}');
            assert_eq!(bare.is_some(), is_object, "{}: {name}: a byte order mark", case.name);
            let bare = bare.unwrap_or(text);
            let strange = bare.bytes().find(|byte| !(matches!(byte, b' '..=b'~') || *byte == b'\n'));
            assert_eq!(strange, None, "{}: {name}", case.name);
            assert!(bare.ends_with('\n') && !bare.ends_with("\n\n"), "{}: {name}: one newline at the end", case.name);
            count += 1;
        }
    }
    assert!(count > 300, "{count} files");
}

#[test]
fn every_xml_file_is_well_formed_and_says_utf_8() {
    let mut count = 0;
    for case in CASES.iter() {
        for (name, text) in case.with(&[".TcPOU", ".TcDUT", ".plcproj-fragment", ".xml"]) {
            let bare = text.strip_prefix('\u{feff}').unwrap_or(text);
            assert!(bare.starts_with("<?xml version=\"1.0\" encoding=\"utf-8\"?>\n<"), "{}: {name}", case.name);
            assert_eq!(bare.matches("<?").count(), 1, "{}: {name}", case.name);
            xml::read(text).unwrap_or_else(|fault| panic!("{}: {name}: {fault}", case.name));
            count += 1;
        }
    }
    assert!(count > 200, "{count} files");
}
