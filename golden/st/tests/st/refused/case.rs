//! Refused: `CASE`.

use crate::refused::{Part, Row, refuses};
use portable::RealKind;

/// A rule about `CASE`, in the body of an LREAL block.
fn row(rule: &'static str, text: &'static str, said: &'static [&'static str]) -> Row {
    Row { rule, part: Part::Body, real: RealKind::F64, text, said }
}

#[test]
fn case() {
    refuses(&[
        row("a UDINT", "CASE u OF\n    1: y := x;\nEND_CASE;", &["14:6: found `CASE` of UDINT; write a DINT"]),
        row("a BOOL", "CASE p OF\n    1: y := x;\nEND_CASE;", &["14:6: found `CASE` of BOOL; write a DINT"]),
        row(
            "a literal",
            "CASE 1 OF\n    1: y := x;\nEND_CASE;",
            &["14:6: found `CASE` of an integer literal; write a DINT"],
        ),
        row(
            "a name that is not declared",
            "CASE z OF\n    1: y := x;\nEND_CASE;",
            &["14:6: found `z`, which is not declared; write a declared variable"],
        ),
        row(
            "a range",
            "CASE i OF\n    0: y := x;\n    1..3: y := x;\nEND_CASE;",
            &["16:5: found the range `1..3`; write each number of it, with commas between them"],
        ),
        row(
            "a name as a label",
            "CASE i OF\n    j: y := x;\nEND_CASE;",
            &["15:5: found the label `j`; write an integer literal"],
        ),
        row(
            "a computed label",
            "CASE i OF\n    1 + 1: y := x;\nEND_CASE;",
            &["15:5: found the label `1 + 1`; write an integer literal"],
        ),
        row(
            "a minus away from its number",
            "CASE i OF\n    - 1: y := x;\nEND_CASE;",
            &["15:5: found the label `- 1`; write an integer literal"],
        ),
        row(
            "a real as a label",
            "CASE i OF\n    1.0: y := x;\nEND_CASE;",
            &["15:5: found the label `1.0`; write an integer literal"],
        ),
        row(
            "a label that is no DINT",
            "CASE i OF\n    2147483648: y := x;\nEND_CASE;",
            &["15:5: found `2147483648`; write an integer that fits a DINT"],
        ),
        row(
            "the smallest DINT as a label",
            "CASE i OF\n    -2147483648: y := x;\nEND_CASE;",
            &["15:5: found the label `-2147483648`; write another label"],
        ),
        row(
            "a label twice",
            "CASE i OF\n    1: y := x;\n    2, 16#1: y := x;\nEND_CASE;",
            &["16:8: found the label `16#1` a second time; write each label once"],
        ),
        row(
            "a label twice in a branch",
            "CASE i OF\n    2, 2: y := x;\nEND_CASE;",
            &["15:8: found the label `2` a second time; write each label once"],
        ),
        row(
            "no statement in a branch",
            "CASE i OF\n    1:\n    2: y := x;\nEND_CASE;",
            &["15:5: found a branch of `CASE` without a statement; write a statement"],
        ),
        row(
            "a semicolon in a branch",
            "CASE i OF\n    1: ;\nEND_CASE;",
            &[
                "15:5: found a branch of `CASE` without a statement; write a statement",
                "15:8: found `;` without a statement; write nothing",
            ],
        ),
        row(
            "no statement in ELSE",
            "CASE i OF\n    1: y := x;\nELSE\nEND_CASE;",
            &["16:1: found `ELSE` without a statement; write a statement"],
        ),
        row(
            "no semicolon after END_CASE",
            "CASE i OF\n    1: y := x;\nEND_CASE\ny := x;",
            &["16:9: found no `;` after `END_CASE`; write `END_CASE;`"],
        ),
        row("no END_CASE", "CASE i OF\n    1: y := x;", &["15:15: found no `END_CASE`; write `END_CASE`"]),
        row("no branch", "CASE i OF\nEND_CASE;", &["14:1: found `CASE i OF...`; write declarations, `:=` and `IF`"]),
        row(
            "no OF",
            "CASE i\n    1: y := x;\nEND_CASE;",
            &["14:1: found `CASE i...`; write declarations, `:=` and `IF`"],
        ),
        row(
            "a mistake in a branch",
            "CASE i OF\n    1: y := z;\nELSE\n    i := 1;\nEND_CASE;",
            &[
                "15:13: found `z`, which is not declared; write a declared variable",
                "17:5: found the input `i` left of `:=`; write a variable of its own",
            ],
        ),
    ]);
}
