//! Removes everything that no output depends on: locals, state, branches, constants. Inputs and outputs stay, because they
//! are the interface.

use super::Defect;
use crate::program::{Expr, Off, Origin, Program, Statement, Switch, Table, Var, close_up, rename, retain_mut};

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

/// An assignment or an `if`.
struct Place<'p> {
    statement: &'p Statement,
    /// the `if` around it
    around: Option<usize>,
    /// the previous assignment of the same variable
    previous: Option<usize>,
    is_live: bool,
}

/// All assignments and `if`s of a program.
struct Places<'p> {
    all: Vec<Place<'p>>,
    /// the last assignment of each variable
    last: Table<Option<usize>>,
}

impl<'p> Places<'p> {
    fn enter(&mut self, list: &'p [Statement], around: Option<usize>) {
        for statement in list {
            let place = self.all.len();
            let previous = match statement {
                Statement::Assign { target, .. } => self.last[*target].replace(place),
                _ => None,
            };
            self.all.push(Place { statement, around, previous, is_live: false });
            statement.branches().for_each(|list| self.enter(list, Some(place)));
        }
    }
}

/// The variables that an output depends on, in this cycle or a later one.
fn live_variables(program: &Program) -> Table<bool> {
    let mut places = Places { all: Vec::with_capacity(256), last: Table::filled(program, None) };
    places.enter(&program.init, None);
    places.enter(&program.step, None);
    let mut live = Table::filled(program, false);
    live.outputs.fill(true);
    let mut fresh: Vec<Var> = (0..program.outputs.len()).map(Var::Output).collect();
    while let Some(var) = fresh.pop() {
        let mut assignment = places.last[var];
        while let Some(at) = assignment {
            assignment = places.all[at].previous;
            // The assignment needs its operands and the conditions around it.
            let mut needed = Some(at);
            while let Some(place) = needed.map(|at| &mut places.all[at]).filter(|place| !place.is_live) {
                place.is_live = true;
                needed = place.around;
                place.statement.expr().into_iter().for_each(|reads| {
                    reads.variables(&mut |var| {
                        if !std::mem::replace(&mut live[var], true) {
                            fresh.push(var);
                        }
                    });
                });
            }
        }
    }
    live
}

fn keep(list: &mut Vec<Statement>, live: &Table<bool>) {
    retain_mut(list, &mut |statement| match statement {
        Statement::Assign { target, .. } => live[*target],
        other => close_up(other, Expr::not),
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
    if let Some(Switch { off: Off::Mode(_, works) | Off::Execute(works), .. }) = &mut program.switch {
        *works = works.filter(|works| mentioned[*works]).map(renamed);
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
