//! What is known of the variables at one point of a program: answers to conditions, ranges of integers. No statement is
//! changed here.

use crate::program::{Constant, Expr, Var};
use portable::{Binary, Literal, Unary};
use std::collections::{BTreeMap, BTreeSet};

/// What holds at the present point.
#[derive(Clone)]
pub(super) struct Facts<'p> {
    constants: &'p [Constant],
    /// questions whose answer is known, none of them with an `and` or an `or` at its top
    answers: Vec<(Expr, bool)>,
    /// an `or` that holds or an `and` that does not hold: which operand decides is not known yet
    open: Vec<(Expr, bool)>,
    /// smallest and largest value of an integer
    ranges: BTreeMap<Var, (i64, i64)>,
    /// a value that an integer does not have
    excluded: BTreeSet<(Var, i64)>,
}

/// The comparison of an integer variable with a known number.
struct Comparison {
    var: Var,
    operator: Binary,
    number: i64,
    /// smallest and largest value of the type
    full: (i64, i64),
}

impl<'p> Facts<'p> {
    pub fn none(constants: &'p [Constant]) -> Self {
        let (answers, open) = (Vec::new(), Vec::new());
        Self { constants, answers, open, ranges: BTreeMap::new(), excluded: BTreeSet::new() }
    }

    /// The condition with everything replaced whose answer is known.
    pub fn simplify(&self, condition: Expr) -> Expr {
        let simpler = match condition {
            Expr::Unary(Unary::Not, operand) => Expr::Unary(Unary::Not, Box::new(self.simplify(*operand))),
            Expr::Binary(operator @ (Binary::And | Binary::Or), left, right) => {
                // Each operand matters only where the other one has not decided.
                let right = self.beside(operator, &left).simplify(*right);
                let left = self.beside(operator, &right).simplify(*left);
                Expr::Binary(operator, Box::new(left), Box::new(right))
            }
            question => question,
        };
        let simpler = without_literals(simpler);
        self.answer(&simpler).map_or(simpler, |holds| Expr::Literal(Literal::Bool(holds)))
    }

    /// What holds where an operand of an `and` or an `or` leaves the answer to the other one.
    fn beside(&self, operator: Binary, operand: &Expr) -> Self {
        let mut facts = self.clone();
        facts.learn(operand, operator == Binary::And);
        facts
    }

    /// From here on the condition holds, or does not hold.
    pub fn learn(&mut self, condition: &Expr, holds: bool) {
        match condition {
            Expr::Literal(_) => {}
            Expr::Unary(Unary::Not, operand) => self.learn(operand, !holds),
            Expr::Binary(operator @ (Binary::And | Binary::Or), left, right) => {
                if (*operator == Binary::And) == holds {
                    self.learn(left, holds);
                    self.learn(right, holds);
                } else {
                    self.open.push((condition.clone(), holds));
                    self.resolve();
                }
            }
            question => {
                match self.comparison(question) {
                    Some(comparison) => self.narrow(&comparison, holds),
                    None => self.answers.push((question.clone(), holds)),
                }
                self.resolve();
            }
        }
    }

    /// The variable gets a value: what was known of the old one is forgotten.
    pub fn assign(&mut self, target: Var, value: &Expr) {
        let range = match value {
            Expr::Var(var) if self.ranges.contains_key(var) => self.ranges.get(var).copied(),
            value => self.number(value).map(|(number, _)| (number, number)),
        };
        let reads = |expr: &Expr| {
            let mut found = false;
            expr.variables(&mut |var| found |= var == target);
            found
        };
        self.answers.retain(|(expr, _)| !reads(expr));
        self.open.retain(|(expr, _)| !reads(expr));
        self.excluded.retain(|(var, _)| *var != target);
        self.ranges.remove(&target);
        if let Some(range) = range {
            self.ranges.insert(target, range);
        }
        if let Expr::Literal(Literal::Bool(value)) = value {
            self.answers.push((Expr::Var(target), *value));
        }
    }

    /// What holds after two branches: what holds after each of them.
    pub fn join(mut self, other: &Self) -> Self {
        self.answers.retain(|fact| other.answers.contains(fact));
        self.open.retain(|fact| other.open.contains(fact));
        self.excluded.retain(|(var, number)| {
            let outside = other.ranges.get(var).is_some_and(|(low, high)| number < low || number > high);
            outside || other.excluded.contains(&(*var, *number))
        });
        let both =
            |(var, (a, b)): (Var, (i64, i64))| other.ranges.get(&var).map(|(c, d)| (var, (a.min(*c), b.max(*d))));
        self.ranges = self.ranges.into_iter().filter_map(both).collect();
        self
    }

    fn answer(&self, question: &Expr) -> Option<bool> {
        if let Some(comparison) = self.comparison(question) {
            return self.compare(&comparison);
        }
        let known = self.answers.iter().chain(&self.open).find(|(expr, _)| expr == question);
        known.map(|(_, holds)| *holds)
    }

    /// Looks whether what was learned decides an open `and` or `or`, or leaves one operand of it.
    fn resolve(&mut self) {
        let mut position = 0;
        while position < self.open.len() {
            let (before, holds) = self.open.remove(position);
            let after = self.simplify(before.clone());
            if after == before {
                self.open.insert(position, (before, holds));
                position += 1;
            } else {
                self.learn(&after, holds);
                position = 0;
            }
        }
    }

    fn comparison(&self, question: &Expr) -> Option<Comparison> {
        use Binary::{Equal, Greater, GreaterEqual, Less, LessEqual, NotEqual};
        let Expr::Binary(operator, left, right) = question else { return None };
        let (var, operator, (number, full)) = match (&**left, &**right) {
            (Expr::Var(Var::Constant(_)) | Expr::Literal(_), Expr::Var(var)) => {
                let turned = match operator {
                    Less => Greater,
                    LessEqual => GreaterEqual,
                    Greater => Less,
                    GreaterEqual => LessEqual,
                    other => *other,
                };
                (var, turned, self.number(left)?)
            }
            (Expr::Var(var), right) => (var, *operator, self.number(right)?),
            _ => return None,
        };
        let compares = matches!(operator, Less | LessEqual | Greater | GreaterEqual | Equal | NotEqual);
        compares.then_some(Comparison { var: *var, operator, number, full })
    }

    /// A known integer, with the smallest and the largest value of its type.
    fn number(&self, expr: &Expr) -> Option<(i64, (i64, i64))> {
        let value = match expr {
            Expr::Literal(literal) => *literal,
            Expr::Var(Var::Constant(index)) => self.constants[*index].value,
            _ => return None,
        };
        match value {
            Literal::I32(value) => Some((value.into(), (i32::MIN.into(), i32::MAX.into()))),
            Literal::U32(value) => Some((value.into(), (0, u32::MAX.into()))),
            _ => None,
        }
    }

    fn compare(&self, comparison: &Comparison) -> Option<bool> {
        let Comparison { var, operator, number, full } = comparison;
        let (low, high) = self.ranges.get(var).unwrap_or(full);
        let decided = |yes: bool, no: bool| (yes || no).then_some(yes);
        let is_excluded = number < low || number > high || self.excluded.contains(&(*var, *number));
        let is_only = low == number && high == number;
        match operator {
            Binary::Less => decided(high < number, low >= number),
            Binary::LessEqual => decided(high <= number, low > number),
            Binary::Greater => decided(low > number, high <= number),
            Binary::GreaterEqual => decided(low >= number, high < number),
            Binary::Equal => decided(is_only, is_excluded),
            _ => decided(is_excluded, is_only),
        }
    }

    fn narrow(&mut self, comparison: &Comparison, holds: bool) {
        let Comparison { var, operator, number, full } = *comparison;
        let (low, high) = self.ranges.get(&var).copied().unwrap_or(full);
        let range = match (operator, holds) {
            (Binary::Less, true) | (Binary::GreaterEqual, false) => (low, high.min(number - 1)),
            (Binary::LessEqual, true) | (Binary::Greater, false) => (low, high.min(number)),
            (Binary::Greater, true) | (Binary::LessEqual, false) => (low.max(number + 1), high),
            (Binary::GreaterEqual, true) | (Binary::Less, false) => (low.max(number), high),
            (Binary::Equal, true) | (Binary::NotEqual, false) => (number, number),
            _ => {
                self.excluded.insert((var, number));
                (if low == number { low + 1 } else { low }, if high == number { high - 1 } else { high })
            }
        };
        self.ranges.insert(var, range);
    }
}

/// An `and`, an `or` or a `not` without operands that are known.
fn without_literals(expr: Expr) -> Expr {
    use Binary::{And, Or};
    let literal = |expr: &Expr| match expr {
        Expr::Literal(Literal::Bool(value)) => Some(*value),
        _ => None,
    };
    match expr {
        Expr::Unary(Unary::Not, operand) => match literal(&operand) {
            Some(value) => Expr::Literal(Literal::Bool(!value)),
            None => Expr::Unary(Unary::Not, operand),
        },
        Expr::Binary(operator @ (And | Or), left, right) => {
            let neutral = operator == And;
            match (literal(&left), literal(&right)) {
                (Some(value), _) => {
                    if value == neutral {
                        *right
                    } else {
                        *left
                    }
                }
                (_, Some(value)) => {
                    if value == neutral {
                        *left
                    } else {
                        *right
                    }
                }
                _ => Expr::Binary(operator, left, right),
            }
        }
        other => other,
    }
}
