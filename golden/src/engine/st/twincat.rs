//! A `.TcPOU` -> its text: the declaration, the body, and the end that the form leaves out.

use super::Mistake;
use super::mistake::Lines;
use super::source::Source;
use super::xml;

/// Reads the file.
pub fn read(file: &str) -> Result<Source, Vec<Mistake>> {
    let lines = Lines::of(file);
    let root = xml::read(file)?;
    let fail = |at: usize, found: &str, instead: &str| Err(vec![lines.mistake(at, found, instead)]);
    if root.name != "TcPlcObject" {
        return fail(root.at, &format!("`<{}>`", root.name), "`<TcPlcObject>`");
    }
    let Some(pou) = root.child("POU") else { return fail(root.at, "no `<POU>`", "`<POU>`") };
    let Some(name) = pou.attribute("Name") else {
        return fail(pou.at, "a `<POU>` without `Name`", "`Name`");
    };
    let known = ["Declaration", "Implementation", "LineIds", "ObjectProperties"];
    let foreign = pou.children.iter().filter(|child| !known.contains(&child.name.as_str()));
    let foreign: Vec<_> =
        foreign.map(|child| lines.mistake(child.at, format!("`<{}>`", child.name), "one body")).collect();
    if !foreign.is_empty() {
        return Err(foreign);
    }
    let Some(declaration) = pou.child("Declaration") else {
        return fail(pou.at, "no `<Declaration>`", "`<Declaration>`");
    };
    let Some(body) = pou.child("Implementation").and_then(|implementation| implementation.child("ST")) else {
        return fail(pou.at, "no `<Implementation><ST>`", "`<Implementation><ST>`");
    };
    let mut source = Source::default();
    source.name = Some(name.to_owned());
    declaration.append_to(&mut source);
    source.make("\n", body.at);
    source.body = Some(source.text.len());
    body.append_to(&mut source);
    source.make("\nEND_FUNCTION_BLOCK", body.at);
    Ok(source)
}
