//! What is refused, rule by rule: a text, and all that is reported for it.

mod at_once;
mod case;
mod declarations;
mod files;
mod instances;
mod lexical;
mod names;
mod numbers;
mod operators_and_calls;
mod single_precision;
mod statements;
mod types;
mod unary;

use crate::support::said;
use portable::RealKind;
use st::Dialect;

/// Where the text of a row stands.
#[derive(Clone, Copy)]
pub enum Part {
    /// in the body of a block with variables of each type, from line 14 on
    Body,
    /// the same, whose reals are `REAL`
    Single,
    /// before the body of a block with one output, from line 5 on
    Declared,
    /// it is a file
    Whole,
}

/// A rule, a text that breaks it, and what is reported.
pub struct Row {
    /// the rule
    pub rule: &'static str,
    /// where the text stands
    pub part: Part,
    /// what a real is
    pub real: RealKind,
    /// the text
    pub text: &'static str,
    /// what is reported
    pub said: &'static [&'static str],
}

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

/// A text in its part.
pub fn file(part: Part, text: &str) -> String {
    let body = format!("{VARIABLES}{text}\nEND_FUNCTION_BLOCK\n");
    match part {
        Part::Body => body,
        Part::Single => body.replace("LREAL;", "REAL;"),
        Part::Declared => {
            let output = "VAR_OUTPUT\n    y : LREAL;\nEND_VAR\n";
            format!("FUNCTION_BLOCK probe\n{output}{text}\ny := 1.0;\nEND_FUNCTION_BLOCK\n")
        }
        Part::Whole => text.to_owned(),
    }
}

/// Asks for each row's messages.
pub fn refuses(rows: &[Row]) {
    for row in rows {
        let text = file(row.part, row.text);
        assert_eq!(said(Dialect::Plain, &text, "probe", row.real), row.said, "{}:\n{text}", row.rule);
    }
}

#[test]
fn the_text_around_the_rows_is_taken() {
    for (part, text, real) in [
        (Part::Body, "y := x;", RealKind::F64),
        (Part::Single, "y := x;", RealKind::F32),
        (Part::Declared, "", RealKind::F64),
    ] {
        assert_eq!(said(Dialect::Plain, &file(part, text), "probe", real), [""; 0]);
    }
}
