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
use crate::program::{Expr, Program, Statement, Var, rename};

pub(super) fn run(mut program: Program) -> Result<Program, Defect> {
    let mut lives = Lives { conflicts: vec![Set::new(program.locals.len()); program.locals.len()] };
    lives.before(&program.step, &mut Set::new(program.locals.len()));
    let shared = variables(&program, &lives.conflicts);
    rename(&mut program.step, &|var| match var {
        Var::Local(local) => Var::Local(shared[local]),
        var => var,
    });
    for local in (0..program.locals.len()).filter(|local| shared[*local] == *local).map(Var::Local) {
        leave_out(&mut program.step, local, &Expr::Var(local));
    }
    drop_unused(&mut program);
    Ok(program)
}

/// A set of locals.
#[derive(Clone)]
struct Set(Vec<u64>);

impl Set {
    fn new(locals: usize) -> Self {
        Self(vec![0; locals.div_ceil(64)])
    }

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

/// For each local those whose values are still needed where it is assigned.
struct Lives {
    conflicts: Vec<Set>,
}

impl Lives {
    /// Changes the locals that are needed after a list of statements into those that are needed before it.
    fn before(&mut self, list: &[Statement], needed: &mut Set) {
        for statement in list.iter().rev() {
            if let Statement::Assign { target: Var::Local(target), value } = statement {
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
                    if let Var::Local(local) = var {
                        needed.insert(local);
                    }
                });
            }
        }
    }
}

/// For each local the one whose variable it uses.
fn variables(program: &Program, conflicts: &[Set]) -> Vec<usize> {
    let mut shared: Vec<usize> = (0..program.locals.len()).collect();
    let mut share = |target: usize, source: usize| {
        let [one, other] = [shared[target], shared[source]];
        if one == other || program.locals[target] != program.locals[source] {
            return;
        }
        let sharers = |of| (0..shared.len()).filter(|local| shared[*local] == of).collect::<Vec<_>>();
        let others = sharers(other);
        let is_free = |a: usize, b: usize| !conflicts[a].has(b) && !conflicts[b].has(a);
        if sharers(one).iter().all(|a| others.iter().all(|b| is_free(*a, *b))) {
            shared.iter_mut().filter(|of| **of == one.max(other)).for_each(|of| *of = one.min(other));
        }
    };
    for statement in &program.step {
        statement.assignments(&mut |target, value| {
            if let (Var::Local(target), Expr::Var(Var::Local(source))) = (target, value) {
                share(target, *source);
            }
        });
    }
    shared
}

/// Removes the locals that no statement mentions any more.
fn drop_unused(program: &mut Program) {
    let mut is_used = vec![false; program.locals.len()];
    program.statements().for_each(|statement| {
        statement.variables(&mut |var| {
            if let Var::Local(local) = var {
                is_used[local] = true;
            }
        });
    });
    let mut places = Vec::with_capacity(is_used.len());
    let mut kept = 0;
    for used in &is_used {
        places.push(kept);
        kept += usize::from(*used);
    }
    let renamed = |var| match var {
        Var::Local(local) => Var::Local(places[local]),
        var => var,
    };
    rename(&mut program.step, &renamed);
    rename(&mut program.init, &renamed);
    let mut used = is_used.iter();
    program.locals.retain(|_| used.next() == Some(&true));
}
