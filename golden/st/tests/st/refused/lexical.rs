//! Refused: lexical.

use crate::refused::{Part, Row, refuses};
use portable::RealKind;

#[test]
fn lexical() {
    refuses(&[
        Row {
            rule: "a letter that is not ASCII",
            part: Part::Body,
            real: RealKind::F64,
            text: "y := x; (* µm *)",
            said: &["14:12: found \"µ\"; write ASCII"],
        },
        Row {
            rule: "a control character",
            part: Part::Body,
            real: RealKind::F64,
            text: "y :=\u{c} x;",
            said: &["14:5: found \"\\u{c}\"; write ASCII"],
        },
        Row {
            rule: "a line comment",
            part: Part::Body,
            real: RealKind::F64,
            text: "y := x; // why",
            said: &["14:9: found `//`; write `(* *)`"],
        },
        Row {
            rule: "a pragma",
            part: Part::Body,
            real: RealKind::F64,
            text: "{attribute := 1}\ny := x;",
            said: &["14:1: found a pragma; write nothing, or a comment"],
        },
        Row {
            rule: "a comment inside a comment",
            part: Part::Body,
            real: RealKind::F64,
            text: "y := x; (* a (* b *)",
            said: &["14:14: found a comment inside a comment; write one comment"],
        },
        Row {
            rule: "a comment that does not end",
            part: Part::Body,
            real: RealKind::F64,
            text: "y := x; (* a",
            said: &["14:9: found a comment that does not end; write `*)`"],
        },
        Row {
            rule: "a comment that ends twice",
            part: Part::Body,
            real: RealKind::F64,
            text: "y := x; (* a *) *)",
            said: &["14:17: found `*)`; write declarations, `:=` and `IF`"],
        },
    ]);
}
