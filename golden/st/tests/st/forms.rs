//! The forms of a file: the same block, the same answers, and mistakes at their places in the file.

use crate::support::{LREAL, answers, block, said};
use portable::{Literal, RealKind};
use st::{Dialect, Signal};

/// The text itself.
pub const PLAIN: &str = include_str!("forms/probe.st");

/// A `.TcPOU`.
pub const TWINCAT: &str = include_str!("forms/probe.TcPOU");

/// PLCopen XML.
pub const CODESYS: &str = include_str!("forms/probe.xml");

/// An external source of SCL.
pub const SCL: &str = include_str!("forms/probe.scl");

/// What the block answers to some inputs.
pub fn found(dialect: Dialect, text: &str, set: &[(&str, bool)]) -> Vec<Literal> {
    let block = block(dialect, text, "probe", RealKind::F64);
    let inputs = [1.0, 4.0, f64::NAN, 3.0, 10.0, f64::INFINITY, -10.0];
    answers(&block, &[("x", LREAL)], &inputs.map(|x| vec![Literal::F64(x)]), &[("y", LREAL)], set).concat()
}

#[test]
fn the_forms_answer_alike() {
    let expected = [0.5, 2.25, 2.0, 2.5, 3.0, 3.0, -3.5].map(Literal::F64);
    assert_eq!(found(Dialect::Plain, PLAIN, &[("ENABLE", true)]), expected);
    assert_eq!(found(Dialect::TwinCat, TWINCAT, &[("Enable", true)]), expected);
    assert_eq!(found(Dialect::Codesys, CODESYS, &[]), expected);
    assert_eq!(found(Dialect::Scl, SCL, &[]), expected);
    assert_eq!(found(Dialect::TwinCat, &format!("\u{feff}{TWINCAT}"), &[]), expected);
    assert_eq!(found(Dialect::TwinCat, &TWINCAT.replace('\n', "\r\n"), &[]), expected);
}

#[test]
fn only_the_tools_honour_initial_values() {
    let zero = [0.0; 7].map(Literal::F64);
    assert_eq!(found(Dialect::Plain, PLAIN, &[]), zero);
    assert_eq!(found(Dialect::TwinCat, TWINCAT, &[("Enable", false)]), zero);
    assert_eq!(found(Dialect::Scl, SCL, &[("Enable", false)]), zero);
}

#[test]
fn mistakes_have_their_places_in_the_file() {
    let said = |dialect, text: &str| said(dialect, text, "probe", RealKind::F64);
    let text = TWINCAT.replace("n := n + 1;", "n := n XOR 2;").replace("5.0 * 2.0", "1E1");
    assert_eq!(
        said(Dialect::TwinCat, &text),
        ["18:27: found `1E1`; write a number like `15`, `1.5`, `1.5E+3` or `1.5E-3`", "22:12: found `XOR`; write `<>`",]
    );
    let text = CODESYS
        .replace("n := n + 1;", "n := n XOR 2;")
        .replace("\"10.0\"", "\"1E1\"")
        .replace("(x &lt;", "(z &lt; 1 AND x &gt;");
    assert_eq!(
        said(Dialect::Codesys, &text),
        [
            "37:15: found `1E1`; write a number like `15`, `1.5`, `1.5E+3` or `1.5E-3`",
            "43:134: found `z`, which is not declared; write a declared variable",
            "44:12: found `XOR`; write `<>`",
        ]
    );
}

#[test]
fn an_instance_asks_for_signals_that_are_there() {
    let block = block(Dialect::Plain, PLAIN, "probe", RealKind::F64);
    let start = |inputs: &[Signal<'_>], outputs: &[Signal<'_>], set: &[(&str, bool)]| {
        let mistakes = block.start(inputs, outputs, set).err().unwrap_or_default();
        mistakes.iter().map(ToString::to_string).collect::<Vec<_>>()
    };
    assert_eq!(start(&[("X", LREAL)], &[("Y", LREAL)], &[("enable", true)]), [""; 0]);
    assert_eq!(
        start(&[("x", Literal::U32(0)), ("y", LREAL)], &[("x", LREAL)], &[("x", true)]),
        [
            "2:16: found no `x : UDINT` in `VAR_INPUT`; write its declaration",
            "2:16: found no `y : LREAL` in `VAR_INPUT`; write its declaration",
            "2:16: found no `x : LREAL` in `VAR_OUTPUT`; write its declaration",
            "2:16: found no `x : BOOL` in `VAR_INPUT`; write its declaration",
        ]
    );
    let said = start(&[("x", Literal::F32(0.0))], &[], &[]);
    assert_eq!(said, ["2:16: found no `x : REAL` in `VAR_INPUT`; write its declaration"]);
}
