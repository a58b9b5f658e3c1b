//! Each pass on its own.

use super::{ON, S, X, Y, assign, binary, real, variable};
use compiler::interp::Machine;
use compiler::legalise;
use compiler::pass::{Defect, PASSES, verify};
use compiler::program::{Constant, Expr, Local, Origin, Program, Statement, Type, Var};
use portable::{Binary, Intrinsic, Literal, RealKind, Unary};

/// One real input, one real output, one real part of the state, as many locals as asked for.
fn program(locals: usize, step: Vec<Statement>) -> Program {
    Program {
        block: "small",
        switch: None,
        usual_first: false,
        fractions: &[],
        set: None,
        real: RealKind::F64,
        inputs: vec![variable("x", Type::Real, Literal::F64(0.0)), variable("on", Type::Bool, Literal::Bool(false))],
        outputs: vec![variable("y", Type::Real, Literal::F64(0.0))],
        state: vec![variable("s", Type::Real, Literal::F64(0.0))],
        constants: vec![constant("a", 2.0), constant("one", 1.0), constant("minus_one", -1.0)],
        locals: (0..locals).map(|index| Local { path: format!("l{index}"), ty: None }).collect(),
        init: Vec::new(),
        step,
    }
}

fn constant(path: &str, value: f64) -> Constant {
    Constant { path: path.to_owned(), doc: "", value: Literal::F64(value), origin: Origin::Function }
}

fn local(index: usize) -> Expr {
    Expr::Var(Var::Local(index))
}

fn choose(then: Vec<Statement>, otherwise: Vec<Statement>) -> Statement {
    Statement::If { condition: ON, then, otherwise }
}

fn run(pass: &str, program: Program) -> Result<Program, Defect> {
    let (_, pass) = PASSES.into_iter().find(|(name, _)| *name == pass).expect("a pass has that name");
    pass(program)
}

fn message(result: Result<Program, Defect>) -> String {
    result.expect_err("the program has a defect").to_string()
}

#[test]
fn typing_fills_in_locals() {
    let comparison = binary(Binary::Less, X, real(1.0));
    let typed = run("typed", program(2, vec![assign(Var::Local(0), X), assign(Var::Local(1), comparison)])).unwrap();
    assert_eq!(typed.locals.iter().map(|local| local.ty).collect::<Vec<_>>(), [Some(Type::Real), Some(Type::Bool)]);
}

#[test]
fn typing_rejects_what_has_no_counterpart() {
    let equal = binary(Binary::Equal, X, real(1.0));
    assert!(message(run("typed", program(1, vec![assign(Var::Local(0), equal)]))).starts_with("typing: Equal of Real"));
    let mixed = binary(Binary::Add, X, Expr::Literal(Literal::U32(1)));
    assert!(message(run("typed", program(0, vec![assign(Y, mixed)]))).starts_with("typing: Real wanted, U32 found"));
    let index = Expr::Literal(Literal::Usize(1));
    assert!(message(run("typed", program(0, vec![assign(Y, index)]))).contains("is left at run time"));
}

#[test]
fn identity_removes_exact_multiplications_only() {
    let step = |value| run("identity", program(0, vec![assign(Y, value)])).unwrap().step;
    let one = Expr::Var(Var::Constant(1));
    let minus_one = Expr::Var(Var::Constant(2));
    let negated = Expr::Unary(Unary::Negate, Box::new(X));
    assert_eq!(step(binary(Binary::Multiply, one.clone(), X)), [assign(Y, X)]);
    assert_eq!(step(binary(Binary::Multiply, X, minus_one.clone())), [assign(Y, negated)]);
    assert_eq!(step(binary(Binary::Multiply, minus_one, real(0.0))), [assign(Y, real(-0.0))]);
    for kept in [
        binary(Binary::Multiply, X, real(0.0)),
        binary(Binary::Add, X, real(0.0)),
        binary(Binary::Multiply, X, Expr::Var(Var::Constant(0))),
        binary(Binary::Divide, one, X),
    ] {
        assert_eq!(step(kept.clone()), [assign(Y, kept)]);
    }
}

#[test]
fn coalescing_moves_a_copy_into_the_branches() {
    let inner = choose(vec![assign(Var::Local(0), X)], vec![assign(Var::Local(0), real(1.0))]);
    let before = program(2, vec![inner, assign(Var::Local(1), local(0)), assign(Y, local(1))]);
    let after = run("coalesced", before).unwrap();
    let inner = choose(vec![assign(Var::Local(1), X)], vec![assign(Var::Local(1), real(1.0))]);
    assert_eq!(after.step, [inner, assign(Y, local(1))]);
}

#[test]
fn coalescing_leaves_a_source_that_is_read_elsewhere() {
    let copy = choose(vec![assign(Var::Local(1), local(0))], vec![assign(Var::Local(1), real(1.0))]);
    let step = vec![assign(Var::Local(0), X), copy, assign(Y, binary(Binary::Add, local(0), local(1)))];
    assert_eq!(run("coalesced", program(2, step.clone())).unwrap().step, step);
}

#[test]
fn pruning_keeps_what_an_output_depends_on_in_a_later_cycle() {
    let state = Expr::Var(S);
    let step = vec![
        assign(Var::Local(0), binary(Binary::Multiply, X, Expr::Var(Var::Constant(0)))),
        assign(Var::Local(1), X),
        assign(Y, state),
        assign(S, local(0)),
        choose(vec![Statement::Note("nothing".to_owned())], vec![assign(Var::Local(2), X)]),
    ];
    let after = run("pruned", run("typed", program(3, step)).unwrap()).unwrap();
    assert_eq!(after.step.len(), 3);
    assert_eq!(after.locals.iter().map(|local| local.path.as_str()).collect::<Vec<_>>(), ["l0"]);
    assert_eq!(after.constants.iter().map(|constant| constant.path.as_str()).collect::<Vec<_>>(), ["a"]);

    let mut machine = Machine::start(&after);
    let mut outputs = Vec::new();
    let seen = [3.0, 5.0, 7.0].map(|x| {
        machine.step(&[Literal::F64(x), Literal::Bool(false)], &mut outputs);
        outputs[0]
    });
    assert_eq!(seen, [Literal::F64(0.0), Literal::F64(6.0), Literal::F64(10.0)]);
}

#[test]
fn pruning_turns_a_branch_without_a_then() {
    let step = vec![assign(Y, X), choose(Vec::new(), vec![assign(Y, real(1.0))])];
    let after = run("pruned", program(0, step)).unwrap();
    let Statement::If { condition, then, otherwise } = &after.step[1] else { panic!("a branch is left") };
    assert_eq!(*condition, Expr::Unary(Unary::Not, Box::new(ON)));
    assert_eq!((then.len(), otherwise.len()), (1, 0));
}

#[test]
fn verifying_finds_broken_promises() {
    let defect = |locals, step| message(run("typed", program(locals, step)).and_then(verify));
    let twice = vec![assign(Var::Local(0), X), assign(Var::Local(0), X), assign(Y, local(0))];
    assert_eq!(defect(1, twice), "verify: Local(0) is assigned twice on one way");
    let one_way = vec![choose(vec![assign(Var::Local(0), X)], Vec::new()), assign(Y, local(0))];
    assert_eq!(defect(1, one_way), "verify: `l0` is read where it may have no value");
    let silent = vec![choose(vec![assign(Y, X)], Vec::new())];
    assert_eq!(defect(0, silent), "verify: the output y is not written on every way");
    let mut infinite = program(0, vec![assign(Y, X)]);
    infinite.constants[0].value = Literal::F64(f64::INFINITY);
    assert_eq!(message(verify(infinite)), "verify: the constant a is F64(inf)");
}

#[test]
fn an_assignment_that_nothing_reads_goes() {
    let inner = choose(
        vec![assign(Var::Local(0), X), assign(Y, local(0)), assign(Var::Local(1), real(1.0))],
        vec![assign(Var::Local(0), real(0.0)), assign(Y, X), assign(Var::Local(1), real(2.0))],
    );
    let step = run("live", program(2, vec![inner, assign(S, X)])).unwrap().step;
    let expected = choose(vec![assign(Var::Local(0), X), assign(Y, local(0))], vec![assign(Y, X)]);
    assert_eq!(step, [expected, assign(S, X)]);
    // What is read after the branches stays in both of them.
    let both =
        vec![choose(vec![assign(Var::Local(0), X)], vec![assign(Var::Local(0), real(0.0))]), assign(Y, local(0))];
    assert_eq!(run("live", program(1, both.clone())).unwrap().step, both);
}

#[test]
fn what_only_goes_to_an_output_goes_there_at_once() {
    let branches = |target| choose(vec![assign(target, X)], vec![assign(target, real(1.0))]);
    let sunk = |step| run("sunk", program(1, step)).unwrap().step;
    let local_first = vec![branches(Var::Local(0)), assign(S, X), assign(Y, local(0))];
    assert_eq!(sunk(local_first), [branches(Y), assign(S, X)]);
    // Not where something looks at the output in between, nor where the local is read again.
    let watched = vec![branches(Var::Local(0)), assign(S, Expr::Var(Y)), assign(Y, local(0))];
    assert_eq!(sunk(watched.clone()), watched);
    let read_again = vec![branches(Var::Local(0)), assign(Y, local(0)), assign(S, local(0))];
    assert_eq!(sunk(read_again.clone()), read_again);
}

#[test]
fn a_flag_becomes_what_it_decides() {
    let (yes, no) = (Expr::Literal(Literal::Bool(true)), Expr::Literal(Literal::Bool(false)));
    let less = binary(Binary::Less, X, real(0.0));
    let set = || assign(Y, real(7.0));
    let asked = |condition| Statement::If { condition, then: vec![set()], otherwise: Vec::new() };
    let raised = |value| choose(vec![assign(Var::Local(0), yes.clone())], vec![assign(Var::Local(0), value)]);
    let sunk = |step| run("sunk", program(1, step)).unwrap().step;
    assert_eq!(sunk(vec![assign(Y, X), raised(no), asked(local(0))]), [assign(Y, X), choose(vec![set()], vec![])]);
    let found = sunk(vec![assign(Y, X), raised(less.clone()), asked(local(0))]);
    assert_eq!(found, [assign(Y, X), choose(vec![set()], vec![asked(less)])]);
}

fn not(operand: Expr) -> Expr {
    Expr::Unary(Unary::Not, Box::new(operand))
}

fn if_(condition: Expr, then: Vec<Statement>, otherwise: Vec<Statement>) -> Statement {
    Statement::If { condition, then, otherwise }
}

#[test]
fn a_known_question_is_not_asked_again() {
    let after = |step| run("known", run("typed", program(1, step)).unwrap()).unwrap().step;
    let low = binary(Binary::Less, X, real(1.0));
    let both = binary(Binary::And, ON, low.clone());
    // Neither holds alone, so that with ON it is the other one that does not.
    let chain =
        if_(ON, vec![if_(low.clone(), vec![assign(Y, X)], vec![assign(Y, real(1.0))])], vec![assign(Y, real(2.0))]);
    let expected = if_(ON, vec![assign(Y, real(1.0))], vec![assign(Y, real(2.0))]);
    assert_eq!(
        after(vec![if_(both.clone(), vec![assign(Y, X)], vec![chain])]),
        [if_(both, vec![assign(Y, X)], vec![expected])]
    );
    // !(x < 1) is not x >= 1 where x is not a number: the other comparison stays a question.
    let high = binary(Binary::GreaterEqual, X, real(1.0));
    let step = vec![if_(low, vec![assign(Y, X)], vec![if_(high, vec![assign(Y, X)], vec![assign(Y, real(0.0))])])];
    assert_eq!(after(step.clone()), step);
}

#[test]
fn what_a_flag_was_assigned_is_known_with_the_flag() {
    let after = |step| run("known", run("typed", program(1, step)).unwrap()).unwrap().step;
    let low = || binary(Binary::Less, Expr::Var(S), real(1.0));
    let asked = |condition| if_(condition, vec![assign(Y, X)], vec![assign(Y, real(1.0))]);
    let flag = || assign(Var::Local(0), binary(Binary::And, ON, low()));
    let step = vec![flag(), if_(local(0), vec![asked(low())], vec![asked(low())])];
    assert_eq!(after(step), [flag(), if_(local(0), vec![assign(Y, X)], vec![asked(low())])]);
    // What it asked for has another value since.
    let step = vec![flag(), assign(S, X), if_(local(0), vec![asked(low())], vec![assign(Y, X)])];
    assert_eq!(after(step.clone()), step);
}

#[test]
fn what_is_known_of_a_variable_is_known_of_its_copy() {
    let after = |step| run("known", run("typed", program(1, step)).unwrap()).unwrap().step;
    let low = |of| binary(Binary::Less, of, real(1.0));
    let copy = || assign(S, X);
    let asked = || if_(low(Expr::Var(S)), vec![assign(Y, X)], vec![assign(Y, real(1.0))]);
    let step = vec![if_(low(X), vec![copy(), asked()], vec![assign(Y, real(2.0))])];
    assert_eq!(after(step), [if_(low(X), vec![copy(), assign(Y, X)], vec![assign(Y, real(2.0))])]);
    // A copy that was changed is one no more.
    let changed = assign(S, binary(Binary::Add, Expr::Var(S), X));
    let step = vec![if_(low(X), vec![copy(), changed, asked()], vec![assign(Y, real(2.0))])];
    assert_eq!(after(step.clone()), step);
}

#[test]
fn a_flag_gets_the_answer_itself() {
    let flag = |raised| vec![assign(Var::Local(0), Expr::Literal(Literal::Bool(raised)))];
    let answered = |step| run("answered", program(1, vec![step])).unwrap().step;
    assert_eq!(answered(choose(flag(true), flag(false))), [assign(Var::Local(0), ON)]);
    assert_eq!(answered(choose(flag(false), flag(true))), [assign(Var::Local(0), not(ON))]);
    // Another statement in a branch keeps the `if`.
    let more = choose([flag(true), vec![assign(Y, X)]].concat(), flag(false));
    assert_eq!(answered(more.clone()), [more]);
}

#[test]
fn an_assignment_makes_a_question_open_again() {
    let low = || binary(Binary::Less, Expr::Var(S), real(1.0));
    let inner = if_(low(), vec![assign(Y, X)], vec![assign(Y, real(1.0))]);
    let step = vec![if_(low(), vec![assign(S, X), inner], vec![assign(Y, real(2.0))])];
    assert_eq!(run("known", run("typed", program(0, step.clone())).unwrap()).unwrap().step, step);
}

#[test]
fn the_range_of_an_integer_answers() {
    let number = |value| Expr::Literal(Literal::U32(value));
    let chosen = choose(vec![assign(Var::Local(0), number(2))], vec![assign(Var::Local(0), number(12))]);
    let question = |operator, value| {
        let asked = if_(binary(operator, local(0), number(value)), vec![assign(Y, X)], vec![assign(Y, real(1.0))]);
        run("known", run("typed", program(1, vec![chosen.clone(), asked])).unwrap()).unwrap().step[1].clone()
    };
    assert_eq!(question(Binary::NotEqual, 0), assign(Y, X));
    assert_eq!(question(Binary::Greater, 12), assign(Y, real(1.0)));
    assert!(matches!(question(Binary::Less, 12), Statement::If { .. }));
}

#[test]
fn a_flag_acts_where_it_is_raised() {
    let flag = |raised| assign(Var::Local(0), Expr::Literal(Literal::Bool(raised)));
    let effect = || vec![assign(S, X), assign(Y, X)];
    let step = vec![choose(vec![flag(true)], vec![flag(false)]), if_(local(0), effect(), Vec::new())];
    let raised = [vec![flag(true)], effect()].concat();
    assert_eq!(run("threaded", program(1, step)).unwrap().step, [choose(raised, vec![flag(false)])]);
    // Raised in two places: the effect stays where it is.
    let step = vec![choose(vec![flag(true)], vec![flag(true)]), if_(local(0), effect(), Vec::new())];
    assert_eq!(run("threaded", program(1, step.clone())).unwrap().step, step);
}

#[test]
fn a_question_is_asked_in_the_positive() {
    let step = vec![if_(not(ON), vec![assign(Y, X)], vec![assign(Y, real(1.0))])];
    assert_eq!(run("turned", program(0, step)).unwrap().step, [choose(vec![assign(Y, real(1.0))], vec![assign(Y, X)])]);
    let chain = vec![if_(not(ON), vec![assign(Y, X)], vec![choose(vec![assign(Y, real(1.0))], vec![assign(Y, X)])])];
    assert_eq!(run("turned", program(0, chain.clone())).unwrap().step, chain);
}

/// Whoever looks at the outputs between two statements sees values of the last cycle or of this one.
#[test]
fn an_output_is_written_once_on_each_way() {
    let settled = |locals, step| {
        let (_, settle) = legalise::WITH_OUTPUTS[0];
        settle(program(locals, step)).unwrap().step
    };
    // What is overwritten at once is not written.
    assert_eq!(settled(0, vec![assign(Y, X), assign(Y, real(0.0))]), [assign(Y, real(0.0))]);
    // A value goes to the ways that keep it.
    let zero = || assign(Y, real(0.0));
    let one = || assign(Y, real(1.0));
    assert_eq!(settled(0, vec![zero(), choose(vec![one()], vec![])]), [choose(vec![one()], vec![zero()])]);
    let nested = vec![zero(), choose(vec![choose(vec![], vec![one()])], vec![])];
    assert_eq!(settled(0, nested), [choose(vec![choose(vec![zero()], vec![one()])], vec![zero()])]);
    // A value of two branches is held in a local until it is known whether it stays.
    let twice = vec![choose(vec![one()], vec![zero()]), choose(vec![assign(Y, X)], vec![])];
    let held = |value| assign(Var::Local(0), value);
    assert_eq!(
        settled(0, twice),
        [choose(vec![held(real(1.0))], vec![held(real(0.0))]), choose(vec![assign(Y, X)], vec![assign(Y, local(0))]),]
    );
    // A value that changes is held, too, and so is one that is read between.
    let state = || Expr::Var(S);
    assert_eq!(
        settled(0, vec![assign(Y, state()), assign(S, X), choose(vec![zero()], vec![])]),
        [held(state()), assign(S, X), choose(vec![zero()], vec![assign(Y, local(0))])]
    );
    assert_eq!(
        settled(0, vec![zero(), assign(S, Expr::Var(Y)), assign(Y, Expr::Var(Y))]),
        [held(real(0.0)), assign(S, local(0)), assign(Y, local(0))]
    );
}

/// A legalising pass by its name.
fn legal(pass: &str, program: Program) -> Program {
    let all = legalise::WITH_OUTPUTS.iter().chain(legalise::WITH_DIGITS);
    let (_, pass) = all.into_iter().find(|(name, _)| *name == pass).expect("a pass has that name");
    pass(program).expect("the program is sound")
}

#[test]
fn what_is_known_is_written_before_branches_that_have_nothing_to_do_with_it() {
    let branch = || choose(vec![assign(S, X)], vec![assign(S, real(0.0))]);
    let step = vec![branch(), assign(Y, X)];
    assert_eq!(legal("early", program(0, step)).step, [assign(Y, X), branch()]);
    // What the branches write or ask for stays after them.
    let computed =
        vec![choose(vec![assign(Var::Local(0), X)], vec![assign(Var::Local(0), real(0.0))]), assign(Y, local(0))];
    assert_eq!(legal("early", program(1, computed.clone())).step, computed);
    let asked = vec![choose(vec![assign(S, Expr::Var(Y))], vec![]), assign(Y, X)];
    assert_eq!(legal("early", program(0, asked.clone())).step, asked);
}

#[test]
fn a_negated_condition_has_a_name() {
    let both = || binary(Binary::And, ON, binary(Binary::LessEqual, X, real(1.0)));
    let step = vec![if_(not(both()), vec![assign(Y, X)], vec![assign(Y, real(0.0))])];
    let named = legal("negated", program(0, step));
    assert_eq!(named.locals[0].path, "condition");
    let asked = if_(not(local(0)), vec![assign(Y, X)], vec![assign(Y, real(0.0))]);
    assert_eq!(named.step, [assign(Var::Local(0), both()), asked]);
    let plain = vec![if_(not(ON), vec![assign(Y, X)], vec![assign(Y, real(0.0))])];
    assert_eq!(legal("negated", program(0, plain.clone())).step, plain, "a variable has one");
}

#[test]
fn a_statement_on_real_does_one_operation() {
    let product = || binary(Binary::Multiply, X, Expr::Var(S));
    let step = vec![assign(Y, binary(Binary::Add, product(), X))];
    assert_eq!(legal("single", program(0, step.clone())).step, step, "LREAL is as wide as anybody evaluates");
    let single = legal("single", Program { real: RealKind::F32, ..program(0, step) });
    assert_eq!(single.locals[0].path, "x_times_s");
    let sum = assign(Y, binary(Binary::Add, local(0), X));
    assert_eq!(single.step, [assign(Var::Local(0), product()), sum]);
}

#[test]
fn a_number_next_to_a_real_gets_a_name() {
    let sum = |value| assign(Y, binary(Binary::Add, X, value));
    let wide = [real(0.5), real(0.25)].map(sum).to_vec();
    assert_eq!(legal("named", program(0, wide.clone())).step, wide, "digits are LREAL anyway");
    let single = |value| Expr::Literal(Literal::F32(value));
    let mut step = [0.5, 0.0, 0.5].map(|value| sum(single(value))).to_vec();
    step.push(assign(S, single(0.125)));
    let program = Program { real: RealKind::F32, ..program(0, step) };
    let own = program.constants.len();
    let named = legal("named", program);
    let names: Vec<_> = named.constants[own..].iter().map(|constant| (&*constant.path, constant.value)).collect();
    assert_eq!(names, [("real_0p5", Literal::F32(0.5)), ("real_zero", Literal::F32(0.0))]);
    let [half, zero] = [own, own + 1].map(|constant| sum(Expr::Var(Var::Constant(constant))));
    assert_eq!(
        named.step,
        [half.clone(), zero, half, assign(S, single(0.125))],
        "a number that is assigned alone stays"
    );
}

/// A program with locals of these paths.
fn with_locals<const N: usize>(paths: [&str; N], step: Vec<Statement>) -> Program {
    let local = |path: &str| Local { path: path.to_owned(), ty: Some(Type::Real) };
    Program { locals: paths.map(local).to_vec(), ..program(0, step) }
}

/// The shared variables of a program: their paths, and the statements.
fn shared<const N: usize>(paths: [&str; N], step: Vec<Statement>) -> (Vec<String>, Vec<Statement>) {
    let Program { locals, step, .. } = legal("shared", with_locals(paths, step));
    (locals.into_iter().map(|local| local.path).collect(), step)
}

#[test]
fn a_new_value_replaces_an_old_one_that_nothing_needs_any_more() {
    let is = |index, value| assign(Var::Local(index), value);
    let limited = || choose(vec![is(1, local(0))], vec![is(1, real(0.0))]);
    let (locals, step) = shared(["a", "a"], vec![is(0, Expr::Var(S)), limited(), assign(Y, local(1))]);
    assert_eq!(locals, ["a"]);
    let shorter = if_(not(ON), vec![is(0, real(0.0))], vec![]);
    assert_eq!(step, [is(0, Expr::Var(S)), shorter, assign(Y, local(0))]);
}

#[test]
fn values_that_are_needed_together_or_have_other_names_keep_their_variables() {
    let is = |index, value| assign(Var::Local(index), value);
    let limited = || choose(vec![is(1, local(0))], vec![is(1, real(0.0))]);
    // The old value is read after the new one.
    let needed = vec![is(0, X), limited(), assign(Y, binary(Binary::Add, local(0), local(1)))];
    assert_eq!(shared(["a", "a"], needed.clone()), (vec!["a".to_owned(); 2], needed));
    let other = vec![is(0, X), limited(), assign(Y, local(1))];
    assert_eq!(shared(["a", "b"], other.clone()).1, other);
    // Two calculations of one name: neither is the old value of the other.
    let apart = vec![is(0, X), assign(S, local(0)), is(1, real(2.0)), assign(Y, local(1))];
    assert_eq!(shared(["a", "a"], apart.clone()).1, apart);
}

#[test]
fn what_most_branches_leave_in_a_local_stands_before_them() {
    let local_is = |value| assign(Var::Local(0), value);
    let rest = |list| [list, vec![assign(Y, local(0))]].concat();
    let inner = || choose(vec![local_is(real(0.0))], vec![local_is(X)]);
    let step = rest(vec![if_(not(ON), vec![local_is(real(0.0))], vec![inner()])]);
    let presumed = |step| legal("presumed", program(1, step)).step;
    let shorter = vec![local_is(real(0.0)), if_(ON, vec![if_(not(ON), vec![local_is(X)], vec![])], vec![])];
    assert_eq!(presumed(step), rest(shorter));
    // 0 and -0 are two values, a state may change before the branch, and a way that assigns nothing is none of it.
    for list in [
        vec![choose(vec![local_is(real(0.0))], vec![local_is(real(-0.0))])],
        vec![choose(vec![assign(S, X), local_is(Expr::Var(S))], vec![local_is(Expr::Var(S))])],
    ] {
        assert_eq!(presumed(rest(list.clone())), rest(list));
    }
    // A branch that explains itself keeps its statement.
    let note = || Statement::Note("why".to_owned());
    let explained = vec![choose(vec![note(), local_is(X)], vec![inner_of_two(X)])];
    let first = presumed(rest(explained));
    assert_eq!(first[0], local_is(X));
    assert!(matches!(&first[1], Statement::If { then, .. } if *then == [note(), local_is(X)]));
    // The program is one that a legal one may be, though not one that a pass may make.
    let twice = Program { step: first, ..program(1, Vec::new()) };
    assert!(verify(twice).is_err_and(|defect| defect.message.contains("assigned twice")));
}

#[test]
fn what_all_branches_assign_last_stands_after_them() {
    let joined = |step| legal("joined", with_locals(["c"], step)).step;
    let s_is = |value| assign(S, value);
    let note = || Statement::Note("why".to_owned());
    // Of a chain all branches, the last one without a condition.
    let chain = |last: Vec<Statement>| {
        let inner = choose(vec![s_is(real(2.0)), assign(Y, X)], last);
        vec![choose(vec![assign(Y, X), s_is(real(1.0))], vec![inner])]
    };
    let shorter = |last| vec![choose(vec![s_is(real(1.0))], vec![choose(vec![s_is(real(2.0))], last)])];
    assert_eq!(joined(chain(vec![assign(Y, X)])), [shorter(vec![]), vec![assign(Y, X)]].concat());
    // A condition that decides nothing is left out, with the local that only it reads.
    let asked = if_(local(0), vec![assign(Y, X)], vec![assign(Y, X)]);
    assert_eq!(joined(vec![assign(Var::Local(0), ON), asked]), [assign(Y, X)]);
    for step in [
        chain(vec![]),
        chain(vec![assign(Y, real(0.0))]),
        // The first branch would be empty, the value changes afterwards, the target is read afterwards, a comment explains it.
        vec![choose(vec![assign(Y, X)], vec![s_is(X), assign(Y, X)])],
        vec![choose(vec![assign(Y, Expr::Var(S)), s_is(X)], vec![s_is(real(1.0)), assign(Y, Expr::Var(S))])],
        vec![choose(vec![s_is(X), assign(Y, Expr::Var(S))], vec![s_is(X), assign(Y, real(1.0))])],
        vec![choose(vec![s_is(X), note(), assign(Y, X)], vec![s_is(real(1.0)), assign(Y, X)])],
    ] {
        assert_eq!(joined(step.clone()), step);
    }
}

#[test]
fn a_variable_is_not_given_the_value_that_it_has() {
    let repeated = |step| legal("repeated", program(0, step)).step;
    let s_is = |value| assign(S, value);
    let inside = |list: Vec<Statement>| vec![s_is(X), choose(list, vec![assign(Y, real(1.0))]), s_is(X)];
    let shorter = vec![s_is(X), choose(vec![assign(Y, X)], vec![assign(Y, real(1.0))])];
    assert_eq!(repeated(inside(vec![s_is(X), assign(Y, X)])), shorter);
    for step in [
        inside(vec![s_is(real(0.0)), assign(Y, X)]),
        vec![choose(vec![s_is(X)], vec![]), s_is(X)],
        vec![s_is(real(0.0)), s_is(real(-0.0))],
        vec![s_is(binary(Binary::Add, Expr::Var(S), X)), s_is(binary(Binary::Add, Expr::Var(S), X))],
        // A branch keeps a statement.
        vec![s_is(X), choose(vec![s_is(X)], vec![assign(Y, X)])],
    ] {
        assert_eq!(repeated(step.clone()), step);
    }
}

#[test]
fn a_copy_of_what_does_not_change_is_not_read() {
    let copied = |step| legal("copied", with_locals(["c"], step)).step;
    let (c_is, s_is) = (|value| assign(Var::Local(0), value), |value| assign(S, value));
    let state = || Expr::Var(S);
    let used = |value: Expr| vec![assign(Y, value.clone()), s_is(binary(Binary::Add, value, X))];
    assert_eq!(copied([vec![c_is(state())], used(local(0))].concat()), used(state()));
    for step in [
        vec![c_is(state()), s_is(X), assign(Y, local(0))],
        vec![c_is(state()), choose(vec![s_is(X), assign(Y, local(0))], vec![assign(Y, X)])],
        vec![choose(vec![c_is(state())], vec![c_is(X)]), assign(Y, local(0))],
        // Another task may change an input.
        vec![c_is(X), assign(Y, local(0))],
    ] {
        assert_eq!(copied(step.clone()), step);
    }
}

#[test]
fn a_negated_comparison_is_named_after_its_limit() {
    let limit = Expr::Var(Var::Constant(0));
    let within = Expr::Intrinsic(Intrinsic::InRange, vec![X, limit]);
    let zero = binary(Binary::Equal, X, real(0.0));
    let named = |condition| {
        let step = vec![if_(not(condition), vec![assign(Y, X)], vec![assign(Y, real(0.0))])];
        legal("negated", program(0, step)).locals[0].path.clone()
    };
    assert_eq!([named(within), named(zero)], ["x_within_a", "x_is_zero"]);
}

/// Two branches, one of which leaves the value in the local.
fn inner_of_two(value: Expr) -> Statement {
    choose(vec![assign(Var::Local(0), value)], vec![assign(Var::Local(0), real(1.0))])
}

#[test]
fn no_sign_stands_before_a_zero() {
    let within = Expr::Intrinsic(Intrinsic::Within, vec![X, real(0.0)]);
    let bounded = legal("bounded", program(0, vec![if_(within, vec![assign(Y, X)], vec![assign(Y, real(0.0))])]));
    let asked = binary(Binary::Equal, X, real(0.0));
    assert_eq!(bounded.step, [if_(asked, vec![assign(Y, X)], vec![assign(Y, real(0.0))])]);
    let negated = Expr::Unary(Unary::Negate, Box::new(real(0.0)));
    let Statement::Assign { value: Expr::Literal(Literal::F64(zero)), .. } =
        &legal("bounded", program(0, vec![assign(Y, negated)])).step[0]
    else {
        panic!("a literal")
    };
    assert_eq!(zero.to_bits(), (-0.0f64).to_bits());
}

#[test]
fn signals_that_an_axis_does_not_have_are_left_out() {
    let step = vec![choose(vec![assign(Y, real(0.0)), assign(S, real(1.0))], vec![assign(Y, real(0.0))])];
    let for_axis = legalise::for_axis(&program(0, step)).unwrap();
    assert_eq!((for_axis.inputs, for_axis.outputs), (vec![1], vec![]), "y is always 0, x is not read");
    assert!(for_axis.program.step.is_empty(), "and nothing shows the state");
    let step = vec![choose(vec![assign(Y, real(1.0))], vec![assign(Y, real(0.0))])];
    let for_axis = legalise::for_axis(&program(0, step)).unwrap();
    assert_eq!((for_axis.inputs, for_axis.outputs), (vec![1], vec![0]));
}
