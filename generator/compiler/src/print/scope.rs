//! Where each local is declared: at its only assignment, or just before the branch that first assigns it.

use crate::program::{Statement, Var};

/// For every statement of a list the locals that are declared with it; those that only one branch of it mentions are left
/// to that branch. `declared` knows the locals that an outer list declares, and learns those of this one.
pub(super) fn declarations(list: &[Statement], declared: &mut [bool]) -> Vec<Vec<usize>> {
    let mut seen = Seen { places: vec![None; declared.len()], order: Vec::new() };
    for (position, statement) in list.iter().enumerate() {
        match statement {
            Statement::If { condition, then, otherwise } => {
                condition.variables(&mut |var| seen.note(var, (position, Part::Whole)));
                for (part, branch) in [(Part::Then, then), (Part::Otherwise, otherwise)] {
                    branch.iter().for_each(|inner| inner.variables(&mut |var| seen.note(var, (position, part))));
                }
            }
            other => other.variables(&mut |var| seen.note(var, (position, Part::Whole))),
        }
    }
    let mut here = vec![Vec::new(); list.len()];
    for local in seen.order {
        if let Some((position, Part::Whole)) = seen.places[local]
            && !std::mem::replace(&mut declared[local], true)
        {
            here[position].push(local);
        }
    }
    here
}

/// The part of a statement that mentions a local.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Part {
    Whole,
    Then,
    Otherwise,
}

/// The first statement of a list that mentions each local, and the part of it that alone does.
struct Seen {
    places: Vec<Option<(usize, Part)>>,
    /// the locals, in the order in which they were met
    order: Vec<usize>,
}

impl Seen {
    fn note(&mut self, var: Var, place: (usize, Part)) {
        let Var::Local(local) = var else { return };
        match &mut self.places[local] {
            Some(known) if *known == place => {}
            Some((_, part)) => *part = Part::Whole,
            unknown => {
                *unknown = Some(place);
                self.order.push(local);
            }
        }
    }
}
