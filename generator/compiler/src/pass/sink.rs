//! Writes an output where its value is computed, instead of a local that is only copied to it at the end; and sets an output
//! directly instead of a flag that only sets it at the end.
//!
//! ```text
//! if a { x := 1 } else { x := b }               if a { output := 1 } else { output := b }
//! ...                                      ->   ...
//! output := x
//!
//! if a { flag := true } else { flag := b }      if a { output := true } else { if b { output := true } }
//! ...                                      ->   ...
//! if flag { output := true }
//! ```

use super::Defect;
use crate::program::{Expr, Program, Statement, Table, Var, retain_mut};
use portable::Literal;

pub(crate) fn run(mut program: Program) -> Result<Program, Defect> {
    let mut reads = Table::filled(&program, 0);
    let mut writes = reads.clone();
    for statement in program.statements() {
        statement.assignments(&mut |target, _| writes[target] += 1);
        statement.reads(&mut |var| reads[var] += 1);
    }
    in_list(&mut program.step, &reads, &writes);
    Ok(program)
}

/// A local and the output to which it is copied, or which it sets to a value.
#[derive(Clone, Copy)]
struct Way {
    local: Var,
    output: Var,
    /// for a flag: the value of the output
    value: Option<Literal>,
}

fn in_list(list: &mut Vec<Statement>, reads: &Table<usize>, writes: &Table<usize>) {
    list.iter_mut().for_each(|statement| statement.change_branches(|inner| in_list(inner, reads, writes)));
    let mut position = 0;
    while position < list.len() {
        match asked(&list[position]).filter(|way| can_go(*way, &list[..position], reads, writes)) {
            Some(way) => {
                let rest = list.split_off(position);
                go(list, way);
                list.extend(rest.into_iter().skip(1));
                // A flag of a flag may have become a flag itself.
                position = 0;
            }
            None => position += 1,
        }
    }
}

/// The local and the output, if a statement only copies one to the other.
fn asked(statement: &Statement) -> Option<Way> {
    let (local, output, value) = match statement {
        Statement::Assign { target, value: Expr::Var(local) } => (local, target, None),
        Statement::If { condition: Expr::Var(local), then, otherwise } if otherwise.is_empty() => match &then[..] {
            [Statement::Assign { target, value: Expr::Literal(value) }] => (local, target, Some(*value)),
            _ => return None,
        },
        _ => return None,
    };
    let is_way = matches!((local, output), (Var::Local(_), Var::Output(_)));
    is_way.then_some(Way { local: *local, output: *output, value })
}

/// Whether nothing else reads the local, all writes of it are before, and the output is not read from there on.
fn can_go(way: Way, before: &[Statement], reads: &Table<usize>, writes: &Table<usize>) -> bool {
    if reads[way.local] != 1 {
        return false;
    }
    let mut written = 0;
    for statement in before {
        statement.assignments(&mut |target, _| written += usize::from(target == way.local));
    }
    let first = before.iter().position(|statement| statement.mentions(way.local));
    let is_watched = |from: usize| before[from..].iter().any(|statement| statement.mentions(way.output));
    written == writes[way.local] && first.is_some_and(|first| !is_watched(first))
}

/// Replaces the local by the output.
fn go(list: &mut Vec<Statement>, way: Way) {
    retain_mut(list, &mut |statement| match statement {
        Statement::Assign { target, value } if *target == way.local => {
            *target = way.output;
            let Some(set) = way.value else { return true };
            let condition = std::mem::replace(value, Expr::Literal(set));
            match condition {
                Expr::Literal(Literal::Bool(false)) => return false,
                Expr::Literal(_) => {}
                condition => {
                    let then = vec![statement.clone()];
                    *statement = Statement::If { condition, then, otherwise: Vec::new() };
                }
            }
            true
        }
        Statement::If { then, otherwise, .. } => !then.is_empty() || !otherwise.is_empty(),
        _ => true,
    });
}
