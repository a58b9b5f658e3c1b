//! Expressions as C text, one to one, with the parentheses that C needs and those that its compilers ask for.

use super::print::Printer;
use super::types;
use compiler::pass::typing::type_of;
use compiler::program::{Expr, Type};
use portable::{Binary, Intrinsic, Literal, RealKind, Unary};

/// How tightly an expression binds, loosest first.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
enum Precedence {
    Or,
    And,
    Equality,
    Relation,
    Sum,
    Product,
    Unary,
    Primary,
}

impl Printer<'_> {
    /// Appends an expression.
    pub(super) fn expr(&self, expr: &Expr, text: &mut String) {
        match expr {
            Expr::Literal(literal) => text.push_str(&types::literal(*literal)),
            Expr::Var(var) => text.push_str(self.var(*var)),
            Expr::Unary(operator, operand) => self.unary(*operator, operand, text),
            Expr::Binary(operator, left, right) => self.binary(*operator, left, right, text),
            Expr::Intrinsic(intrinsic, operands) => self.intrinsic(*intrinsic, operands, text),
        }
    }

    /// Appends an expression that binds at least as tightly as asked.
    fn bound(&self, expr: &Expr, least: Precedence, text: &mut String) {
        if self.precedence(expr) < least {
            text.push('(');
            self.expr(expr, text);
            text.push(')');
        } else {
            self.expr(expr, text);
        }
    }

    fn unary(&self, operator: Unary, operand: &Expr, text: &mut String) {
        let wraps = operator == Unary::Negate && self.is_i32(operand);
        text.push_str(match operator {
            Unary::Negate if wraps => "(int32_t)(0u - (uint32_t)",
            Unary::Negate => "-",
            Unary::Not => "!",
        });
        // `Primary`: no `--x`, and the reader sees what the sign belongs to.
        self.bound(operand, Precedence::Primary, text);
        text.push_str(if wraps { ")" } else { "" });
    }

    fn binary(&self, operator: Binary, left: &Expr, right: &Expr, text: &mut String) {
        let symbol = symbol(operator);
        if is_arithmetic(operator) && self.is_i32(left) {
            // A signed overflow has no meaning in C: wrap around as unsigned numbers do.
            text.push_str("(int32_t)((uint32_t)");
            self.bound(left, Precedence::Primary, text);
            text.push_str(symbol);
            text.push_str("(uint32_t)");
            self.bound(right, Precedence::Primary, text);
            text.push(')');
            return;
        }
        let (left_least, right_least) = match operator {
            Binary::Add | Binary::Subtract => (Precedence::Sum, Precedence::Product),
            Binary::Multiply | Binary::Divide => (Precedence::Product, Precedence::Primary),
            Binary::And => (Precedence::And, Precedence::And),
            // `&&` beside `||`, and a comparison of comparisons, are legal and misread: they get parentheses.
            Binary::Or if is_or(left) => (Precedence::Or, Precedence::Equality),
            Binary::Or => (Precedence::Equality, Precedence::Equality),
            _ => (Precedence::Sum, Precedence::Sum),
        };
        // A sign right of an operator is easily overlooked.
        let right_least = if matches!(right, Expr::Literal(_)) { Precedence::Primary } else { right_least };
        self.bound(left, left_least, text);
        text.push_str(symbol);
        self.bound(right, right_least, text);
    }

    fn intrinsic(&self, intrinsic: Intrinsic, operands: &[Expr], text: &mut String) {
        match (intrinsic, operands) {
            (Intrinsic::Usable | Intrinsic::Within, [x, limit]) => {
                text.push_str("magnitude(");
                self.expr(x, text);
                text.push_str(") <= ");
                self.bound(limit, Precedence::Sum, text);
            }
            (Intrinsic::Truncate, [x]) => {
                text.push_str("(int32_t)");
                self.bound(x, Precedence::Primary, text);
            }
            (Intrinsic::Nearest, [x]) => {
                text.push_str("nearest(");
                self.expr(x, text);
                text.push(')');
            }
            (Intrinsic::FromU32 | Intrinsic::FromI32, [value]) => {
                text.push_str(match self.program().real {
                    RealKind::F64 => "(double)",
                    RealKind::F32 => "(float)",
                });
                self.bound(value, Precedence::Primary, text);
            }
            _ => panic!("c: {intrinsic:?} with {} operands", operands.len()),
        }
    }

    fn precedence(&self, expr: &Expr) -> Precedence {
        match expr {
            Expr::Literal(literal) if is_negative(*literal) => Precedence::Unary,
            Expr::Literal(_) | Expr::Var(_) => Precedence::Primary,
            Expr::Unary(..) => Precedence::Unary,
            Expr::Binary(operator, left, _) => match operator {
                operator if is_arithmetic(*operator) && self.is_i32(left) => Precedence::Unary,
                Binary::Add | Binary::Subtract => Precedence::Sum,
                Binary::Multiply | Binary::Divide => Precedence::Product,
                Binary::Less | Binary::LessEqual | Binary::Greater | Binary::GreaterEqual => Precedence::Relation,
                Binary::Equal | Binary::NotEqual => Precedence::Equality,
                Binary::And => Precedence::And,
                Binary::Or => Precedence::Or,
            },
            Expr::Intrinsic(Intrinsic::Usable | Intrinsic::Within, _) => Precedence::Relation,
            Expr::Intrinsic(Intrinsic::FromU32 | Intrinsic::FromI32 | Intrinsic::Truncate, _) => Precedence::Unary,
            Expr::Intrinsic(Intrinsic::Nearest, _) => Precedence::Primary,
        }
    }

    fn is_i32(&self, expr: &Expr) -> bool {
        type_of(expr, self.program()) == Ok(Type::I32)
    }
}

fn symbol(operator: Binary) -> &'static str {
    match operator {
        Binary::Add => " + ",
        Binary::Subtract => " - ",
        Binary::Multiply => " * ",
        Binary::Divide => " / ",
        Binary::Less => " < ",
        Binary::LessEqual => " <= ",
        Binary::Greater => " > ",
        Binary::GreaterEqual => " >= ",
        Binary::Equal => " == ",
        Binary::NotEqual => " != ",
        Binary::And => " && ",
        Binary::Or => " || ",
    }
}

fn is_arithmetic(operator: Binary) -> bool {
    matches!(operator, Binary::Add | Binary::Subtract | Binary::Multiply)
}

fn is_or(expr: &Expr) -> bool {
    matches!(expr, Expr::Binary(Binary::Or, ..))
}

/// Whether the literal's text begins with a sign.
fn is_negative(literal: Literal) -> bool {
    match literal {
        Literal::F64(value) => value.is_sign_negative(),
        Literal::F32(value) => value.is_sign_negative(),
        Literal::I32(value) => value < 0 && value != i32::MIN,
        _ => false,
    }
}
