//! Random statements that belong together: where an order of effects, or the value of a local, is most easily lost.

use super::expression::operation;
use super::scope::{Access, Writer};
use super::shape;
use crate::random::syntax::{Block, Choice, Expr, Place, Scalar, Statement, Step, Type, Value};
use portable::Binary;

impl Writer<'_> {
    /// A value is kept, what it was read from changes, perhaps only on one way, and then both are used.
    pub fn copied_before_change(&mut self, depth: usize, statements: &mut Vec<Statement>) {
        let Some((place, scalar)) = self.writable(None) else { return };
        if !self.has_value(&place) {
            return;
        }
        let kept = self.fresh();
        let read = Expr::Read(place.clone(), scalar);
        self.enter(&kept, Type::Scalar(scalar), Access::Read);
        statements.push(Statement::Let { name: kept.clone(), mutable: false, value: read.clone() });
        let call = if self.choices.chance(50) { self.mutating_call() } else { None };
        let change = match call {
            Some(call) => Statement::Call(call),
            None => Statement::Assign { place: place.clone(), value: self.expr(scalar, 2) },
        };
        statements.push(if depth > 0 && self.choices.chance(40) {
            let condition = self.condition();
            let then = Block { statements: vec![change], value: None };
            Statement::If(Choice { condition, then, otherwise: None })
        } else {
            change
        });
        let both = match scalar {
            Scalar::Real | Scalar::I32 | Scalar::U32 => {
                let kept = Expr::Read(Place::root(&kept), scalar);
                let (operator, swapped) =
                    (*self.choices.pick(&[Binary::Subtract, Binary::Multiply]), self.choices.chance(50));
                if swapped { operation(operator, kept, read) } else { operation(operator, read, kept) }
            }
            other => Expr::Read(Place::root(&kept), other),
        };
        if let Some((target, _)) = self.writable(Some(scalar)) {
            statements.push(Statement::Assign { place: target, value: both });
        }
    }

    /// A local that is assigned in some branches, perhaps within a loop, and in others not.
    pub fn assigned_on_some_ways(&mut self, depth: usize, statements: &mut Vec<Statement>) {
        let scalar =
            if self.choices.chance(60) { Scalar::Real } else { shape::scalar(false, self.program, self.choices) };
        let (name, value) = (self.fresh(), self.leaf(scalar));
        statements.push(Statement::Let { name: name.clone(), mutable: true, value });
        self.enter(&name, Type::Scalar(scalar), Access::Local);
        let mut change = self.assignment_to(&name, scalar);
        for _ in 0..self.choices.between(1, 2) {
            let otherwise = if self.choices.chance(40) { Some(self.assignment_to(&name, scalar)) } else { None };
            let condition = self.condition();
            let alone = |statement| Block { statements: vec![statement], value: None };
            change = Statement::If(Choice { condition, then: alone(change), otherwise: otherwise.map(alone) });
        }
        let repeated = if self.choices.chance(30) { self.repetition(depth - 1, true) } else { None };
        statements.push(match repeated {
            Some(Statement::For { variable, from, to, mut body }) => {
                body.statements.push(change);
                Statement::For { variable, from, to, body }
            }
            _ => change,
        });
    }

    /// The element of an array in the state that a number selects, by a question for each index.
    pub fn picked(&mut self, statements: &mut Vec<Statement>) {
        let Some((place, scalar, length)) = self.array_in_state() else { return };
        let Some((target, _)) = self.writable(Some(scalar)).filter(|(target, _)| !target.overlaps(&place)) else {
            return;
        };
        if !self.has_value(&place) || !self.spend(length) {
            return;
        }
        let (turn, number) = (self.fresh(), self.expr(Scalar::U32, 2));
        let turns = Expr::Literal(Value::U32(u32::try_from(length).unwrap_or(u32::MAX) + 1));
        let value = operation(Binary::Remainder, number, turns);
        statements.push(Statement::Let { name: turn.clone(), mutable: false, value });
        self.enter(&turn, Type::Scalar(Scalar::U32), Access::Read);
        for index in 0..length {
            let asked = Expr::Literal(Value::U32(u32::try_from(index).unwrap_or(u32::MAX)));
            let condition = operation(Binary::Equal, Expr::Read(Place::root(&turn), Scalar::U32), asked);
            let mut element = place.clone();
            element.steps.push(Step::Index(Expr::Literal(Value::Usize(index))));
            let value = Expr::Read(element, scalar);
            let then = Block { statements: vec![Statement::Assign { place: target.clone(), value }], value: None };
            statements.push(Statement::If(Choice { condition, then, otherwise: None }));
        }
    }

    /// An array of at least three scalars that a `&mut` parameter holds.
    fn array_in_state(&mut self) -> Option<(Place, Scalar, usize)> {
        let mut found = Vec::new();
        for binding in self.scope.iter().filter(|binding| binding.readable && binding.access == Access::Mutable) {
            let Type::Struct(which) = binding.ty else { continue };
            for (name, ty) in &self.program.structs[which].fields {
                if let Type::Array(element, length) = ty
                    && let (Type::Scalar(scalar), 3..) = (&**element, length.count)
                {
                    let steps = vec![Step::Field(name.clone())];
                    found.push((Place { steps, ..Place::root(&binding.name) }, *scalar, length.count));
                }
            }
        }
        if found.is_empty() { None } else { Some(self.choices.pick(&found).clone()) }
    }

    fn assignment_to(&mut self, name: &str, scalar: Scalar) -> Statement {
        self.spend(1);
        Statement::Assign { place: Place::root(name), value: self.expr(scalar, 2) }
    }
}
