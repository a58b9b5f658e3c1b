//! Which chains of questions become a choice, and what its arms are.

use super::*;
use compiler::program::Arm;

/// Whether a variable is one of these.
fn is(by: Var, labels: &[Expr]) -> Expr {
    let one = |label: &Expr| binary(Binary::Equal, Expr::Var(by), label.clone());
    let mut all = labels.iter().map(one);
    let first = all.next().expect("a label");
    all.fold(first, |left, right| binary(Binary::Or, left, right))
}

/// A variant of the enumeration; Fall has no constant at first.
fn phase(index: usize) -> Expr {
    Expr::Var(Var::Constant(2 + index))
}

fn number(value: i32) -> Expr {
    Expr::Literal(Literal::I32(value))
}

/// A chain of questions, each with what it does; then what is left.
fn chain(links: Vec<(Expr, Vec<Statement>)>, rest: Vec<Statement>) -> Vec<Statement> {
    links.into_iter().rev().fold(rest, |otherwise, (condition, then)| vec![when(condition, then, otherwise)])
}

/// A chain for the numbers from 0 on, by the count, and what is left.
fn numbers(questions: i32) -> Vec<Statement> {
    let link = |n| (is(COUNT, &[number(n)]), vec![put(f64::from(n))]);
    chain((0..questions).map(link).collect(), vec![put(-1.0)])
}

fn arm(labels: &[Expr], body: Vec<Statement>) -> Arm {
    Arm { labels: labels.to_vec(), body }
}

fn chosen(step: Vec<Statement>) -> Program {
    legal("chosen", program(0, step))
}

/// What stays as it is.
fn assert_kept(step: Vec<Statement>) {
    assert_eq!(chosen(step.clone()).step, step);
}

fn choice(by: Var, arms: Vec<Arm>) -> Statement {
    Statement::Choose { by: Expr::Var(by), arms }
}

/// Two questions for three variants: each its arm, and the last one for the variants that are left, of which one gets a constant.
#[test]
fn a_chain_by_an_enumeration() {
    let step = chain(
        vec![(is(PHASE_NOW, &[phase(1)]), vec![put(1.0)]), (is(PHASE_NOW, &[phase(0)]), vec![put(0.0)])],
        vec![put(2.0), assign(S, X)],
    );
    let made = chosen(step);
    let fall = Expr::Var(Var::Constant(5));
    assert_eq!(
        made.step,
        [choice(
            PHASE_NOW,
            vec![
                arm(&[phase(1)], vec![put(1.0)]),
                arm(&[phase(0)], vec![put(0.0)]),
                arm(&[phase(2), fall], vec![put(2.0), assign(S, X)]),
            ]
        )]
    );
    assert_eq!(made.constants.len(), 6, "Hold has a constant already");
    let Constant { path, doc, value, origin } = &made.constants[5];
    assert_eq!((path.as_str(), *doc, *value), ("phase_fall", "falls", Literal::I32(3)));
    assert_eq!(*origin, Origin::Variant(Variant { of: &PHASE, index: 3 }));
    // The first variant and the last one are left.
    let step = chain(
        vec![(is(PHASE_NOW, &[phase(1)]), vec![put(1.0)]), (is(PHASE_NOW, &[phase(2)]), vec![put(2.0)])],
        vec![put(0.0)],
    );
    let Statement::Choose { arms, .. } = &chosen(step).step[0] else { panic!("a choice") };
    assert_eq!(arms[2], arm(&[phase(0), Expr::Var(Var::Constant(5))], vec![put(0.0)]));
}

/// One question has two answers: an `if` says that as well.
#[test]
fn one_question_stays_an_if() {
    assert_kept(chain(vec![(is(PHASE_NOW, &[phase(1)]), vec![put(1.0)])], vec![put(2.0)]));
    assert_kept(chain(vec![(is(PHASE_NOW, &[phase(0), phase(1), phase(2)]), vec![put(1.0)])], vec![put(2.0)]));
}

/// Several variants in one question are labels of one arm.
#[test]
fn questions_with_an_or() {
    let step = chain(
        vec![(is(PHASE_NOW, &[phase(2), phase(0)]), vec![put(1.0)]), (is(PHASE_NOW, &[phase(1)]), vec![put(0.0)])],
        vec![put(2.0)],
    );
    let fall = Expr::Var(Var::Constant(5));
    assert_eq!(
        chosen(step).step,
        [choice(
            PHASE_NOW,
            vec![
                arm(&[phase(2), phase(0)], vec![put(1.0)]),
                arm(&[phase(1)], vec![put(0.0)]),
                arm(&[fall], vec![put(2.0)]),
            ]
        )]
    );
    // An `or` of two variables is a question for neither, and an `and` for none.
    let two = binary(Binary::Or, is(PHASE_NOW, &[phase(0)]), is(OTHER, &[phase(2)]));
    let both = binary(Binary::And, is(PHASE_NOW, &[phase(0)]), is(PHASE_NOW, &[phase(2)]));
    let mixed = binary(Binary::Or, is(PHASE_NOW, &[phase(0)]), ON);
    for condition in [two, both, mixed] {
        let links = vec![(condition, vec![put(1.0)]), (is(PHASE_NOW, &[phase(1)]), vec![put(0.0)])];
        assert_kept(chain(links, vec![put(2.0)]));
    }
}

/// A choice by numbers wants eight arms; what no question names has no label.
#[test]
fn a_chain_by_numbers() {
    assert_kept(numbers(6));
    let made = chosen(numbers(7));
    let arms = (0..7).map(|n| arm(&[number(n)], vec![put(f64::from(n))]));
    assert_eq!(made.step, [choice(COUNT, arms.chain([arm(&[], vec![put(-1.0)])]).collect())]);
    assert_eq!(made.constants.len(), 5, "numbers need no constants");
}

/// What is asked for another variable, in another way or together with something else ends the chain, and stands in its last arm.
#[test]
fn a_chain_ends_where_something_else_is_asked() {
    let first = || (is(PHASE_NOW, &[phase(0)]), vec![put(0.0)]);
    let second = || (is(PHASE_NOW, &[phase(1)]), vec![put(1.0)]);
    let of_another = || (is(OTHER, &[phase(2)]), vec![put(2.0)]);
    // Not counted: two questions for one variable, and one for another.
    assert_kept(chain(vec![first(), of_another()], vec![put(3.0)]));
    let [fall, hold] = [Expr::Var(Var::Constant(5)), phase(2)];
    let others = |rest: Vec<Statement>| {
        let arms = vec![arm(&[phase(0)], vec![put(0.0)]), arm(&[phase(1)], vec![put(1.0)])];
        [choice(PHASE_NOW, [arms, vec![arm(&[hold.clone(), fall.clone()], rest)]].concat())]
    };
    let rest = chain(vec![of_another()], vec![put(3.0)]);
    assert_eq!(chosen(chain(vec![first(), second()], rest.clone())).step, others(rest));
    let rest = vec![when(ON, vec![put(2.0)], vec![put(3.0)])];
    assert_eq!(chosen(chain(vec![first(), second()], rest.clone())).step, others(rest));
    // A further question that does not stand alone.
    let rest = [vec![assign(S, X)], chain(vec![(is(PHASE_NOW, &[phase(2)]), vec![put(2.0)])], vec![put(3.0)])].concat();
    assert_eq!(chosen(chain(vec![first(), second()], rest.clone())).step, others(rest));
    assert_kept(chain(vec![first()], [vec![assign(S, X)], chain(vec![second()], vec![put(3.0)])].concat()));
    assert_kept(chain(vec![first()], [chain(vec![second()], vec![put(3.0)]), vec![assign(S, X)]].concat()));
}

/// Structured Text has no branch without a statement; the last one may be left out.
#[test]
fn a_branch_that_does_nothing_keeps_the_chain() {
    let second = || (is(PHASE_NOW, &[phase(1)]), vec![put(1.0)]);
    for nothing in [vec![], vec![Statement::Note("nothing".to_owned())]] {
        assert_kept(chain(vec![(is(PHASE_NOW, &[phase(0)]), nothing.clone()), second()], vec![put(2.0)]));
        assert_kept(chain(vec![second(), (is(PHASE_NOW, &[phase(0)]), nothing)], vec![put(2.0)]));
    }
    // Nor one far down the chain.
    let first = || (is(PHASE_NOW, &[phase(0)]), vec![put(0.0)]);
    assert_kept(chain(vec![first(), second(), (is(PHASE_NOW, &[phase(2)]), vec![])], vec![put(2.0)]));
    let noted = vec![Statement::Note("something".to_owned()), put(0.0)];
    let made = chosen(chain(vec![(is(PHASE_NOW, &[phase(0)]), noted.clone()), second()], vec![]));
    let labels = [phase(2), Expr::Var(Var::Constant(5))];
    let arms = vec![arm(&[phase(0)], noted), arm(&[phase(1)], vec![put(1.0)]), arm(&labels, vec![])];
    assert_eq!(made.step, [choice(PHASE_NOW, arms)]);
}

/// Only `variable = variant` and `variable = DINT` choose: no other comparison, no coefficient, no UDINT, no expression,
/// no label in front.
#[test]
fn what_is_no_question() {
    let compared = |operator| binary(operator, Expr::Var(PHASE_NOW), phase(0));
    let sum = binary(Binary::Add, Expr::Var(PHASE_NOW), Expr::Var(OTHER));
    let label_first = binary(Binary::Equal, phase(0), Expr::Var(PHASE_NOW));
    for condition in [
        compared(Binary::NotEqual),
        compared(Binary::Less),
        compared(Binary::LessEqual),
        binary(Binary::Equal, Expr::Var(PHASE_NOW), Expr::Var(Var::Constant(1))),
        binary(Binary::Equal, sum, phase(0)),
        label_first,
        ON,
    ] {
        let links = vec![(condition, vec![put(0.0)]), (is(PHASE_NOW, &[phase(1)]), vec![put(1.0)])];
        assert_kept(chain(links, vec![put(2.0)]));
    }
    let unsigned = |n| binary(Binary::Equal, N, Expr::Literal(Literal::U32(n)));
    assert_kept(chain((0..9).map(|n| (unsigned(n), vec![put(f64::from(n))])).collect(), vec![put(-1.0)]));
}

/// Chains inside of branches, of arms and after other statements are found as well.
#[test]
fn a_chain_inside() {
    let inner = || {
        chain(vec![(is(OTHER, &[phase(0)]), vec![put(0.0)]), (is(OTHER, &[phase(1)]), vec![put(1.0)])], vec![put(2.0)])
    };
    let inner_made = |rest: &[Expr]| {
        let arms = vec![arm(&[phase(0)], vec![put(0.0)]), arm(&[phase(1)], vec![put(1.0)]), arm(rest, vec![put(2.0)])];
        choice(OTHER, arms)
    };
    let rest = [phase(2), Expr::Var(Var::Constant(5))];
    let step = vec![assign(S, X), when(ON, inner(), inner())];
    let made = chosen(step);
    assert_eq!(made.step, [assign(S, X), when(ON, vec![inner_made(&rest)], vec![inner_made(&rest)])]);
    assert_eq!(made.constants.len(), 6, "the constant that the first one has made is known to the second one");
    let links = vec![(is(PHASE_NOW, &[phase(0)]), inner()), (is(PHASE_NOW, &[phase(1)]), vec![put(1.0)])];
    let Statement::Choose { by, arms } = &chosen(chain(links, vec![put(2.0)])).step[0] else { panic!("a choice") };
    assert_eq!((by, arms[0].body.as_slice()), (&Expr::Var(PHASE_NOW), &[inner_made(&rest)][..]));
}
