//! Facts about the variables at one point of a program: answers to conditions, ranges of integers. No statement is changed
//! here.

use super::condition::{Comparison, Condition, Conditions, Id};
use crate::program::{Expr, Var};
use portable::Literal;

/// The facts at the present point. Each list only grows while a condition is examined, so that a mark can restore the
/// earlier state.
#[derive(Clone, Default)]
pub(super) struct Facts {
    /// to questions that do not compare an integer with a known number
    answers: Vec<(usize, bool)>,
    /// an `or` that is true or an `and` that is false: it is not known yet which operand decides
    open: Vec<(Id, bool)>,
    /// smallest and largest value of an integer; the last entry of a variable applies
    ranges: Vec<(Var, (i64, i64))>,
    /// a value that an integer does not have
    excluded: Vec<(Var, i64)>,
    /// the condition assigned to a flag: its answer is that of the condition
    flags: Vec<(Var, Id)>,
}

impl Facts {
    /// The condition, simplified by all known answers.
    pub(super) fn simplify(&mut self, conditions: &mut Conditions<'_>, id: Id) -> Id {
        let simpler = match conditions.all[id] {
            Condition::Not(operand) => {
                let simpler = self.simplify(conditions, operand);
                if simpler == operand { id } else { conditions.add(Condition::Not(simpler)) }
            }
            Condition::Both(and, left, right) => {
                // Each operand matters only if the other one has not decided.
                let second = self.simplify_beside(conditions, and, left, right);
                let first = self.simplify_beside(conditions, and, second, left);
                let is_same = (first, second) == (left, right);
                if is_same { id } else { conditions.add(Condition::Both(and, first, second)) }
            }
            Condition::Known(_) | Condition::Question(_) => id,
        };
        self.answer(conditions, simpler).map_or(simpler, |holds| conditions.add(Condition::Known(holds)))
    }

    /// Simplifies an operand of an `and` or an `or` for the case that the other operand does not decide.
    fn simplify_beside(&mut self, conditions: &mut Conditions<'_>, and: bool, other: Id, operand: Id) -> Id {
        let mark = [self.answers.len(), self.open.len(), self.ranges.len(), self.excluded.len()];
        self.note(conditions, other, and);
        let simpler = self.simplify(conditions, operand);
        self.answers.truncate(mark[0]);
        self.open.truncate(mark[1]);
        self.ranges.truncate(mark[2]);
        self.excluded.truncate(mark[3]);
        simpler
    }

    /// From here on the condition is true, or false.
    pub(super) fn learn(&mut self, conditions: &mut Conditions<'_>, id: Id, holds: bool) {
        self.note(conditions, id, holds);
        // New facts may decide an open `and` or `or`, or leave one operand of it.
        let mut position = 0;
        while position < self.open.len() {
            let (before, holds) = self.open.remove(position);
            let after = self.simplify(conditions, before);
            if after == before {
                self.open.insert(position, (before, holds));
                position += 1;
            } else {
                self.note(conditions, after, holds);
                position = 0;
            }
        }
    }

    /// Learns the condition alone, without conclusions from open conditions.
    fn note(&mut self, conditions: &Conditions<'_>, id: Id, holds: bool) {
        match conditions.all[id] {
            Condition::Known(_) => {}
            Condition::Not(operand) => self.note(conditions, operand, !holds),
            Condition::Both(and, left, right) if and == holds => {
                self.note(conditions, left, holds);
                self.note(conditions, right, holds);
            }
            Condition::Both(..) => self.open.push((id, holds)),
            Condition::Question(index) => match &conditions.questions[index].comparison {
                Some(comparison) => self.narrow(comparison, holds),
                None => {
                    self.answers.push((index, holds));
                    let Expr::Var(asked) = conditions.questions[index].expr else { return };
                    if let Some((_, meant)) = self.flags.iter().find(|(flag, _)| *flag == asked).copied() {
                        self.note(conditions, meant, holds);
                    }
                }
            },
        }
    }

    /// Assigns a value to a variable: facts about the old value are forgotten.
    pub(super) fn assign(&mut self, conditions: &mut Conditions<'_>, target: Var, value: &Expr) {
        let range = match value {
            Expr::Var(var) if self.range(*var).is_some() => self.range(*var),
            value => conditions.integer(value).map(|(number, _)| (number, number)),
        };
        if conditions.asked[target] {
            self.answers.retain(|(index, _)| !conditions.questions[*index].expr.mentions(target));
            self.open.retain(|(id, _)| !conditions.mentions(*id, target));
            self.flags.retain(|(flag, meant)| *flag != target && !conditions.mentions(*meant, target));
        }
        self.excluded.retain(|(var, _)| *var != target);
        self.ranges.retain(|(var, _)| *var != target);
        self.ranges.extend(range.map(|range| (target, range)));
        if let Expr::Literal(Literal::Bool(value)) = value {
            let id = conditions.number(&Expr::Var(target));
            self.note(conditions, id, *value);
        }
        if let Expr::Var(source) = value
            && conditions.asked[*source]
        {
            self.copy(conditions, target, *source);
        }
    }

    /// Records that a flag has been assigned a condition; from here on the flag is a question itself.
    pub(super) fn mean(&mut self, conditions: &mut Conditions<'_>, flag: Var, meant: Id) {
        if !matches!(conditions.all[meant], Condition::Known(_)) && !conditions.mentions(meant, flag) {
            conditions.number(&Expr::Var(flag));
            self.flags.push((flag, meant));
        }
    }

    /// Copies the facts about a variable to its copy.
    fn copy(&mut self, conditions: &mut Conditions<'_>, target: Var, source: Var) {
        for position in 0..self.answers.len() {
            let (index, holds) = self.answers[position];
            let known = &conditions.questions[index].expr;
            if !known.mentions(source) || known.mentions(target) {
                continue;
            }
            let mut question = known.clone();
            question.change(&mut |part| {
                if *part == Expr::Var(source) {
                    *part = Expr::Var(target);
                }
            });
            let id = conditions.number(&question);
            self.note(conditions, id, holds);
        }
    }

    /// The facts after two branches: those that hold after both.
    pub(super) fn join(&mut self, other: &Self) {
        self.answers.retain(|fact| other.answers.contains(fact));
        self.open.retain(|fact| other.open.contains(fact));
        self.excluded.retain(|(var, number)| other.is_excluded(*var, *number));
        self.flags.retain(|flag| other.flags.contains(flag));
        let mut ranges: Vec<(Var, (i64, i64))> = Vec::new();
        for (var, (a, b)) in self.ranges.drain(..).rev() {
            if ranges.iter().all(|(known, _)| *known != var) {
                ranges.extend(other.range(var).map(|(c, d)| (var, (a.min(c), b.max(d)))));
            }
        }
        self.ranges = ranges;
    }

    fn range(&self, var: Var) -> Option<(i64, i64)> {
        self.ranges.iter().rfind(|(known, _)| *known == var).map(|(_, range)| *range)
    }

    fn is_excluded(&self, var: Var, number: i64) -> bool {
        let outside = self.range(var).is_some_and(|(low, high)| number < low || number > high);
        outside || self.excluded.contains(&(var, number))
    }

    fn answer(&self, conditions: &Conditions<'_>, id: Id) -> Option<bool> {
        let found = match conditions.all[id] {
            Condition::Known(value) => return Some(value),
            Condition::Question(index) => match &conditions.questions[index].comparison {
                Some(comparison) => return self.compare(comparison),
                None => self.answers.iter().find(|(known, holds)| conditions.implies(*known, *holds, index)),
            },
            _ => self.open.iter().find(|(open, _)| *open == id),
        };
        found.map(|(_, holds)| *holds)
    }

    fn compare(&self, comparison: &Comparison) -> Option<bool> {
        let Comparison { var, answer, within: (first, last), full } = *comparison;
        let (low, high) = self.range(var).unwrap_or(full);
        let is_within = first <= low && high <= last;
        let is_beyond = high < first || last < low || first == last && self.is_excluded(var, first);
        (is_within || is_beyond).then_some(is_within == answer)
    }

    fn narrow(&mut self, comparison: &Comparison, holds: bool) {
        let Comparison { var, answer, within: (first, last), full } = *comparison;
        let (low, high) = self.range(var).unwrap_or(full);
        let range = if holds == answer {
            (low.max(first), high.min(last))
        } else if first == full.0 {
            (low.max(last + 1), high)
        } else if last == full.1 {
            (low, high.min(first - 1))
        } else {
            self.excluded.push((var, first));
            (if low == first { low + 1 } else { low }, if high == last { high - 1 } else { high })
        };
        self.ranges.push((var, range));
    }
}
