//! Writes once, after the branches, what all of them do last: the text in Structured Text becomes shorter, and shows that it does
//! not depend on the condition.
//!
//! ```text
//! if a { x := 1; y := z } else { x := 2; y := z }   ->   if a { x := 1 } else { x := 2 }; y := z
//! ```

use super::presumed::leave_out;
use super::share::drop_unused;
use crate::pass::Defect;
use crate::program::{Program, Statement, Var};

pub(super) fn run(mut program: Program) -> Result<Program, Defect> {
    in_list(&mut program.step);
    drop_unread(&mut program);
    Ok(program)
}

fn in_list(list: &mut Vec<Statement>) {
    let mut at = 0;
    while at < list.len() {
        let mut branches = Vec::new();
        branches_of(&mut list[at], &mut branches);
        branches.iter_mut().for_each(|branch| in_list(branch));
        let joined = joined(&mut branches);
        let does_nothing = branches.iter().all(|branch| branch.is_empty());
        at += 1;
        if !joined.is_empty() {
            let next = at + joined.len() - usize::from(does_nothing);
            list.splice(at - usize::from(does_nothing)..at, joined);
            at = next;
        }
    }
}

/// The branches of a chain of conditions, the last one for none of them.
fn branches_of<'s>(statement: &'s mut Statement, branches: &mut Vec<&'s mut Vec<Statement>>) {
    let Statement::If { then, otherwise, .. } = statement else { return };
    branches.push(then);
    if matches!(otherwise[..], [Statement::If { .. }]) {
        branches_of(&mut otherwise[0], branches);
    } else {
        branches.push(otherwise);
    }
}

/// Takes the assignments that can be after the branches out of all of them.
fn joined(branches: &mut [&mut Vec<Statement>]) -> Vec<Statement> {
    let mut joined = Vec::new();
    let last = branches.first().map_or(0, |first| first.len());
    for at in (0..last).rev() {
        let wanted @ Statement::Assign { .. } = &branches[0][at] else { continue };
        let place = |branch: &&mut Vec<Statement>| branch.iter().rposition(|inner| inner == wanted);
        let Some(places) = branches.iter().map(place).collect::<Option<Vec<usize>>>() else { continue };
        if !branches.iter().zip(&places).all(|(branch, at)| can_go(branch, *at)) {
            continue;
        }
        let (ends, others) = (branches.iter().filter(|branch| branch.len() == 1).count(), branches.len() - 1);
        // A condition without a statement has to become another one: only the last branch may end, or all of them.
        if ends == 0 || ends > others || ends == 1 && branches[others].len() == 1 {
            joined.extend(branches.iter_mut().zip(places).map(|(branch, at)| branch.remove(at)).last());
        }
    }
    joined.reverse();
    joined
}

/// Whether an assignment in a list can be after the list: nothing after it reads or changes what it is about, and it is not the
/// statement that a comment explains.
fn can_go(list: &[Statement], at: usize) -> bool {
    let Statement::Assign { target, value } = &list[at] else { return false };
    let is_note = |statement: &Statement| matches!(statement, Statement::Note(_));
    let mut asked = vec![*target];
    value.variables(&mut |var| asked.push(var));
    let has_others = list.len() == 1 || list.iter().filter(|statement| !is_note(statement)).count() > 1;
    let is_explained = at > 0 && is_note(&list[at - 1]);
    let is_free =
        |statement: &Statement| !statement.mentions(*target) && !asked.iter().any(|var| statement.writes(*var));
    has_others && !is_explained && list[at + 1..].iter().all(is_free)
}

/// Removes what only a condition needed that is gone.
fn drop_unread(program: &mut Program) {
    let mut known = 0;
    loop {
        let mut is_read = vec![false; program.locals.len()];
        program.step.iter().for_each(|statement| {
            statement.reads(&mut |var| {
                if let Var::Local(local) = var {
                    is_read[local] = true;
                }
            });
        });
        let is_unread = |target| matches!(target, Var::Local(local) if !is_read[local]);
        let mut unread = 0;
        program.step.iter().for_each(|statement| {
            statement.assignments(&mut |target, _| unread += usize::from(is_unread(target)));
        });
        if unread == known {
            break drop_unused(program);
        }
        known = unread;
        leave_out(
            &mut program.step,
            &|statement| matches!(statement, Statement::Assign { target, .. } if is_unread(*target)),
        );
    }
}
