//! PLCopen XML -> its text: each function block as a declaration would say it.

use super::Mistake;
use super::mistake::Lines;
use super::source::Source;
use super::xml::{self, Element};

const SPACE: &str = "http://www.plcopen.org/xml/tc6_0200";

/// Reads the file: all its function blocks, one after another.
pub fn read(file: &str) -> Result<Source, Vec<Mistake>> {
    let lines = Lines::of(file);
    let root = xml::read(file)?;
    if root.name != "project" || root.attribute("xmlns") != Some(SPACE) {
        let found = format!("`<{}>`", root.name);
        return Err(vec![lines.mistake(root.at, found, format!("`<project xmlns=\"{SPACE}\">`"))]);
    }
    let mut pous = Vec::new();
    root.all("pou", &mut pous);
    // A function that comes along is known by its name, and not read.
    pous.retain(|pou| pou.attribute("pouType") != Some("function"));
    let (mut source, mut mistakes) = (Source::default(), Vec::new());
    for pou in pous {
        block(pou, &mut source, &lines, &mut mistakes);
    }
    if mistakes.is_empty() { Ok(source) } else { Err(mistakes) }
}

fn block(pou: &Element, source: &mut Source, lines: &Lines<'_>, mistakes: &mut Vec<Mistake>) {
    if pou.attribute("pouType") != Some("functionBlock") {
        mistakes.push(lines.mistake(pou.at, "a `<pou>` of another type", "`pouType=\"functionBlock\"`"));
        return;
    }
    let name = word(pou, pou.attribute("name"), lines, mistakes);
    source.make(&format!("FUNCTION_BLOCK {name}\n"), pou.at);
    for part in pou.child("interface").map_or(&[][..], |interface| &interface.children) {
        let header = match part.name.as_str() {
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
                    part.at,
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
        source.make(&format!("{header}{qualifier}\n"), part.at);
        for variable in part.children.iter().filter(|child| child.name == "variable") {
            declaration(variable, source, lines, mistakes);
        }
        source.make("END_VAR\n", part.at);
    }
    let body = pou.child("body").and_then(|body| body.child("ST")).and_then(|body| body.child("xhtml"));
    match body {
        Some(body) => body.append_to(source),
        None => mistakes.push(lines.mistake(pou.at, "no `<body><ST><xhtml>`", "`<body><ST><xhtml>`")),
    }
    source.make("\nEND_FUNCTION_BLOCK\n", pou.at);
}

fn declaration(variable: &Element, source: &mut Source, lines: &Lines<'_>, mistakes: &mut Vec<Mistake>) {
    let name = word(variable, variable.attribute("name"), lines, mistakes);
    if variable.attribute("address").is_some() {
        mistakes.push(lines.mistake(variable.at, "`address`", "a variable without an address"));
    }
    let ty = variable.child("type").and_then(|ty| ty.children.first());
    let ty = word(variable, ty.map(|ty| ty.attribute("name").unwrap_or(&ty.name)), lines, mistakes);
    source.make(&format!("{name} : {ty}"), variable.at);
    if let Some(initial) = variable.child("initialValue") {
        let value = initial.child("simpleValue").and_then(|value| value.attribute("value"));
        let letter = |letter: char| letter.is_ascii_alphanumeric() || "+-*.#_() ".contains(letter);
        match value.filter(|value| !value.is_empty() && value.chars().all(letter)) {
            Some(value) => source.make(&format!(" := {value}"), initial.at),
            None => mistakes.push(lines.mistake(
                initial.at,
                "this initial value",
                "`<simpleValue value=\"...\"/>` with a literal",
            )),
        }
    }
    source.make(";\n", variable.at);
}

/// A word that may stand in the text; anything else would be more than a word there.
fn word<'e>(at: &Element, word: Option<&'e str>, lines: &Lines<'_>, mistakes: &mut Vec<Mistake>) -> &'e str {
    let good = |word: &&str| !word.is_empty() && word.bytes().all(|byte| byte.is_ascii_alphanumeric() || byte == b'_');
    word.filter(good).unwrap_or_else(|| {
        mistakes.push(lines.mistake(at.at, format!("`<{}>` without a name or a type", at.name), "a word"));
        "none"
    })
}
