//! Where each local is declared: at its only assignment, or just before the branch that first assigns it.

use compiler::program::{Expr, Statement, Var};

/// For every statement of a list the locals that are declared with it; those that only one branch of it mentions are left
/// to that branch. `declared` knows the locals that an outer list declares, and learns those of this one.
pub fn declarations(list: &[Statement], declared: &mut [bool]) -> Vec<Vec<usize>> {
    let mut seen: Vec<Seen> = Vec::new();
    for (position, statement) in list.iter().enumerate() {
        mentions(statement, &mut |local| {
            if declared[local] {
                return;
            }
            match seen.iter_mut().find(|seen| seen.local == local) {
                Some(seen) => seen.again |= seen.first != position,
                None => seen.push(Seen { local, first: position, again: false }),
            }
        });
    }
    let mut here = vec![Vec::new(); list.len()];
    for Seen { local, first, again } in seen {
        if again || !within_one_branch(&list[first], local) {
            here[first].push(local);
            declared[local] = true;
        }
    }
    here
}

/// A local that a list mentions.
struct Seen {
    local: usize,
    /// the first statement that mentions it
    first: usize,
    /// whether another one does
    again: bool,
}

/// Calls `visit` for every local that a statement mentions, as often as it does.
fn mentions(statement: &Statement, visit: &mut dyn FnMut(usize)) {
    let mut local = |var| {
        if let Var::Local(local) = var {
            visit(local);
        }
    };
    statement.targets(&mut local);
    statement.expressions(&mut |expr| expr.variables(&mut local));
}

fn within_one_branch(statement: &Statement, local: usize) -> bool {
    let Statement::If { condition, then, otherwise } = statement else { return false };
    let reads = |expr: &Expr| {
        let mut found = false;
        expr.variables(&mut |var| found |= var == Var::Local(local));
        found
    };
    let mentioned = |branch: &[Statement]| branch.iter().any(|inner| inner.mentions(Var::Local(local)));
    !reads(condition) && mentioned(then) != mentioned(otherwise)
}
