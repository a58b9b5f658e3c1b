//! Expressions, one to one, with the parentheses that a language's description asks for.

use super::language::{Form, Level, Operation, PRIMARY, Piece};
use super::{Doc, INDENTATION, Layout};
use crate::program::{Expr, Type};
use portable::{Binary, Intrinsic};
use pretty::DocAllocator;

/// An expression that has been printed.
pub(super) struct Printed<'d> {
    pub doc: Doc<'d>,
    level: Level,
    ty: Type,
}

impl<'d> Layout<'d> {
    pub(super) fn expr(&self, expr: &'d Expr) -> Printed<'d> {
        match expr {
            Expr::Literal(value) => {
                let (text, level) = (self.printer.language.operand)(*value);
                let ty = Type::of(*value).expect("print: the passes leave what exists at run time");
                Printed { doc: self.arena.text(text), level, ty }
            }
            Expr::Var(var) => {
                let ty = self.printer.program.ty(*var).expect("print: the typing pass has typed every local");
                Printed { doc: self.arena.text(self.printer.text(*var)), level: PRIMARY, ty }
            }
            Expr::Unary(operator, operand) => self.pieces(Operation::Unary(*operator), &[self.expr(operand)]),
            Expr::Binary(operator, left, right) => self.binary(*operator, left, right),
            Expr::Intrinsic(intrinsic, operands) => {
                let operands: Vec<_> = operands.iter().map(|operand| self.expr(operand)).collect();
                self.pieces(Operation::Intrinsic(*intrinsic), &operands)
            }
        }
    }

    fn binary(&self, operator: Binary, left: &'d Expr, right: &'d Expr) -> Printed<'d> {
        let printed = [self.expr(left), self.expr(right)];
        let ty = printed[0].ty;
        let operation = Operation::Binary(operator);
        let Form::Infix(level, symbol, [mut left_least, mut right_least]) = self.form(operation, ty) else {
            return self.pieces(operation, &printed);
        };
        let is_logic = matches!(operator, Binary::And | Binary::Or);
        if is_logic && matches!(left, Expr::Binary(same, ..) if *same == operator) {
            left_least = 0;
        }
        // A sign right of an operator is easily overlooked.
        if matches!(right, Expr::Literal(_)) {
            right_least = PRIMARY;
        }
        let [left, right] = printed;
        let right = self.arena.text(symbol).append(" ").append(self.bound(right, right_least, INDENTATION));
        let left = self.bound(left, left_least, INDENTATION);
        let doc = if is_logic || matches!(operator, Binary::Add | Binary::Subtract) {
            left.append(self.arena.line().append(right).group())
        } else {
            left.append(" ").append(right)
        };
        Printed { doc, level, ty: result(operation, ty) }
    }

    fn pieces(&self, operation: Operation, operands: &[Printed<'d>]) -> Printed<'d> {
        let ty = operands.first().expect("print: an operation has operands").ty;
        let Form::Pieces(level, pieces) = self.form(operation, ty) else {
            panic!("print: {operation:?} stands between no operands");
        };
        let (mut doc, mut behind_blank) = (self.arena.nil(), None);
        for piece in pieces {
            let next = match piece {
                Piece::Text(text) => self.arena.text(*text),
                Piece::Operand(index, least) => self.bound(operands[*index].clone(), *least, 0),
                Piece::Blank => {
                    behind_blank = Some(self.arena.line());
                    continue;
                }
            };
            match &mut behind_blank {
                Some(rest) => *rest = rest.clone().append(next),
                None => doc = doc.append(next),
            }
        }
        if let Some(rest) = behind_blank {
            doc = doc.append(rest.group());
        }
        Printed { doc, level, ty: result(operation, ty) }
    }

    /// An operand: in parentheses unless it binds at least as tightly as asked. What is broken within them is indented.
    fn bound(&self, operand: Printed<'d>, least: Level, indentation: isize) -> Doc<'d> {
        if operand.level >= least {
            return operand.doc;
        }
        self.arena.text("(").append(operand.doc.nest(indentation)).append(")")
    }

    fn form(&self, operation: Operation, ty: Type) -> Form {
        (self.printer.language.form)(operation, ty, self.printer.program.real)
    }
}

impl Clone for Printed<'_> {
    fn clone(&self) -> Self {
        Self { doc: self.doc.clone(), ..*self }
    }
}

/// The type of an operation whose first operand has a type.
fn result(operation: Operation, ty: Type) -> Type {
    use Binary::{Add, And, Divide, Multiply, Or, Subtract};
    match operation {
        Operation::Unary(_) | Operation::Binary(Add | Subtract | Multiply | Divide | And | Or) => ty,
        Operation::Binary(_) | Operation::Intrinsic(Intrinsic::InRange | Intrinsic::Within) => Type::Bool,
        Operation::Intrinsic(Intrinsic::FromU32 | Intrinsic::FromI32) => Type::Real,
        Operation::Intrinsic(Intrinsic::Truncate | Intrinsic::Nearest) => Type::I32,
    }
}
