//! What is refused: `texts/*.txt`, each rule with a text and all that is reported for it. No rule stands here.

mod names;
mod scl;

use crate::support::{block, said, said_with};
use portable::RealKind;
use st::{Block, Dialect};
use std::path::Path;

const VARIABLES: &str = "FUNCTION_BLOCK probe
VAR_INPUT
    x : LREAL;
    i : DINT;
    u : UDINT;
    p : BOOL;
END_VAR
VAR_OUTPUT
    y : LREAL;
    j : DINT;
    v : UDINT;
    q : BOOL;
END_VAR
";

/// Another block, for instances of it.
const GAIN: &str = "FUNCTION_BLOCK gain
VAR_INPUT
    x : LREAL;
    n : DINT;
    w : LREAL;
END_VAR
VAR_OUTPUT
    y : LREAL;
END_VAR
VAR
    k : LREAL;
END_VAR
k := 2.0;
y := k * x;
END_FUNCTION_BLOCK
";

fn gain(real: RealKind) -> Block {
    let text = if real == RealKind::F32 { GAIN.replace("LREAL", "REAL") } else { GAIN.to_owned() };
    block(Dialect::Plain, &text, "gain", real)
}

#[test]
fn what_is_reported() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/st/refused/texts");
    for file in folder.read_dir().expect("the texts") {
        let file = file.expect("a file");
        transcript::compare(file.path(), |form, text| reported(form, text).join("\n"));
    }
}

/// What is reported about a text, by the form, which says where it stands:
///
/// - `body`: in a block with variables of each type, from line 14 on
/// - `instance`: the same, with a `gain` named `g`, from line 17 on
/// - `declared`: before the body of a block with one output, from line 5 on
/// - `declared instance`: the same, where the text may have a `gain`
/// - `file`, `TwinCAT`: it is a file
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
        other => panic!("no such form: {other}"),
    }
}
