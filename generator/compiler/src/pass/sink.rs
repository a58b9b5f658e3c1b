//! Writes an output where its value is found, instead of a local that only goes there in the end; and sets an output where
//! a flag would be raised that only says so in the end.
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
use crate::program::{Expr, Program, Statement, Var};
use portable::Literal;

/// Runs the pass.
///
/// # Errors
/// None.
pub fn run(mut program: Program) -> Result<Program, Defect> {
    let mut reads = vec![0; program.locals.len()];
    for statement in program.init.iter().chain(&program.step) {
        statement.expressions(&mut |expr| {
            expr.variables(&mut |var| {
                if let Var::Local(local) = var {
                    reads[local] += 1;
                }
            });
        });
    }
    let mut writes = vec![0; program.locals.len()];
    for statement in program.init.iter().chain(&program.step) {
        count_writes(statement, &mut writes);
    }
    program.step = in_list(program.step, &reads, &writes);
    Ok(program)
}

fn count_writes(statement: &Statement, writes: &mut [usize]) {
    statement.targets(&mut |target| {
        if let Var::Local(local) = target {
            writes[local] += 1;
        }
    });
}

/// A local and the output that it goes to, or that it sets to a value.
#[derive(Clone, Copy)]
struct Way {
    local: usize,
    output: Var,
    /// of a flag: what the output gets
    value: Option<Literal>,
}

/// Treats a list, inner lists first.
fn in_list(list: Vec<Statement>, reads: &[usize], writes: &[usize]) -> Vec<Statement> {
    let mut list: Vec<Statement> = list
        .into_iter()
        .map(|statement| match statement {
            Statement::If { condition, then, otherwise } => Statement::If {
                condition,
                then: in_list(then, reads, writes),
                otherwise: in_list(otherwise, reads, writes),
            },
            other => other,
        })
        .collect();
    let mut position = 0;
    while position < list.len() {
        match asked(&list[position]).filter(|way| can_go(*way, &list[..position], reads, writes)) {
            Some(way) => {
                list.remove(position);
                let rest = list.split_off(position);
                list = go(list, way);
                list.extend(rest);
                // What was a flag of a flag is one itself now.
                position = 0;
            }
            None => position += 1,
        }
    }
    list
}

/// The way of a local to an output, if a statement does nothing else.
fn asked(statement: &Statement) -> Option<Way> {
    match statement {
        Statement::Assign { target: output @ Var::Output(_), value: Expr::Var(Var::Local(local)) } => {
            Some(Way { local: *local, output: *output, value: None })
        }
        Statement::If { condition: Expr::Var(Var::Local(local)), then, otherwise } => match (&then[..], &otherwise[..])
        {
            ([Statement::Assign { target: output @ Var::Output(_), value: Expr::Literal(value) }], []) => {
                Some(Way { local: *local, output: *output, value: Some(*value) })
            }
            _ => None,
        },
        _ => None,
    }
}

/// Whether nothing else reads the local, all that writes it stands before, and nobody looks at the output from there on.
fn can_go(way: Way, before: &[Statement], reads: &[usize], writes: &[usize]) -> bool {
    let mut written = vec![0; writes.len()];
    before.iter().for_each(|statement| count_writes(statement, &mut written));
    let first = before.iter().position(|statement| statement.mentions(Var::Local(way.local)));
    let is_watched = |from: usize| before[from..].iter().any(|statement| statement.mentions(way.output));
    reads[way.local] == 1 && written[way.local] == writes[way.local] && first.is_some_and(|first| !is_watched(first))
}

/// The statements with the output in the place of the local.
fn go(list: Vec<Statement>, way: Way) -> Vec<Statement> {
    let assign = |value| Statement::Assign { target: way.output, value };
    list.into_iter()
        .filter_map(|statement| match statement {
            Statement::Assign { target, value } if target == Var::Local(way.local) => match (way.value, value) {
                (None, value) => Some(assign(value)),
                (Some(set), Expr::Literal(Literal::Bool(raised))) => raised.then(|| assign(Expr::Literal(set))),
                (Some(set), condition) => {
                    let then = vec![assign(Expr::Literal(set))];
                    Some(Statement::If { condition, then, otherwise: Vec::new() })
                }
            },
            Statement::If { condition, then, otherwise } => {
                let (then, otherwise) = (go(then, way), go(otherwise, way));
                (!then.is_empty() || !otherwise.is_empty()).then_some(Statement::If { condition, then, otherwise })
            }
            other => Some(other),
        })
        .collect()
}
