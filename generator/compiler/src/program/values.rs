//! Finds the named numbers that the integer signals of a program can have: modes, states, error ids. Nothing is changed.

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

/// The signals with named numbers only: outputs to which only named numbers are assigned, and inputs that are only compared
/// with such.
pub fn of_signals(program: &Program) -> Vec<Signal> {
    // The numbers of a parameter set are not written individually.
    let is_set = |index: &usize| program.in_set(&program.inputs[*index]).is_some();
    let inputs = (0..program.inputs.len()).filter(|index| !is_set(index)).map(Var::Input);
    of_those(program, inputs.chain(outputs(program)))
}

/// The outputs with named numbers only, which takes less time.
pub fn of_outputs(program: &Program) -> Vec<Signal> {
    of_those(program, outputs(program))
}

/// The outputs outside a parameter set that the program makes.
fn outputs(program: &Program) -> impl Iterator<Item = Var> {
    let is_made = |index: &usize| program.in_made(&program.outputs[*index]).is_some();
    (0..program.outputs.len()).filter(move |index| !is_made(index)).map(Var::Output)
}

fn of_those(program: &Program, signals: impl Iterator<Item = Var>) -> Vec<Signal> {
    let reaching = reaching(program);
    let mut compared = None;
    let mut values = |var| match var {
        Var::Input(index) => compared.get_or_insert_with(|| compared_inputs(program, &reaching))[index].clone(),
        Var::Output(index) => reaching.outputs[index].clone(),
        _ => Values::others(),
    };
    let integers = signals.filter(|var| is_integer(program, *var));
    let named = integers.filter_map(|var| Some(Signal { var, constants: values(var).named(program)? }));
    named.filter(|signal| !signal.constants.is_empty()).collect()
}

fn is_integer(program: &Program, var: Var) -> bool {
    matches!(program.ty(var), Some(Type::I32 | Type::U32))
}

/// The known values of a variable.
#[derive(Clone, Debug, Default, PartialEq)]
struct Values {
    constants: BTreeSet<usize>,
    literals: Vec<Literal>,
    /// whether other values are possible
    others: bool,
}

impl Values {
    fn others() -> Self {
        Self { others: true, ..Self::default() }
    }

    /// Adds the values of an expression; returns whether anything was new.
    fn extend(&mut self, expr: &Expr, reaching: &Table<Self>) -> bool {
        let before = (self.constants.len(), self.literals.len(), self.others);
        match expr {
            Expr::Literal(literal) => self.literal(*literal),
            Expr::Var(var) => {
                let more = &reaching[*var];
                self.constants.extend(&more.constants);
                more.literals.iter().for_each(|literal| self.literal(*literal));
                self.others |= more.others;
            }
            Expr::Unary(..) | Expr::Binary(..) | Expr::Intrinsic(..) | Expr::Element(..) => self.others = true,
        }
        before != (self.constants.len(), self.literals.len(), self.others)
    }

    fn literal(&mut self, literal: Literal) {
        if !self.literals.contains(&literal) {
            self.literals.push(literal);
        }
    }

    /// The constants, if each value is that of one of them.
    fn named(self, program: &Program) -> Option<BTreeSet<usize>> {
        let is_named = |literal| self.constants.iter().any(|index| program.constants[*index].value == literal);
        (!self.others && self.literals.iter().all(|literal| is_named(*literal))).then_some(self.constants)
    }
}

/// The values that every integer can have, in this cycle or another one.
fn reaching(program: &Program) -> Table<Values> {
    let mut reaching = Table::filled(program, Values::default());
    reaching.inputs.fill(Values::others());
    for index in (0..program.constants.len()).filter(|index| is_integer(program, Var::Constant(*index))) {
        reaching.constants[index].constants.insert(index);
    }
    let mut is_set = vec![false; program.state.len()];
    for statement in &program.init {
        statement.assignments(&mut |target, _| {
            if let Var::State(index) = target {
                is_set[index] = true;
            }
        });
    }
    for (index, variable) in program.state.iter().enumerate().filter(|(index, _)| !is_set[*index]) {
        reaching.state[index] = Values { literals: vec![variable.start], ..Values::default() };
    }
    let mut assigned = Vec::new();
    for statement in program.statements() {
        statement.assignments(&mut |target, value| {
            if is_integer(program, target) {
                assigned.push((target, value));
            }
        });
    }
    let mut grows = true;
    while std::mem::take(&mut grows) {
        for (target, value) in &assigned {
            if !reaching[*target].others {
                let mut values = std::mem::take(&mut reaching[*target]);
                grows |= values.extend(value, &reaching);
                reaching[*target] = values;
            }
        }
    }
    reaching
}

/// The values with which each input is compared, if it is not used otherwise. The comparison may be with a local that copies
/// it or is a named number.
fn compared_inputs(program: &Program, reaching: &Table<Values>) -> Vec<Values> {
    let meant = meant(program);
    let input = |expr: &Expr| if let Expr::Var(var) = expr { meant[*var] } else { None };
    let constant = |label: &Expr| if let Expr::Var(Var::Constant(index)) = label { Some(*index) } else { None };
    let mut values = vec![Values::default(); program.inputs.len()];
    let mut other_uses = vec![0; values.len()];
    for statement in program.statements() {
        statement.reads(&mut |var| meant[var].into_iter().for_each(|input| other_uses[input] += 1));
        statement.walk(&mut |inner| match inner {
            Statement::Assign { target, value } => {
                let taken_over = input(value).filter(|input| meant[*target] == Some(*input));
                taken_over.into_iter().for_each(|input| other_uses[input] -= 1);
            }
            Statement::Choose { by, arms } => {
                if let Some(input) = input(by) {
                    other_uses[input] -= 1;
                    values[input].constants.extend(arms.iter().flat_map(|arm| &arm.labels).filter_map(constant));
                }
            }
            Statement::Note(_) | Statement::If { .. } | Statement::Apart(_) => {}
        });
        statement.expressions(&mut |expr| {
            expr.parts(&mut |part| {
                let Expr::Binary(Binary::Equal | Binary::NotEqual, left, right) = part else { return };
                for (one, other) in [(left, right), (right, left)] {
                    if let Some(input) = input(one) {
                        other_uses[input] -= 1;
                        values[input].extend(other, reaching);
                    }
                }
            });
        });
    }
    values.iter_mut().zip(other_uses).for_each(|(values, other_uses)| values.others |= other_uses != 0);
    values
}

/// The input that each variable represents: itself, or the one that a local copies, if the local is otherwise only a named
/// number.
fn meant(program: &Program) -> Table<Option<usize>> {
    let mut meant = Table::filled(program, None);
    let mut is_other = Table::filled(program, false);
    for statement in program.statements() {
        statement.assignments(&mut |target, value| match value {
            Expr::Var(Var::Input(input)) => {
                is_other[target] |= meant[target].replace(*input).is_some_and(|before| before != *input);
            }
            Expr::Var(Var::Constant(_)) => {}
            _ => is_other[target] = true,
        });
    }
    meant.outputs.fill(None);
    meant.state.fill(None);
    meant.locals.iter_mut().zip(is_other.locals).filter(|(_, is_other)| *is_other).for_each(|(meant, _)| *meant = None);
    meant.inputs.iter_mut().enumerate().for_each(|(index, meant)| *meant = Some(index));
    meant
}
