//! Expressions, one to one, with the parentheses that the description of a language requires.

use super::Layout;
use super::language::{Form, Level};
use crate::program::{Expr, Var};
use portable::{Binary, Unary};

impl<'p> Layout<'p> {
    /// Writes an expression, and returns how tightly it binds.
    pub(super) fn expr(&mut self, expr: &Expr) -> Level {
        let super::Printer { language, program, texts, .. } = self.printer;
        let first = match expr {
            Expr::Literal(value) => {
                let (text, level) = (language.operand)(*value);
                self.lines.text(&text);
                return level;
            }
            Expr::Var(var) => {
                self.lines.text(&texts[*var]);
                return Level::Primary;
            }
            Expr::Element(row, index) => {
                let [open, close] = language.index;
                self.lines.text(super::without_index(&texts.state[row.first]));
                self.lines.text(open);
                self.expr(index);
                self.lines.text(close);
                return Level::Primary;
            }
            _ => expr.operands().next().expect("print: an operation has operands"),
        };
        match ((language.form)(expr, first.ty(program), program.real), expr) {
            (Some(form), _) => self.spelled(&form, expr),
            (None, Expr::Binary(operator, left, right)) => self.infix(*operator, left, right),
            (None, _) => panic!("print: {expr:?} stands between no operands"),
        }
    }

    fn infix(&mut self, operator: Binary, left: &Expr, right: &Expr) -> Level {
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
        self.bound(left, left_least, 1);
        let right = |layout: &mut Self| {
            layout.lines.text(language.symbols[operator as usize]);
            layout.lines.text(" ");
            layout.bound(right, right_least, 1);
        };
        if is_logic || level == Level::Sum {
            self.part(right);
        } else {
            self.lines.text(" ");
            right(self);
        }
        level
    }

    fn spelled(&mut self, form: &Form, expr: &Expr) -> Level {
        match form.text.split_once('\n') {
            Some((first, second)) => {
                self.pieces(first, form, expr);
                self.part(|layout| layout.pieces(second, form, expr));
            }
            None => self.pieces(form.text, form, expr),
        }
        form.level
    }

    /// A line of the text of an operation.
    fn pieces(&mut self, text: &str, form: &Form, expr: &Expr) {
        let mut pieces = text.split('{');
        let mut before = pieces.next().unwrap_or_default();
        self.lines.text(before);
        for piece in pieces {
            let (what, text) = piece.split_once('}').expect("print: a form's operand ends");
            let index = usize::from(what == "1");
            let operand = || expr.operands().nth(index).expect("print: a form has as many operands as its operation");
            match what {
                "block" => self.lines.text(self.printer.block),
                _ => match self.negated(operand()).filter(|_| before.ends_with('-')) {
                    Some(negated) => self.lines.text(negated),
                    None => self.bound(operand(), form.least[index], 0),
                },
            }
            self.lines.text(text);
            before = text;
        }
    }

    /// The text of an operand after a sign, if that differs.
    fn negated(&self, operand: &Expr) -> Option<&'p str> {
        let Expr::Var(Var::Constant(index)) = operand else { return None };
        self.printer.negated[*index].as_deref()
    }

    /// An operand: in parentheses unless it binds at least as tightly as required. Lines that begin in them are indented.
    fn bound(&mut self, operand: &Expr, least: Level, levels: usize) {
        let place = self.lines.place();
        if self.expr(operand) < least {
            self.lines.enclose(&place, levels);
        }
    }
}
