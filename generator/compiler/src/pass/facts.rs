//! What is known of the variables at one point of a program: answers to conditions, values of integers. No statement is
//! changed here.

use crate::program::{Constant, Expr, Var};
use portable::{Binary, Literal, Unary};
use std::collections::BTreeMap;
use std::rc::Rc;

/// What holds at the present point.
#[derive(Clone)]
pub(super) struct Facts<'p> {
    constants: &'p [Constant],
    /// conditions whose answer is known; of an `or` that holds and an `and` that does not, it is open which operand decides
    answers: Vec<Rc<(Expr, bool)>>,
    /// the values that an integer may have
    integers: BTreeMap<Var, Ranges>,
}

/// Ranges of values, from the smallest to the largest, both included.
type Ranges = Rc<[(i64, i64)]>;

/// The comparison of an integer variable with a known number.
struct Comparison {
    var: Var,
    /// all values of the type
    all: [(i64, i64); 1],
    /// the values for which it holds, and those for which it does not
    holds: Vec<(i64, i64)>,
    fails: Vec<(i64, i64)>,
}

impl<'p> Facts<'p> {
    pub(super) fn none(constants: &'p [Constant]) -> Self {
        Self { constants, answers: Vec::new(), integers: BTreeMap::new() }
    }

    /// The condition with everything replaced whose answer is known.
    pub(super) fn simplify(&self, condition: Expr) -> Expr {
        let simpler = match condition {
            Expr::Unary(Unary::Not, operand) => Expr::not(self.simplify(*operand)),
            Expr::Binary(operator @ (Binary::And | Binary::Or), left, right) => {
                // Each operand matters only where the other one has not decided.
                let right = self.beside(operator, &left).simplify(*right);
                let left = self.beside(operator, &right).simplify(*left);
                Expr::logic(operator, left, right)
            }
            question => question,
        };
        self.answer(&simpler).map_or(simpler, Expr::bool)
    }

    /// What holds where an operand of an `and` or an `or` leaves the answer to the other one.
    fn beside(&self, operator: Binary, operand: &Expr) -> Self {
        let mut facts = self.clone();
        facts.learn(operand, operator == Binary::And);
        facts
    }

    /// From here on the condition holds, or does not hold.
    pub(super) fn learn(&mut self, condition: &Expr, holds: bool) {
        match condition {
            Expr::Literal(_) => return,
            Expr::Unary(Unary::Not, operand) => return self.learn(operand, !holds),
            Expr::Binary(operator @ (Binary::And | Binary::Or), left, right) if (*operator == Binary::And) == holds => {
                self.learn(left, holds);
                return self.learn(right, holds);
            }
            question => match self.comparison(question) {
                Some(comparison) => {
                    let learned = if holds { &comparison.holds } else { &comparison.fails };
                    let values = common(self.values(&comparison), learned);
                    self.integers.insert(comparison.var, values.into());
                }
                None => self.answers.push(Rc::new((question.clone(), holds))),
            },
        }
        self.resolve();
    }

    /// The variable gets a value: what was known of the old one is forgotten.
    pub(super) fn assign(&mut self, target: Var, value: &Expr) {
        let values = match value {
            Expr::Var(var) if self.integers.contains_key(var) => self.integers.get(var).cloned(),
            value => self.number(value).map(|(number, _)| [(number, number)].into()),
        };
        self.answers.retain(|fact| !fact.0.mentions(target));
        self.integers.remove(&target);
        self.integers.extend(values.map(|values| (target, values)));
        if matches!(value, Expr::Literal(Literal::Bool(true) | Literal::Bool(false))) {
            self.answers.push(Rc::new((Expr::Var(target), *value == Expr::bool(true))));
        }
    }

    /// What holds after two branches: what holds after each of them.
    pub(super) fn join(mut self, other: &Self) -> Self {
        self.answers.retain(|fact| other.answers.contains(fact));
        self.integers.retain(|var, values| {
            let Some(others) = other.integers.get(var) else { return false };
            if values != others {
                *values = values.iter().chain(others.iter().filter(|range| !values.contains(range))).copied().collect();
            }
            true
        });
        self
    }

    fn answer(&self, question: &Expr) -> Option<bool> {
        if let Some(comparison) = self.comparison(question) {
            let is_possible = |ranges: &[_]| !common(self.values(&comparison), ranges).is_empty();
            let (can_hold, can_fail) = (is_possible(&comparison.holds), is_possible(&comparison.fails));
            return (can_hold != can_fail).then_some(can_hold);
        }
        self.answers.iter().find(|fact| fact.0 == *question).map(|fact| fact.1)
    }

    /// The values that the variable of a comparison may have.
    fn values<'c>(&'c self, comparison: &'c Comparison) -> &'c [(i64, i64)] {
        self.integers.get(&comparison.var).map_or(&comparison.all, |values| values)
    }

    /// Looks whether what was learned decides an open `and` or `or`, or leaves one operand of it.
    fn resolve(&mut self) {
        let mut position = 0;
        while position < self.answers.len() {
            if !matches!(self.answers[position].0, Expr::Binary(Binary::And | Binary::Or, ..)) {
                position += 1;
                continue;
            }
            let fact = self.answers.remove(position);
            let after = self.simplify(fact.0.clone());
            if after == fact.0 {
                self.answers.insert(position, fact);
                position += 1;
            } else {
                self.learn(&after, fact.1);
                position = 0;
            }
        }
    }

    fn comparison(&self, question: &Expr) -> Option<Comparison> {
        use Binary::{Equal, Greater, GreaterEqual, Less, LessEqual, NotEqual};
        let Expr::Binary(operator, left, right) = question else { return None };
        let (var, number, is_turned) = match (&**left, &**right) {
            (Expr::Var(Var::Constant(_)) | Expr::Literal(_), Expr::Var(var)) => (*var, left, true),
            (Expr::Var(var), _) => (*var, right, false),
            _ => return None,
        };
        let (number, (least, most)) = self.number(number)?;
        let (mut below, mut up_to) = ((least, number - 1), (least, number));
        let (mut from, mut above) = ((number, most), (number + 1, most));
        if is_turned {
            (below, up_to, from, above) = (above, from, up_to, below);
        }
        let (holds, fails) = match operator {
            Less => (vec![below], vec![from]),
            LessEqual => (vec![up_to], vec![above]),
            Greater => (vec![above], vec![up_to]),
            GreaterEqual => (vec![from], vec![below]),
            Equal => (vec![(number, number)], vec![below, above]),
            NotEqual => (vec![below, above], vec![(number, number)]),
            _ => return None,
        };
        Some(Comparison { var, all: [(least, most)], holds, fails })
    }

    /// A known integer, with the smallest and the largest value of its type.
    fn number(&self, expr: &Expr) -> Option<(i64, (i64, i64))> {
        match expr.known(self.constants)? {
            Literal::I32(value) => Some((value.into(), (i32::MIN.into(), i32::MAX.into()))),
            Literal::U32(value) => Some((value.into(), (0, u32::MAX.into()))),
            _ => None,
        }
    }
}

/// The values that are in both.
fn common(some: &[(i64, i64)], others: &[(i64, i64)]) -> Vec<(i64, i64)> {
    let pairs = some.iter().flat_map(|one| others.iter().map(|other| (one.0.max(other.0), one.1.min(other.1))));
    pairs.filter(|(low, high)| low <= high).collect()
}
