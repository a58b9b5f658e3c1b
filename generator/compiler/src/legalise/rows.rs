//! Reads an element of an array instead of asking for each number in turn. The array is what the chain reads: consecutive parts
//! of the state. A condition around the reading keeps the index below the length, whatever the state contains.
//!
//! ```text
//! if n == 0 { x = of.a } else if n == 1 { x = of.b } else if n == 2 { x = of.c }   ->   if n < 3 { x = of[n] }
//! ```

use crate::pass::Defect;
use crate::program::{Expr, Program, Row, Statement, Var};
use portable::{Binary, Literal};

/// A shorter chain stays as it is.
const LEAST: usize = 3;

/// Variables, each with a number that it is below of.
type Below = Vec<(Var, usize)>;

/// What each statement of a branch assigns, and the part of the state that it takes in the first branch.
type Columns = Vec<(Var, usize)>;

pub(super) fn run(mut program: Program) -> Result<Program, Defect> {
    let mut step = std::mem::take(&mut program.step);
    in_list(&mut step, Below::new(), &mut program);
    program.step = step;
    Ok(program)
}

fn in_list(list: &mut Vec<Statement>, mut below: Below, program: &mut Program) {
    let mut at = 0;
    while at < list.len() {
        if let Some((by, length, columns)) = table(&list[at], program) {
            let mut fresh = rows(&columns, length);
            fresh.retain(|row| !program.rows.contains(row));
            program.rows.extend(fresh);
            let read = |(target, first): &(Var, usize)| Statement::Assign {
                target: *target,
                value: Expr::Element(Row { first: *first, length }, Box::new(Expr::Var(by))),
            };
            let (then, otherwise) = (columns.iter().map(read), after(&mut list[at], length));
            if below.contains(&(by, length)) && otherwise.is_empty() {
                list.splice(at..=at, then);
            } else {
                let number = u32::try_from(length).expect("rows: a chain is shorter than 2^32");
                let condition = Expr::binary(Binary::Less, Expr::Var(by), Expr::Literal(Literal::U32(number)));
                list[at] = Statement::If { condition, then: then.collect(), otherwise };
            }
        }
        let mut bound = bound(&list[at]);
        list[at].change_branches(|branch| in_list(branch, inside(&below, bound.take()), program));
        pass(&list[at], &mut below);
        at += 1;
    }
}

/// What is known in a branch, with the bound of the condition in the first one.
fn inside(below: &Below, bound: Option<(Var, usize)>) -> Below {
    below.iter().copied().chain(bound).collect()
}

/// What is known after a statement: nothing about what it assigns, unless it only copies.
fn pass(statement: &Statement, below: &mut Below) {
    if below.is_empty() {
        return;
    }
    let copied = match statement {
        Statement::Assign { target, value: Expr::Var(source) } => {
            below.iter().find(|(var, _)| var == source).map(|(_, bound)| (*target, *bound))
        }
        _ => None,
    };
    statement.assignments(&mut |target, _| below.retain(|(var, _)| *var != target));
    below.extend(copied);
}

/// The variable that a condition compares with a number, if it is below of that where the condition holds.
fn bound(statement: &Statement) -> Option<(Var, usize)> {
    let Statement::If { condition: Expr::Binary(Binary::Less, left, right), .. } = statement else { return None };
    match (&**left, &**right) {
        (Expr::Var(var @ (Var::State(_) | Var::Local(_))), Expr::Literal(Literal::U32(bound))) => {
            Some((*var, *bound as usize))
        }
        _ => None,
    }
}

fn rows(columns: &[(Var, usize)], length: usize) -> Vec<Row> {
    columns.iter().map(|(_, first)| Row { first: *first, length }).collect()
}

/// The number for which a chain asks, how often, and what it assigns; `None` if a statement is not such a chain.
fn table(statement: &Statement, program: &Program) -> Option<(Var, usize, Columns)> {
    let (by, _, first) = question(statement, 0)?;
    let columns: Columns = first.iter().map(taken).collect::<Option<_>>()?;
    let (mut link, mut length) = (statement, 0);
    while let Some((same, rest, body)) = question(link, length) {
        let is_next = body.len() == columns.len()
            && body
                .iter()
                .zip(&columns)
                .all(|(inner, (target, start))| taken(inner) == Some((*target, start + length)));
        if same != by || !is_next {
            break;
        }
        length += 1;
        match rest {
            [next] => link = next,
            _ => break,
        }
    }
    let rows = rows(&columns, length);
    let is_array = |row: &Row| {
        let mut neighbours = program.state[row.first..row.first + length].windows(2);
        let is_own = |other: &Row| row == other || row.elements().all(|part| other.elements().all(|its| part != its));
        neighbours.all(|pair| (pair[0].ty, pair[0].start) == (pair[1].ty, pair[1].start))
            && row.elements().all(|part| starts_as_declared(part, program))
            && program.path_of_row(*row).is_some()
            && program.rows.iter().chain(&rows).all(is_own)
    };
    let is_read_only = columns
        .iter()
        .all(|(target, _)| *target != by && rows.iter().all(|row| row.elements().all(|element| element != *target)));
    (length >= LEAST && is_read_only && rows.iter().all(is_array)).then_some((by, length, columns))
}

/// Whether `init` leaves a part of the state at its start value.
fn starts_as_declared(part: Var, program: &Program) -> bool {
    let is_start = |statement: &Statement| {
        let Statement::Assign { target: Var::State(index), value: Expr::Literal(value) } = statement else {
            return false;
        };
        Var::State(*index) == part && program.state[*index].start == *value
    };
    program.init.iter().filter(|statement| statement.mentions(part)).all(is_start)
}

/// A question whether a variable is this number: the variable, the rest of the chain, and what it does.
fn question(statement: &Statement, number: usize) -> Option<(Var, &[Statement], &[Statement])> {
    let Statement::If { condition: Expr::Binary(Binary::Equal, left, right), then, otherwise } = statement else {
        return None;
    };
    match (&**left, &**right) {
        // Another task may change an input after the condition.
        (Expr::Var(by @ (Var::State(_) | Var::Local(_))), Expr::Literal(Literal::U32(asked)))
            if *asked as usize == number =>
        {
            Some((*by, otherwise, then))
        }
        _ => None,
    }
}

/// The target of an assignment, and the part of the state that it takes.
fn taken(statement: &Statement) -> Option<(Var, usize)> {
    match statement {
        Statement::Assign { target, value: Expr::Var(Var::State(part)) } => Some((*target, *part)),
        _ => None,
    }
}

/// What a chain does after its first questions.
fn after(statement: &mut Statement, questions: usize) -> Vec<Statement> {
    let Statement::If { otherwise, .. } = statement else { return Vec::new() };
    let mut rest = std::mem::take(otherwise);
    for _ in 1..questions {
        let Some(Statement::If { otherwise, .. }) = rest.pop() else { return Vec::new() };
        rest = otherwise;
    }
    rest
}

/// Checks that an index is below the length of its array wherever an element is read: a condition around the statement compares
/// the same variable, or the one that it copies, with a number up to the length, and nothing assigns it in between.
pub(super) fn verify(program: &Program) -> Result<(), Defect> {
    [&program.init, &program.step].into_iter().try_for_each(|list| verify_list(list, Below::new()))
}

fn verify_list(list: &[Statement], mut below: Below) -> Result<(), Defect> {
    for statement in list {
        let mut outside = None;
        if let Some(expr) = statement.expr() {
            expr.parts(&mut |part| {
                if let Expr::Element(row, index) = part
                    && !below.iter().any(|(var, bound)| **index == Expr::Var(*var) && *bound <= row.length)
                {
                    outside = Some(format!("an element of {row:?} is read at {index:?}, which may be outside"));
                }
            });
        }
        if let Some(message) = outside {
            return Err(Defect { pass: "indexed", message });
        }
        let mut bound = bound(statement);
        for list in statement.branches() {
            verify_list(list, inside(&below, bound.take()))?;
        }
        pass(statement, &mut below);
    }
    Ok(())
}
