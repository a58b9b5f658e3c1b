//! Lets a new value of a variable replace its old one, if nothing needs the old one any more: a person would not declare a
//! second variable for it. Only values of one name share a variable, and only if one of them is a copy of the other on some
//! path.
//!
//! ```text
//! lag := a - b;                                    lag := a - b;
//! if c { lag_2 := lag } else { lag_2 := 0 }   ->   if not c { lag := 0 }
//! ```

use super::presumed::leave_out;
use crate::pass::Defect;
use crate::pass::prune::retain;
use crate::program::{Expr, Origin, Program, Statement, Var, rename};

pub(super) fn run(mut program: Program) -> Result<Program, Defect> {
    let copies = copies(&program);
    if copies.is_empty() {
        return Ok(program);
    }
    let empty = Set(vec![0; program.locals.len().div_ceil(64)]);
    let mut lives = Lives { copied: empty.clone(), conflicts: vec![empty.clone(); program.locals.len()] };
    copies.iter().flatten().for_each(|local| lives.copied.insert(*local));
    lives.before(&program.step, &mut empty.clone());
    let shared = variables(program.locals.len(), &copies, &lives.conflicts);
    rename(&mut program.step, &|var| match var {
        Var::Local(local) => Var::Local(shared[local]),
        var => var,
    });
    leave_out(&mut program.step, &|statement| match statement {
        Statement::Assign { target, value: Expr::Var(source) } => target == source,
        _ => false,
    });
    drop_unused(&mut program);
    // A branch without statements is left out, and its condition negated.
    super::negation::run(program)
}

/// Target and source of each copy of a local to another one with its name.
fn copies(program: &Program) -> Vec<[usize; 2]> {
    let mut copies = Vec::new();
    for statement in &program.step {
        statement.assignments(&mut |target, value| {
            if let (Var::Local(target), Expr::Var(Var::Local(source))) = (target, value)
                && program.locals[target] == program.locals[*source]
            {
                copies.push([target, *source]);
            }
        });
    }
    copies
}

/// A set of locals.
#[derive(Clone)]
struct Set(Vec<u64>);

impl Set {
    fn insert(&mut self, local: usize) {
        self.0[local / 64] |= 1 << (local % 64);
    }

    fn remove(&mut self, local: usize) {
        self.0[local / 64] &= !(1 << (local % 64));
    }

    fn has(&self, local: usize) -> bool {
        self.0[local / 64] & 1 << (local % 64) != 0
    }

    fn extend(&mut self, other: &Self) {
        self.0.iter_mut().zip(&other.0).for_each(|(word, other)| *word |= other);
    }
}

/// What is needed when.
struct Lives {
    /// the locals that are copied, or are copies; the others are left out everywhere
    copied: Set,
    /// for each local those whose values are still needed where it is assigned
    conflicts: Vec<Set>,
}

impl Lives {
    /// Changes the locals that are needed after a list of statements into those that are needed before it.
    fn before(&mut self, list: &[Statement], needed: &mut Set) {
        for statement in list.iter().rev() {
            if let Statement::Assign { target: Var::Local(target), value } = statement
                && self.copied.has(*target)
            {
                let mut others = needed.clone();
                others.remove(*target);
                if let Expr::Var(Var::Local(source)) = value {
                    others.remove(*source); // both have this value
                }
                self.conflicts[*target].extend(&others);
                needed.remove(*target);
            }
            let mut branches = statement.branches().map(|branch| {
                let mut inside = needed.clone();
                self.before(branch, &mut inside);
                inside
            });
            if let Some(mut all) = branches.next() {
                branches.for_each(|inside| all.extend(&inside));
                *needed = all;
            }
            if let Some(expr) = statement.expr() {
                expr.variables(&mut |var| {
                    if let Var::Local(local) = var
                        && self.copied.has(local)
                    {
                        needed.insert(local);
                    }
                });
            }
        }
    }
}

/// For each local the one whose variable it uses.
fn variables(locals: usize, copies: &[[usize; 2]], conflicts: &[Set]) -> Vec<usize> {
    let mut shared: Vec<usize> = (0..locals).collect();
    for [target, source] in copies {
        let [one, other] = [shared[*target], shared[*source]];
        let sharers = |of| (0..locals).filter(|local| shared[*local] == of).collect::<Vec<_>>();
        let others = sharers(other);
        let is_free = |a: usize, b: usize| !conflicts[a].has(b) && !conflicts[b].has(a);
        if one != other && sharers(one).iter().all(|a| others.iter().all(|b| is_free(*a, *b))) {
            shared.iter_mut().filter(|of| **of == one.max(other)).for_each(|of| *of = one.min(other));
        }
    }
    shared
}

/// Removes the locals that no statement mentions any more.
pub(super) fn drop_unused(program: &mut Program) {
    let mut is_used = vec![false; program.locals.len()];
    program.statements().for_each(|statement| {
        statement.variables(&mut |var| {
            if let Var::Local(local) = var {
                is_used[local] = true;
            }
        });
    });
    if is_used.iter().all(|is_used| *is_used) {
        return;
    }
    let mut places = vec![usize::MAX; is_used.len()];
    retain(&mut program.locals, &is_used, &mut places, |_| Origin::Function);
    let renamed = |var| match var {
        Var::Local(local) => Var::Local(places[local]),
        var => var,
    };
    rename(&mut program.step, &renamed);
    rename(&mut program.init, &renamed);
}
