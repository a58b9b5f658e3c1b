//! Puts the signals around a block that users of PLCopen-style function blocks expect: Enable, Valid, Busy, Error, ErrorID.

use crate::pass::Defect;
use crate::program::{Expr, Local, Program, Statement, Switch, Type, Var, Variable, rename};
use portable::{Binary, Literal};

/// The outputs that get another name, and that name.
pub const RENAMED: [(&str, &str); 2] = [("fault", "Error"), ("error_id", "ErrorID")];

/// The program with these signals, which come before the others.
///
/// - `Enable` FALSE acts as mode OFF, or as the switch at FALSE where the block cannot be faded; TRUE as that input says.
/// - `Valid`: enabled, and no fault in this cycle. It is no gate: on a fault of a part the others go on.
/// - `Busy`: enabled, or not yet at rest: the block must go on being called.
/// - `Error`, `ErrorID`: what `fault` and `error_id` are elsewhere.
pub(super) fn run(mut program: Program) -> Result<Program, Defect> {
    let missing = |what: &str| Defect { pass: "enable", message: format!("{} has no {what}", program.block) };
    let switch = program.switch.take().ok_or_else(|| missing("input to turn it off"))?;
    let output = |path: &str| program.outputs.iter().position(|variable| variable.path == path);
    let [error, error_id] = RENAMED.map(|(path, _)| output(path).ok_or_else(|| missing(path)));
    let [error, _] = add_signals(&mut program, &switch, [error?, error_id?]);
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
        assign(Var::Output(0), Expr::binary(Binary::And, enable, Expr::not(Expr::Var(error)))),
        assign(Var::Output(1), busy),
    ]);
    Ok(program)
}

/// Puts the new signals before the others, which nothing reads or writes yet, and the two that get another name behind them; gives
/// these two.
fn add_signals(program: &mut Program, switch: &Switch, renamed: [usize; 2]) -> [Var; 2] {
    let signal = |path: &str, doc| Variable { path: path.to_owned(), doc, ty: Type::Bool, start: Literal::Bool(false) };
    let [of_enable, of_valid, of_busy] = docs(switch);
    program.inputs.insert(0, signal("Enable", of_enable));
    let mut order: Vec<usize> = renamed.to_vec();
    order.extend((0..program.outputs.len()).filter(|index| !renamed.contains(index)));
    let mut old: Vec<Option<Variable>> = std::mem::take(&mut program.outputs).into_iter().map(Some).collect();
    program.outputs = vec![signal("Valid", of_valid), signal("Busy", of_busy)];
    program.outputs.extend(order.iter().filter_map(|index| old[*index].take()));
    for ((_, name), output) in RENAMED.iter().zip(&mut program.outputs[2..]) {
        (*name).clone_into(&mut output.path);
    }
    let moved = |var| match var {
        Var::Input(index) => Var::Input(index + 1),
        Var::Output(index) => Var::Output(2 + order.iter().position(|old| *old == index).unwrap_or_default()),
        other => other,
    };
    rename(&mut program.init, &moved);
    rename(&mut program.step, &moved);
    renamed.map(|index| moved(Var::Output(index)))
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
