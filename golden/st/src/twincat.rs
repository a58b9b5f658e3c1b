//! A `.TcPOU` -> its text: the declaration, the body, and the end that the form omits.

use super::Mistake;
use super::mistake::Lines;
use super::source::Source;
use super::xml::{self, append_text, child};

/// Reads the file of a block, or of a program.
pub(crate) fn read(file: &str) -> Result<Source, Vec<Mistake>> {
    let lines = Lines::new(file);
    let document = xml::read(file)?;
    let root = document.root_element();
    let fail = |at: usize, found: &str, instead: &str| Err(vec![lines.mistake(at, found, instead)]);
    if root.tag_name().name() != "TcPlcObject" {
        return fail(root.range().start, &format!("`<{}>`", root.tag_name().name()), "`<TcPlcObject>`");
    }
    let Some(pou) = child(root, "POU") else { return fail(root.range().start, "no `<POU>`", "`<POU>`") };
    let at = pou.range().start;
    let Some(name) = pou.attribute("Name") else { return fail(at, "a `<POU>` without `Name`", "`Name`") };
    let known = ["Declaration", "Implementation", "LineIds", "ObjectProperties"];
    let foreign: Vec<Mistake> = pou
        .children()
        .filter(|child| child.is_element() && !known.contains(&child.tag_name().name()))
        .map(|child| lines.mistake(child.range().start, format!("`<{}>`", child.tag_name().name()), "one body"))
        .collect();
    if !foreign.is_empty() {
        return Err(foreign);
    }
    let Some(declaration) = child(pou, "Declaration") else {
        return fail(at, "no `<Declaration>`", "`<Declaration>`");
    };
    let Some(body) = child(pou, "Implementation").and_then(|implementation| child(implementation, "ST")) else {
        return fail(at, "no `<Implementation><ST>`", "`<Implementation><ST>`");
    };
    let mut source = Source::default();
    source.name = Some(name.to_owned());
    append_text(declaration, &mut source);
    source.make("\n", body.range().start);
    source.body = Some(source.text.len());
    append_text(body, &mut source);
    let end = if is_program(&source.text) { "\nEND_PROGRAM" } else { "\nEND_FUNCTION_BLOCK" };
    source.make(end, body.range().start);
    Ok(source)
}

/// Reads the declaration of a `.TcDUT` or a `.TcGVL`, and its name in the file.
pub(crate) fn declaration(file: &str, element: &str) -> Result<(Source, String), Vec<Mistake>> {
    let lines = Lines::new(file);
    let document = xml::read(file)?;
    let outer = child(document.root_element(), element);
    let name = outer.and_then(|outer| outer.attribute("Name"));
    let (Some(declaration), Some(name)) = (outer.and_then(|outer| child(outer, "Declaration")), name) else {
        let found = format!("no `<{element} Name=...><Declaration>`");
        return Err(vec![lines.mistake(document.root_element().range().start, found, "the file of one object")]);
    };
    let mut source = Source::default();
    append_text(declaration, &mut source);
    Ok((source, name.to_owned()))
}

/// Whether the first word of a declaration is `PROGRAM`.
fn is_program(text: &str) -> bool {
    let mut rest = text.trim_start();
    loop {
        let end = match rest.as_bytes() {
            [b'(', b'*', ..] => rest.find("*)").map(|end| end + 2),
            [b'/', b'/', ..] => rest.find('\n'),
            [b'{', ..] => rest.find('}').map(|end| end + 1),
            _ => return rest.split_whitespace().next() == Some("PROGRAM"),
        };
        let Some(end) = end else { return false };
        rest = rest[end..].trim_start();
    }
}
