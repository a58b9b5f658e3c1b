//! Reads a part of the state, or a local, itself instead of a local that has a copy of it for as long as it does not change. An
//! input is copied on purpose: another task may write a parameter set.
//!
//! ```text
//! t := turn; if t = 0 { x := a }; turn := turn + 1   ->   if turn = 0 { x := a }; turn := turn + 1
//! ```

use crate::pass::Defect;
use crate::program::{Expr, Program, Statement, Var, rename};

pub(super) fn run(mut program: Program) -> Result<Program, Defect> {
    let mut writes = vec![0; program.locals.len()];
    program.step.iter().for_each(|statement| {
        statement.assignments(&mut |target, _| {
            if let Var::Local(local) = target {
                writes[local] += 1;
            }
        });
    });
    in_list(&mut program.step, &writes);
    super::share::drop_unused(&mut program);
    Ok(program)
}

/// `writes`: the number of assignments to each local.
fn in_list(list: &mut Vec<Statement>, writes: &[usize]) {
    let mut at = 0;
    while at < list.len() {
        match copy(&list[at], writes) {
            Some((local, source)) if stays(&list[at + 1..], local, source) => {
                list.remove(at);
                rename(&mut list[at..], &|var| if var == local { source } else { var });
            }
            _ => at += 1,
        }
    }
    list.iter_mut().for_each(|statement| statement.change_branches(|inner| in_list(inner, writes)));
}

/// The local and its source, if a statement only copies and nothing else assigns the local.
fn copy(statement: &Statement, writes: &[usize]) -> Option<(Var, Var)> {
    match statement {
        Statement::Assign {
            target: local @ Var::Local(index),
            value: Expr::Var(source @ (Var::State(_) | Var::Local(_))),
        } if writes[*index] == 1 => Some((*local, *source)),
        _ => None,
    }
}

/// Whether the source keeps its value until the last statement that reads the local; that one may assign it.
fn stays(rest: &[Statement], local: Var, source: Var) -> bool {
    let Some(last) = rest.iter().rposition(|statement| statement.mentions(local)) else { return false };
    let may_be_last = matches!(rest[last], Statement::Assign { .. }) || !rest[last].writes(source);
    may_be_last && !rest[..last].iter().any(|statement| statement.writes(source))
}
