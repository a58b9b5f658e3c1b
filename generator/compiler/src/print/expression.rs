//! Expressions, one to one, with the parentheses that the description of a language requires.

use super::language::{Form, Level};
use super::{Doc, INDENTATION, Layout};
use crate::program::{Expr, Var};
use portable::{Binary, Unary};
use pretty::DocAllocator;

#[derive(Clone)]
pub(super) struct Printed<'d> {
    pub doc: Doc<'d>,
    level: Level,
}

impl<'d> Layout<'d> {
    pub(super) fn expr(&self, expr: &'d Expr) -> Printed<'d> {
        let (language, program) = (self.printer.language, self.printer.program);
        let first = match expr {
            Expr::Literal(value) => {
                let (text, level) = (language.operand)(*value);
                return Printed { doc: self.arena.text(text), level };
            }
            Expr::Var(var) => {
                return Printed { doc: self.arena.text(&self.printer.texts[*var]), level: Level::Primary };
            }
            Expr::Element(row, index) => {
                let array = super::without_index(&self.printer.texts.state[row.first]);
                let [open, close] = language.index;
                let doc = self.arena.text(array).append(open).append(self.expr(index).doc).append(close);
                return Printed { doc, level: Level::Primary };
            }
            _ => expr.operands().next().expect("print: an operation has operands"),
        };
        match ((language.form)(expr, first.ty(program), program.real), expr) {
            (Some(form), _) => self.spelled(&form, expr),
            (None, Expr::Binary(operator, left, right)) => self.infix(*operator, left, right),
            (None, _) => panic!("print: {expr:?} stands between no operands"),
        }
    }

    fn infix(&self, operator: Binary, left: &'d Expr, right: &'d Expr) -> Printed<'d> {
        let language = self.printer.language;
        let (level, [mut left_least, mut right_least]) = match operator {
            Binary::Add | Binary::Subtract => (Level::Sum, [Level::Sum, Level::Product]),
            Binary::Multiply | Binary::Divide => (Level::Product, [Level::Product, Level::Primary]),
            // The precedence of a remainder is easily misread.
            Binary::Remainder => (Level::Any, [Level::Primary; 2]),
            Binary::And => (Level::And, [language.logic[0]; 2]),
            Binary::Or => (Level::Or, [language.logic[1]; 2]),
            // A comparison of comparisons is legal in C but misread: it gets parentheses.
            _ => (Level::Comparison, [Level::Sum; 2]),
        };
        let is_logic = matches!(operator, Binary::And | Binary::Or);
        if is_logic && matches!(left, Expr::Binary(same, ..) if *same == operator) {
            left_least = Level::Any;
        }
        // Compilers warn of a negation on the left of a comparison.
        if level == Level::Comparison && matches!(left, Expr::Unary(Unary::Not, _)) {
            left_least = Level::Primary;
        }
        // A sign on the right of an operator is easily overlooked.
        if matches!(right, Expr::Literal(_)) {
            right_least = Level::Primary;
        }
        let right = self.arena.text(language.symbols[operator as usize]).append(" ").append(self.bound(
            self.expr(right),
            right_least,
            INDENTATION,
        ));
        let left = self.bound(self.expr(left), left_least, INDENTATION);
        let doc = if is_logic || level == Level::Sum {
            left.append(self.line_before(right))
        } else {
            left.append(" ").append(right)
        };
        Printed { doc, level }
    }

    fn spelled(&self, form: &Form, expr: &'d Expr) -> Printed<'d> {
        let operands: Vec<Printed<'d>> = expr.operands().map(|operand| self.expr(operand)).collect();
        let line = |text: &'static str| {
            let mut pieces = text.split('{');
            let mut before = pieces.next().unwrap_or_default();
            let mut doc = self.arena.text(before);
            for piece in pieces {
                let (what, text) = piece.split_once('}').expect("print: a form's operand ends");
                let index = usize::from(what == "1");
                doc = match self.negated(expr.operands().nth(index)).filter(|_| before.ends_with('-')) {
                    _ if what == "block" => doc.append(self.printer.block),
                    Some(negated) => doc.append(negated),
                    None => doc.append(self.bound(operands[index].clone(), form.least[index], 0)),
                };
                doc = doc.append(text);
                before = text;
            }
            doc
        };
        let doc = match form.text.split_once('\n') {
            Some((first, second)) => line(first).append(self.line_before(line(second))),
            None => line(form.text),
        };
        Printed { doc, level: form.level }
    }

    /// The text of an operand after a sign, if that differs.
    fn negated(&self, operand: Option<&Expr>) -> Option<&'d str> {
        let Some(Expr::Var(Var::Constant(index))) = operand else { return None };
        self.printer.negated[*index].as_deref()
    }

    /// An operand: in parentheses unless it binds at least as tightly as required. Line breaks inside are indented.
    fn bound(&self, operand: Printed<'d>, least: Level, indentation: isize) -> Doc<'d> {
        if operand.level >= least {
            return operand.doc;
        }
        self.arena.text("(").append(operand.doc.nest(indentation)).append(")")
    }
}
