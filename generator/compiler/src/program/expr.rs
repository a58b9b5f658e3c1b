//! Expressions that passes build, and their properties.

use super::{Constant, Expr, Program, Type, Var};
use portable::{Binary, Intrinsic, Literal, Unary};

impl Expr {
    pub(crate) fn bool(value: bool) -> Self {
        Self::Literal(Literal::Bool(value))
    }

    pub(crate) fn binary(operator: Binary, left: Self, right: Self) -> Self {
        Self::Binary(operator, Box::new(left), Box::new(right))
    }

    /// The negation, without a literal as its operand.
    pub(crate) fn not(operand: Self) -> Self {
        match operand {
            Self::Literal(Literal::Bool(value)) => Self::bool(!value),
            operand => Self::Unary(Unary::Not, Box::new(operand)),
        }
    }

    /// An `and` or an `or`, without a literal as an operand.
    pub(crate) fn logic(operator: Binary, left: Self, right: Self) -> Self {
        let neutral = operator == Binary::And;
        match (&left, &right) {
            (Self::Literal(Literal::Bool(value)), _) if *value == neutral => right,
            (_, Self::Literal(Literal::Bool(value))) if *value != neutral => right,
            (Self::Literal(Literal::Bool(_)), _) | (_, Self::Literal(Literal::Bool(_))) => left,
            _ => Self::binary(operator, left, right),
        }
    }

    /// The value of a literal or of a named number.
    pub(crate) fn known(&self, constants: &[Constant]) -> Option<Literal> {
        match self {
            Self::Literal(literal) => Some(*literal),
            Self::Var(Var::Constant(index)) => Some(constants[*index].value),
            _ => None,
        }
    }

    /// Whether its value is the real number 0.
    pub(crate) fn is_zero(&self, constants: &[Constant]) -> bool {
        matches!(self.known(constants), Some(Literal::F64(0.0) | Literal::F32(0.0)))
    }

    /// Whether it is a comparison of a magnitude with 0: whether a number is 0.
    pub fn is_about_zero(&self) -> bool {
        let Self::Intrinsic(Intrinsic::InRange | Intrinsic::Within, operands) = self else { return false };
        matches!(operands.last(), Some(Self::Literal(Literal::F64(0.0) | Literal::F32(0.0))))
    }

    /// The type of an expression in a program whose types fit.
    pub(crate) fn ty(&self, program: &Program) -> Type {
        use Binary::{Add, And, Divide, Multiply, Or, Remainder, Subtract};
        match self {
            Self::Literal(literal) => {
                Type::of_literal(*literal).expect("program: the passes leave what exists at run time")
            }
            Self::Var(var) => program.ty(*var).expect("program: the typing pass has typed every local"),
            Self::Unary(_, operand) => operand.ty(program),
            Self::Binary(Add | Subtract | Multiply | Divide | Remainder | And | Or, left, _) => left.ty(program),
            Self::Binary(..) => Type::Bool,
            Self::Intrinsic(intrinsic, _) => Type::of_intrinsic(*intrinsic),
            Self::Element(row, _) => program.state[row.first].ty,
        }
    }
}
