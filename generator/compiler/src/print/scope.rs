//! The declaration of each local: at its only assignment, or just before the branch that first assigns it.

use crate::program::{Statement, Var};

/// For every statement of a list the locals that are declared with it; a local that only one branch of it mentions is
/// declared in that branch. `declared` contains the locals that an outer list declares, and is extended by those of this
/// one.
pub(super) fn declarations(list: &[Statement], declared: &mut [bool]) -> Vec<Vec<usize>> {
    // The first statement that mentions each local; with its branch, if nothing else mentions the local.
    let mut places: Vec<Option<(usize, Option<usize>)>> = vec![None; declared.len()];
    let mut order = Vec::new();
    let mut note = |var: Var, position: usize, branch: Option<usize>| {
        let Var::Local(local) = var else { return };
        match &mut places[local] {
            Some(known) if *known == (position, branch) => {}
            Some((_, branch)) => *branch = None,
            unknown => {
                *unknown = Some((position, branch));
                order.push(local);
            }
        }
    };
    for (position, statement) in list.iter().enumerate() {
        if let Statement::Assign { target, .. } = statement {
            note(*target, position, None);
        }
        if let Some(expr) = statement.expr() {
            expr.variables(&mut |var| note(var, position, None));
        }
        for (branch, list) in statement.branches().enumerate() {
            list.iter().for_each(|inner| inner.variables(&mut |var| note(var, position, Some(branch))));
        }
    }
    let mut here = vec![Vec::new(); list.len()];
    for local in order {
        if let Some((position, None)) = places[local]
            && !std::mem::replace(&mut declared[local], true)
        {
            here[position].push(local);
        }
    }
    here
}
