//! Expressions and places: from the portable IR to the program, folding known values.

use super::Specialiser;
use super::part::{Cell, Named, Part};
use crate::arithmetic;
use crate::program::{Expr, push_field, push_index};
use portable::{Binary, Literal, Projection};
use std::rc::Rc;

impl Specialiser<'_> {
    /// Evaluates an expression: a literal if it is known completely, else the computation of the program.
    pub(super) fn expr(&mut self, expr: &'static portable::Expr) -> Expr {
        match expr {
            portable::Expr::Constant { value } => Expr::Literal(value()),
            portable::Expr::Read { place } => {
                let part = self.place(place);
                self.read(part)
            }
            portable::Expr::Unary { operator, operand } => match self.expr(operand) {
                Expr::Literal(literal) => Expr::Literal(arithmetic::unary(*operator, literal)),
                operand => Expr::Unary(*operator, Box::new(operand)),
            },
            portable::Expr::Binary { operator, left, right } => {
                let left = self.expr(left);
                let right = self.expr(right);
                self.binary(*operator, left, right)
            }
            portable::Expr::Call { function, arguments } => self.called(function, arguments, "value"),
            portable::Expr::If { .. } | portable::Expr::Match { .. } => self.choice(expr, "value"),
            portable::Expr::Array { .. } | portable::Expr::Repeat { .. } => {
                panic!("specialise: in {}: an array is not a scalar", self.frame().function)
            }
        }
    }

    /// Evaluates an expression that must be known: an index or the bound of a loop.
    pub(super) fn known_index(&mut self, expr: &'static portable::Expr) -> usize {
        match self.expr(expr) {
            Expr::Literal(Literal::Usize(index)) => index,
            other => panic!("specialise: in {}: an index or a bound is not known: {other:?}", self.frame().function),
        }
    }

    /// The cells of a place.
    pub(super) fn place(&mut self, place: &'static portable::Place) -> Part {
        let mut part = self.lookup(place.root).part;
        for projection in place.projections {
            let inner = match projection {
                Projection::Field { name } => part.field(name),
                Projection::Index { index } => part.element(self.known_index(index)),
            };
            part = inner.unwrap_or_else(|| {
                panic!("specialise: in {}: no such part of `{}`", self.frame().function, place.root)
            });
        }
        part
    }

    /// The path of a place in the state, the inputs or the outputs.
    pub(super) fn path(&mut self, place: &'static portable::Place) -> Option<Rc<str>> {
        let root = self.lookup(place.root).path.as_ref()?;
        if place.projections.is_empty() {
            return Some(Rc::clone(root));
        }
        let mut path = root.to_string();
        for projection in place.projections {
            match projection {
                Projection::Field { name } => push_field(&mut path, name),
                Projection::Index { index } => push_index(&mut path, self.known_index(index)),
            }
        }
        Some(path.into())
    }

    fn lookup(&self, name: &str) -> &Named {
        let found = self.names[self.frame().first_name..].iter().rfind(|known| known.name == name);
        found.unwrap_or_else(|| panic!("specialise: in {}: no name `{name}`", self.frame().function))
    }

    /// The value of a scalar.
    pub(super) fn read(&mut self, part: Part) -> Expr {
        let Some(cell) = part.cell() else {
            panic!("specialise: in {}: a struct or an array is not a scalar; borrow it", self.frame().function)
        };
        match self.cells[cell] {
            Cell::Coefficient(position) => match self.coefficients[position] {
                Literal::F64(_) | Literal::F32(_) | Literal::I32(_) | Literal::U32(_) => self.coefficient(position),
                decides => Expr::Literal(decides),
            },
            Cell::Known(value) => Expr::Literal(value),
            Cell::Fixed(var) | Cell::Memory(var) => Expr::Var(var),
        }
    }

    /// The value of an expression that is known, named or not.
    pub(super) fn known(&self, expr: &Expr) -> Option<Literal> {
        expr.known(&self.program.constants)
    }

    /// An operator on two values. A comparison of known values is decided; arithmetic on a named constant is kept, so that
    /// the name is kept.
    pub(super) fn binary(&mut self, operator: Binary, left: Expr, right: Expr) -> Expr {
        if matches!(operator, Binary::And | Binary::Or) {
            return Expr::logic(operator, left, right);
        }
        match (operator, (self.known(&left), self.known(&right))) {
            // The first term of a sum: the only addition that changes no number.
            (Binary::Add, (Some(start), _)) if [Literal::F64(-0.0), Literal::F32(-0.0)].contains(&start) => {
                return right;
            }
            (_, (Some(a), Some(b))) => {
                let computes = matches!(
                    operator,
                    Binary::Add | Binary::Subtract | Binary::Multiply | Binary::Divide | Binary::Remainder
                );
                let anonymous = matches!((&left, &right), (Expr::Literal(_), Expr::Literal(_)));
                if anonymous || !computes {
                    let value = arithmetic::binary(operator, a, b);
                    if arithmetic::is_finite(value) {
                        return Expr::Literal(value);
                    }
                }
            }
            _ => {}
        }
        let (left, right) = (self.run_time(left), self.run_time(right));
        Expr::binary(operator, left, right)
    }
}
