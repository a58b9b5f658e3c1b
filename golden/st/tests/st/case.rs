//! `CASE`: which branch is taken, and which variables have a value after it.

use crate::support::{answers, block};
use portable::{Literal, RealKind};
use st::Dialect;

const TEXT: &str = include_str!("forms/case.st");

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

#[test]
fn the_number_may_be_a_udint() {
    let text = TEXT.replace(" : DINT;", " : UDINT;").replace("-3", "4000000000").replace("-7", "9");
    let block = block(Dialect::Plain, &text, "probe", RealKind::F64);
    let whole = Literal::U32(0);
    let samples = [0, 1, 4_000_000_000, 16, 7, 9, 3].map(|n| vec![Literal::U32(n)]);
    let found = answers(&block, &[("n", whole)], &samples, &[("y", whole)], &[]).concat();
    assert_eq!(found, [10, 20, 20, 20, 30, 40, 50].map(Literal::U32));
}

pub const SCL: &str = include_str!("forms/case.scl");

/// Where a branch gives it none: `refused/changes/scl_case.txt`.
#[test]
fn a_temporary_has_a_value_after_it_if_each_branch_gives_it_one() {
    let block = block(Dialect::Scl, SCL, "probe", RealKind::F64);
    let whole = Literal::I32(0);
    let samples = [2, -1, 0].map(|n| vec![Literal::I32(n)]);
    assert_eq!(answers(&block, &[("n", whole)], &samples, &[("y", whole)], &[]).concat(), [1, 2, 3].map(Literal::I32));
}
