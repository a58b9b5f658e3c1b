//! Writes every output once on each path, with its final value: a task that interrupts the block sees values of the previous
//! or of the present cycle, never intermediate ones.
//!
//! ```text
//! limited := false                              if a { limited := true } else { limited := false }
//! if a { limited := true }                 ->
//! ```

use super::presumed::is_fixed;
use crate::pass::Defect;
use crate::program::{Expr, Local, Program, Statement, Var, rename};
use portable::Binary;

/// The suffixes of locals that hold an output: the first one, the second one, ...
const HELD: [&str; 3] = ["so_far", "until_now", "up_to_here"];

pub(super) fn run(mut program: Program) -> Result<Program, Defect> {
    for output in 0..program.outputs.len() {
        let mut step = std::mem::take(&mut program.step);
        in_list(&mut step, Var::Output(output), &mut program);
        program.step = step;
    }
    Ok(program)
}

/// Checks that every output is written once on each path.
pub(super) fn verify(program: &Program) -> Result<(), Defect> {
    let mut times = vec![Some(0); program.outputs.len()];
    count(&program.step, &mut times);
    match times.iter().position(|times| *times != Some(1)) {
        None => Ok(()),
        Some(index) => {
            let message = format!("the output {} is not written once on each way", program.outputs[index].path);
            Err(Defect { pass: "settled", message })
        }
    }
}

/// Adds the number of writes of each output on every path through a list; `None` if it differs between paths.
fn count(list: &[Statement], times: &mut Vec<Option<usize>>) {
    for statement in list {
        if let Statement::Assign { target: Var::Output(output), .. } = statement {
            times[*output] = times[*output].map(|times| times + 1);
        }
        let branches = statement.branches().map(|branch| {
            let mut times = times.clone();
            count(branch, &mut times);
            times
        });
        let both = |one: Vec<Option<usize>>, other| {
            one.into_iter().zip(other).map(|(one, other)| one.filter(|_| one == other)).collect()
        };
        if let Some(after) = branches.reduce(both) {
            *times = after;
        }
    }
}

/// Leaves only one statement that writes the output, in a list and in every inner list.
fn in_list(list: &mut Vec<Statement>, output: Var, program: &mut Program) {
    let writers: Vec<usize> = (0..list.len()).filter(|at| list[*at].writes(output)).collect();
    let Some((first, others)) = writers.split_first() else { return };
    let (mut first, mut removed) = (*first, 0);
    for next in others {
        let mut next = next - removed;
        let value = if let Statement::Assign { value, .. } = &list[first]
            && is_fixed(value)
            && !list[first + 1..next].iter().any(|statement| reads(statement, output))
            && !asks(&list[next], output)
        {
            let value = value.clone();
            list.remove(first);
            removed += 1;
            next -= 1;
            value
        } else {
            Expr::Var(hold(list, (first, next), output, program))
        };
        go_before(&mut list[next], output, &value);
        first = next;
    }
    let statement = &mut list[first];
    statement.change_branches(|list| in_list(list, output, program));
    if let Some(value) = either(statement, output) {
        *statement = Statement::Assign { target: output, value };
    }
}

/// The value of a BOOL that both branches of an `if` write and nothing else: the condition combined with another value.
fn either(statement: &Statement, output: Var) -> Option<Expr> {
    let Statement::If { condition, then, otherwise } = statement else { return None };
    let ([Statement::Assign { target: one, value: yes }], [Statement::Assign { target: other, value: no }]) =
        (&then[..], &otherwise[..])
    else {
        return None;
    };
    let is_it = *one == output && *other == output && *yes == Expr::bool(true);
    is_it.then(|| Expr::logic(Binary::Or, condition.clone(), no.clone()))
}

/// Inserts a value before the writes of a statement: into both branches of an `if`. An assignment overwrites it, so nothing
/// is inserted.
fn go_before(statement: &mut Statement, output: Var, value: &Expr) {
    let assign = || Statement::Assign { target: output, value: value.clone() };
    statement.change_branches(|list| list.insert(0, assign()));
}

/// Replaces the output by a local, which it returns, from the first of two statements that write it until the second one.
fn hold(list: &mut [Statement], (first, next): (usize, usize), output: Var, program: &mut Program) -> Var {
    let local = Var::Local(program.locals.len());
    let Var::Output(index) = output else { panic!("settle: {output:?} is not an output") };
    let variable = &program.outputs[index];
    let start = variable.start;
    let path = |end: &&str| format!("{}_{end}", variable.path);
    let is_free = |path: &String| program.locals.iter().all(|local| local.path != *path);
    let path = HELD.iter().map(path).find(is_free).unwrap_or_else(|| path(&HELD[0]));
    program.locals.push(Local { path, ty: Some(variable.ty) });
    // Paths that do not write it have the start value: it is overwritten there, or never read.
    go_before(&mut list[first], output, &Expr::Literal(start));
    list[first].change_branches(|list| in_list(list, output, program));
    rename(&mut list[first..=first], &|var| if var == output { local } else { var });
    // Until the next write, the local replaces the output.
    rename(&mut list[first + 1..next], &|var| if var == output { local } else { var });
    read_instead(&mut list[next], output, local);
    local
}

/// Replaces the output by the local in the expressions that a statement reads before it writes anything. Its branches get
/// the value separately.
fn read_instead(statement: &mut Statement, output: Var, local: Var) {
    if let Statement::Assign { value: expr, .. } | Statement::If { condition: expr, .. } = statement {
        expr.change(&mut |part| {
            if *part == Expr::Var(output) {
                *part = Expr::Var(local);
            }
        });
    }
}

/// Whether a statement reads the output before it writes anything.
fn asks(statement: &Statement, output: Var) -> bool {
    statement.expr().is_some_and(|expr| expr.mentions(output))
}

fn reads(statement: &Statement, output: Var) -> bool {
    let mut found = false;
    statement.reads(&mut |var| found |= var == output);
    found
}
