//! Conditions as numbers: equal conditions have equal numbers, so that facts about them are cheap to copy and compare.

use crate::arithmetic;
use crate::program::{Constant, Expr, Program, Table, Var};
use portable::{Binary, Intrinsic, Literal, Unary};

/// The number of a condition.
pub(super) type Id = usize;

/// A condition with numbers for its operands.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Condition {
    Known(bool),
    /// by its position among the questions
    Question(usize),
    Not(Id),
    /// an `and` if the flag is set, else an `or`
    Both(bool, Id, Id),
}

/// A question without `and`, `or` and `not`.
pub(super) struct Question {
    pub expr: Expr,
    pub comparison: Option<Comparison>,
    bound: Option<Bound>,
    id: Id,
}

/// Whether the magnitude of a real is at most a known number.
#[derive(Clone, Copy)]
struct Bound {
    /// the real, by the first question about it
    of: usize,
    limit: f64,
}

/// The comparison of an integer variable with a known number.
#[derive(Clone, Copy)]
pub(super) struct Comparison {
    pub var: Var,
    /// the answer for the values from the first to the last of `within`; other values have the opposite answer
    pub answer: bool,
    /// one value, or all up to one end of the type
    pub within: (i64, i64),
    /// smallest and largest value of the type
    pub full: (i64, i64),
}

/// All conditions of a program that were examined.
pub(super) struct Conditions<'p> {
    constants: &'p [Constant],
    pub all: Vec<Condition>,
    pub questions: Vec<Question>,
    /// whether a question reads the variable
    pub asked: Table<bool>,
    /// the number of each flag that is a question
    flags: Table<Option<Id>>,
}

impl<'p> Conditions<'p> {
    pub(super) fn of(program: &'p Program) -> Self {
        Self {
            constants: &program.constants,
            all: Vec::new(),
            questions: Vec::new(),
            asked: Table::filled(program, false),
            flags: Table::filled(program, None),
        }
    }

    /// The number of an expression of type BOOL.
    pub(super) fn number(&mut self, expr: &Expr) -> Id {
        match expr {
            Expr::Literal(Literal::Bool(value)) => self.add(Condition::Known(*value)),
            Expr::Unary(Unary::Not, operand) => {
                let operand = self.number(operand);
                self.add(Condition::Not(operand))
            }
            Expr::Binary(operator @ (Binary::And | Binary::Or), left, right) => {
                let (left, right) = (self.number(left), self.number(right));
                self.add(Condition::Both(*operator == Binary::And, left, right))
            }
            Expr::Var(flag) => self.flags[*flag].unwrap_or_else(|| {
                let id = self.ask(expr);
                self.flags[*flag] = Some(id);
                id
            }),
            question => {
                let known = self.questions.iter().find(|known| known.expr == *question).map(|known| known.id);
                known.unwrap_or_else(|| self.ask(question))
            }
        }
    }

    /// The number of a new question.
    fn ask(&mut self, question: &Expr) -> Id {
        let (id, comparison) = (self.all.len(), self.comparison(question));
        self.all.push(Condition::Question(self.questions.len()));
        let bound = self.bound(question);
        self.questions.push(Question { expr: question.clone(), comparison, bound, id });
        question.variables(&mut |var| self.asked[var] = true);
        id
    }

    /// The number of a condition, simplified if an operand is known.
    pub(super) fn add(&mut self, condition: Condition) -> Id {
        let simpler = match condition {
            Condition::Not(operand) => match self.all[operand] {
                Condition::Known(value) => Condition::Known(!value),
                _ => condition,
            },
            Condition::Both(and, left, right) => match (self.all[left], self.all[right]) {
                (Condition::Known(value), _) => return if value == and { right } else { left },
                (_, Condition::Known(value)) => return if value == and { left } else { right },
                _ => condition,
            },
            Condition::Known(_) | Condition::Question(_) => condition,
        };
        self.all.iter().position(|known| *known == simpler).unwrap_or_else(|| {
            self.all.push(simpler);
            self.all.len() - 1
        })
    }

    pub(super) fn mentions(&self, id: Id, var: Var) -> bool {
        match self.all[id] {
            Condition::Known(_) => false,
            Condition::Question(index) => self.questions[index].expr.mentions(var),
            Condition::Not(operand) => self.mentions(operand, var),
            Condition::Both(_, left, right) => self.mentions(left, var) || self.mentions(right, var),
        }
    }

    pub(super) fn expr(&self, id: Id) -> Expr {
        match self.all[id] {
            Condition::Known(value) => Expr::bool(value),
            Condition::Question(index) => self.questions[index].expr.clone(),
            Condition::Not(operand) => Expr::not(self.expr(operand)),
            Condition::Both(and, left, right) => {
                let operator = if and { Binary::And } else { Binary::Or };
                Expr::binary(operator, self.expr(left), self.expr(right))
            }
        }
    }

    /// The comparison of an integer variable with a known number, if the question is one.
    pub(super) fn comparison(&self, question: &Expr) -> Option<Comparison> {
        use Binary::{Equal, Greater, GreaterEqual, Less, LessEqual, NotEqual};
        let Expr::Binary(operator, left, right) = question else { return None };
        let (var, (number, full), is_turned) = match (&**left, &**right) {
            (Expr::Var(Var::Constant(_)) | Expr::Literal(_), Expr::Var(var)) => (*var, self.integer(left)?, true),
            (Expr::Var(var), right) => (*var, self.integer(right)?, false),
            _ => return None,
        };
        let within = match (operator, is_turned) {
            (Less, false) | (Greater, true) => (full.0, number - 1),
            (LessEqual, false) | (GreaterEqual, true) => (full.0, number),
            (Greater, false) | (Less, true) => (number + 1, full.1),
            (GreaterEqual, false) | (LessEqual, true) => (number, full.1),
            (Equal | NotEqual, _) => (number, number),
            _ => return None,
        };
        Some(Comparison { var, answer: *operator != NotEqual, within, full })
    }

    /// The bound of a magnitude, if the question asks for it.
    fn bound(&self, question: &Expr) -> Option<Bound> {
        let [real, limit] = magnitude(question)?;
        let limit = arithmetic::wide(limit.known(self.constants)?)?;
        let same = |known: &Question| magnitude(&known.expr).is_some_and(|[of, _]| of == real);
        let of = self.questions.iter().position(same).unwrap_or(self.questions.len());
        Some(Bound { of, limit })
    }

    /// Whether the answer to one question implies the same answer to another one, which may be another bound of its magnitude.
    pub(super) fn implies(&self, known: usize, holds: bool, question: usize) -> bool {
        known == question
            || match (self.questions[known].bound, self.questions[question].bound) {
                (Some(one), Some(other)) if one.of == other.of => {
                    if holds {
                        one.limit <= other.limit
                    } else {
                        one.limit >= other.limit
                    }
                }
                _ => false,
            }
    }

    /// A known integer, with the smallest and the largest value of its type.
    pub(super) fn integer(&self, expr: &Expr) -> Option<(i64, (i64, i64))> {
        match expr.known(self.constants)? {
            Literal::I32(value) => Some((value.into(), (i32::MIN.into(), i32::MAX.into()))),
            Literal::U32(value) => Some((value.into(), (0, u32::MAX.into()))),
            _ => None,
        }
    }
}

/// The real and the limit of a question about a magnitude. A NaN is within no limit.
fn magnitude(question: &Expr) -> Option<[&Expr; 2]> {
    match question {
        Expr::Intrinsic(Intrinsic::InRange | Intrinsic::Within, operands) => Some([&operands[0], &operands[1]]),
        _ => None,
    }
}
