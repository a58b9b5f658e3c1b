//! Which named numbers the integers among the signals of a program can be: a mode, a state, the id of a fault. Nothing is changed.

use super::{Expr, Program, Statement, Table, Type, Var};
use portable::{Binary, Literal};
use std::collections::BTreeSet;

/// A signal that is always one of some named numbers.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Signal {
    /// an input or an output
    pub var: Var,
    /// the constants, by position
    pub constants: BTreeSet<usize>,
}

/// The signals for which that is so: outputs that nothing but named numbers reach, and inputs that are only compared with such.
pub fn of_signals(program: &Program) -> Vec<Signal> {
    // Nobody writes the numbers of a parameter set one by one.
    let is_set = |index: &usize| program.in_set(&program.inputs[*index]).is_some();
    let inputs = (0..program.inputs.len()).filter(|index| !is_set(index)).map(Var::Input);
    of_those(program, inputs.chain((0..program.outputs.len()).map(Var::Output)))
}

/// The same of the outputs alone, which costs less.
pub fn of_outputs(program: &Program) -> Vec<Signal> {
    of_those(program, (0..program.outputs.len()).map(Var::Output))
}

fn of_those(program: &Program, signals: impl Iterator<Item = Var>) -> Vec<Signal> {
    let reaching = reaching(program);
    let integers = signals.filter(|var| matches!(program.ty(*var), Some(Type::I32 | Type::U32)));
    let values = |var| match var {
        Var::Input(index) => compared(program, index, &reaching),
        Var::Output(index) => reaching.outputs[index].clone(),
        _ => Values::others(),
    };
    let named = integers.filter_map(|var| Some(Signal { var, constants: values(var).named(program)? }));
    named.filter(|signal| !signal.constants.is_empty()).collect()
}

/// What is known of the values of a variable.
#[derive(Clone, Debug, Default, PartialEq)]
struct Values {
    constants: BTreeSet<usize>,
    literals: Vec<Literal>,
    /// whether anything else may come
    others: bool,
}

impl Values {
    fn others() -> Self {
        Self { others: true, ..Self::default() }
    }

    fn extend(&mut self, more: &Self) {
        self.constants.extend(&more.constants);
        for literal in &more.literals {
            if !self.literals.contains(literal) {
                self.literals.push(*literal);
            }
        }
        self.others |= more.others;
    }

    /// The constants, if each value is that of one of them.
    fn named(self, program: &Program) -> Option<BTreeSet<usize>> {
        let is_named = |literal| self.constants.iter().any(|index| program.constants[*index].value == literal);
        (!self.others && self.literals.iter().all(|literal| is_named(*literal))).then_some(self.constants)
    }
}

/// What reaches every variable, in this cycle or another one.
fn reaching(program: &Program) -> Table<Values> {
    let mut reaching = Table::filled(program, Values::default());
    for index in 0..program.inputs.len() {
        reaching[Var::Input(index)] = Values::others();
    }
    for index in 0..program.constants.len() {
        reaching[Var::Constant(index)] = Values { constants: [index].into(), ..Values::default() };
    }
    for (index, variable) in program.state.iter().enumerate() {
        if !program.init.iter().any(|statement| statement.writes(Var::State(index))) {
            reaching[Var::State(index)] = Values { literals: vec![variable.start], ..Values::default() };
        }
    }
    let mut grows = true;
    while std::mem::take(&mut grows) {
        for statement in program.statements() {
            statement.assignments(&mut |target, value| {
                let mut values = reaching[target].clone();
                values.extend(&of_expression(value, &reaching));
                if values != reaching[target] {
                    reaching[target] = values;
                    grows = true;
                }
            });
        }
    }
    reaching
}

fn of_expression(expr: &Expr, reaching: &Table<Values>) -> Values {
    match expr {
        Expr::Literal(literal) => Values { literals: vec![*literal], ..Values::default() },
        Expr::Var(var) => reaching[*var].clone(),
        Expr::Unary(..) | Expr::Binary(..) | Expr::Intrinsic(..) => Values::others(),
    }
}

/// What an input is compared with, if nothing else is done with it; in its place stands a local that takes it over or is a named number.
fn compared(program: &Program, input: usize, reaching: &Table<Values>) -> Values {
    let input = Var::Input(input);
    let stand_ins = stand_ins(program, input);
    let is_meant = |var: Var| var == input || stand_ins.contains(&var);
    let is_input = |expr: &Expr| matches!(expr, Expr::Var(var) if is_meant(*var));
    let mut values = Values::default();
    let (mut mentioned, mut asked) = (0, 0);
    for statement in program.statements() {
        statement.reads(&mut |var| mentioned += usize::from(is_meant(var)));
        statement.assignments(&mut |target, value| asked += usize::from(is_meant(target) && is_input(value)));
        statement.expressions(&mut |expr| {
            expr.parts(&mut |part| {
                if let Expr::Binary(Binary::Equal | Binary::NotEqual, left, right) = part {
                    for (_, other) in [(left, right), (right, left)].into_iter().filter(|(one, _)| is_input(one)) {
                        asked += 1;
                        values.extend(&of_expression(other, reaching));
                    }
                }
            });
        });
        statement.walk(&mut |inner| {
            if let Statement::Choose { by, arms } = inner
                && is_input(by)
            {
                asked += 1;
                let constant = |label: &Expr| match label {
                    Expr::Var(Var::Constant(index)) => Some(*index),
                    _ => None,
                };
                values.constants.extend(arms.iter().flat_map(|arm| &arm.labels).filter_map(constant));
            }
        });
    }
    values.others |= asked != mentioned;
    values
}

/// The locals that are what an input is, or a named number.
fn stand_ins(program: &Program, input: Var) -> BTreeSet<Var> {
    let (mut takes_over, mut others) = (BTreeSet::new(), BTreeSet::new());
    for statement in program.statements() {
        statement.assignments(&mut |target, value| match value {
            Expr::Var(var) if *var == input => drop(takes_over.insert(target)),
            Expr::Var(Var::Constant(_)) => {}
            _ => drop(others.insert(target)),
        });
    }
    takes_over.into_iter().filter(|var| matches!(var, Var::Local(_)) && !others.contains(var)).collect()
}
