//! Removes everything that no output depends on: locals, state, branches, constants. Inputs and outputs stay, because they
//! are the interface.

use super::Defect;
use crate::program::{Expr, Off, Origin, Program, Statement, Switch, Table, Var, rename, retain_mut};

pub(crate) fn run(program: Program) -> Result<Program, Defect> {
    let interface = (vec![true; program.inputs.len()], vec![true; program.outputs.len()]);
    Ok(with_signals(program, interface))
}

/// Does the same, and keeps only the flagged inputs and outputs.
pub(crate) fn with_signals(mut program: Program, signals: (Vec<bool>, Vec<bool>)) -> Program {
    let live = live_variables(&program);
    keep(&mut program.init, &live);
    keep(&mut program.step, &live);
    number_afresh(program, signals)
}

/// The variables that an output depends on, in this cycle or a later one.
fn live_variables(program: &Program) -> Table<Life> {
    let mut live = Table::filled(program, Life::Unread);
    live.outputs.fill(Life::Live);
    let mut grows = true;
    while std::mem::take(&mut grows) {
        mark(&program.init, &mut live, &mut grows);
        mark(&program.step, &mut live, &mut grows);
    }
    live
}

/// The present knowledge about a variable.
#[derive(Clone, Copy, PartialEq)]
enum Life {
    Unread,
    /// unread where its assignment was last examined
    Dead,
    Live,
}

/// Marks the variables that the live statements of a list read, from its end; returns whether there are such statements.
/// `grows`: an assignment that was dead when it was examined is live now.
fn mark(list: &[Statement], live: &mut Table<Life>, grows: &mut bool) -> bool {
    let mut is_any_live = false;
    for statement in list.iter().rev() {
        let is_live = match statement {
            Statement::Assign { target, .. } if live[*target] == Life::Live => true,
            Statement::Assign { target, .. } => {
                live[*target] = Life::Dead;
                false
            }
            Statement::If { then, otherwise, .. } => {
                let is_then_live = mark(then, live, grows);
                mark(otherwise, live, grows) || is_then_live
            }
            Statement::Note(_) => false,
            Statement::Choose { .. } | Statement::Apart(_) => panic!("prune: nothing has been legalised yet"),
        };
        if is_live && let Some(reads) = statement.expr() {
            reads.variables(&mut |var| *grows |= std::mem::replace(&mut live[var], Life::Live) == Life::Dead);
        }
        is_any_live |= is_live;
    }
    is_any_live
}

fn keep(list: &mut Vec<Statement>, live: &Table<Life>) {
    let only_notes = |list: &[Statement]| list.iter().all(|inner| matches!(inner, Statement::Note(_)));
    retain_mut(list, &mut |statement| match statement {
        Statement::Assign { target, .. } => live[*target] == Life::Live,
        Statement::If { condition, then, otherwise } => {
            match (only_notes(then), only_notes(otherwise)) {
                (true, true) => return false,
                (true, false) => {
                    *condition = Expr::not(std::mem::replace(condition, Expr::bool(true)));
                    *then = std::mem::take(otherwise);
                }
                (false, true) => otherwise.clear(),
                (false, false) => {}
            }
            true
        }
        _ => true,
    });
}

/// Removes the variables that are not mentioned any more and renumbers the others; constants in their declared order.
fn number_afresh(mut program: Program, signals: (Vec<bool>, Vec<bool>)) -> Program {
    let mut mentioned = Table::filled(&program, false);
    program.statements().for_each(|statement| statement.variables(&mut |var| mentioned[var] = true));
    (mentioned.inputs, mentioned.outputs) = signals;
    let mut new = Table::filled(&program, usize::MAX);
    retain(&mut program.inputs, &mentioned.inputs, &mut new.inputs, |_| Origin::Function);
    retain(&mut program.outputs, &mentioned.outputs, &mut new.outputs, |_| Origin::Function);
    retain(&mut program.state, &mentioned.state, &mut new.state, |_| Origin::Function);
    retain(&mut program.locals, &mentioned.locals, &mut new.locals, |_| Origin::Function);
    retain(&mut program.constants, &mentioned.constants, &mut new.constants, |constant| constant.origin);
    let renamed = |var: Var| match var {
        Var::Input(_) => Var::Input(new[var]),
        Var::Output(_) => Var::Output(new[var]),
        Var::State(_) => Var::State(new[var]),
        Var::Local(_) => Var::Local(new[var]),
        Var::Constant(_) => Var::Constant(new[var]),
    };
    rename(&mut program.init, &renamed);
    rename(&mut program.step, &renamed);
    program.switch = program.switch.filter(|switch| mentioned.inputs[switch.input]);
    if let Some(switch) = &mut program.switch {
        switch.input = new.inputs[switch.input];
    }
    if let Some(Switch { off: Off::Mode(_, fades) | Off::Fade(fades) | Off::Execute(fades), .. }) = &mut program.switch
    {
        *fades = fades.filter(|fades| mentioned[*fades]).map(renamed);
    }
    program
}

/// Keeps the mentioned items, in the order of their origin; `new` gets the position of each.
pub(crate) fn retain<T>(items: &mut Vec<T>, mentioned: &[bool], new: &mut [usize], origin: impl Fn(&T) -> Origin) {
    let all = std::mem::take(items).into_iter().enumerate();
    let mut kept: Vec<(usize, T)> = all.filter(|(old, _)| mentioned[*old]).collect();
    kept.sort_by_key(|(_, item)| origin(item));
    kept.iter().enumerate().for_each(|(place, (old, _))| new[*old] = place);
    items.extend(kept.into_iter().map(|(_, item)| item));
}
