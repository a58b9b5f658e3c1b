//! Where an output is written once on each way, and with which value.

use super::*;
use compiler::interp::Machine;
use compiler::legalise::run;
use compiler::pass::Defect;

fn settled(locals: usize, step: Vec<Statement>) -> Program {
    legal("settled", program(locals, step))
}

fn assert_settled(locals: usize, step: Vec<Statement>, expected: &[Statement]) {
    assert_eq!(settled(locals, step).step, expected);
}

/// What is held in the local that a pass has made.
fn held(index: usize, value: Expr) -> Statement {
    assign(Var::Local(index), value)
}

fn local(index: usize) -> Expr {
    var(Var::Local(index))
}

/// A value that nothing changes goes to the ways that keep it: a literal, a constant, an input, a local.
#[test]
fn a_value_that_nothing_changes() {
    for value in [real(0.0), var(Var::Constant(0)), X, local(0)] {
        assert_settled(
            1,
            vec![assign(Y, value.clone()), when(ON, vec![put(1.0)], vec![])],
            &[when(ON, vec![put(1.0)], vec![assign(Y, value)])],
        );
    }
}

/// A part of the state, another output and an operation may have another value later: they are held.
#[test]
fn a_value_that_may_change() {
    for value in [var(S), binary(Binary::Add, X, X)] {
        assert_settled(
            0,
            vec![assign(Y, value.clone()), when(ON, vec![put(1.0)], vec![])],
            &[held(0, value), when(ON, vec![put(1.0)], vec![assign(Y, local(0))])],
        );
    }
    // Another output that is written before the value is needed.
    assert_settled(
        0,
        vec![assign(Y, var(Z)), assign(Z, X), when(ON, vec![put(1.0)], vec![])],
        &[held(0, var(Z)), assign(Z, X), when(ON, vec![put(1.0)], vec![assign(Y, local(0))])],
    );
    // `flag` is settled after `y`: what it held first goes with it.
    let made = settled(
        0,
        vec![
            assign(FLAG, ALSO),
            when(var(FLAG), vec![put(1.0)], vec![put(2.0)]),
            when(ON, vec![assign(FLAG, yes(false))], vec![]),
        ],
    );
    assert_eq!(
        made.step,
        [
            held(0, ALSO),
            when(local(0), vec![put(1.0)], vec![put(2.0)]),
            when(ON, vec![assign(FLAG, yes(false))], vec![assign(FLAG, local(0))])
        ]
    );
}

/// Between the two something reads the output, or the second one asks for it: held, and read from where it is held.
#[test]
fn a_value_that_is_read() {
    assert_settled(
        0,
        vec![put(1.0), assign(S, var(Y)), put(2.0)],
        &[held(0, real(1.0)), assign(S, local(0)), put(2.0)],
    );
    let asks = binary(Binary::Less, var(Y), X);
    let asked = binary(Binary::Less, local(0), X);
    assert_settled(
        0,
        vec![put(1.0), when(asks, vec![put(2.0)], vec![])],
        &[held(0, real(1.0)), when(asked, vec![put(2.0)], vec![assign(Y, local(0))])],
    );
    // Another output that the second one asks for stays what it is.
    let both = |of: Expr| binary(Binary::And, var(FLAG), binary(Binary::Less, of, X));
    assert_settled(
        0,
        vec![assign(FLAG, ON), put(1.0), when(both(var(Y)), vec![put(2.0)], vec![])],
        &[assign(FLAG, ON), held(0, real(1.0)), when(both(local(0)), vec![put(2.0)], vec![assign(Y, local(0))])],
    );
    let more = |of: Expr| assign(Y, binary(Binary::Add, of, X));
    assert_settled(0, vec![put(1.0), more(var(Y))], &[held(0, real(1.0)), more(local(0))]);
}

/// What does not read it keeps its place, and the value goes past it.
#[test]
fn statements_between() {
    assert_settled(
        0,
        vec![put(1.0), assign(S, X), assign(COUNT, var(OTHER)), when(ON, vec![put(2.0)], vec![])],
        &[assign(S, X), assign(COUNT, var(OTHER)), when(ON, vec![put(2.0)], vec![put(1.0)])],
    );
    // Who reads it afterwards reads the output.
    assert_settled(0, vec![put(1.0), assign(S, var(Y))], &[put(1.0), assign(S, var(Y))]);
}

/// Three writers, the first two of them branches: each value is held in a local of another name, and every way has one.
#[test]
fn several_writers() {
    let branch = |condition: Expr, value: f64| when(condition, vec![put(value)], vec![]);
    let made = settled(0, vec![branch(ON, 1.0), branch(ALSO, 2.0), branch(ON, 3.0)]);
    assert_eq!(made.locals.iter().map(|local| local.path.as_str()).collect::<Vec<_>>(), ["y_so_far", "y_until_now"]);
    assert!(made.locals.iter().all(|local| local.ty == Some(Type::Real)));
    assert_eq!(
        made.step,
        [
            // Where the first one does not write, the output's start stands for what another cycle has left.
            when(ON, vec![held(0, real(1.0))], vec![held(0, real(7.0))]),
            when(ALSO, vec![held(1, real(2.0))], vec![held(1, local(0))]),
            when(ON, vec![put(3.0)], vec![assign(Y, local(1))]),
        ]
    );
    // A fourth name does not exist: names are made different when they are printed.
    let many = settled(0, (0..5).map(|_| branch(ON, 1.0)).collect());
    let names: Vec<_> = many.locals.iter().map(|local| local.path.as_str()).collect();
    assert_eq!(names, ["y_so_far", "y_until_now", "y_up_to_here", "y_so_far"]);
}

/// A way that does not write the output has its start; one that writes it, in every branch or with other statements, its own
/// value.
#[test]
fn ways_that_write() {
    let inner = when(ALSO, vec![put(1.0)], vec![put(2.0)]);
    let partly = when(ALSO, vec![put(1.0)], vec![assign(S, X)]);
    let last = || when(ON, vec![put(3.0)], vec![]);
    let held_inner = when(ALSO, vec![held(0, real(1.0))], vec![held(0, real(2.0))]);
    let held_partly = when(ALSO, vec![held(0, real(1.0))], vec![held(0, real(7.0)), assign(S, X)]);
    let end = when(ON, vec![put(3.0)], vec![assign(Y, local(0))]);
    let note = || Statement::Note("a note".to_owned());
    assert_settled(
        0,
        vec![when(ON, vec![note(), inner], vec![note(), partly]), last()],
        &[when(ON, vec![note(), held_inner], vec![note(), held_partly]), end],
    );
}

/// A choice that is inside of one way only is settled there.
#[test]
fn ways_inside_of_ways() {
    let inner = vec![put(1.0), when(ALSO, vec![put(2.0)], vec![])];
    assert_settled(
        0,
        vec![when(ON, inner, vec![put(3.0)])],
        &[when(ON, vec![when(ALSO, vec![put(2.0)], vec![put(1.0)])], vec![put(3.0)])],
    );
}

/// A BOOL that is TRUE in one branch is the condition or what the other branch says; any other `if` stays.
#[test]
fn a_condition_that_is_the_value() {
    let of = |then: Vec<Statement>, otherwise: Vec<Statement>| when(ON, then, otherwise);
    let flag = |value: Expr| assign(FLAG, value);
    assert_settled(0, vec![of(vec![flag(yes(true))], vec![flag(ALSO)])], &[flag(binary(Binary::Or, ON, ALSO))]);
    for kept in [
        of(vec![flag(yes(false))], vec![flag(ALSO)]),
        of(vec![flag(ALSO)], vec![flag(yes(true))]),
        of(vec![flag(yes(true)), assign(S, X)], vec![flag(ALSO)]),
        of(vec![flag(yes(true))], vec![flag(ALSO), assign(S, X)]),
        of(vec![flag(yes(true))], vec![assign(S, X)]),
        of(vec![assign(S, X)], vec![flag(ALSO)]),
        of(vec![assign(Var::Local(0), yes(true))], vec![flag(ALSO)]),
        of(vec![flag(yes(true))], vec![assign(Var::Local(0), ALSO)]),
    ] {
        assert_settled(1, vec![kept.clone()], &[kept]);
    }
}

/// Every output is settled, not the first one alone.
#[test]
fn each_output() {
    let step = vec![put(1.0), assign(FLAG, yes(false)), when(ON, vec![put(2.0)], vec![assign(FLAG, ALSO)])];
    let expected = [when(ON, vec![assign(FLAG, yes(false)), put(2.0)], vec![put(1.0), assign(FLAG, ALSO)])];
    assert_settled(0, step, &expected);
}

/// The same values as before, and each output written once in a cycle.
#[test]
fn the_values_stay() {
    let steps = [
        vec![put(1.0), when(ON, vec![assign(S, var(Y)), put(2.0)], vec![]), assign(FLAG, ALSO)],
        vec![
            when(ON, vec![put(1.0)], vec![assign(Y, X)]),
            when(ALSO, vec![assign(Y, binary(Binary::Add, var(Y), X))], vec![]),
            assign(S, var(Y)),
            assign(FLAG, ON),
            when(var(FLAG), vec![assign(FLAG, ALSO)], vec![]),
        ],
    ];
    for step in steps {
        let (before, after) = (program(0, step.clone()), settled(0, step));
        let mut machines = [&before, &after].map(Machine::start);
        for (x, on, also) in [(3.0, false, false), (5.0, true, false), (7.0, false, true), (9.0, true, true)] {
            let inputs = [Literal::F64(x), Literal::Bool(on), Literal::Bool(also), Literal::U32(0)];
            let [mut expected, mut found] = [Vec::new(), Vec::new()];
            let mut times = [0, 0, 0];
            machines[0].step(&inputs, &mut expected);
            machines[1].step_watched(&inputs, &mut found, &mut |output, _| times[output] += 1);
            assert_eq!((found, times), (expected, [1, 1, 0]));
            assert_eq!(machines[0].state(), machines[1].state());
        }
    }
}

/// A program that writes an output twice on a way, or on some ways only, is a defect of the passes.
#[test]
fn what_is_not_settled_is_found() {
    fn same(program: Program) -> Result<Program, Defect> {
        Ok(program)
    }
    let verified = |step: Vec<Statement>| {
        let step = [step, vec![assign(FLAG, ON), assign(Z, X)]].concat();
        let result = run(&program(0, step), &[("same", same)]).map(|_| ());
        result.map_err(|defect| defect.to_string())
    };
    let found = Err("settled: the output y is not written once on each way".to_owned());
    let note = || Statement::Note("a note".to_owned());
    assert_eq!(verified(vec![note(), put(1.0), assign(S, var(Y))]), Ok(()));
    assert_eq!(verified(vec![when(ON, vec![put(1.0)], vec![assign(S, X), put(2.0)])]), Ok(()));
    assert_eq!(verified(vec![put(1.0), put(2.0)]), found);
    assert_eq!(verified(vec![put(1.0), when(ON, vec![put(2.0)], vec![])]), found);
    assert_eq!(verified(vec![when(ON, vec![put(1.0), put(2.0)], vec![put(1.0), put(2.0)])]), found);
    assert_eq!(verified(vec![when(ON, vec![put(1.0)], vec![])]), found);
    assert_eq!(verified(vec![]), found);
}
