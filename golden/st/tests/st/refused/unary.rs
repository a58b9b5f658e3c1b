//! Refused: operators before an operand, and numbers with a sign.

use crate::refused::{Part, Row, file, refuses};
use crate::support::said;
use portable::RealKind;
use st::Dialect;

/// A rule, in the body of an LREAL block.
fn row(rule: &'static str, text: &'static str, said: &'static [&'static str]) -> Row {
    Row { rule, part: Part::Body, real: RealKind::F64, text, said }
}

#[test]
fn not_of_an_expression() {
    let found = |text: &str| said(Dialect::Plain, &file(Part::Body, text), "probe", RealKind::F64).join("; ");
    let refused = |place: &str| {
        format!(
            "{place}: found `NOT` of an expression, which one compiler translates wrongly; \
             write a BOOL variable that was assigned the condition"
        )
    };
    for (text, place) in [
        ("q := NOT (p AND q);", "14:6"),
        ("q := p OR NOT (x < 1.0);", "14:11"),
        ("q := NOT (p);", "14:6"),
        ("q := NOT TRUE;", "14:6"),
        ("q := NOT NOT p;", "14:6"),
        ("q := NOT -i;", "14:6"),
        ("IF NOT (i = 2) THEN\n    y := x;\nEND_IF;", "14:4"),
    ] {
        assert_eq!(found(text), refused(place), "{text}");
    }
    assert_eq!(found("q := NOT p AND NOT q;\nq := NOT p = q;"), "");
    assert_eq!(found("q := NOT x;"), "14:6: found `NOT` of LREAL; write a BOOL");
    assert_eq!(found("q := NOT DINT_TO_LREAL(i);"), "14:6: found `NOT` of LREAL; write a BOOL");
}

#[test]
fn minus_zero() {
    refuses(&[
        row("alone", "y := -0.0;", &["14:6: found `-0.0`; write `-1.0 * 0.0`"]),
        row("with an exponent", "y := -0.00E+3;", &["14:6: found `-0.00E+3`; write `-1.0 * 0.0`"]),
        row("in parentheses", "y := (-0.0);", &["14:7: found `-0.0`; write `-1.0 * 0.0`"]),
        row("a minus before it", "y := - 0.0;", &["14:6: found `- 0.0`; write `-1.0 * 0.0`"]),
        row("a minus before parentheses", "y := -(0.0);", &["14:6: found `-(0.0)`; write `-1.0 * 0.0`"]),
        row("two minuses", "y := - -0.0;", &["14:8: found `-0.0`; write `-1.0 * 0.0`"]),
        row("an operand", "y := x * -0.0;", &["14:10: found `-0.0`; write `-1.0 * 0.0`"]),
        row("in a condition", "q := x < -0.0;", &["14:10: found `-0.0`; write `-1.0 * 0.0`"]),
        row("a difference", "y := x -0.0;\ny := x - 0.0;\nj := i - -0;", &[]),
        Row {
            rule: "a start value",
            part: Part::Declared,
            real: RealKind::F64,
            text: "VAR_INPUT\n    x : LREAL := -0.0;\nEND_VAR",
            said: &["6:18: found `-0.0`; write `-1.0 * 0.0`"],
        },
        Row {
            rule: "as REAL",
            part: Part::Single,
            real: RealKind::F32,
            text: "y := -0.0;",
            said: &["14:6: found `-0.0`; write `-1.0 * 0.0`"],
        },
    ]);
}

#[test]
fn the_smallest_dint() {
    let start = |text, said| Row { rule: "a start value", part: Part::Declared, real: RealKind::F64, text, said };
    let instead = "found `-2147483648` in an expression; write `-2147483647 - 1`";
    let found = |text: &str| said(Dialect::Plain, &file(Part::Body, text), "probe", RealKind::F64).join("; ");
    assert_eq!(found("j := -2147483648;"), format!("14:6: {instead}"));
    assert_eq!(found("j := - 2147483648;"), format!("14:6: {instead}"));
    assert_eq!(found("j := i + -(2147483648);"), format!("14:10: {instead}"));
    assert_eq!(found("j := -2147483647 - 1;"), "");
    refuses(&[
        start("VAR_INPUT\n    k : DINT := -2147483647 - 1;\nEND_VAR", &[]),
        start(
            "VAR_INPUT\n    k : DINT := -2147483648;\nEND_VAR",
            &["6:17: found the initial value `-2147483648`; write `-2147483647 - 1`"],
        ),
        start(
            "VAR_INPUT\n    k : DINT := -2147483647 - 2;\nEND_VAR",
            &["6:17: found the initial value `-2147483647 - 2`; write a literal of DINT"],
        ),
        start(
            "VAR_INPUT\n    k : DINT := -2147483646 - 1;\nEND_VAR",
            &["6:17: found the initial value `-2147483646 - 1`; write a literal of DINT"],
        ),
        start(
            "VAR_INPUT\n    k : UDINT := -2147483647 - 1;\nEND_VAR",
            &["6:18: found the initial value `-2147483647 - 1`; write a literal of UDINT"],
        ),
        start(
            "VAR_INPUT\n    k : UDINT := -2147483648;\nEND_VAR",
            &["6:18: found the initial value `-2147483648`; write a literal of UDINT"],
        ),
    ]);
}
