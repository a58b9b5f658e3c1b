//! Defects planted in the program of a block: each is refused.

use compiler::program::{Constant, Expr, Origin, Program, Statement, Var, map_expressions};
use compiler::ranges::{self, Limit};
use generator::blocks::{BlockKind, of_axis};
use golden::case;
use portable::{Binary, Intrinsic, Literal, Unary};
use std::path::Path;

/// The verified program of a block of a case, and its limit.
fn program(case: &str, block: &str) -> (Program, f64) {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../golden/cases").join(case);
    let designed = case::axis(&folder).expect("the axis of a case");
    let kind: &dyn BlockKind = of_axis(&designed.axis).find(|kind| kind.name() == block).expect("the block");
    let limit = kind.limit(&designed).and_then(|figure| compiler::arithmetic::wide(figure.value));
    (kind.program(&designed, Some("verified")).expect("a program"), limit.unwrap_or(0.0))
}

/// The codes of what cannot be shown.
fn codes(program: &Program, limit: f64) -> Vec<&'static str> {
    let limits: [Limit<'_>; 2] = ["v_add", "v_add_calculated"].map(|path| (path, limit));
    ranges::run(program, &limits).findings.into_iter().map(|finding| finding.code).collect()
}

fn refused(case: &str, block: &str, code: &str, plant: impl Fn(&mut Program)) {
    let (mut program, limit) = program(case, block);
    assert_eq!(codes(&program, limit), [""; 0], "{case}, {block}: before anything is planted");
    plant(&mut program);
    let found = codes(&program, limit);
    assert!(found.contains(&code), "{case}, {block}: {code} is planted, {found:?} found");
}

fn output(program: &Program, path: &str) -> Var {
    Var::Output(program.outputs.iter().position(|output| output.path == path).expect("the output"))
}

fn state(program: &Program, path: &str) -> Var {
    Var::State(program.state.iter().position(|state| state.path == path).expect("the part of the state"))
}

fn assign(target: Var, value: Expr) -> Statement {
    Statement::Assign { target, value }
}

fn of(operator: Binary, left: Expr, right: Expr) -> Expr {
    Expr::Binary(operator, Box::new(left), Box::new(right))
}

/// Writes an output anew at the end of the cycle.
fn puts_out(path: &'static str, value: impl Fn(&Program) -> Expr) -> impl Fn(&mut Program) {
    move |program| {
        let statement = assign(output(program, path), value(program));
        program.step.push(statement);
    }
}

/// Every test of a magnitude that compares with this constant is always true.
fn without_tests(path: &'static str) -> impl Fn(&mut Program) {
    move |program| {
        let constants = program.constants.clone();
        let is_meant = |expr: &Expr| matches!(expr, Expr::Var(Var::Constant(index)) if constants[*index].path == path);
        map_expressions(&mut program.step, &mut |expr| {
            expr.change(&mut |part| {
                if matches!(part, Expr::Intrinsic(Intrinsic::InRange | Intrinsic::Within, operands) if is_meant(&operands[1]))
                {
                    *part = Expr::Literal(Literal::Bool(true));
                }
            });
        });
    }
}

#[test]
fn a_limit_that_is_not_held_is_refused() {
    refused("limit-reached", "ipc", "finite", without_tests("limit"));
    refused(
        "limit-reached",
        "ipc",
        "limit",
        puts_out("v_add", |program| {
            of(Binary::Multiply, Expr::Var(output(program, "v_add")), Expr::Literal(Literal::F64(-1.000_000_1)))
        }),
    );
}

#[test]
fn a_limit_on_another_output_is_refused() {
    let other = |program: &Program| {
        Expr::Var(Var::Input(program.inputs.iter().position(|input| input.path == "v_motor").expect("an input")))
    };
    refused("limit-reached", "ipc", "finite", puts_out("v_add_calculated", other));
}

#[test]
fn a_missing_test_for_what_is_no_number_is_refused() {
    refused("feedforward-conventional", "feedforward", "finite", without_tests("sample_limit"));
}

#[test]
fn an_unguarded_conversion_is_refused() {
    refused("axis-in-the-cnc", "position_control", "conversion", without_tests("manipulated_range.upper_limit"));
}

#[test]
fn a_delay_without_its_comparison_is_refused() {
    refused("axis-in-a-profidrive", "position_control", "finite", |program: &mut Program| {
        map_expressions(&mut program.step, &mut |expr| {
            if matches!(expr, Expr::Intrinsic(Intrinsic::InRange, operands) if matches!(operands[1], Expr::Literal(_)))
            {
                *expr = Expr::Literal(Literal::Bool(true));
            }
        });
    });
}

#[test]
fn a_state_beyond_its_range_is_refused() {
    refused("limit-reached", "ipc", "list", puts_out("error_id", |program| Expr::Var(state(program, "fade"))));
}

#[test]
fn a_counter_that_may_overflow_is_refused() {
    refused("limit-reached", "ipc", "overflow", |program: &mut Program| {
        let fade = state(program, "fade");
        let more = of(Binary::Add, Expr::Var(fade), Expr::Literal(Literal::U32(1)));
        program.step.insert(0, assign(fade, more));
    });
}

#[test]
fn a_division_by_a_state_is_refused() {
    refused(
        "feedforward-additive-velocity",
        "feedforward",
        "finite",
        puts_out("v_feedforward", |program| {
            of(Binary::Divide, Expr::Literal(Literal::F64(1.0)), Expr::Var(state(program, "velocity_delay.x[0]")))
        }),
    );
}

#[test]
fn an_id_outside_its_list_is_refused() {
    refused("limit-reached", "ipc", "list", |program: &mut Program| {
        let error = output(program, "error_id");
        let is_disturbed = of(Binary::Greater, Expr::Var(state(program, "fade")), Expr::Literal(Literal::U32(0)));
        let then = vec![assign(error, of(Binary::Add, Expr::Var(error), Expr::Literal(Literal::U32(1))))];
        program.step.push(Statement::If { condition: is_disturbed, then, otherwise: Vec::new() });
    });
}

#[test]
fn a_limit_with_another_sign_is_refused() {
    refused("axis-of-a-gantry-slave", "axis", "limit", |program: &mut Program| {
        let lower = program.constants.iter_mut().find(|constant| constant.path == "master_lower_limit");
        let lower: &mut Constant = lower.expect("the constant");
        assert!(matches!(lower.origin, Origin::Coefficient(_)));
        lower.value = Literal::F64(-1.0e9);
    });
}

#[test]
fn an_infinite_output_is_refused() {
    refused(
        "axis-in-the-cnc",
        "position_control",
        "finite",
        puts_out("v_command", |program| {
            let v = Expr::Var(output(program, "v_command"));
            of(Binary::Multiply, Expr::Unary(Unary::Negate, Box::new(v)), Expr::Literal(Literal::F64(1.0e300)))
        }),
    );
}
