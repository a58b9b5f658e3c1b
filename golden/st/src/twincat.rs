//! A `.TcPOU` -> its text: the declaration, the body, and the end that the form leaves out.

use super::Mistake;
use super::mistake::Lines;
use super::source::Source;
use super::xml::{self, append_text, child};

/// Reads the file.
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
    source.make("\nEND_FUNCTION_BLOCK", body.range().start);
    Ok(source)
}
