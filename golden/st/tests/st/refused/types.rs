//! Refused: types.

use crate::refused::{Part, Row, refuses};
use portable::RealKind;

#[test]
fn types() {
    refuses(&[
        Row {
            rule: "an integer for a real",
            part: Part::Body,
            real: RealKind::F64,
            text: "y := 1;",
            said: &["14:6: found the integer `1` where a LREAL belongs; write `1.0`"],
        },
        Row {
            rule: "a DINT for a LREAL",
            part: Part::Body,
            real: RealKind::F64,
            text: "y := i;",
            said: &["14:6: found a DINT for a LREAL; write `DINT_TO_LREAL`, or a LREAL"],
        },
        Row {
            rule: "a LREAL for a DINT",
            part: Part::Body,
            real: RealKind::F64,
            text: "j := x;",
            said: &["14:6: found a LREAL for a DINT; write a DINT"],
        },
        Row {
            rule: "a UDINT for a DINT",
            part: Part::Body,
            real: RealKind::F64,
            text: "j := u;",
            said: &["14:6: found a UDINT for a DINT; write a DINT"],
        },
        Row {
            rule: "a BOOL for a LREAL",
            part: Part::Body,
            real: RealKind::F64,
            text: "y := p;",
            said: &["14:6: found a BOOL for a LREAL; write a LREAL"],
        },
        Row {
            rule: "a number for a BOOL",
            part: Part::Body,
            real: RealKind::F64,
            text: "q := 1;",
            said: &["14:6: found the integer `1` where a BOOL belongs; write `TRUE` or `FALSE`"],
        },
        Row {
            rule: "an integer beside a real",
            part: Part::Body,
            real: RealKind::F64,
            text: "y := x * 2;",
            said: &["14:10: found the integer `2` where a LREAL belongs; write `2.0`"],
        },
        Row {
            rule: "a DINT beside a LREAL",
            part: Part::Body,
            real: RealKind::F64,
            text: "y := x * i;",
            said: &["14:8: found `*` of LREAL and DINT; write `DINT_TO_LREAL`"],
        },
        Row {
            rule: "a LREAL beside a UDINT",
            part: Part::Body,
            real: RealKind::F64,
            text: "q := u < x;",
            said: &["14:8: found `<` of UDINT and LREAL; write `UDINT_TO_LREAL`"],
        },
        Row {
            rule: "a DINT beside a UDINT",
            part: Part::Body,
            real: RealKind::F64,
            text: "q := i < u;",
            said: &["14:8: found `<` of DINT and UDINT; write one type on both sides"],
        },
        Row {
            rule: "arithmetic of BOOLs",
            part: Part::Body,
            real: RealKind::F64,
            text: "q := p + p;",
            said: &["14:8: found `+` of BOOL; write `AND`, `OR`, `NOT`, `=` or `<>`"],
        },
        Row {
            rule: "an order of BOOLs",
            part: Part::Body,
            real: RealKind::F64,
            text: "q := p < q;",
            said: &["14:8: found `<` of BOOL; write `AND`, `OR`, `NOT`, `=` or `<>`"],
        },
        Row {
            rule: "AND of integers",
            part: Part::Body,
            real: RealKind::F64,
            text: "j := i AND j;",
            said: &["14:8: found `AND` of DINT; write BOOLs, or arithmetic"],
        },
        Row {
            rule: "NOT of an integer",
            part: Part::Body,
            real: RealKind::F64,
            text: "j := NOT i;",
            said: &["14:6: found `NOT` of DINT; write a BOOL"],
        },
        Row {
            rule: "minus of a UDINT",
            part: Part::Body,
            real: RealKind::F64,
            text: "v := -u;",
            said: &["14:6: found `-` of UDINT; write a REAL, LREAL or DINT"],
        },
        Row {
            rule: "minus of a BOOL",
            part: Part::Body,
            real: RealKind::F64,
            text: "q := -p;",
            said: &["14:6: found `-` of BOOL; write a REAL, LREAL or DINT"],
        },
        Row {
            rule: "division of integers",
            part: Part::Body,
            real: RealKind::F64,
            text: "j := i / 3;",
            said: &["14:8: found `/` of DINT; write reals, or a coefficient"],
        },
        Row {
            rule: "two integer literals",
            part: Part::Body,
            real: RealKind::F64,
            text: "j := 1 + 2;",
            said: &["14:6: found `+` of two integer literals; write its result"],
        },
        Row {
            rule: "the smallest DINT as minus a number that is none",
            part: Part::Body,
            real: RealKind::F64,
            text: "j := (-2147483648);",
            said: &["14:7: found `-2147483648` in an expression; write `-2147483647 - 1`"],
        },
        Row {
            rule: "a condition that is no BOOL",
            part: Part::Body,
            real: RealKind::F64,
            text: "IF i THEN\n    y := x;\nEND_IF;",
            said: &["14:4: found a condition of type DINT; write a BOOL"],
        },
        Row {
            rule: "a comparison of a comparison",
            part: Part::Body,
            real: RealKind::F64,
            text: "q := x < x < x;",
            said: &["14:12: found `<` of BOOL and LREAL; write one type on both sides"],
        },
    ]);
}
