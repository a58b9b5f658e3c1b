//! What is refused, rule by rule: a text, and all that is said of it.

mod at_once;
mod declarations;
mod files;
mod lexical;
mod names;
mod numbers;
mod operators_and_calls;
mod single_precision;
mod statements;
mod types;

use crate::support::said;
use portable::RealKind;
use st::Dialect;

/// Where the text of a row stands.
#[derive(Clone, Copy)]
pub enum Place {
    /// in the body of a block with variables of each type, from line 14 on
    Body,
    /// the same, whose reals are `REAL`
    Single,
    /// before the body of a block with one output, from line 5 on
    Declared,
    /// it is a file
    Whole,
}

/// A rule, a text that breaks it, and what is said.
pub struct Row {
    /// the rule
    pub rule: &'static str,
    /// where the text stands
    pub place: Place,
    /// what a real is
    pub real: RealKind,
    /// the text
    pub text: &'static str,
    /// what is said
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

/// A text in its place.
pub fn file(place: Place, text: &str) -> String {
    let body = format!("{VARIABLES}{text}\nEND_FUNCTION_BLOCK\n");
    match place {
        Place::Body => body,
        Place::Single => body.replace("LREAL;", "REAL;"),
        Place::Declared => {
            let output = "VAR_OUTPUT\n    y : LREAL;\nEND_VAR\n";
            format!("FUNCTION_BLOCK probe\n{output}{text}\ny := 1.0;\nEND_FUNCTION_BLOCK\n")
        }
        Place::Whole => text.to_owned(),
    }
}

/// Asks for each row's messages.
pub fn refuses(rows: &[Row]) {
    for row in rows {
        let text = file(row.place, row.text);
        assert_eq!(said(Dialect::Plain, &text, "probe", row.real), row.said, "{}:\n{text}", row.rule);
    }
}

#[test]
fn the_text_around_the_rows_is_taken() {
    for (place, text, real) in [
        (Place::Body, "y := x;", RealKind::F64),
        (Place::Single, "y := x;", RealKind::F32),
        (Place::Declared, "", RealKind::F64),
    ] {
        assert_eq!(said(Dialect::Plain, &file(place, text), "probe", real), [""; 0]);
    }
}
