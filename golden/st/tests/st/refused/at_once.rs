//! Refused: several things of a file at once, each at its place, in the order of the file.

use crate::support::said;
use portable::RealKind;
use st::Dialect;

const TEXT: &str = "FUNCTION_BLOCK probe
VAR_INPUT
    x, x2 : LREAL; // input
    on : BOOL;
END_VAR
VAR_OUTPUT
    y : LREAL := 1.0;
END_VAR
y := MIN(x, 1E-3);
y := (x + ;
IF on THEN
END_IF
z := .5;
END_FUNCTION_BLOCK
";

#[test]
fn all_of_a_file() {
    assert_eq!(
        said(Dialect::Plain, TEXT, "probe", RealKind::F64),
        [
            "3:8: found a second name in a declaration; write one declaration for each name",
            "3:20: found `//`; write `(* *)`",
            "4:5: found the name `on`, which some compiler takes for its own; write another name",
            "7:18: found an initial value, which some compiler drops; write an assignment in the first cycle",
            "9:6: found the standard function `MIN`; write `IF`",
            "9:13: found `1E-3`; write a number like `15`, `1.5`, `1.5E+3` or `1.5E-3`",
            "10:1: found `y := (x +`; write declarations, `:=` and `IF`",
            "11:1: found `IF` without a statement; write a statement",
            "12:7: found no `;` after `END_IF`; write `END_IF;`",
            "13:6: found `.5`; write a number like `15`, `1.5`, `1.5E+3` or `1.5E-3`"
        ]
    );
}

#[test]
fn a_comment_that_does_not_end_hides_only_what_comes_after_it() {
    let text = TEXT.replace("IF on", "(* IF on");
    assert_eq!(
        said(Dialect::Plain, &text, "probe", RealKind::F64).last().map(String::as_str),
        Some("11:1: found a comment that does not end; write `*)`")
    );
}

#[test]
fn where_a_declaration_cannot_be_read_no_name_is_called_unknown() {
    let text =
        "FUNCTION_BLOCK probe\nVAR_OUTPUT\n    y LREAL;\n    z : INT;\nEND_VAR\ny := MIN(z);\nEND_FUNCTION_BLOCK\n";
    assert_eq!(
        said(Dialect::Plain, text, "probe", RealKind::F64),
        [
            "3:5: found `y LREAL;`; write declarations, `:=` and `IF`",
            "4:9: found the type `INT`; write `LREAL`, `BOOL`, `DINT` or `UDINT`",
            "6:6: found the standard function `MIN`; write `IF`"
        ]
    );
}
