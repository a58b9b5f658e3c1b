//! Removes what no output depends on: locals, state, branches, constants. Inputs and outputs stay, they are the interface.

use super::Defect;
use crate::program::{Expr, Program, Statement, Var, rename};

/// Runs the pass.
///
/// # Errors
/// None.
pub fn run(mut program: Program) -> Result<Program, Defect> {
    let live = live_variables(&program);
    program.init = keep(program.init, &live);
    program.step = keep(program.step, &live);
    number_afresh(program)
}

/// A set of variables of one program.
struct Marks {
    marked: [Vec<bool>; 5],
    count: usize,
}

impl Marks {
    /// The empty set.
    fn of(program: &Program) -> Self {
        let Program { inputs, outputs, state, constants, locals, .. } = program;
        let lengths = [inputs.len(), outputs.len(), state.len(), constants.len(), locals.len()];
        Self { marked: lengths.map(|length| vec![false; length]), count: 0 }
    }

    fn mark(&mut self, var: Var) {
        let (space, index) = Self::place(var);
        self.count += usize::from(!self.marked[space][index]);
        self.marked[space][index] = true;
    }

    fn has(&self, var: Var) -> bool {
        let (space, index) = Self::place(var);
        self.marked[space][index]
    }

    fn place(var: Var) -> (usize, usize) {
        match var {
            Var::Input(index) => (0, index),
            Var::Output(index) => (1, index),
            Var::State(index) => (2, index),
            Var::Constant(index) => (3, index),
            Var::Local(index) => (4, index),
        }
    }
}

/// The variables that an output depends on, in this cycle or a later one.
fn live_variables(program: &Program) -> Marks {
    let mut live = Marks::of(program);
    (0..program.outputs.len()).for_each(|output| live.mark(Var::Output(output)));
    loop {
        let known = live.count;
        for statement in program.step.iter().chain(&program.init).rev() {
            mark(statement, &mut live);
        }
        if live.count == known {
            return live;
        }
    }
}

/// Marks what the live part of a statement reads; tells whether there is such a part.
fn mark(statement: &Statement, live: &mut Marks) -> bool {
    match statement {
        Statement::Note(_) => false,
        Statement::Assign { target, value } => {
            let alive = live.has(*target);
            if alive {
                value.variables(&mut |var| live.mark(var));
            }
            alive
        }
        Statement::If { condition, then, otherwise } => {
            let mut alive = false;
            for inner in then.iter().chain(otherwise).rev() {
                alive |= mark(inner, live);
            }
            if alive {
                condition.variables(&mut |var| live.mark(var));
            }
            alive
        }
    }
}

fn keep(statements: Vec<Statement>, live: &Marks) -> Vec<Statement> {
    statements
        .into_iter()
        .filter_map(|statement| match statement {
            Statement::Assign { target, .. } if !live.has(target) => None,
            Statement::If { condition, then, otherwise } => {
                let (then, otherwise) = (keep(then, live), keep(otherwise, live));
                let only_notes = |list: &[Statement]| list.iter().all(|inner| matches!(inner, Statement::Note(_)));
                match (only_notes(&then), only_notes(&otherwise)) {
                    (true, true) => None,
                    (true, false) => {
                        let condition = Expr::Unary(portable::Unary::Not, Box::new(condition));
                        Some(Statement::If { condition, then: otherwise, otherwise: Vec::new() })
                    }
                    (false, true) => Some(Statement::If { condition, then, otherwise: Vec::new() }),
                    (false, false) => Some(Statement::If { condition, then, otherwise }),
                }
            }
            other => Some(other),
        })
        .collect()
}

/// Drops the variables that nothing mentions any more and numbers the others afresh; constants in their declared order.
fn number_afresh(mut program: Program) -> Result<Program, Defect> {
    let mut mentioned = Marks::of(&program);
    for statement in program.init.iter().chain(&program.step) {
        statement.targets(&mut |var| mentioned.mark(var));
        statement.expressions(&mut |expr| expr.variables(&mut |var| mentioned.mark(var)));
    }
    let state = order(program.state.len(), |index| mentioned.has(Var::State(index)));
    let locals = order(program.locals.len(), |index| mentioned.has(Var::Local(index)));
    let mut constants = order(program.constants.len(), |index| mentioned.has(Var::Constant(index)));
    constants.sort_by_key(|index| program.constants[*index].origin);
    let (new_state, new_locals, new_constants) = (inverse(&state), inverse(&locals), inverse(&constants));
    let renamed = |var: Var| match var {
        Var::State(index) => Var::State(new_state[index]),
        Var::Local(index) => Var::Local(new_locals[index]),
        Var::Constant(index) => Var::Constant(new_constants[index]),
        interface => interface,
    };
    for body in [&mut program.init, &mut program.step] {
        *body = rename(std::mem::take(body), &renamed);
    }
    program.state = state.iter().map(|index| program.state[*index].clone()).collect();
    program.locals = locals.iter().map(|index| program.locals[*index].clone()).collect();
    program.constants = constants.iter().map(|index| program.constants[*index].clone()).collect();
    Ok(program)
}

/// The positions that are kept.
fn order(len: usize, kept: impl Fn(usize) -> bool) -> Vec<usize> {
    (0..len).filter(|index| kept(*index)).collect()
}

/// From the old position to the new one.
fn inverse(kept: &[usize]) -> Vec<usize> {
    let mut new = vec![usize::MAX; kept.iter().max().map_or(0, |last| last + 1)];
    for (position, old) in kept.iter().enumerate() {
        new[*old] = position;
    }
    new
}
