//! Conclusions from the answer to a condition: narrower ranges of the variables that it reads. Nothing is checked here.

use super::real::{self, Interval};
use super::value::Value;
use super::walk::Walk;
use super::whole::Whole;
use crate::program::{Expr, Type, Var};
use portable::{Binary, Intrinsic, Unary};

impl Walk<'_> {
    /// From here on the condition has this answer. Returns whether it can have it.
    pub(super) fn learn(&mut self, condition: &Expr, holds: bool) -> bool {
        match condition {
            Expr::Literal(literal) => self.literal(*literal).holds(portable::Literal::Bool(holds)),
            Expr::Var(_) => self.restrict(condition, Value::Bool([!holds, holds])),
            Expr::Unary(Unary::Not, operand) => self.learn(operand, !holds),
            Expr::Binary(operator @ (Binary::And | Binary::Or), left, right) => {
                if (*operator == Binary::And) == holds {
                    return self.learn(left, holds) && self.learn(right, holds);
                }
                // Either the first operand decides, or the second one.
                let mark = self.known.mark();
                let first = self.learn(left, holds);
                let first = self.changes(mark, first);
                let second = self.learn(left, !holds) && self.learn(right, holds);
                let second = self.changes(mark, second);
                let is_reached = first.is_some() || second.is_some();
                self.known.merge([first, second]);
                is_reached
            }
            Expr::Binary(operator, left, right) => self.learn_comparison(*operator, left, right, holds),
            Expr::Intrinsic(Intrinsic::InRange | Intrinsic::Within, operands) => {
                self.learn_magnitude(&operands[0], &operands[1], holds)
            }
            Expr::Intrinsic(..) | Expr::Unary(..) | Expr::Element(..) => true,
        }
    }

    fn learn_comparison(&mut self, operator: Binary, left: &Expr, right: &Expr, holds: bool) -> bool {
        use Binary::{Equal, Greater, GreaterEqual, Less, LessEqual, NotEqual};
        match (operator, left.ty(self.program)) {
            (Equal | NotEqual, ty) => {
                let are_equal = (operator == Equal) == holds;
                if ty == Type::Bool {
                    self.learn_same(left, right, are_equal)
                } else {
                    self.learn_equal(left, right, are_equal)
                }
            }
            (Less | LessEqual, Type::Real) => self.learn_order(left, right, operator == Less, holds),
            (Greater | GreaterEqual, Type::Real) => self.learn_order(right, left, operator == Greater, holds),
            (Less | LessEqual | Greater | GreaterEqual, _) => {
                let is_turned = matches!(operator, Greater | GreaterEqual) == holds;
                let is_strict = matches!(operator, Less | Greater) == holds;
                let (low, high) = if is_turned { (right, left) } else { (left, right) };
                self.learn_integer_order(low, high, is_strict)
            }
            _ => panic!("ranges: {operator:?} is not a comparison"),
        }
    }

    /// Two bools are equal, or not equal.
    fn learn_same(&mut self, left: &Expr, right: &Expr, are_equal: bool) -> bool {
        for (known, other) in [(left, right), (right, left)] {
            if let Value::Bool([false, true] | [true, false]) = self.value(known) {
                let is_true = self.value(known) == Value::Bool([false, true]);
                return self.learn(other, is_true == are_equal);
            }
        }
        true
    }

    fn learn_equal(&mut self, left: &Expr, right: &Expr, are_equal: bool) -> bool {
        let (a, b) = (self.whole(left), self.whole(right));
        if are_equal {
            return self.restrict(left, Value::Whole(b)) && self.restrict(right, Value::Whole(a));
        }
        let without = |of: Whole, other: Whole| {
            if other.low == other.high { self.known.names.without(of, other.low) } else { of }
        };
        let (a, b) = (without(a, b), without(b, a));
        self.restrict(left, Value::Whole(a)) && self.restrict(right, Value::Whole(b))
    }

    fn learn_integer_order(&mut self, low: &Expr, high: &Expr, is_strict: bool) -> bool {
        let (a, b) = (self.whole(low), self.whole(high));
        let step = i64::from(is_strict);
        self.restrict(low, Value::Whole(Whole::numbers(i64::MIN, b.high - step)))
            && self.restrict(high, Value::Whole(Whole::numbers(a.low + step, i64::MAX)))
    }

    /// `low < high` or `low <= high` is true, or false: if it is false, one of them may be NaN.
    fn learn_order(&mut self, low: &Expr, high: &Expr, is_strict: bool, holds: bool) -> bool {
        let kind = self.program.real;
        let (a, b) = (self.interval(low), self.interval(high));
        let above = |value: f64, strict: bool| if strict { real::above(value, kind) } else { value };
        let below = |value: f64, strict: bool| if strict { -real::above(-value, kind) } else { value };
        if holds {
            if !a.has_number() || !b.has_number() {
                return false;
            }
            let up_to = Interval::numbers(f64::NEG_INFINITY, below(b.high, is_strict));
            let from = Interval::numbers(above(a.low, is_strict), f64::INFINITY);
            return self.restrict(low, Value::Real(up_to)) && self.restrict(high, Value::Real(from));
        }
        let from = Interval { low: above(b.low, !is_strict), high: f64::INFINITY, nan: true };
        let up_to = Interval { low: f64::NEG_INFINITY, high: below(a.high, !is_strict), nan: true };
        (b.nan || self.restrict(low, Value::Real(from))) && (a.nan || self.restrict(high, Value::Real(up_to)))
    }

    /// `-limit <= x <= limit` is true, or false: if it is false, one of them may be NaN.
    fn learn_magnitude(&mut self, x: &Expr, limit: &Expr, holds: bool) -> bool {
        let (a, b) = (self.interval(x), self.interval(limit));
        if holds {
            if !a.has_number() || !b.has_number() || b.high < 0.0 {
                return false;
            }
            return self.restrict(x, Value::Real(Interval::numbers(-b.high, b.high)))
                && self.restrict(limit, Value::Real(Interval::numbers(0.0, f64::INFINITY)));
        }
        if b.nan || !b.has_number() || b.low < 0.0 {
            return true;
        }
        let above = real::above(b.low, self.program.real);
        let (low, high) = match (a.low >= -b.low, a.high <= b.low) {
            (true, true) => (f64::INFINITY, f64::NEG_INFINITY),
            (true, false) => (above, f64::INFINITY),
            (false, true) => (f64::NEG_INFINITY, -above),
            (false, false) => return true,
        };
        self.restrict(x, Value::Real(Interval { low, high, nan: true }))
    }

    /// An expression has one of these values only; applies this to a variable if possible.
    fn restrict(&mut self, expr: &Expr, to: Value) -> bool {
        match expr {
            Expr::Var(Var::Constant(_)) | Expr::Literal(_) => !self.value(expr).meet(to, &self.known.names).is_none(),
            Expr::Var(var) => self.known.restrict(self.place(*var), to),
            Expr::Unary(Unary::Negate, operand) => match to {
                Value::Real(interval) => self.restrict(operand, Value::Real(interval.negated())),
                _ => true,
            },
            _ if self.value(expr).meet(to, &self.known.names).is_none() => false,
            Expr::Binary(operator, left, right) => match to {
                Value::Real(result) if result.is_finite() => self.restrict_operands(*operator, left, right, result),
                _ => true,
            },
            _ => true,
        }
    }

    /// Limits the operands of an operation whose result is one of these finite numbers. No operand of a sum, difference or
    /// product is then infinite or a NaN; each operand of a sum or difference is limited by the other one.
    fn restrict_operands(&mut self, operator: Binary, left: &Expr, right: &Expr, result: Interval) -> bool {
        if !matches!(operator, Binary::Add | Binary::Subtract | Binary::Multiply) {
            return true;
        }
        let kind = self.program.real;
        let finite = Value::Real(Interval::finite(kind));
        if !(self.restrict(left, finite) && self.restrict(right, finite)) {
            return false;
        }
        let (a, b, exact) = (self.interval(left), self.interval(right), result.before_rounding(kind));
        let (left_is, right_is) = match operator {
            Binary::Add => {
                (real::binary(Binary::Subtract, exact, b, kind), real::binary(Binary::Subtract, exact, a, kind))
            }
            Binary::Subtract => {
                (real::binary(Binary::Add, exact, b, kind), real::binary(Binary::Subtract, a, exact, kind))
            }
            _ => return true,
        };
        self.restrict(left, Value::Real(left_is.before_rounding(kind)))
            && self.restrict(right, Value::Real(right_is.before_rounding(kind)))
    }
}
