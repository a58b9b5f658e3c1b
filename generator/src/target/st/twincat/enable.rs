//! Puts the signals around a block that users of PLCopen-style function blocks expect: Enable, Valid, Busy, Error, ErrorID.

use compiler::program::{Constant, Expr, Local, Origin, Program, Statement, Type, Var, Variable, rename};
use portable::{Binary, Literal, Unary};

/// The program with five more signals.
///
/// - `Enable` FALSE acts as mode OFF, or as `position_controlled` FALSE where the block cannot be faded; TRUE as that input
///   says.
/// - `Valid`: enabled, and no fault in this cycle. It is no gate: on a fault of a part the others go on.
/// - `Busy`: enabled, or not yet at rest: the block must go on being called.
/// - `Error`, `ErrorID`: `fault` and `error_id`.
///
/// # Panics
/// If the block has no input to turn it off, no `fault` or no `error_id`.
#[must_use]
pub fn run(program: Program) -> Program {
    let (inputs, outputs) = (program.inputs.len(), program.outputs.len());
    // The new signals come first.
    let mut program = shifted(program);
    let find = |list: &[Variable], path: &str| list.iter().position(|variable| variable.path == path);
    let switch = find(&program.inputs, program.enable).expect("enable: the block has an input to turn it off");
    let ty = program.inputs[switch].ty;
    let fault = find(&program.outputs, "fault").expect("enable: the block has a fault");
    let error_id = find(&program.outputs, "error_id").expect("enable: the block has an error_id");
    // A mode fades; a switch acts at once, and leaves nothing to wait for.
    let settled = find(&program.state, "settled").filter(|_| ty == Type::I32);
    let enabled = Var::Local(program.locals.len());
    program.locals.push(Local { path: format!("{}_enabled", program.enable), ty: Some(ty) });
    program.step = rename(program.step, &|var| if var == Var::Input(switch) { enabled } else { var });
    let (enable, of) = (Expr::Var(Var::Input(0)), Expr::Var);
    let off = if ty == Type::I32 { of(mode_off(&mut program)) } else { Expr::Literal(Literal::Bool(false)) };
    program.step.insert(
        0,
        Statement::If {
            condition: enable.clone(),
            then: vec![assign(enabled, of(Var::Input(switch)))],
            otherwise: vec![assign(enabled, off)],
        },
    );
    let not_fault = Expr::Unary(Unary::Not, Box::new(of(Var::Output(fault))));
    let busy = match settled {
        Some(settled) => both(Binary::Or, enable.clone(), of(Var::State(settled))),
        None => enable.clone(),
    };
    program.step.extend([
        assign(Var::Output(0), both(Binary::And, enable, not_fault)),
        assign(Var::Output(1), busy),
        assign(Var::Output(2), of(Var::Output(fault))),
        assign(Var::Output(3), of(Var::Output(error_id))),
    ]);
    debug_assert_eq!((program.inputs.len(), program.outputs.len()), (inputs + 1, outputs + 4));
    program
}

/// The program with the new signals before the others, which nothing reads or writes yet.
fn shifted(mut program: Program) -> Program {
    let signal = |path: &str, doc, ty, start| Variable { path: path.to_owned(), doc, ty, start };
    let no = Literal::Bool(false);
    let [of_enable, of_valid, of_busy] = docs(program.enable);
    program.inputs.insert(0, signal("Enable", of_enable, Type::Bool, no));
    let new = [
        signal("Valid", of_valid, Type::Bool, no),
        signal("Busy", of_busy, Type::Bool, no),
        signal("Error", "as fault", Type::Bool, no),
        signal("ErrorID", "as error_id", Type::U32, Literal::U32(0)),
    ];
    let count = new.len();
    program.outputs.splice(0..0, new);
    let renamed = |var| match var {
        Var::Input(index) => Var::Input(index + 1),
        Var::Output(index) => Var::Output(index + count),
        other => other,
    };
    program.init = rename(program.init, &renamed);
    program.step = rename(program.step, &renamed);
    program
}

/// What the signals mean, by the input that turns the block off.
fn docs(switch: &str) -> [&'static str; 3] {
    match switch {
        "mode" => [
            "FALSE acts as mode OFF, TRUE as mode says",
            "enabled, and no fault in this cycle: v_add may be added",
            "enabled, or still fading out: go on calling the block",
        ],
        _ => [
            "FALSE acts as position_controlled FALSE, at once and without a ramp; TRUE as position_controlled says",
            "enabled, and no fault of any part in this cycle; the outputs hold in any case, do not gate them with it",
            "enabled: go on calling the block",
        ],
    }
}

/// The constant of the mode OFF; a block that never asks for it gets it here.
fn mode_off(program: &mut Program) -> Var {
    let known = program.constants.iter().position(|constant| constant.path == "mode_off");
    Var::Constant(known.unwrap_or_else(|| {
        program.constants.push(Constant {
            path: "mode_off".to_owned(),
            doc: "mode: the block is off",
            value: Literal::I32(reference::ipc::mode_off()),
            origin: Origin::Function,
        });
        program.constants.len() - 1
    }))
}

fn assign(target: Var, value: Expr) -> Statement {
    Statement::Assign { target, value }
}

fn both(operator: Binary, left: Expr, right: Expr) -> Expr {
    Expr::Binary(operator, Box::new(left), Box::new(right))
}
