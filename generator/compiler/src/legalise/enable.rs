//! Puts the signals around a block that users of PLCopen-style function blocks expect: Enable, Valid, Busy, Error, ErrorID.

use crate::pass::Defect;
use crate::program::{Expr, Local, Program, Statement, Switch, Type, Var, Variable, rename};
use portable::{Binary, Literal};

/// The program with five more signals, which come before the others.
///
/// - `Enable` FALSE acts as mode OFF, or as the switch at FALSE where the block cannot be faded; TRUE as that input says.
/// - `Valid`: enabled, and no fault in this cycle. It is no gate: on a fault of a part the others go on.
/// - `Busy`: enabled, or not yet at rest: the block must go on being called.
/// - `Error`, `ErrorID`: `fault` and `error_id`.
pub(super) fn run(mut program: Program) -> Result<Program, Defect> {
    let missing = |what: &str| Defect { pass: "enable", message: format!("{} has no {what}", program.block) };
    let output = |path: &str| program.outputs.iter().position(|variable| variable.path == path);
    let switch = program.switch.take().ok_or_else(|| missing("input to turn it off"))?;
    let fault = output("fault").ok_or_else(|| missing("fault"))?;
    let error_id = output("error_id").ok_or_else(|| missing("error_id"))?;
    let added = add_signals(&mut program, &switch);
    let value_of = |output: usize| Expr::Var(Var::Output(output + added));
    // What the block reads is no longer the input, but what `Enable` makes of it.
    let (input, enabled) = (Var::Input(switch.input + 1), Var::Local(program.locals.len()));
    let variable = &program.inputs[switch.input + 1];
    program.locals.push(Local { path: format!("{}_enabled", variable.path), ty: Some(variable.ty) });
    rename(&mut program.step, &|var| if var == input { enabled } else { var });
    let off = switch.off.map_or(Expr::bool(false), |off| {
        let known = program.constants.iter().position(|constant| *constant == off);
        Expr::Var(Var::Constant(known.unwrap_or_else(|| {
            program.constants.push(off);
            program.constants.len() - 1
        })))
    });
    let enable = Expr::Var(Var::Input(0));
    let (then, otherwise) = (vec![assign(enabled, Expr::Var(input))], vec![assign(enabled, off)]);
    program.step.insert(0, Statement::If { condition: enable.clone(), then, otherwise });
    let busy = match switch.busy {
        Some(busy) => Expr::binary(Binary::Or, enable.clone(), Expr::Var(busy)),
        None => enable.clone(),
    };
    program.step.extend([
        assign(Var::Output(0), Expr::binary(Binary::And, enable, Expr::not(value_of(fault)))),
        assign(Var::Output(1), busy),
        assign(Var::Output(2), value_of(fault)),
        assign(Var::Output(3), value_of(error_id)),
    ]);
    Ok(program)
}

/// Puts the new signals before the others, which nothing reads or writes yet; gives the number of new outputs.
fn add_signals(program: &mut Program, switch: &Switch) -> usize {
    let signal = |path: &str, doc, ty, start| Variable { path: path.to_owned(), doc, ty, start };
    let no = Literal::Bool(false);
    let [of_enable, of_valid, of_busy] = docs(switch);
    program.inputs.insert(0, signal("Enable", of_enable, Type::Bool, no));
    let new = [
        signal("Valid", of_valid, Type::Bool, no),
        signal("Busy", of_busy, Type::Bool, no),
        signal("Error", "as fault", Type::Bool, no),
        signal("ErrorID", "as error_id", Type::U32, Literal::U32(0)),
    ];
    let added = new.len();
    program.outputs.splice(0..0, new);
    let renamed = |var| match var {
        Var::Input(index) => Var::Input(index + 1),
        Var::Output(index) => Var::Output(index + added),
        other => other,
    };
    rename(&mut program.init, &renamed);
    rename(&mut program.step, &renamed);
    added
}

/// What the signals mean, by what turns the block off.
fn docs(switch: &Switch) -> [&'static str; 3] {
    match switch.off {
        Some(_) => [
            "FALSE acts as mode OFF, TRUE as mode says",
            "enabled, and no fault in this cycle: v_add may be added",
            "enabled, or still fading out: go on calling the block",
        ],
        None => [
            "FALSE acts as position_controlled FALSE, at once and without a ramp; TRUE as position_controlled says",
            "enabled, and no fault of any part in this cycle; the outputs hold in any case, do not gate them with it",
            "enabled: go on calling the block",
        ],
    }
}

fn assign(target: Var, value: Expr) -> Statement {
    Statement::Assign { target, value }
}
