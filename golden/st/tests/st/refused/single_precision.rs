//! Refused: single precision.

use crate::refused::{Part, Row, file, refuses};
use crate::support::{block, said, said_with};
use portable::RealKind;
use st::Dialect;

#[test]
fn single_precision() {
    refuses(&[
        Row {
            rule: "a literal in arithmetic",
            part: Part::Single,
            real: RealKind::F32,
            text: "y := x * 0.5;",
            said: &[
                "14:10: found `0.5`, which is LREAL, in an expression of REAL; write a REAL variable that was assigned it",
            ],
        },
        Row {
            rule: "a literal in a comparison",
            part: Part::Single,
            real: RealKind::F32,
            text: "q := x < 1.0;",
            said: &[
                "14:10: found `1.0`, which is LREAL, in an expression of REAL; write a REAL variable that was assigned it",
            ],
        },
        Row {
            rule: "a literal that two roundings change",
            part: Part::Single,
            real: RealKind::F32,
            text: "y := 1.00000017881393432617187499;",
            said: &[
                "14:6: found `1.00000017881393432617187499`, which is not the same number read as LREAL and as REAL; write digits that give the same REAL both ways",
            ],
        },
        Row {
            rule: "a product that depends on the precision",
            part: Part::Single,
            real: RealKind::F32,
            text: "y := 0.1 * 0.1;",
            said: &[
                "14:6: found `0.1 * 0.1`, which is not the same number read as LREAL and as REAL; write digits that give the same REAL both ways",
            ],
        },
        Row {
            rule: "a product that is not finite",
            part: Part::Single,
            real: RealKind::F32,
            text: "y := 3.0E+38 * 3.0E+38;",
            said: &[
                "14:6: found `3.0E+38 * 3.0E+38`, which is not the same number read as LREAL and as REAL; write digits that give the same REAL both ways",
            ],
        },
        Row {
            rule: "a conversion to LREAL",
            part: Part::Single,
            real: RealKind::F32,
            text: "y := DINT_TO_LREAL(i);",
            said: &[
                "14:6: found the standard function `DINT_TO_LREAL`; write a conversion to REAL, the type of this block",
            ],
        },
        Row {
            rule: "a sum of literals",
            part: Part::Single,
            real: RealKind::F32,
            text: "y := 1.0 + 2.0;",
            said: &[
                "14:6: found `1.0`, which is LREAL, in an expression of REAL; write a REAL variable that was assigned it",
                "14:12: found `2.0`, which is LREAL, in an expression of REAL; write a REAL variable that was assigned it",
            ],
        },
        Row {
            rule: "a variable of type LREAL",
            part: Part::Whole,
            real: RealKind::F32,
            text: "FUNCTION_BLOCK probe\nVAR_OUTPUT\n    y : LREAL;\nEND_VAR\ny := 1.0;\nEND_FUNCTION_BLOCK\n",
            said: &["3:9: found the type `LREAL`; write `REAL`, `BOOL`, `DINT` or `UDINT`"],
        },
        Row {
            rule: "a variable of type REAL",
            part: Part::Whole,
            real: RealKind::F64,
            text: "FUNCTION_BLOCK probe\nVAR_OUTPUT\n    y : REAL;\nEND_VAR\ny := 1.0;\nEND_FUNCTION_BLOCK\n",
            said: &["3:9: found the type `REAL`; write `LREAL`, `BOOL`, `DINT` or `UDINT`"],
        },
        Row {
            rule: "an initial value that two roundings change",
            part: Part::Whole,
            real: RealKind::F32,
            text: "FUNCTION_BLOCK probe\nVAR_INPUT\n    x : REAL := 1.00000017881393432617187499;\nEND_VAR\nVAR_OUTPUT\n    y : REAL;\nEND_VAR\ny := x;\nEND_FUNCTION_BLOCK\n",
            said: &[
                "3:17: found `1.00000017881393432617187499`, which is not the same number read as LREAL and as REAL; write digits that give the same REAL both ways",
            ],
        },
    ]);
}

#[test]
fn one_operation_a_statement() {
    let row = |text, said| Row { rule: "one operation", part: Part::Single, real: RealKind::F32, text, said };
    refuses(&[
        row(
            "y := x * y;\ny := -x / -y;\ny := (-x) - (y);\ny := DINT_TO_REAL(i * j + 1);\ny := -x;\nj := TRUNC(x);",
            &[],
        ),
        row(
            "q := (x < y) AND (-x <= y) OR (x > (-(y))) AND p;\nIF (x = y) OR (x <> -y) THEN\n    y := x;\nEND_IF;",
            &[],
        ),
        row("y := x * y + x;", &["14:6: found 2 operations on reals in a statement; write one operation a statement"]),
        row(
            "y := (x - y) / (x + y);",
            &["14:6: found 3 operations on reals in a statement; write one operation a statement"],
        ),
        row(
            "y := x * UDINT_TO_REAL(u);",
            &["14:6: found 2 operations on reals in a statement; write one operation a statement"],
        ),
        row(
            "y := DINT_TO_REAL(i) - UDINT_TO_REAL(u);",
            &["14:6: found 3 operations on reals in a statement; write one operation a statement"],
        ),
        row("y := -(x * y);", &["14:7: found `(x * y)` as an operand of `-`; write one operation a statement"]),
        row(
            "y := -DINT_TO_REAL(i);",
            &["14:7: found `DINT_TO_REAL(i)` as an operand of `-`; write one operation a statement"],
        ),
        row("y := -(-x);", &["14:7: found `(-x)` as an operand of `-`; write one operation a statement"]),
        row("q := x + y < x;", &["14:6: found `x + y` as an operand of `<`; write one operation a statement"]),
        row(
            "IF x >= DINT_TO_REAL(i) THEN\n    y := x;\nELSIF -y = (x / y) THEN\n    y := x;\nEND_IF;",
            &[
                "14:9: found `DINT_TO_REAL(i)` as an operand of `>=`; write one operation a statement",
                "16:12: found `(x / y)` as an operand of `=`; write one operation a statement",
            ],
        ),
        row("j := TRUNC(x + y);", &["14:12: found `x + y` as an operand of TRUNC; write one operation a statement"]),
        row("j := TRUNC(-x);", &["14:12: found `-x` as an operand of TRUNC; write one operation a statement"]),
        row(
            "j := TRUNC(DINT_TO_REAL(i));",
            &["14:12: found `DINT_TO_REAL(i)` as an operand of TRUNC; write one operation a statement"],
        ),
    ]);
    // LREAL is the widest type of all controllers.
    refuses(&[Row {
        rule: "several operations",
        part: Part::Body,
        real: RealKind::F64,
        text: "y := -(x * y) + x / DINT_TO_LREAL(i);\nq := x + y < x * y;\nj := TRUNC(x + y);",
        said: &[],
    }]);
}

#[test]
fn an_argument_is_a_statement() {
    let inner = "FUNCTION_BLOCK gain\nVAR_INPUT\n    x : REAL;\n    k : REAL;\nEND_VAR\nVAR_OUTPUT\n    y : REAL;\nEND_VAR\ny := k * x;\nEND_FUNCTION_BLOCK\n";
    let inner = block(Dialect::Plain, inner, "gain", RealKind::F32);
    let check = |body: &str| {
        let text = file(Part::Single, body).replace("VAR_OUTPUT", "VAR\n    g : gain;\nEND_VAR\nVAR_OUTPUT");
        said_with(Dialect::Plain, &text, "probe", RealKind::F32, std::slice::from_ref(&inner)).join("; ")
    };
    assert_eq!(check("g(x := x * y, k := DINT_TO_REAL(i));\nq := g.y < -g.y;\nj := TRUNC(g.y);\ny := g.y * -g.y;"), "");
    assert_eq!(
        check("g(x := x * y, k := x * y + x);"),
        "17:20: found 2 operations on reals in a statement; write one operation a statement"
    );
    let text = "<TcPlcObject><POU Name=\"probe\"><Declaration><![CDATA[FUNCTION_BLOCK probe\nVAR_INPUT\n    x : REAL;\nEND_VAR\n\
                VAR_OUTPUT\n    q : BOOL;\nEND_VAR\nVAR\n    y : REAL;\nEND_VAR]]></Declaration><Implementation><ST>\n<![CDATA[\
                q := NOT F_axgen_in_range_REAL(value := -x, largest := y);\nq := F_axgen_in_range_REAL(value := x - y, largest := x);\
                ]]></ST></Implementation></POU></TcPlcObject>";
    assert_eq!(
        said(Dialect::TwinCat, text, "probe", RealKind::F32),
        ["12:37: found `x - y` as an argument of a function; write one operation a statement"]
    );
}
