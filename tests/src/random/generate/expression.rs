//! Random expressions without effect: constants, places, operators, pure calls, intrinsics.

use super::constant;
use super::scope::Writer;
use crate::random::syntax::{Argument, Call, Callee, Expr, Scalar, Value};
use portable::{Binary, Intrinsic, Unary};

impl Writer<'_> {
    /// An expression of a type, at most so many operators deep.
    pub fn expr(&mut self, scalar: Scalar, depth: usize) -> Expr {
        self.choices.enter();
        let expr = self.expr_here(scalar, depth);
        self.choices.leave();
        expr
    }

    fn expr_here(&mut self, scalar: Scalar, depth: usize) -> Expr {
        if depth == 0 || !self.choices.chance(80) {
            return self.leaf(scalar);
        }
        if !self.known
            && self.choices.chance(18)
            && let Some(call) = self.pure_call(scalar)
        {
            return self.or_argument(call);
        }
        match scalar {
            Scalar::Real => self.real(depth - 1),
            Scalar::Bool => self.bool(depth - 1),
            Scalar::I32 if self.choices.chance(12) => self.unary(Unary::Negate, scalar, depth - 1),
            Scalar::I32 | Scalar::U32 => {
                let operator = *self.choices.pick(&[
                    Binary::Add,
                    Binary::Subtract,
                    Binary::Multiply,
                    Binary::Divide,
                    Binary::Remainder,
                ]);
                if matches!(operator, Binary::Divide | Binary::Remainder) {
                    return self.quotient(operator, scalar, depth - 1);
                }
                self.binary(operator, scalar, depth - 1)
            }
            Scalar::Usize | Scalar::Enum(_) => self.leaf(scalar),
        }
    }

    /// An integer divided by a number from 1 on.
    fn quotient(&mut self, operator: Binary, scalar: Scalar, depth: usize) -> Expr {
        let divisor = *self.choices.pick(&[1u32, 2, 3, 7, 10, 256, 65_537, i32::MAX.cast_unsigned()]);
        let dividend = self.expr(scalar, depth);
        let divisor = if scalar == Scalar::I32 { Value::I32(divisor.cast_signed()) } else { Value::U32(divisor) };
        operation(operator, dividend, Expr::Literal(divisor))
    }

    /// The value of a call; or, where it is not to be there, an argument of its type.
    pub fn or_argument(&mut self, call: Call) -> Expr {
        let fits = |argument: &Argument| match argument {
            Argument::Value(value) if Some(value.scalar()) == call.returns => Some(value.clone()),
            _ => None,
        };
        let argument = if self.choices.is_there() { None } else { call.arguments.iter().find_map(fits) };
        argument.unwrap_or(Expr::Call(call))
    }

    /// A place or a constant; for want of both, of a bool, a comparison.
    pub fn leaf(&mut self, scalar: Scalar) -> Expr {
        let read = if self.choices.chance(80) { self.read(scalar) } else { None };
        match read {
            Some(read) => read,
            None if scalar == Scalar::Bool && self.choices.chance(80) => self.order(Scalar::Real, 0),
            None => self.constant(scalar),
        }
    }

    /// A constant.
    pub fn constant(&mut self, scalar: Scalar) -> Expr {
        Expr::Literal(constant::value(scalar, &self.program.enums, self.choices))
    }

    fn real(&mut self, depth: usize) -> Expr {
        match self.choices.weighted(&[26, 22, 28, 10, 9, 5]) {
            0 => self.binary(Binary::Add, Scalar::Real, depth),
            1 => self.binary(Binary::Subtract, Scalar::Real, depth),
            2 => self.binary(Binary::Multiply, Scalar::Real, depth),
            3 => self.binary(Binary::Divide, Scalar::Real, depth),
            4 => self.unary(Unary::Negate, Scalar::Real, depth),
            _ => {
                let (from, which) =
                    *self.choices.pick(&[(Scalar::U32, Intrinsic::FromU32), (Scalar::I32, Intrinsic::FromI32)]);
                let value = self.expr(from, depth.min(1));
                intrinsic(which, vec![value], Scalar::Real)
            }
        }
    }

    /// An integer from a quarter of an integer: with a fraction, halves among them, and never beyond the integers.
    pub fn truncated(&mut self) -> Expr {
        let number = self.expr(Scalar::I32, 1);
        let real = intrinsic(Intrinsic::FromI32, vec![number], Scalar::Real);
        let quarter = operation(Binary::Multiply, real, Expr::Literal(Value::Lit(0.25)));
        let which = *self.choices.pick(&[Intrinsic::Truncate, Intrinsic::Nearest]);
        intrinsic(which, vec![quarter], Scalar::I32)
    }

    fn bool(&mut self, depth: usize) -> Expr {
        let can_read = |scalar| usize::from(self.can_read(scalar));
        let (real, signed, unsigned) = (can_read(Scalar::Real), can_read(Scalar::I32), can_read(Scalar::U32));
        let (bool, known) = (can_read(Scalar::Bool), can_read(Scalar::Usize));
        let enums = usize::from(!self.program.enums.is_empty());
        let weights =
            [14, 13, 11, 2 + 25 * real, 12 * signed, 12 * unsigned, 6 * bool, 9 * enums, 12 * known, 8 * real];
        match self.choices.weighted(&weights) {
            0 => self.binary(Binary::And, Scalar::Bool, depth),
            1 => self.binary(Binary::Or, Scalar::Bool, depth),
            2 => self.unary(Unary::Not, Scalar::Bool, depth),
            3 => self.order(Scalar::Real, depth),
            4 => self.order(Scalar::I32, depth),
            5 => self.order(Scalar::U32, depth),
            6 => self.equality(Scalar::Bool, depth),
            7 => {
                let which = self.choices.below(self.program.enums.len());
                self.equality(Scalar::Enum(which), depth)
            }
            8 => self.order(Scalar::Usize, depth),
            _ => {
                let which = *self.choices.pick(&[Intrinsic::InRange, Intrinsic::Within]);
                let operands = vec![self.expr(Scalar::Real, depth), self.expr(Scalar::Real, depth.min(1))];
                intrinsic(which, operands, Scalar::Bool)
            }
        }
    }

    /// A comparison by order; of integers also by equality.
    fn order(&mut self, scalar: Scalar, depth: usize) -> Expr {
        if scalar != Scalar::Real && self.choices.chance(35) {
            return self.equality(scalar, depth);
        }
        let order = [Binary::Less, Binary::LessEqual, Binary::Greater, Binary::GreaterEqual];
        let operator = *self.choices.pick(&order);
        self.binary(operator, scalar, depth)
    }

    fn equality(&mut self, scalar: Scalar, depth: usize) -> Expr {
        let operator = *self.choices.pick(&[Binary::Equal, Binary::NotEqual]);
        self.binary(operator, scalar, depth)
    }

    fn unary(&mut self, operator: Unary, scalar: Scalar, depth: usize) -> Expr {
        let (is_there, operand) = (self.choices.is_there(), self.expr(scalar, depth));
        if is_there { Expr::Unary(operator, Box::new(operand)) } else { operand }
    }

    /// An operator on two operands, one of which is a place where there is one. An operand of the result's type may stand alone.
    fn binary(&mut self, operator: Binary, operands: Scalar, depth: usize) -> Expr {
        let there = (self.choices.is_there(), self.choices.is_there());
        let swapped = self.choices.chance(50);
        let left = self.expr(operands, depth);
        let mut right = match &left {
            Expr::Literal(_) => self.read(operands).unwrap_or_else(|| self.expr(operands, depth)),
            _ => self.expr(operands, depth),
        };
        if left == right {
            right = self.expr(operands, depth);
        }
        let result = operation(operator, left.clone(), right.clone());
        match there {
            (false, _) if result.scalar() == operands => right,
            (_, false) if result.scalar() == operands => left,
            _ if swapped => operation(operator, right, left),
            _ => result,
        }
    }

    /// A value of the kinds that a `match` is for: an enum, an integer, a bool. A place of one of them, if there is one.
    pub fn scrutinee(&mut self) -> Expr {
        let enums = (0..self.program.enums.len()).map(Scalar::Enum);
        let mut kinds: Vec<Scalar> = enums.chain([Scalar::I32, Scalar::U32, Scalar::Bool, Scalar::Usize]).collect();
        while !kinds.is_empty() {
            let scalar = kinds.remove(self.choices.below(kinds.len()));
            if let Some(read) = self.read(scalar) {
                return if self.choices.chance(70) { read } else { self.expr(scalar, 1) };
            }
        }
        self.expr(Scalar::Bool, 1)
    }
}

fn intrinsic(intrinsic: Intrinsic, values: Vec<Expr>, returns: Scalar) -> Expr {
    Expr::Call(Call {
        callee: Callee::Intrinsic(intrinsic),
        arguments: values.into_iter().map(Argument::Value).collect(),
        returns: Some(returns),
    })
}

/// An operator on two expressions.
pub fn operation(operator: Binary, left: Expr, right: Expr) -> Expr {
    Expr::Binary(operator, Box::new(left), Box::new(right))
}
