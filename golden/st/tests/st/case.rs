//! `CASE`: which branch is taken, and which variables have a value after it.

use crate::support::{answers, block, said};
use portable::{Literal, RealKind};
use st::Dialect;

const TEXT: &str = "
FUNCTION_BLOCK probe
VAR_INPUT
    n : DINT;
END_VAR
VAR_OUTPUT
    y : DINT;
END_VAR
VAR
    k : DINT;
END_VAR
k := n;
CASE k OF
    0:
        y := 10;
        (* the value of the question is that of before *)
        k := 7;
    1, -3, (* two more *) 16#10:
        y := 20;
    7:
        CASE n * n - 48 OF
            1: y := 30;
        END_CASE;
    -7:
        y := 40;
ELSE
    y := 50;
    IF n = 2 THEN
        y := 60;
    END_IF;
END_CASE;
END_FUNCTION_BLOCK
";

fn found(text: &str, inputs: &[i32]) -> Vec<Literal> {
    let block = block(Dialect::Plain, text, "probe", RealKind::F64);
    let whole = Literal::I32(0);
    let samples: Vec<Vec<Literal>> = inputs.iter().map(|&n| vec![Literal::I32(n)]).collect();
    answers(&block, &[("n", whole)], &samples, &[("y", whole)], &[]).concat()
}

#[test]
fn the_branch_whose_label_it_is_is_taken() {
    let expected = [10, 20, 20, 20, 30, 40, 50, 60, 50, 50].map(Literal::I32);
    assert_eq!(found(TEXT, &[0, 1, -3, 16, 7, -7, 3, 2, i32::MAX, i32::MIN]), expected);
}

#[test]
fn without_an_else_nothing_may_be_done() {
    let text = TEXT.replace("ELSE\n    y := 50;\n    IF n = 2 THEN\n        y := 60;\n    END_IF;\n", "");
    assert_eq!(found(&text, &[0, 3, 1, 2, -7, i32::MIN]), [10, 10, 20, 20, 40, 40].map(Literal::I32));
}

const SCL: &str = "FUNCTION_BLOCK \"probe\"
{ S7_Optimized_Access := 'TRUE' }
VERSION : 0.1
VAR_INPUT
    n : DINT;
END_VAR
VAR_OUTPUT
    y : DINT;
END_VAR
VAR_TEMP
    t : DINT;
END_VAR
BEGIN
CASE #n OF
    1, 2:
        #t := 1;
    -1:
        #t := 2;
ELSE
    #t := 3;
END_CASE;
#y := #t;
END_FUNCTION_BLOCK
";

#[test]
fn a_temporary_has_a_value_after_it_if_each_branch_gives_it_one() {
    let check = |from: &str, to: &str| {
        assert!(SCL.contains(from), "{from}");
        said(Dialect::Scl, &SCL.replacen(from, to, 1), "probe", RealKind::F64).join("; ")
    };
    let none = |line| format!("{line}: found `t`, which has no value here on some way; write an assignment before it");
    assert_eq!(check("ELSE", "ELSE"), "");
    assert_eq!(check("ELSE\n    #t := 3;\n", ""), none("20:8"));
    assert_eq!(check("#t := 2;", "#y := 2;"), none("22:8"));
    assert_eq!(check("#t := 3;", "#y := 3;"), none("22:8"));
    assert_eq!(check("#t := 2;", "#y := #t;\n        #t := 2;"), none("18:16"));
    assert_eq!(check("CASE #n", "CASE #t"), none("14:7"));
    // What is refused has been assigned all the same.
    assert_eq!(check("#t := 3;", "#t := TRUE;"), "20:11: found a BOOL for a DINT; write a DINT");
    assert_eq!(check("END_CASE", "end_case"), "21:1: found `end_case`; write `END_CASE`");
    let block = block(Dialect::Scl, SCL, "probe", RealKind::F64);
    let whole = Literal::I32(0);
    let samples = [2, -1, 0].map(|n| vec![Literal::I32(n)]);
    assert_eq!(answers(&block, &[("n", whole)], &samples, &[("y", whole)], &[]).concat(), [1, 2, 3].map(Literal::I32));
}
