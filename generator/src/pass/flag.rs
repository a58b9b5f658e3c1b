//! Removes flags that only say whether an output is set in the end: the output is set where the flag would be raised.
//!
//! ```text
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

/// A flag, the output that it decides about, and the value that the output gets.
#[derive(Clone, Copy)]
struct Flag {
    local: usize,
    output: Var,
    value: Literal,
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
        match asked(&list[position]).filter(|flag| can_go(*flag, &list[..position], reads, writes)) {
            Some(flag) => {
                list.remove(position);
                let rest = list.split_off(position);
                list = raise(list, flag);
                list.extend(rest);
                // What was a flag of a flag is one itself now.
                position = 0;
            }
            None => position += 1,
        }
    }
    list
}

/// The flag that a statement asks, if it does nothing but set an output.
fn asked(statement: &Statement) -> Option<Flag> {
    let Statement::If { condition: Expr::Var(Var::Local(local)), then, otherwise } = statement else { return None };
    match (&then[..], &otherwise[..]) {
        ([Statement::Assign { target: output @ Var::Output(_), value: Expr::Literal(value) }], []) => {
            Some(Flag { local: *local, output: *output, value: *value })
        }
        _ => None,
    }
}

/// Whether nothing else reads the flag, all that writes it stands before, and nobody looks at the output from there on.
fn can_go(flag: Flag, before: &[Statement], reads: &[usize], writes: &[usize]) -> bool {
    let mut written = vec![0; writes.len()];
    before.iter().for_each(|statement| count_writes(statement, &mut written));
    let first = before.iter().position(|statement| statement.mentions(Var::Local(flag.local)));
    let is_watched = |from: usize| before[from..].iter().any(|statement| statement.mentions(flag.output));
    reads[flag.local] == 1 && written[flag.local] == writes[flag.local] && first.is_some_and(|first| !is_watched(first))
}

/// The statements with the output set where the flag was raised.
fn raise(list: Vec<Statement>, flag: Flag) -> Vec<Statement> {
    let set = || Statement::Assign { target: flag.output, value: Expr::Literal(flag.value) };
    list.into_iter()
        .filter_map(|statement| match statement {
            Statement::Assign { target, value } if target == Var::Local(flag.local) => match value {
                Expr::Literal(Literal::Bool(true)) => Some(set()),
                Expr::Literal(Literal::Bool(false)) => None,
                condition => Some(Statement::If { condition, then: vec![set()], otherwise: Vec::new() }),
            },
            Statement::If { condition, then, otherwise } => {
                let (then, otherwise) = (raise(then, flag), raise(otherwise, flag));
                (!then.is_empty() || !otherwise.is_empty()).then_some(Statement::If { condition, then, otherwise })
            }
            other => Some(other),
        })
        .collect()
}
