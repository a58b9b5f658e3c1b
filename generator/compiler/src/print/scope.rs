//! Where each local is declared: at its only assignment, or just before the branch that first assigns it.

use crate::program::{Statement, Var};

/// For every statement of a list the locals that are declared with it; those that only one branch of it mentions are left
/// to that branch. `declared` knows the locals that an outer list declares, and learns those of this one.
pub(super) fn declarations(list: &[Statement], declared: &mut [bool]) -> Vec<Vec<usize>> {
    // The first statement that mentions each local; with its branch, if nothing else mentions the local.
    let mut places: Vec<Option<(usize, Option<bool>)>> = vec![None; declared.len()];
    let mut order = Vec::new();
    let mut note = |var: Var, position: usize, branch: Option<bool>| {
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
        match statement {
            Statement::If { condition, then, otherwise } => {
                condition.variables(&mut |var| note(var, position, None));
                then.iter().for_each(|inner| inner.variables(&mut |var| note(var, position, Some(true))));
                otherwise.iter().for_each(|inner| inner.variables(&mut |var| note(var, position, Some(false))));
            }
            other => other.variables(&mut |var| note(var, position, None)),
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
