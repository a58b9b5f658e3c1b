//! What a text does not show: signs of zeros, constants, values of later cycles, signals that an axis does not have.

use super::legal;
use super::read::{self, PHASE};
use compiler::interp::Machine;
use compiler::legalise;
use compiler::pass::{Defect, PASSES, verify};
use compiler::program::{Expr, Origin, Program, Statement, Type};
use portable::{Literal, RealKind, Variant};

fn program(text: &str) -> Program {
    read::program(RealKind::F64, text, Some(Type::Real))
}

/// The value that a program assigns first.
fn first_value(program: &Program) -> &Expr {
    let Some(Statement::Assign { value, .. }) = program.step.first() else { panic!("{program}") };
    value
}

#[test]
fn pruning_keeps_what_an_output_depends_on_in_a_later_cycle() {
    let text = "l%0 = x * a\nl%1 = x\ny = s\ns = l%0\nif on\n    # nothing\nelse\n    l%2 = x";
    let mut after = read::program(RealKind::F64, text, None);
    for (_, pass) in PASSES.into_iter().filter(|(name, _)| ["typed", "pruned"].contains(name)) {
        after = pass(after).expect("the program is sound");
    }
    assert_eq!(after.step.len(), 3);
    assert_eq!(after.locals.iter().map(|local| local.path.as_str()).collect::<Vec<_>>(), ["l"]);
    assert_eq!(after.constants.iter().map(|constant| constant.path.as_str()).collect::<Vec<_>>(), ["a"]);
    let mut machine = Machine::start(&after);
    let seen = [3.0, 5.0, 7.0].map(|x| {
        let mut outputs = Vec::new();
        machine.step(&[Literal::F64(x), Literal::Bool(false), Literal::Bool(false), Literal::U32(0)], &mut outputs);
        outputs[0]
    });
    assert_eq!(seen, [0.0, 6.0, 10.0].map(Literal::F64));
}

#[test]
fn a_constant_that_is_no_number_is_found() {
    let mut infinite = program("y = x");
    infinite.constants[0].value = Literal::F64(f64::INFINITY);
    let defect = verify(infinite).expect_err("a defect").to_string();
    assert_eq!(defect, "verify: the constant a is F64(inf)");
}

/// A literal, and no sign before one.
#[test]
fn a_negated_zero_is_a_literal() {
    let (_, identity) = PASSES.into_iter().find(|(name, _)| *name == "identity").expect("a pass");
    let product = identity(program("y = minus_one * 0.0")).expect("sound");
    let negated = legal("bounded", program("y = minus 0.0")).expect("sound");
    for program in [product, negated] {
        let Expr::Literal(Literal::F64(zero)) = first_value(&program) else { panic!("{program}") };
        assert_eq!(zero.to_bits(), (-0.0f64).to_bits());
    }
    assert!(matches!(first_value(&identity(program("y = x * minus_one")).expect("sound")), Expr::Unary(..)));
}

#[test]
fn a_choice_makes_a_constant_for_a_variant_that_has_none() {
    let text = "if phase == phase_rise\n    y = 1.0\nelse\n    if phase == phase_rest\n        y = 0.0\n    else\n        y = 2.0";
    let made = legal("chosen", program(text)).expect("sound");
    let constant = made.constants.last().expect("constants");
    assert_eq!((constant.path.as_str(), constant.doc, constant.value), ("phase_fall", "falls", Literal::I32(3)));
    assert_eq!(constant.origin, Origin::Variant(Variant { of: &PHASE, index: 3 }));
}

/// The same values as before, and each output written once in a cycle.
#[test]
fn settled_values_stay() {
    for text in [
        "y = 1.0\nif on\n    s = y\n    y = 2.0\nflag = also",
        "if on\n    y = 1.0\nelse\n    y = x\nif also\n    y = y + x\ns = y\nflag = on\nif flag\n    flag = also",
    ] {
        let before = program(text);
        let after = legal("settled", before.clone()).expect("sound");
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
    for (text, is_settled) in [
        ("# a note\ny = 1.0\ns = y\n", true),
        ("if on\n    y = 1.0\nelse\n    s = x\n    y = 2.0\n", true),
        ("y = 1.0\ny = 2.0\n", false),
        ("y = 1.0\nif on\n    y = 2.0\n", false),
        ("if on\n    y = 1.0\n    y = 2.0\nelse\n    y = 1.0\n    y = 2.0\n", false),
        ("if on\n    y = 1.0\n", false),
        ("", false),
    ] {
        let program = program(&format!("{text}flag = on\nz = x"));
        let found = legalise::run(&program, &[("same", same)]).err().map(|defect| defect.to_string());
        let expected = (!is_settled).then_some("settled: the output y is not written once on each way");
        assert_eq!(found.as_deref(), expected, "{text}");
    }
}

#[test]
fn signals_that_an_axis_does_not_have_are_left_out() {
    let of = |value: &str| {
        let mut program = program(&format!("if on\n    y = {value}\n    s = 1.0\nelse\n    y = 0.0"));
        program.inputs.truncate(2);
        program.outputs.truncate(1);
        program.outputs[0].start = Literal::F64(0.0);
        legalise::for_axis(&program)
    };
    let silent = of("0.0");
    assert_eq!((silent.inputs, silent.outputs), (vec![1], vec![]), "y is always 0, x is not read");
    assert!(silent.program.step.is_empty(), "and nothing shows the state");
    let for_axis = of("1.0");
    assert_eq!((for_axis.inputs, for_axis.outputs), (vec![1], vec![0]));
}

/// An index that no condition keeps below the length, and one that changes after the condition.
#[test]
fn an_element_that_may_be_outside_is_refused() {
    let chain = "y = 0.0\nz = 0.0\nif turn == 0u\n    s = row.a\nelse\n    if turn == 1u\n        s = row.b\n    else\n        \
        if turn == 2u\n            s = row.c";
    let refused = |change: fn(&mut Program)| {
        let mut program = legal("indexed", program(&format!("flag = on\n{chain}"))).expect("sound");
        change(&mut program);
        legalise::run(&program, &[("unchanged", Ok as fn(Program) -> Result<Program, Defect>)]).map(drop)
    };
    assert_eq!(refused(|_| {}), Ok(()));
    let outside = |result: Result<(), Defect>| result.expect_err("a defect").pass == "indexed";
    assert!(outside(refused(|program| {
        let Some(Statement::If { then, .. }) = program.step.pop() else { panic!("{program}") };
        program.step.extend(then);
    })));
    assert!(outside(refused(|program| {
        let Some(Statement::If { condition: Expr::Binary(_, _, bound), .. }) = program.step.last_mut() else {
            panic!("no condition")
        };
        **bound = Expr::Literal(Literal::U32(4));
    })));
}
