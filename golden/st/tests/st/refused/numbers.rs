//! Refused: numbers.

use crate::refused::{Part, Row, refuses};
use portable::RealKind;

#[test]
fn numbers() {
    refuses(&[
        Row {
            rule: "no digit before the dot",
            part: Part::Body,
            real: RealKind::F64,
            text: "y := .5;",
            said: &["14:6: found `.5`; write a number like `15`, `1.5`, `1.5E+3` or `1.5E-3`"],
        },
        Row {
            rule: "no digit after the dot",
            part: Part::Body,
            real: RealKind::F64,
            text: "y := 5.;",
            said: &["14:6: found `5.`; write a number like `15`, `1.5`, `1.5E+3` or `1.5E-3`"],
        },
        Row {
            rule: "an exponent without a dot",
            part: Part::Body,
            real: RealKind::F64,
            text: "y := 1E-3;",
            said: &["14:6: found `1E-3`; write a number like `15`, `1.5`, `1.5E+3` or `1.5E-3`"],
        },
        Row {
            rule: "an exponent without a sign",
            part: Part::Body,
            real: RealKind::F64,
            text: "y := 1.0E5;",
            said: &["14:6: found `1.0E5`; write a number like `15`, `1.5`, `1.5E+3` or `1.5E-3`"],
        },
        Row {
            rule: "a small exponent letter",
            part: Part::Body,
            real: RealKind::F64,
            text: "y := 1.0e-5;",
            said: &["14:6: found `1.0e-5`; write a number like `15`, `1.5`, `1.5E+3` or `1.5E-3`"],
        },
        Row {
            rule: "digits in groups",
            part: Part::Body,
            real: RealKind::F64,
            text: "y := 1_000.0;",
            said: &["14:6: found `1_000.0`; write a number like `15`, `1.5`, `1.5E+3` or `1.5E-3`"],
        },
        Row {
            rule: "an integer in groups",
            part: Part::Body,
            real: RealKind::F64,
            text: "j := 1_000;",
            said: &["14:6: found `1_000`; write a number like `15`, `1.5`, `1.5E+3` or `1.5E-3`"],
        },
        Row {
            rule: "a small magnitude",
            part: Part::Body,
            real: RealKind::F64,
            text: "y := 1.17E-38;",
            said: &[
                "14:6: found `1.17E-38`, a magnitude outside 1.18E-38 .. 3.4E38; write a product of numbers inside it",
            ],
        },
        Row {
            rule: "a large magnitude",
            part: Part::Body,
            real: RealKind::F64,
            text: "y := 3.5E+38;",
            said: &[
                "14:6: found `3.5E+38`, a magnitude outside 1.18E-38 .. 3.4E38; write a product of numbers inside it",
            ],
        },
        Row {
            rule: "a typed real",
            part: Part::Body,
            real: RealKind::F64,
            text: "y := LREAL#1.0;",
            said: &["14:6: found `LREAL#1.0`; write the number without a type"],
        },
        Row {
            rule: "a typed integer",
            part: Part::Body,
            real: RealKind::F64,
            text: "j := DINT#5;",
            said: &["14:6: found `DINT#5`; write the number without a type"],
        },
        Row {
            rule: "a typed bool",
            part: Part::Body,
            real: RealKind::F64,
            text: "q := BOOL#TRUE;",
            said: &["14:6: found `BOOL#TRUE`; write the number without a type"],
        },
        Row {
            rule: "a binary integer",
            part: Part::Body,
            real: RealKind::F64,
            text: "j := 2#11;",
            said: &["14:6: found `2#11`; write the number in decimal, or `16#` and its digits without `_`"],
        },
        Row {
            rule: "an octal integer",
            part: Part::Body,
            real: RealKind::F64,
            text: "j := 8#17;",
            said: &["14:6: found `8#17`; write the number in decimal, or `16#` and its digits without `_`"],
        },
        Row {
            rule: "a duration",
            part: Part::Body,
            real: RealKind::F64,
            text: "y := T#1s;",
            said: &["14:6: found `T#1s`; write the number without a type"],
        },
        Row {
            rule: "a text",
            part: Part::Body,
            real: RealKind::F64,
            text: "y := 'one';",
            said: &["14:6: found a string; write a number or a BOOL"],
        },
        Row {
            rule: "a DINT out of range",
            part: Part::Body,
            real: RealKind::F64,
            text: "j := 2147483648;",
            said: &["14:6: found `2147483648`; write an integer that fits a DINT"],
        },
        Row {
            rule: "a UDINT out of range",
            part: Part::Body,
            real: RealKind::F64,
            text: "v := 4294967296;",
            said: &["14:6: found `4294967296`; write an integer that fits a UDINT"],
        },
        Row {
            rule: "an integer out of every range",
            part: Part::Body,
            real: RealKind::F64,
            text: "v := 99999999999999999999;",
            said: &["14:6: found `99999999999999999999`; write an integer that fits a DINT or UDINT"],
        },
        Row {
            rule: "a negative UDINT",
            part: Part::Body,
            real: RealKind::F64,
            text: "v := u + -1;",
            said: &["14:10: found `-1`; write an integer that fits a UDINT"],
        },
        Row {
            rule: "a plus before a number",
            part: Part::Body,
            real: RealKind::F64,
            text: "y := +1.0;",
            said: &["14:6: found `+` before an operand; write the operand alone"],
        },
        Row {
            rule: "a plus before an operand",
            part: Part::Body,
            real: RealKind::F64,
            text: "y := +x;",
            said: &["14:6: found `+` before an operand; write the operand alone"],
        },
    ]);
}
