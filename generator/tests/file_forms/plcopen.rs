//! PLCopen XML: the structure of tc6_0200 as far as a project of functions and function blocks needs it.

use super::structure::Inside::{self, Elements, Nothing, Text};
use super::structure::Times::{Any, Once, Perhaps};
use super::structure::{Rule, any, faults, rule};
use super::{CASES, xml};
use std::collections::BTreeSet;

/// The types that a variable may have.
const TYPES: [&str; 8] = ["BOOL", "DINT", "UDINT", "REAL", "LREAL", "array", "pointer", "derived"];

/// What a list of variables holds.
const VARIABLES: Inside = Elements(&[(&["variable"], Any), (&["documentation"], Perhaps)]);

/// What holds text for people.
const FORMATTED: Inside = Elements(&[(&["xhtml"], Once)]);

/// The schema's elements that are used here, in the schema's order (which has `addData` before each `documentation`).
const RULES: [Rule; 48] = [
    rule(
        "project",
        &[("xmlns", |value| value == "http://www.plcopen.org/xml/tc6_0200")],
        Elements(&[(&["fileHeader"], Once), (&["contentHeader"], Once), (&["types"], Once), (&["instances"], Once)]),
    ),
    rule(
        "fileHeader",
        &[("companyName", any), ("productName", any), ("productVersion", any), ("creationDateTime", is_date_time)],
        Nothing,
    ),
    rule("contentHeader", &[("name", is_name)], Elements(&[(&["coordinateInfo"], Once)])),
    rule("coordinateInfo", &[], Elements(&[(&["fbd"], Once), (&["ld"], Once), (&["sfc"], Once)])),
    rule("fbd", &[], Elements(&[(&["scaling"], Once)])),
    rule("ld", &[], Elements(&[(&["scaling"], Once)])),
    rule("sfc", &[], Elements(&[(&["scaling"], Once)])),
    rule("scaling", &[("x", is_decimal), ("y", is_decimal)], Nothing),
    rule("types", &[], Elements(&[(&["dataTypes"], Once), (&["pous"], Once)])),
    rule("dataTypes", &[], Elements(&[(&["dataType"], Any)])),
    rule("dataType", &[("name", is_name)], Elements(&[(&["baseType"], Once), (&["addData"], Perhaps)])),
    rule("enum", &[], Elements(&[(&["values"], Once), (&["baseType"], Perhaps)])),
    rule("values", &[], Elements(&[(&["value"], Any)])),
    rule("value", &[("name", is_name), ("value", is_decimal)], Nothing),
    rule("addData", &[], Elements(&[(&["data"], Any)])),
    rule(
        "data",
        &[("name", |name| name.starts_with("http://www.3s-software.com/plcopenxml/")), ("handleUnknown", any)],
        Elements(&[(&["Attributes"], Once)]),
    ),
    rule("Attributes", &[], Elements(&[(&["Attribute"], Any)])),
    rule("Attribute", &[("Name", is_name), ("Value", any)], Nothing),
    rule("derived", &[("name", is_name)], Nothing),
    rule("pous", &[], Elements(&[(&["pou"], Any)])),
    rule(
        "pou",
        &[("name", is_name), ("pouType", |kind| ["function", "functionBlock", "program"].contains(&kind))],
        Elements(&[(&["interface"], Perhaps), (&["body"], Once)]),
    ),
    rule("interface", &[], Elements(&[(&["returnType"], Perhaps), (&["localVars", "inputVars", "outputVars"], Any)])),
    rule("returnType", &[], Elements(&[(&TYPES, Once)])),
    rule("inputVars", &[], VARIABLES),
    rule("outputVars", &[], VARIABLES),
    Rule { perhaps: &[("constant", |value| value == "true")], ..rule("localVars", &[], VARIABLES) },
    rule(
        "variable",
        &[("name", is_name)],
        Elements(&[(&["type"], Once), (&["initialValue"], Perhaps), (&["documentation"], Perhaps)]),
    ),
    rule("type", &[], Elements(&[(&TYPES, Once)])),
    rule("initialValue", &[], Elements(&[(&["simpleValue"], Once)])),
    rule("simpleValue", &[("value", |value| !value.is_empty())], Nothing),
    rule("documentation", &[], FORMATTED),
    rule("pointer", &[], Elements(&[(&["baseType"], Once)])),
    rule("array", &[], Elements(&[(&["dimension"], Once), (&["baseType"], Once)])),
    rule("dimension", &[("lower", is_decimal), ("upper", is_decimal)], Nothing),
    rule(
        "baseType",
        &[],
        Elements(&[(&["DWORD", "LWORD", "DINT", "UDINT", "BOOL", "REAL", "LREAL", "enum", "struct"], Once)]),
    ),
    rule("struct", &[], Elements(&[(&["variable"], Any)])),
    rule("body", &[], Elements(&[(&["ST"], Once)])),
    rule("ST", &[], FORMATTED),
    rule("xhtml", &[("xmlns", |value| value == "http://www.w3.org/1999/xhtml")], Text),
    rule("instances", &[], Elements(&[(&["configurations"], Once)])),
    rule("configurations", &[], Nothing),
    rule("BOOL", &[], Nothing),
    rule("DINT", &[], Nothing),
    rule("UDINT", &[], Nothing),
    rule("REAL", &[], Nothing),
    rule("LREAL", &[], Nothing),
    rule("DWORD", &[], Nothing),
    rule("LWORD", &[], Nothing),
];

fn is_name(text: &str) -> bool {
    let is_letter = |c: char| c.is_ascii_alphanumeric() || c == '_';
    text.chars().all(is_letter) && text.starts_with(|c: char| c.is_ascii_alphabetic()) && !text.contains("__")
}

fn is_decimal(text: &str) -> bool {
    !text.is_empty() && text.bytes().all(|digit| digit.is_ascii_digit())
}

/// `YYYY-MM-DDThh:mm:ss`, as `xs:dateTime` has it.
fn is_date_time(text: &str) -> bool {
    let shape: String = text.chars().map(|c| if c.is_ascii_digit() { '0' } else { c }).collect();
    let number = |from: usize| text[from..from + 2].parse::<u32>().unwrap();
    shape == "0000-00-00T00:00:00"
        && (1..=12).contains(&number(5))
        && (1..=31).contains(&number(8))
        && number(11) < 24
        && number(14) < 60
        && number(17) < 60
}

#[test]
fn every_project_has_the_structure_of_the_schema() {
    let mut count = 0;
    for case in CASES.iter() {
        for (name, text) in case.with(&[".xml"]) {
            assert_eq!(faults(&RULES, &xml::read(text).unwrap()), [""; 0], "{}: {name}", case.name);
            count += 1;
        }
    }
    assert!(count > 40, "{count} projects");
}

#[test]
fn the_shared_project_has_functions_and_the_others_function_blocks() {
    for case in CASES.iter() {
        for (name, text) in case.with(&[".xml"]) {
            let root = xml::read(text).unwrap();
            // The file has the name of its function block without what tells its kind.
            let of = root.at("contentHeader").attribute("name");
            assert_eq!(of.strip_prefix("FB_").unwrap_or(of), name.trim_end_matches(".xml"), "{}", case.name);
            assert_eq!(of.starts_with("FB_"), name != "axgen_shared.xml", "{}: {name}", case.name);
            let pous: Vec<&xml::Element> = root.at("types/pous").all("pou").collect();
            assert!(!pous.is_empty(), "{}: {name}", case.name);
            for pou in pous {
                let is_shared = name == "axgen_shared.xml";
                let kind = if is_shared { "function" } else { "functionBlock" };
                assert_eq!(pou.attribute("pouType"), kind, "{}: {name}", case.name);
                let results = pou.at("interface").all("returnType").count();
                assert_eq!(results, usize::from(is_shared), "{}: {name}", case.name);
                let own = if is_shared { "F_axgen_in_range_" } else { of };
                assert!(pou.attribute("name").starts_with(own), "{}: {name}", case.name);
            }
        }
    }
}

#[test]
fn a_name_is_declared_once_and_a_constant_has_its_value() {
    for case in CASES.iter() {
        for (file, text) in case.with(&[".xml"]) {
            let root = xml::read(text).unwrap();
            for pou in root.at("types/pous").all("pou") {
                let mut names = BTreeSet::from([pou.attribute("name").to_ascii_lowercase()]);
                for list in pou.at("interface").children.iter().filter(|list| list.name != "returnType") {
                    let is_constant = list.attributes.iter().any(|(key, _)| key == "constant");
                    for variable in list.all("variable") {
                        let name = variable.attribute("name");
                        assert!(names.insert(name.to_ascii_lowercase()), "{}: {file}: {name} twice", case.name);
                        let values = variable.all("initialValue").count();
                        assert!(!is_constant || values == 1, "{}: {file}: {name} without a value", case.name);
                        let is_pointer = variable.at("type").children[0].name == "pointer";
                        assert!(!is_pointer || file == "axgen_shared.xml", "{file}: {name}");
                    }
                }
            }
        }
    }
}

#[test]
fn what_the_schema_does_not_allow_is_found() {
    let text = &CASES[0].files["axis_x_ipc.xml"];
    let change = |from: &str, to: &str| {
        assert!(text.contains(from), "{from}");
        let changed = text.replacen(from, to, 1);
        assert!(!faults(&RULES, &xml::read(&changed).unwrap()).is_empty(), "{from} -> {to}");
    };
    change("tc6_0200", "tc6_0201");
    change("2000-01-01T00:00:00", "2000-01-01");
    change("2000-01-01T00:00:00", "2000-13-01T00:00:00");
    change("companyName=\"\" ", "");
    change("<dataTypes />", "");
    change("<fbd>", "<sfc><scaling x=\"1\" y=\"1\" /></sfc><fbd>");
    change("pouType=\"functionBlock\"", "pouType=\"block\"");
    change("<type>\n                <LREAL />", "<type>\n                <FLOAT />");
    change(
        "<initialValue>",
        "<documentation><xhtml xmlns=\"http://www.w3.org/1999/xhtml\"/></documentation><initialValue>",
    );
    change("constant=\"true\"", "constant=\"yes\"");
    change("<ST>\n            <xhtml xmlns=\"http://www.w3.org/1999/xhtml\">", "<ST>\n            <xhtml>");
    change("<configurations />", "<configurations /><configurations />");
}
