//! Expressions and places: from the portable IR to the program, folding what is known.

use super::node::{Cell, Node};
use super::{Specialiser, number};
use crate::arithmetic;
use crate::program::{Expr, Var};
use portable::{Binary, Literal, Projection, Unary};
use std::rc::Rc;

impl Specialiser<'_> {
    /// Evaluates an expression: a literal where all of it is known, else what the program has to compute.
    pub(super) fn expr(&mut self, expr: &'static portable::Expr) -> Expr {
        match expr {
            portable::Expr::Constant { value } => Expr::Literal(value()),
            portable::Expr::Read { place } => {
                let node = self.place(place);
                self.read(&node)
            }
            portable::Expr::Unary { operator, operand } => {
                let operand = self.expr(operand);
                Self::unary(*operator, operand)
            }
            portable::Expr::Binary { operator, left, right } => {
                let left = self.expr(left);
                let right = self.expr(right);
                self.binary(*operator, left, right)
            }
            portable::Expr::Call { function, arguments } => {
                self.call(function, arguments).expect("specialise: a function that is used as a value has one")
            }
            portable::Expr::If { .. } | portable::Expr::Match { .. } => self.choice(expr, "value"),
            portable::Expr::Array { .. } | portable::Expr::Repeat { .. } => {
                panic!("specialise: in {}: an array is no scalar", self.frame().function)
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

    /// What a place stands for.
    pub(super) fn place(&mut self, place: &'static portable::Place) -> Rc<Node> {
        let mut node = self.lookup(place.root);
        for projection in place.projections {
            let inner = match (projection, &*node) {
                (Projection::Field { name }, Node::Struct { fields, .. }) => {
                    fields.iter().find(|(field, _)| field == name).map(|(_, inner)| Rc::clone(inner))
                }
                (Projection::Index { index }, Node::Array { .. }) => {
                    let index = self.known_index(index);
                    let Node::Array { elements, .. } = &*node else { unreachable!() };
                    elements.get(index).map(Rc::clone)
                }
                _ => None,
            };
            node = inner.unwrap_or_else(|| {
                panic!("specialise: in {}: no such part of `{}`", self.frame().function, place.root)
            });
        }
        node
    }

    fn lookup(&self, name: &str) -> Rc<Node> {
        let names = &self.frame().names;
        let found = names.iter().rev().find(|(known, _)| *known == name);
        Rc::clone(&found.unwrap_or_else(|| panic!("specialise: in {}: no name `{name}`", self.frame().function)).1)
    }

    /// The value of a scalar.
    fn read(&mut self, node: &Node) -> Expr {
        let Node::Leaf(cell) = node else {
            panic!("specialise: in {}: a struct or an array is no scalar; borrow it", self.frame().function)
        };
        match self.cells[*cell] {
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
        match expr {
            Expr::Literal(literal) => Some(*literal),
            Expr::Var(Var::Constant(index)) => Some(self.constants[*index].value),
            _ => None,
        }
    }

    fn unary(operator: Unary, operand: Expr) -> Expr {
        match operand {
            Expr::Literal(literal) => Expr::Literal(arithmetic::unary(operator, literal)),
            operand => Expr::Unary(operator, Box::new(operand)),
        }
    }

    /// An operator on two values. A comparison of known values is decided; arithmetic on a named constant stays, so that
    /// the name stays.
    pub(super) fn binary(&self, operator: Binary, left: Expr, right: Expr) -> Expr {
        let known = (self.known(&left), self.known(&right));
        match (operator, known) {
            (Binary::And, (Some(Literal::Bool(true)), _)) | (Binary::Or, (Some(Literal::Bool(false)), _)) => {
                return right;
            }
            (Binary::And, (_, Some(Literal::Bool(true)))) | (Binary::Or, (_, Some(Literal::Bool(false)))) => {
                return left;
            }
            (Binary::And, (Some(Literal::Bool(false)), _) | (_, Some(Literal::Bool(false)))) => {
                return Expr::Literal(Literal::Bool(false));
            }
            (Binary::Or, (Some(Literal::Bool(true)), _) | (_, Some(Literal::Bool(true)))) => {
                return Expr::Literal(Literal::Bool(true));
            }
            // The first term of a sum: the only addition that changes no number.
            (Binary::Add, (Some(start), _)) if arithmetic::is_negative_zero(start) => return right,
            (_, (Some(a), Some(b))) => {
                let computes = matches!(operator, Binary::Add | Binary::Subtract | Binary::Multiply | Binary::Divide);
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
        Expr::Binary(operator, Box::new(at_run_time(left)), Box::new(at_run_time(right)))
    }
}

/// A literal that meets a run-time value: a variant becomes its number.
fn at_run_time(expr: Expr) -> Expr {
    match expr {
        Expr::Literal(literal) => Expr::Literal(number(literal)),
        other => other,
    }
}
