//! Expressions as Structured Text, one to one, with more parentheses than the standard asks for: implementations read
//! `NOT`, signs and mixed operators in more than one way.

use super::dialect::{type_name, usable};
use super::print::Printer;
use super::types;
use compiler::program::{Expr, Type};
use portable::{Binary, Intrinsic, Literal, Unary};

/// How tightly an expression binds, loosest first.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
enum Precedence {
    Logic,
    Comparison,
    Sum,
    Product,
    Sign,
    Primary,
}

impl Printer<'_> {
    /// Appends an expression.
    pub(super) fn expr(&self, expr: &Expr, text: &mut String) {
        match expr {
            Expr::Literal(literal) => text.push_str(&types::in_statement(*literal)),
            Expr::Var(var) => text.push_str(self.var(*var)),
            Expr::Unary(operator, operand) => self.unary(*operator, operand, text),
            Expr::Binary(operator, left, right) => self.binary(*operator, left, right, text),
            Expr::Intrinsic(intrinsic, operands) => self.intrinsic(*intrinsic, operands, text),
        }
    }

    /// Appends an operand: in parentheses unless it binds at least as tightly as asked. A sign always gets them.
    fn operand(&self, expr: &Expr, least: Precedence, text: &mut String) {
        let precedence = precedence(expr);
        if precedence < least || precedence == Precedence::Sign {
            text.push('(');
            self.expr(expr, text);
            text.push(')');
        } else {
            self.expr(expr, text);
        }
    }

    fn unary(&self, operator: Unary, operand: &Expr, text: &mut String) {
        text.push_str(match operator {
            Unary::Negate => "-",
            Unary::Not => "NOT ",
        });
        self.operand(operand, Precedence::Primary, text);
    }

    fn binary(&self, operator: Binary, left: &Expr, right: &Expr, text: &mut String) {
        let (left_least, right_least) = match operator {
            Binary::Add | Binary::Subtract => (Precedence::Sum, Precedence::Product),
            Binary::Multiply | Binary::Divide => (Precedence::Product, Precedence::Primary),
            Binary::And | Binary::Or if is(operator, left) => (Precedence::Logic, Precedence::Primary),
            Binary::And | Binary::Or => (Precedence::Primary, Precedence::Primary),
            _ => (Precedence::Sum, Precedence::Sum),
        };
        self.operand(left, left_least, text);
        text.push_str(symbol(operator));
        self.operand(right, right_least, text);
    }

    fn intrinsic(&self, intrinsic: Intrinsic, operands: &[Expr], text: &mut String) {
        let real = self.program().real;
        match (intrinsic, operands) {
            (Intrinsic::Usable, [x, limit]) if self.dialect().looks_at_bits => {
                text.push_str(usable(real));
                text.push_str("(value := ");
                self.expr(x, text);
                text.push_str(", largest := ");
                self.expr(limit, text);
                text.push(')');
            }
            (Intrinsic::Usable | Intrinsic::Within, [x, limit]) => {
                text.push_str("(-");
                self.operand(limit, Precedence::Primary, text);
                text.push_str(" <= ");
                self.operand(x, Precedence::Sum, text);
                text.push_str(") AND (");
                self.operand(x, Precedence::Sum, text);
                text.push_str(" <= ");
                self.operand(limit, Precedence::Sum, text);
                text.push(')');
            }
            (Intrinsic::FromU32 | Intrinsic::FromI32, [value]) => {
                text.push_str(if intrinsic == Intrinsic::FromU32 { "UDINT_TO_" } else { "DINT_TO_" });
                text.push_str(type_name(Type::Real, real));
                text.push('(');
                self.expr(value, text);
                text.push(')');
            }
            // The only conversion to an integer on which implementations agree.
            (Intrinsic::Truncate, [x]) => {
                text.push_str("TRUNC(");
                self.expr(x, text);
                text.push(')');
            }
            _ => panic!("st: {intrinsic:?} with {} operands", operands.len()),
        }
    }
}

fn precedence(expr: &Expr) -> Precedence {
    match expr {
        Expr::Literal(literal) => of_literal(*literal),
        Expr::Var(_)
        | Expr::Intrinsic(Intrinsic::FromU32 | Intrinsic::FromI32 | Intrinsic::Truncate | Intrinsic::Nearest, _) => {
            Precedence::Primary
        }
        Expr::Unary(..) => Precedence::Sign,
        Expr::Binary(operator, ..) => match operator {
            Binary::Add | Binary::Subtract => Precedence::Sum,
            Binary::Multiply | Binary::Divide => Precedence::Product,
            Binary::And | Binary::Or => Precedence::Logic,
            _ => Precedence::Comparison,
        },
        Expr::Intrinsic(Intrinsic::Usable | Intrinsic::Within, _) => Precedence::Logic,
    }
}

/// A literal may be a product, or begin with a sign.
fn of_literal(literal: Literal) -> Precedence {
    let text = types::in_statement(literal);
    match text.as_bytes().first() {
        _ if text.contains(" * ") => Precedence::Product,
        Some(b'-') => Precedence::Sign,
        _ => Precedence::Primary,
    }
}

/// Whether the expression is one with this operator.
fn is(operator: Binary, expr: &Expr) -> bool {
    matches!(expr, Expr::Binary(found, ..) if *found == operator)
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
        Binary::Equal => " = ",
        Binary::NotEqual => " <> ",
        Binary::And => " AND ",
        Binary::Or => " OR ",
    }
}
