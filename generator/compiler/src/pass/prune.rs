//! Removes what no output depends on: locals, state, branches, constants. Inputs and outputs stay, they are the interface.

use super::Defect;
use crate::program::{Expr, Program, Statement, Var, rename, rewrite};

/// Runs the pass.
///
/// # Errors
/// None.
pub fn run(mut program: Program) -> Result<Program, Defect> {
    let live = live_variables(&program);
    keep(&mut program.init, &live);
    keep(&mut program.step, &live);
    Ok(number_afresh(program))
}

/// A set of variables of one program.
struct Marks {
    marked: [Vec<bool>; 5],
    count: usize,
}

impl Marks {
    /// The empty set.
    fn empty(program: &Program) -> Self {
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
    let mut live = Marks::empty(program);
    (0..program.outputs.len()).for_each(|output| live.mark(Var::Output(output)));
    loop {
        let known = live.count;
        for statement in program.statements().rev() {
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

fn keep(list: &mut Vec<Statement>, live: &Marks) {
    let only_notes = |list: &[Statement]| list.iter().all(|inner| matches!(inner, Statement::Note(_)));
    rewrite(list, &mut |statement, list| match statement {
        Statement::Assign { target, .. } if !live.has(target) => {}
        Statement::If { condition, then, otherwise } => match (only_notes(&then), only_notes(&otherwise)) {
            (true, true) => {}
            (true, false) => {
                let condition = Expr::Unary(portable::Unary::Not, Box::new(condition));
                list.push(Statement::If { condition, then: otherwise, otherwise: Vec::new() });
            }
            (false, true) => list.push(Statement::If { condition, then, otherwise: Vec::new() }),
            (false, false) => list.push(Statement::If { condition, then, otherwise }),
        },
        other => list.push(other),
    });
}

/// Drops the variables that nothing mentions any more and numbers the others afresh; constants in their declared order.
fn number_afresh(mut program: Program) -> Program {
    let mut mentioned = Marks::empty(&program);
    program.statements().for_each(|statement| statement.variables(&mut |var| mentioned.mark(var)));
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
    rename(&mut program.init, &renamed);
    rename(&mut program.step, &renamed);
    if let Some(switch) = &mut program.switch {
        switch.busy = switch.busy.filter(|busy| mentioned.has(*busy)).map(renamed);
    }
    retain(&mut program.state, &state);
    retain(&mut program.locals, &locals);
    retain(&mut program.constants, &constants);
    program
}

/// The items at some positions, each once, in their order.
fn retain<T>(items: &mut Vec<T>, kept: &[usize]) {
    let mut old: Vec<Option<T>> = std::mem::take(items).into_iter().map(Some).collect();
    items.extend(kept.iter().filter_map(|index| old[*index].take()));
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
