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
use crate::program::{Expr, Program, Statement, Var, rewrite};
use portable::Literal;

/// Runs the pass.
///
/// # Errors
/// None.
pub fn run(mut program: Program) -> Result<Program, Defect> {
    let (mut reads, mut writes) = (vec![0; program.locals.len()], vec![0; program.locals.len()]);
    for statement in program.statements() {
        count_writes(statement, &mut writes);
        statement.reads(&mut |var| {
            if let Var::Local(local) = var {
                reads[local] += 1;
            }
        });
    }
    in_list(&mut program.step, &reads, &writes);
    Ok(program)
}

fn count_writes(statement: &Statement, writes: &mut [usize]) {
    statement.assignments(&mut |target, _| {
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
fn in_list(list: &mut Vec<Statement>, reads: &[usize], writes: &[usize]) {
    for statement in &mut *list {
        if let Statement::If { then, otherwise, .. } = statement {
            in_list(then, reads, writes);
            in_list(otherwise, reads, writes);
        }
    }
    let mut position = 0;
    while position < list.len() {
        match asked(&list[position]).filter(|way| can_go(*way, &list[..position], reads, writes)) {
            Some(way) => {
                let rest = list.split_off(position);
                go(list, way);
                list.extend(rest.into_iter().skip(1));
                // What was a flag of a flag is one itself now.
                position = 0;
            }
            None => position += 1,
        }
    }
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
    if reads[way.local] != 1 {
        return false;
    }
    let local = Var::Local(way.local);
    let mut written = 0;
    for statement in before {
        statement.assignments(&mut |target, _| written += usize::from(target == local));
    }
    let first = before.iter().position(|statement| statement.mentions(local));
    let is_watched = |from: usize| before[from..].iter().any(|statement| statement.mentions(way.output));
    written == writes[way.local] && first.is_some_and(|first| !is_watched(first))
}

/// Puts the output in the place of the local.
fn go(list: &mut Vec<Statement>, way: Way) {
    let assign = |value| Statement::Assign { target: way.output, value };
    rewrite(list, &mut |statement, list| match statement {
        Statement::Assign { target, value } if target == Var::Local(way.local) => match (way.value, value) {
            (None, value) => list.push(assign(value)),
            (Some(set), Expr::Literal(Literal::Bool(raised))) => {
                list.extend(raised.then(|| assign(Expr::Literal(set))))
            }
            (Some(set), condition) => {
                let then = vec![assign(Expr::Literal(set))];
                list.push(Statement::If { condition, then, otherwise: Vec::new() });
            }
        },
        Statement::If { then, otherwise, .. } if then.is_empty() && otherwise.is_empty() => {}
        other => list.push(other),
    });
}
