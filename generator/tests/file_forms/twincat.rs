//! TwinCAT's objects: their structure, their names, their GUIDs.

use super::structure::{Inside, Rule, Times, any, faults, rule};
use super::{CASES, Case, OBJECTS, files, xml};
use std::collections::BTreeSet;

/// The structure of a `.TcPOU` or `.TcDUT`.
const RULES: [Rule; 7] = [
    rule(
        "TcPlcObject",
        &[("Version", |value| value == "1.1.0.1")],
        Inside::Elements(&[(&["POU", "DUT"], Times::Once)]),
    ),
    rule(
        "POU",
        &[("Name", any), ("Id", is_guid), ("SpecialFunc", |value| value == "None")],
        Inside::Elements(&[
            (&["Declaration"], Times::Once),
            (&["Implementation"], Times::Once),
            (&["Method"], Times::Any),
        ]),
    ),
    rule("DUT", &[("Name", any), ("Id", is_guid)], DECLARATION),
    rule(
        "Method",
        &[("Name", any), ("Id", is_guid)],
        Inside::Elements(&[(&["Declaration"], Times::Once), (&["Implementation"], Times::Once)]),
    ),
    rule("Declaration", &[], Inside::Text),
    rule("Implementation", &[], Inside::Elements(&[(&["ST"], Times::Once)])),
    rule("ST", &[], Inside::Text),
];

const DECLARATION: Inside = Inside::Elements(&[(&["Declaration"], Times::Once)]);

/// A GUID of RFC 9562 in braces, lower case: version 5 (derived from a name), variant 10.
fn is_guid(text: &str) -> bool {
    let Some(inside) = text.strip_prefix('{').and_then(|text| text.strip_suffix('}')) else { return false };
    let parts: Vec<&str> = inside.split('-').collect();
    let is_hex = |part: &&str| part.bytes().all(|digit| matches!(digit, b'0'..=b'9' | b'a'..=b'f'));
    parts.iter().map(|part| part.len()).eq([8, 4, 4, 4, 12])
        && parts.iter().all(is_hex)
        && parts[2].starts_with('5')
        && parts[3].starts_with(['8', '9', 'a', 'b'])
}

/// The object of a file.
pub fn object(text: &str) -> xml::Element {
    xml::read(text).unwrap().children.remove(0)
}

/// A text without its comments and pragmas.
pub fn code(text: &str) -> String {
    let mut code = String::new();
    let mut rest = text;
    while let Some(at) = rest.find(['(', '{']) {
        let end = match &rest[at..] {
            inside if inside.starts_with("(*") => "*)",
            inside if inside.starts_with('{') => "}",
            _ => "",
        };
        let cut = if end.is_empty() { at + 1 } else { at };
        code.push_str(&rest[..cut]);
        rest = if end.is_empty() { &rest[cut..] } else { rest[at..].split_once(end).unwrap().1 };
    }
    code + rest
}

/// The name that a declaration gives its object.
fn declared(kind: &str, declaration: &str) -> String {
    let code = code(declaration);
    let words: Vec<&str> = code.split_ascii_whitespace().collect();
    let name = match (kind, words.as_slice()) {
        ("POU", ["FUNCTION_BLOCK" | "PROGRAM", name, ..]) | ("POU" | "DUT", ["FUNCTION" | "TYPE", name, ":", ..]) => {
            name
        }
        ("Method", ["METHOD", "PRIVATE" | "PUBLIC" | "PROTECTED", name, ..] | ["METHOD", name, ..]) => name,
        _ => panic!("{kind}: {declaration}"),
    };
    (*name).to_owned()
}

#[test]
fn every_object_has_its_structure() {
    let mut count = 0;
    for case in CASES.iter() {
        for (name, text) in case.with(&OBJECTS) {
            assert_eq!(faults(&RULES, &xml::read(text).unwrap()), [""; 0], "{}: {name}", case.name);
            count += 1;
        }
    }
    assert!(count > 140, "{count} objects");
}

#[test]
fn an_object_a_file_and_a_declaration_have_one_name() {
    for case in CASES.iter() {
        for (file, text) in case.with(&OBJECTS) {
            let object = object(text);
            let name = object.attribute("Name");
            let (stem, ending) = file.rsplit('/').next().unwrap().split_once('.').unwrap();
            assert_eq!((name, format!("Tc{}", object.name)), (stem, ending.to_owned()), "{file}");
            assert_eq!(declared(&object.name, &object.at("Declaration").text), name, "{file}");
            for method in object.all("Method") {
                let declaration = &method.at("Declaration").text;
                assert_eq!(declared("Method", declaration), method.attribute("Name"), "{file}");
                let header = code(declaration);
                assert_eq!(header.lines().next().unwrap().split(' ').count(), 3, "{file}: a method without result");
            }
        }
    }
}

/// TwinCAT keeps the end of an object out of its declaration; a type has one.
#[test]
fn a_declaration_does_not_end_its_object() {
    for case in CASES.iter() {
        for (file, text) in case.with(&OBJECTS) {
            let object = object(text);
            let methods = object.all("Method").map(|method| method.at("Declaration"));
            for declaration in [object.at("Declaration")].into_iter().chain(methods) {
                let code = code(&declaration.text);
                let ends: Vec<&str> = code.split_ascii_whitespace().filter(|word| word.starts_with("END_")).collect();
                let allowed = ["END_VAR", "END_STRUCT", "END_TYPE"];
                assert!(ends.iter().all(|end| allowed.contains(&end.trim_end_matches(';'))), "{file}: {ends:?}");
                assert_eq!(ends.contains(&"END_TYPE"), object.name == "DUT", "{file}");
                assert_eq!(code.matches("VAR").count() % 2, 0, "{file}: every VAR has its END_VAR");
            }
        }
    }
}

/// All GUIDs of a set, each with what bears it.
fn guids(files: &Case) -> Vec<(String, String)> {
    let mut found = Vec::new();
    for (file, text) in files.with(&OBJECTS) {
        let object = object(text);
        for element in [&object].into_iter().chain(object.all("Method")) {
            found.push((element.attribute("Id").to_owned(), format!("{file} {}", element.attribute("Name"))));
        }
    }
    found
}

#[test]
fn every_object_has_its_own_guid_and_keeps_it() {
    for case in CASES.iter() {
        let found = guids(case);
        let distinct: BTreeSet<&String> = found.iter().map(|(id, _)| id).collect();
        assert_eq!(distinct.len(), found.len(), "{}: {found:?}", case.name);
        let again = Case { name: case.name.clone(), set: case.set.clone(), files: files(&case.set) };
        assert_eq!(guids(&again), found, "{}", case.name);
    }
}

#[test]
fn what_is_no_guid_is_refused() {
    assert!(is_guid("{01234567-89ab-5def-8123-456789abcdef}"));
    for broken in [
        "01234567-89ab-5def-8123-456789abcdef",
        "{01234567-89AB-5def-8123-456789abcdef}",
        "{01234567-89ab-4def-8123-456789abcdef}",
        "{01234567-89ab-5def-c123-456789abcdef}",
        "{0123456-789ab-5def-8123-456789abcdef}",
        "{01234567-89ab-5def-8123-456789abcdeg}",
        "{01234567-89ab-5def-8123}",
    ] {
        assert!(!is_guid(broken), "{broken}");
    }
}
