//! Refused: files.

use crate::refused::{Part, Row, refuses};
use portable::RealKind;

#[test]
fn files() {
    refuses(&[
        Row {
            rule: "no block",
            part: Part::Whole,
            real: RealKind::F64,
            text: "(* nothing *)\n",
            said: &["1:1: found no block `probe`; write `FUNCTION_BLOCK probe`"],
        },
        Row {
            rule: "another block",
            part: Part::Whole,
            real: RealKind::F64,
            text: "FUNCTION_BLOCK other\nVAR_OUTPUT\n    y : LREAL;\nEND_VAR\ny := 1.0;\nEND_FUNCTION_BLOCK\n",
            said: &["1:1: found no block `probe`; write `FUNCTION_BLOCK probe`"],
        },
        Row {
            rule: "a name to avoid",
            part: Part::Whole,
            real: RealKind::F64,
            text: "FUNCTION_BLOCK ramp\nVAR_OUTPUT\n    y : LREAL;\nEND_VAR\ny := 1.0;\nEND_FUNCTION_BLOCK\n",
            said: &[
                "1:1: found no block `probe`; write `FUNCTION_BLOCK probe`",
                "1:16: found the name `ramp`, which some compiler takes for its own; write another name",
            ],
        },
        Row {
            rule: "a block twice",
            part: Part::Whole,
            real: RealKind::F64,
            text: "FUNCTION_BLOCK probe\nVAR_OUTPUT\n    y : LREAL;\nEND_VAR\ny := 1.0;\nEND_FUNCTION_BLOCK\nFUNCTION_BLOCK probe\nVAR_OUTPUT\n    y : LREAL;\nEND_VAR\ny := 1.0;\nEND_FUNCTION_BLOCK\n",
            said: &["7:1: found a second block `probe`; write another name"],
        },
        Row {
            rule: "a semicolon after the block",
            part: Part::Whole,
            real: RealKind::F64,
            text: "FUNCTION_BLOCK probe\nVAR_OUTPUT\n    y : LREAL;\nEND_VAR\ny := 1.0;\nEND_FUNCTION_BLOCK;\n",
            said: &["6:19: found `;` without a statement; write nothing"],
        },
        Row {
            rule: "a program",
            part: Part::Whole,
            real: RealKind::F64,
            text: "FUNCTION_BLOCK probe\nVAR_INPUT\n    x : LREAL;\n    i : DINT;\n    u : UDINT;\n    p : BOOL;\nEND_VAR\nVAR_OUTPUT\n    y : LREAL;\n    j : DINT;\n    v : UDINT;\n    q : BOOL;\nEND_VAR\ny := x;\nEND_FUNCTION_BLOCK\nPROGRAM main\nVAR\n    k : LREAL;\nEND_VAR\nk := 1.0;\nEND_PROGRAM\n",
            said: &["16:1: found `PROGRAM main...`; write `FUNCTION_BLOCK`"],
        },
        Row {
            rule: "a function",
            part: Part::Whole,
            real: RealKind::F64,
            text: "FUNCTION_BLOCK probe\nVAR_INPUT\n    x : LREAL;\n    i : DINT;\n    u : UDINT;\n    p : BOOL;\nEND_VAR\nVAR_OUTPUT\n    y : LREAL;\n    j : DINT;\n    v : UDINT;\n    q : BOOL;\nEND_VAR\ny := x;\nEND_FUNCTION_BLOCK\nFUNCTION gain : LREAL\nVAR_INPUT\n    k : LREAL;\nEND_VAR\ngain := k;\nEND_FUNCTION\n",
            said: &["16:1: found `FUNCTION gain : LREAL...`; write `FUNCTION_BLOCK`"],
        },
        Row {
            rule: "a type",
            part: Part::Whole,
            real: RealKind::F64,
            text: "TYPE\n    t : LREAL;\nEND_TYPE\nFUNCTION_BLOCK probe\nVAR_INPUT\n    x : LREAL;\n    i : DINT;\n    u : UDINT;\n    p : BOOL;\nEND_VAR\nVAR_OUTPUT\n    y : LREAL;\n    j : DINT;\n    v : UDINT;\n    q : BOOL;\nEND_VAR\ny := x;\nEND_FUNCTION_BLOCK\n",
            said: &["1:1: found `TYPE...`; write `TYPE x : STRUCT ... END_STRUCT END_TYPE`"],
        },
        Row {
            rule: "a part of a structure that has another type",
            part: Part::Whole,
            real: RealKind::F64,
            text: "TYPE ST_probe :\nSTRUCT\n    t : LREAL;\n    w : STRING;\nEND_STRUCT;\nEND_TYPE\nFUNCTION_BLOCK probe\nVAR_INPUT\n    x : LREAL;\n    i : DINT;\n    u : UDINT;\n    p : BOOL;\nEND_VAR\nVAR_OUTPUT\n    y : LREAL;\n    j : DINT;\n    v : UDINT;\n    q : BOOL;\nEND_VAR\ny := x;\nEND_FUNCTION_BLOCK\n",
            said: &[
                "4:9: found the type `STRING`; write a type of a variable, or a structure of a file before this one",
            ],
        },
        Row {
            rule: "a method",
            part: Part::Whole,
            real: RealKind::F64,
            text: "FUNCTION_BLOCK probe\nVAR_OUTPUT\n    y : LREAL;\nEND_VAR\nMETHOD get_it : LREAL\nget_it := 1.0;\nEND_METHOD\ny := 1.0;\nEND_FUNCTION_BLOCK\n",
            said: &["5:1: found `METHOD get_it : LREAL...`; write one body"],
        },
        Row {
            rule: "a block that extends",
            part: Part::Whole,
            real: RealKind::F64,
            text: "FUNCTION_BLOCK probe EXTENDS other\nVAR_OUTPUT\n    y : LREAL;\nEND_VAR\ny := 1.0;\nEND_FUNCTION_BLOCK\n",
            said: &["1:22: found `EXTENDS`; write a block by itself"],
        },
        Row {
            rule: "an abstract block",
            part: Part::Whole,
            real: RealKind::F64,
            text: "ABSTRACT FUNCTION_BLOCK probe\nVAR_OUTPUT\n    y : LREAL;\nEND_VAR\ny := 1.0;\nEND_FUNCTION_BLOCK\n",
            said: &["1:1: found `ABSTRACT`; write a block by itself"],
        },
    ]);
}
