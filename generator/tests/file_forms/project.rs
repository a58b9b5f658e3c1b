//! The entries for a PLC project, and the program that runs the suites: they name exactly what is there.

use super::structure::{Inside, Rule, Times, any, faults, rule};
use super::twincat::{code, object};
use super::{CASES, OBJECTS, xml};

/// The structure of the entries: folders first.
const RULES: [Rule; 5] = [
    rule(
        "Project",
        &[("xmlns", |value| value == "http://schemas.microsoft.com/developer/msbuild/2003")],
        Inside::Elements(&[(&["ItemGroup"], Times::Some)]),
    ),
    rule("ItemGroup", &[], Inside::Elements(&[(&["Folder"], Times::Some), (&["Compile"], Times::Some)])),
    rule("Folder", &[("Include", any)], Inside::Nothing),
    rule(
        "Compile",
        &[("Include", |value| value.contains('\\') && !value.contains('/'))],
        Inside::Elements(&[(&["SubType"], Times::Once)]),
    ),
    rule("SubType", &[], Inside::Text),
];

#[test]
fn the_project_names_exactly_the_files_that_there_are() {
    for case in CASES.iter() {
        let root = xml::read(&case.files["twincat/axgen.plcproj-fragment"]).unwrap();
        assert_eq!(faults(&RULES, &root), [""; 0], "{}", case.name);
        let groups: Vec<_> = root.all("ItemGroup").collect();
        let (mut named, mut folders) = (Vec::new(), Vec::new());
        for group in &groups {
            let entries: Vec<&str> = group.all("Compile").map(|entry| entry.attribute("Include")).collect();
            assert!(entries.is_sorted(), "{}: {entries:?}", case.name);
            assert!(group.all("Compile").all(|entry| entry.at("SubType").text == "Code"), "{}", case.name);
            let own: Vec<&str> = group.all("Folder").map(|folder| folder.attribute("Include")).collect();
            assert!(entries.iter().all(|entry| own.contains(&entry.split('\\').next().unwrap())), "{entries:?}");
            named.extend(entries.iter().map(|entry| format!("twincat/{}", entry.replace('\\', "/"))));
            folders.push(own);
        }
        assert_eq!(folders, [vec!["DUTs", "POUs"], vec!["Tests"]], "{}: what tests need stands apart", case.name);
        named.sort();
        let there: Vec<String> = case.with(&OBJECTS).into_iter().map(|(name, _)| name.clone()).collect();
        assert_eq!(named, there, "{}", case.name);
    }
}

#[test]
fn the_test_program_has_every_suite_once() {
    for case in CASES.iter() {
        let program = object(&case.files["twincat/Tests/PRG_axgen_tests.TcPOU"]);
        let code = code(&program.at("Declaration").text);
        let found: Vec<(&str, &str)> = code.lines().filter_map(|line| line.trim().split_once(" : ")).collect();
        let suites: Vec<String> = case
            .with(&["_Test.TcPOU"])
            .into_iter()
            .map(|(name, _)| name.rsplit('/').next().unwrap().replace(".TcPOU", ""))
            .collect();
        let expected: Vec<(String, String)> =
            suites.iter().map(|suite| (format!("test_{suite}"), format!("{suite};"))).collect();
        let expected: Vec<(&str, &str)> = expected.iter().map(|(name, ty)| (name.as_str(), ty.as_str())).collect();
        assert!(!expected.is_empty() && found == expected, "{}: {found:?}", case.name);
        assert_eq!(program.at("Implementation/ST").text, "TcUnit.RUN();\n", "{}", case.name);
    }
}

/// Every name of ours that an object uses is an object of the set.
#[test]
fn what_an_object_uses_is_there() {
    for case in CASES.iter() {
        let there: Vec<String> =
            case.with(&OBJECTS).into_iter().map(|(_, text)| object(text).attribute("Name").to_owned()).collect();
        for (file, text) in case.with(&OBJECTS) {
            let words = text.split(|c: char| !(c.is_ascii_alphanumeric() || c == '_'));
            let ours = ["FB_axis_", "F_axgen_", "E_axgen_", "PRG_axgen_"];
            for word in words.filter(|word| ours.iter().any(|prefix| word.starts_with(prefix))) {
                assert!(there.iter().any(|name| name == word), "{}: {file}: {word}", case.name);
            }
        }
    }
}
