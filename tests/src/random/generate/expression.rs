//! Random expressions without effect: constants, places, operators, pure calls, intrinsics.

use super::constant;
use super::scope::Writer;
use crate::random::syntax::{Argument, Call, Callee, Expr, Scalar, Value};
use portable::{Binary, Intrinsic, Unary};

impl Writer<'_> {
    /// An expression of a type, at most so many operators deep.
    pub fn expr(&mut self, scalar: Scalar, depth: usize) -> Expr {
        if depth == 0 || self.rng.chance(20) {
            return self.leaf(scalar);
        }
        if !self.known
            && self.rng.chance(18)
            && let Some(call) = self.pure_call(scalar)
        {
            return Expr::Call(call);
        }
        match scalar {
            Scalar::Real => self.real(depth - 1),
            Scalar::Bool => self.bool(depth - 1),
            Scalar::I32 if self.rng.chance(12) => self.unary(Unary::Negate, scalar, depth - 1),
            Scalar::I32 | Scalar::U32 => {
                let operator = *self.rng.pick(&[Binary::Add, Binary::Subtract, Binary::Multiply]);
                self.binary(operator, scalar, depth - 1)
            }
            Scalar::Usize | Scalar::Enum(_) => self.leaf(scalar),
        }
    }

    /// A place or a constant; for want of both, of a bool, a comparison.
    pub fn leaf(&mut self, scalar: Scalar) -> Expr {
        let read = if self.rng.chance(80) { self.read(scalar) } else { None };
        match read {
            Some(read) => read,
            None if scalar == Scalar::Bool && self.rng.chance(80) => self.order(Scalar::Real, 0),
            None => self.constant(scalar),
        }
    }

    /// A constant.
    pub fn constant(&mut self, scalar: Scalar) -> Expr {
        Expr::Literal(constant::value(scalar, &self.program.enums, self.rng))
    }

    fn real(&mut self, depth: usize) -> Expr {
        match self.rng.weighted(&[26, 22, 28, 10, 9, 5]) {
            0 => self.binary(Binary::Add, Scalar::Real, depth),
            1 => self.binary(Binary::Subtract, Scalar::Real, depth),
            2 => self.binary(Binary::Multiply, Scalar::Real, depth),
            3 => self.binary(Binary::Divide, Scalar::Real, depth),
            4 => self.unary(Unary::Negate, Scalar::Real, depth),
            _ => {
                let (from, which) =
                    *self.rng.pick(&[(Scalar::U32, Intrinsic::FromU32), (Scalar::I32, Intrinsic::FromI32)]);
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
        let which = *self.rng.pick(&[Intrinsic::Truncate, Intrinsic::Nearest]);
        intrinsic(which, vec![quarter], Scalar::I32)
    }

    fn bool(&mut self, depth: usize) -> Expr {
        let can_read = |scalar| usize::from(self.can_read(scalar));
        let (real, signed, unsigned) = (can_read(Scalar::Real), can_read(Scalar::I32), can_read(Scalar::U32));
        let (bool, known) = (can_read(Scalar::Bool), can_read(Scalar::Usize));
        let enums = usize::from(!self.program.enums.is_empty());
        let weights =
            [14, 13, 11, 2 + 25 * real, 12 * signed, 12 * unsigned, 6 * bool, 9 * enums, 12 * known, 8 * real];
        match self.rng.weighted(&weights) {
            0 => self.binary(Binary::And, Scalar::Bool, depth),
            1 => self.binary(Binary::Or, Scalar::Bool, depth),
            2 => self.unary(Unary::Not, Scalar::Bool, depth),
            3 => self.order(Scalar::Real, depth),
            4 => self.order(Scalar::I32, depth),
            5 => self.order(Scalar::U32, depth),
            6 => self.equality(Scalar::Bool, depth),
            7 => {
                let which = self.rng.below(self.program.enums.len());
                self.equality(Scalar::Enum(which), depth)
            }
            8 => self.order(Scalar::Usize, depth),
            _ => {
                let which = *self.rng.pick(&[Intrinsic::Usable, Intrinsic::Within]);
                let operands = vec![self.expr(Scalar::Real, depth), self.expr(Scalar::Real, depth.min(1))];
                intrinsic(which, operands, Scalar::Bool)
            }
        }
    }

    /// A comparison by order; of integers also by equality.
    fn order(&mut self, scalar: Scalar, depth: usize) -> Expr {
        if scalar != Scalar::Real && self.rng.chance(35) {
            return self.equality(scalar, depth);
        }
        let order = [Binary::Less, Binary::LessEqual, Binary::Greater, Binary::GreaterEqual];
        let operator = *self.rng.pick(&order);
        self.binary(operator, scalar, depth)
    }

    fn equality(&mut self, scalar: Scalar, depth: usize) -> Expr {
        let operator = *self.rng.pick(&[Binary::Equal, Binary::NotEqual]);
        self.binary(operator, scalar, depth)
    }

    fn unary(&mut self, operator: Unary, scalar: Scalar, depth: usize) -> Expr {
        Expr::Unary(operator, Box::new(self.expr(scalar, depth)))
    }

    /// An operator on two operands, one of which is a place where there is one.
    fn binary(&mut self, operator: Binary, operands: Scalar, depth: usize) -> Expr {
        let left = self.expr(operands, depth);
        let mut right = match &left {
            Expr::Literal(_) => self.read(operands).unwrap_or_else(|| self.expr(operands, depth)),
            _ => self.expr(operands, depth),
        };
        if left == right {
            right = self.expr(operands, depth);
        }
        if self.rng.chance(50) { operation(operator, left, right) } else { operation(operator, right, left) }
    }

    /// A value of the kinds that a `match` is for: an enum, an integer, a bool. A place of one of them, if there is one.
    pub fn scrutinee(&mut self) -> Expr {
        let enums = (0..self.program.enums.len()).map(Scalar::Enum);
        let mut kinds: Vec<Scalar> = enums.chain([Scalar::I32, Scalar::U32, Scalar::Bool, Scalar::Usize]).collect();
        while !kinds.is_empty() {
            let scalar = kinds.remove(self.rng.below(kinds.len()));
            if let Some(read) = self.read(scalar) {
                return if self.rng.chance(70) { read } else { self.expr(scalar, 1) };
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
