//! Removes everything that no output depends on: locals, state, branches, constants. Inputs and outputs stay, because they
//! are the interface.

use super::Defect;
use crate::program::{Expr, Off, Origin, Program, Statement, Switch, Table, Var, rename, rewrite};

pub(crate) fn run(mut program: Program) -> Result<Program, Defect> {
    let live = live_variables(&program);
    keep(&mut program.init, &live);
    keep(&mut program.step, &live);
    Ok(number_afresh(program))
}

/// The variables that an output depends on, in this cycle or a later one.
fn live_variables(program: &Program) -> Table<bool> {
    let mut live = Table::filled(program, false);
    live.outputs.fill(true);
    let mut grows = true;
    while std::mem::take(&mut grows) {
        for statement in program.statements().rev() {
            mark(statement, &mut live, &mut grows);
        }
    }
    live
}

/// Marks the variables that the live part of a statement reads; returns whether there is such a part.
fn mark(statement: &Statement, live: &mut Table<bool>, grows: &mut bool) -> bool {
    let is_target_live = matches!(statement, Statement::Assign { target, .. } if live[*target]);
    let alive =
        statement.branches().flat_map(|list| list.iter().rev()).filter(|inner| mark(inner, live, grows)).count();
    if !is_target_live && alive == 0 {
        return false;
    }
    if let Some(reads) = statement.expr() {
        reads.variables(&mut |var| *grows |= !std::mem::replace(&mut live[var], true));
    }
    true
}

fn keep(list: &mut Vec<Statement>, live: &Table<bool>) {
    let only_notes = |list: &[Statement]| list.iter().all(|inner| matches!(inner, Statement::Note(_)));
    rewrite(list, &mut |statement, list| match statement {
        Statement::Assign { target, .. } if !live[target] => {}
        Statement::If { condition, then, otherwise } => match (only_notes(&then), only_notes(&otherwise)) {
            (true, true) => {}
            (true, false) => {
                list.push(Statement::If { condition: Expr::not(condition), then: otherwise, otherwise: Vec::new() });
            }
            (false, true) => list.push(Statement::If { condition, then, otherwise: Vec::new() }),
            (false, false) => list.push(Statement::If { condition, then, otherwise }),
        },
        other => list.push(other),
    });
}

/// Removes the variables that are not mentioned any more and renumbers the others; constants in their declared order.
fn number_afresh(mut program: Program) -> Program {
    let mut mentioned = Table::filled(&program, false);
    program.statements().for_each(|statement| statement.variables(&mut |var| mentioned[var] = true));
    let mut new = Table::filled(&program, usize::MAX);
    retain(&mut program.state, &mentioned.state, &mut new.state, |_| Origin::Function);
    retain(&mut program.locals, &mentioned.locals, &mut new.locals, |_| Origin::Function);
    retain(&mut program.constants, &mentioned.constants, &mut new.constants, |constant| constant.origin);
    let renamed = |var: Var| match var {
        Var::State(_) => Var::State(new[var]),
        Var::Local(_) => Var::Local(new[var]),
        Var::Constant(_) => Var::Constant(new[var]),
        interface => interface,
    };
    rename(&mut program.init, &renamed);
    rename(&mut program.step, &renamed);
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
    for (old, item) in kept {
        new[old] = items.len();
        items.push(item);
    }
}
