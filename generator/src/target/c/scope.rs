//! Where each local is declared: at its only assignment, or just before the branch that first assigns it.

use crate::program::{Statement, Var};
use std::collections::BTreeSet;

/// The locals that a list of statements declares itself, with the statement before which each stands. Those that only
/// one branch of one statement mentions are left to that branch.
pub fn declared_here(list: &[Statement], candidates: &BTreeSet<usize>) -> Vec<(usize, usize)> {
    let mentioned: Vec<BTreeSet<usize>> = list.iter().map(locals).collect();
    let mut declared = Vec::new();
    for local in candidates {
        let mut mentions = mentioned.iter().enumerate().filter(|(_, locals)| locals.contains(local));
        let Some((first, _)) = mentions.next() else { continue };
        if mentions.next().is_some() || !within_one_branch(&list[first], *local) {
            declared.push((first, *local));
        }
    }
    declared
}

/// The locals that a statement or one inside it mentions.
pub fn locals(statement: &Statement) -> BTreeSet<usize> {
    let mut found = BTreeSet::new();
    let mut add = |var| {
        if let Var::Local(local) = var {
            found.insert(local);
        }
    };
    statement.targets(&mut add);
    statement.expressions(&mut |expr| expr.variables(&mut add));
    found
}

fn within_one_branch(statement: &Statement, local: usize) -> bool {
    let Statement::If { condition, then, otherwise } = statement else { return false };
    let mut in_condition = false;
    condition.variables(&mut |var| in_condition |= var == Var::Local(local));
    let mentions = |branch: &[Statement]| branch.iter().any(|inner| inner.mentions(Var::Local(local)));
    !in_condition && mentions(then) != mentions(otherwise)
}
