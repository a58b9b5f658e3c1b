//! What is refused: `texts/*.txt`, each rule with a text and all that is reported for it; `changes/*.txt`, the same of a file in
//! which a part is replaced. No rule stands here.

mod names;

use crate::forms;
use crate::support::{block, said, said_with};
use portable::RealKind;
use st::{Block, Dialect};
use std::path::Path;

const VARIABLES: &str = include_str!("../forms/variables.st");

/// Another block, for instances of it.
const GAIN: &str = include_str!("../forms/gain.st");

fn gain(real: RealKind) -> Block {
    let text = if real == RealKind::F32 { GAIN.replace("LREAL", "REAL") } else { GAIN.to_owned() };
    block(Dialect::Plain, &text, "gain", real)
}

#[test]
fn what_is_reported() {
    for (name, reported) in [("texts", reported as fn(&str, &str) -> Vec<String>), ("changes", of_a_change)] {
        let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/st/refused").join(name);
        for file in folder.read_dir().expect("the texts") {
            let file = file.expect("a file");
            transcript::compare(file.path(), |form, text| reported(form, text).join("\n"));
        }
    }
}

/// What is reported about a file, by the form, in which the part before a line `=>` is replaced by the one after it.
fn of_a_change(form: &str, change: &str) -> Vec<String> {
    let (dialect, text, name) = match form {
        "TwinCAT" => (Dialect::TwinCat, forms::TWINCAT, "probe"),
        "CODESYS" => (Dialect::Codesys, forms::CODESYS, "probe"),
        "SCL" => (Dialect::Scl, crate::scl::SOURCE, "FB_x"),
        "SCL case" => (Dialect::Scl, crate::case::SCL, "probe"),
        "SCL instance" => (Dialect::Scl, include_str!("../forms/instance.scl"), "FB_probe"),
        other => panic!("no such form: {other}"),
    };
    let (from, to) = change.split_once("\n=>\n").expect("a line `=>`");
    assert!(text.contains(from), "{form}: {from}");
    said_with(dialect, &text.replacen(from, to, 1), name, RealKind::F64, &[gain(RealKind::F64)])
}

/// What is reported about a text, by the form, which says where it stands:
///
/// - `body`: in a block with variables of each type, from line 14 on
/// - `instance`: the same, with a `gain` named `g`, from line 17 on
/// - `declared`: before the body of a block with one output, from line 5 on
/// - `declared instance`: the same, where the text may have a `gain`
/// - `file`, `TwinCAT`: it is a file
/// - `program`: the body of the program of `program.rs`
pub fn reported(form: &str, text: &str) -> Vec<String> {
    let (form, real) = form.strip_suffix(" of REAL").map_or((form, RealKind::F64), |form| (form, RealKind::F32));
    let body = |variables: &str| {
        let text = format!("{VARIABLES}{variables}{text}\nEND_FUNCTION_BLOCK\n");
        if real == RealKind::F32 { text.replace("LREAL;", "REAL;") } else { text }
    };
    let declared = || {
        let output = "VAR_OUTPUT\n    y : LREAL;\nEND_VAR\n";
        format!("FUNCTION_BLOCK probe\n{output}{text}\ny := 1.0;\nEND_FUNCTION_BLOCK\n")
    };
    match form {
        "body" => said(Dialect::Plain, &body(""), "probe", real),
        "instance" => said_with(Dialect::Plain, &body("VAR\n    g : gain;\nEND_VAR\n"), "probe", real, &[gain(real)]),
        "declared" => said(Dialect::Plain, &declared(), "probe", real),
        "declared instance" => said_with(Dialect::Plain, &declared(), "probe", RealKind::F64, &[gain(real)]),
        "file" => said(Dialect::Plain, text, "probe", real),
        "TwinCAT" => said(Dialect::TwinCat, text, "probe", real),
        "program" => crate::program::refused(text),
        other => panic!("no such form: {other}"),
    }
}
