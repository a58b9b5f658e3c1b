//! PLCopen XML -> its text: each function block in the form of a declaration.

use super::Mistake;
use super::mistake::Lines;
use super::source::Source;
use super::xml::{self, append_text, child};
use roxmltree::Node;

const SPACE: &str = "http://www.plcopen.org/xml/tc6_0200";

/// Reads the file: all its function blocks, one after another.
pub(crate) fn read(file: &str) -> Result<Source, Vec<Mistake>> {
    let lines = Lines::new(file);
    let document = xml::read(file)?;
    let root = document.root_element();
    if !root.has_tag_name((SPACE, "project")) {
        let found = format!("`<{}>`", root.tag_name().name());
        return Err(vec![lines.mistake(root.range().start, found, format!("`<project xmlns=\"{SPACE}\">`"))]);
    }
    let (mut source, mut mistakes) = (Source::default(), Vec::new());
    for of_type in root.descendants().filter(|node| node.tag_name().name() == "dataType") {
        structure(of_type, &mut source, &lines, &mut mistakes);
    }
    for pou in root.descendants().filter(|node| node.tag_name().name() == "pou") {
        // An included function is known by its name, and not read.
        if pou.attribute("pouType") != Some("function") {
            block(pou, &mut source, &lines, &mut mistakes);
        }
    }
    if mistakes.is_empty() { Ok(source) } else { Err(mistakes) }
}

/// A data type that is a structure.
fn structure(of_type: Node<'_, '_>, source: &mut Source, lines: &Lines<'_>, mistakes: &mut Vec<Mistake>) {
    let at = of_type.range().start;
    let Some(parts) = child(of_type, "baseType").and_then(|base| child(base, "struct")) else {
        mistakes.push(lines.mistake(at, "a `<dataType>` of another kind", "`<baseType><struct>`"));
        return;
    };
    let name = word(of_type, of_type.attribute("name"), lines, mistakes);
    source.make(&format!("TYPE {name} :\nSTRUCT\n"), at);
    for variable in parts.children().filter(|child| child.tag_name().name() == "variable") {
        declaration(variable, source, lines, mistakes);
    }
    source.make("END_STRUCT;\nEND_TYPE\n", at);
}

fn block(pou: Node<'_, '_>, source: &mut Source, lines: &Lines<'_>, mistakes: &mut Vec<Mistake>) {
    if pou.attribute("pouType") != Some("functionBlock") {
        mistakes.push(lines.mistake(pou.range().start, "a `<pou>` of another type", "`pouType=\"functionBlock\"`"));
        return;
    }
    let name = word(pou, pou.attribute("name"), lines, mistakes);
    source.make(&format!("FUNCTION_BLOCK {name}\n"), pou.range().start);
    for part in child(pou, "interface").into_iter().flat_map(|interface| interface.children()).filter(Node::is_element)
    {
        let header = match part.tag_name().name() {
            "inputVars" => "VAR_INPUT",
            "outputVars" => "VAR_OUTPUT",
            "localVars" => "VAR",
            "inOutVars" => "VAR_IN_OUT",
            "tempVars" => "VAR_TEMP",
            "externalVars" => "VAR_EXTERNAL",
            "globalVars" => "VAR_GLOBAL",
            "documentation" | "addData" => continue,
            other => {
                mistakes.push(lines.mistake(
                    part.range().start,
                    format!("`<{other}>`"),
                    "`<inputVars>`, `<outputVars>` or `<localVars>`",
                ));
                continue;
            }
        };
        let is = |name: &str| part.attribute(name) == Some("true");
        let qualifier = match (is("constant"), is("retain"), is("nonretain")) {
            (false, false, false) => "",
            (true, false, false) => " CONSTANT",
            (_, true, _) => " RETAIN",
            (_, _, true) => " NON_RETAIN",
        };
        source.make(&format!("{header}{qualifier}\n"), part.range().start);
        for variable in part.children().filter(|child| child.tag_name().name() == "variable") {
            declaration(variable, source, lines, mistakes);
        }
        source.make("END_VAR\n", part.range().start);
    }
    let body = child(pou, "body").and_then(|body| child(body, "ST")).and_then(|body| child(body, "xhtml"));
    match body {
        Some(body) => append_text(body, source),
        None => mistakes.push(lines.mistake(pou.range().start, "no `<body><ST><xhtml>`", "`<body><ST><xhtml>`")),
    }
    source.make("\nEND_FUNCTION_BLOCK\n", pou.range().start);
}

fn declaration(variable: Node<'_, '_>, source: &mut Source, lines: &Lines<'_>, mistakes: &mut Vec<Mistake>) {
    let name = word(variable, variable.attribute("name"), lines, mistakes);
    if variable.attribute("address").is_some() {
        mistakes.push(lines.mistake(variable.range().start, "`address`", "a variable without an address"));
    }
    let ty = child(variable, "type").and_then(|ty| ty.first_element_child());
    let ty = match ty.filter(|ty| ty.tag_name().name() == "array") {
        Some(array) => self::array(array, lines, mistakes),
        None => {
            let named = ty.map(|ty| ty.attribute("name").unwrap_or(ty.tag_name().name()));
            word(variable, named, lines, mistakes).to_owned()
        }
    };
    source.make(&format!("{name} : {ty}"), variable.range().start);
    if let Some(initial) = child(variable, "initialValue") {
        let value = child(initial, "simpleValue").and_then(|value| value.attribute("value"));
        let letter = |letter: char| letter.is_ascii_alphanumeric() || "+-*.#_() ".contains(letter);
        match value.filter(|value| !value.is_empty() && value.chars().all(letter)) {
            Some(value) => source.make(&format!(" := {value}"), initial.range().start),
            None => mistakes.push(lines.mistake(
                initial.range().start,
                "this initial value",
                "`<simpleValue value=\"...\"/>` with a literal",
            )),
        }
    }
    source.make(";\n", variable.range().start);
}

/// The type of an array.
fn array(array: Node<'_, '_>, lines: &Lines<'_>, mistakes: &mut Vec<Mistake>) -> String {
    let dimension = child(array, "dimension");
    let bound = |name| word(array, dimension.and_then(|dimension| dimension.attribute(name)), lines, &mut Vec::new());
    let (lower, upper) = (bound("lower"), bound("upper"));
    let of = child(array, "baseType").and_then(|base| base.first_element_child());
    let of = word(array, of.map(|of| of.tag_name().name()), lines, mistakes);
    format!("ARRAY[{lower}..{upper}] OF {of}")
}

/// A word that may be in the text; anything else would be more than one word there.
fn word<'e>(at: Node<'_, '_>, word: Option<&'e str>, lines: &Lines<'_>, mistakes: &mut Vec<Mistake>) -> &'e str {
    let good = |word: &&str| !word.is_empty() && word.bytes().all(|byte| byte.is_ascii_alphanumeric() || byte == b'_');
    word.filter(good).unwrap_or_else(|| {
        mistakes.push(lines.mistake(
            at.range().start,
            format!("`<{}>` without a name or a type", at.tag_name().name()),
            "a word",
        ));
        "none"
    })
}
