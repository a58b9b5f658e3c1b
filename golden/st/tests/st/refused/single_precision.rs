//! Refused: single precision.

use crate::refused::{Part, Row, refuses};
use portable::RealKind;

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
            rule: "a product that is no number",
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
