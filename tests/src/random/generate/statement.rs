//! Random statements and blocks.

use super::scope::{Access, Writer};
use super::shape;
use crate::random::syntax::{Block, Expr, Place, Scalar, Statement, Type, Value};
use portable::Binary;

impl Writer<'_> {
    /// A block of so many statements, with a value if its type is given.
    pub fn block(&mut self, count: usize, value: Option<Scalar>, depth: usize) -> Block {
        let visible = self.scope.len();
        let mut statements = Vec::new();
        for _ in 0..count {
            self.statement(depth, &mut statements);
        }
        let value = value.map(|scalar| Box::new(self.whole(scalar, depth)));
        self.scope.truncate(visible);
        Block { statements, value }
    }

    /// Adds a statement, or a few that belong together.
    pub fn statement(&mut self, depth: usize, statements: &mut Vec<Statement>) {
        if !self.spend(1) {
            return;
        }
        let branch = usize::from(depth > 0);
        let written = match self.rng.weighted(&[24, 6, 26, 13, 14 * branch, 9 * branch, 10 * branch, 15, 8, 7 * branch])
        {
            0 => Some(self.local()),
            1 => Some(self.array()),
            2 => self.assignment(depth),
            3 => self.compound(),
            4 => Some(Statement::If(self.choice(None, depth - 1))),
            5 => Some(Statement::Match(self.selection(None, depth - 1))),
            6 => self.repetition(depth - 1),
            7 => self.mutating_call().map(Statement::Call),
            8 => {
                self.copied_before_change(depth, statements);
                None
            }
            _ => {
                self.assigned_on_some_ways(depth, statements);
                None
            }
        };
        statements.extend(written);
    }

    /// A whole value: right of `let` or `=`, or at a block's end.
    pub fn whole(&mut self, scalar: Scalar, depth: usize) -> Expr {
        let branch = usize::from(depth > 0 && scalar != Scalar::Usize);
        match self.rng.weighted(&[60, 14 * branch, 9 * branch, 22]) {
            1 => Expr::If(Box::new(self.choice(Some(scalar), depth - 1))),
            2 => Expr::Match(Box::new(self.selection(Some(scalar), depth - 1))),
            3 => match self.call_for(scalar) {
                Some(call) => Expr::Call(call),
                None => self.expr(scalar, 2),
            },
            _ => {
                let depth = self.rng.between(1, 3);
                self.expr(scalar, depth)
            }
        }
    }

    fn local(&mut self) -> Statement {
        if self.rng.chance(5)
            && let Some(known) = self.read(Scalar::Usize)
            && !matches!(&known, Expr::Read(place, _) if self.is_index(place))
        {
            let name = self.fresh();
            self.enter(&name, Type::Scalar(Scalar::Usize), Access::Read);
            return Statement::Let { name, mutable: false, value: known };
        }
        if self.rng.chance(6) {
            let value = self.truncated();
            let name = self.fresh();
            self.enter(&name, Type::Scalar(Scalar::I32), Access::Read);
            return Statement::Let { name, mutable: false, value };
        }
        let scalar = shape::scalar(false, self.program, self.rng);
        let mutable = self.rng.chance(50);
        let value = if mutable && self.rng.chance(40) { self.leaf(scalar) } else { self.whole(scalar, 1) };
        let name = self.fresh();
        self.enter(&name, Type::Scalar(scalar), if mutable { Access::Local } else { Access::Read });
        Statement::Let { name, mutable, value }
    }

    fn array(&mut self) -> Statement {
        let scalar = shape::scalar(false, self.program, self.rng);
        let length = shape::length(self.program, self.rng);
        let value = if self.rng.chance(50) {
            Expr::Array((0..length.count).map(|_| self.expr(scalar, 1)).collect())
        } else {
            Expr::Repeat(Box::new(self.expr(scalar, 1)), length)
        };
        let (name, mutable) = (self.fresh(), self.rng.chance(70));
        let access = if mutable { Access::Local } else { Access::Read };
        self.enter(&name, Type::Array(Box::new(Type::Scalar(scalar)), length), access);
        Statement::Let { name, mutable, value }
    }

    fn assignment(&mut self, depth: usize) -> Option<Statement> {
        let (place, scalar) = self.writable(None)?;
        let mut value = self.whole(scalar, depth.min(1));
        if value == Expr::Read(place.clone(), scalar) {
            value = self.expr(scalar, 2);
        }
        Some(Statement::Assign { place, value })
    }

    fn compound(&mut self) -> Option<Statement> {
        let scalar = *self.rng.pick(&[Scalar::I32, Scalar::U32]);
        let (place, _) = self.writable(Some(scalar)).filter(|(place, _)| self.has_value(place))?;
        let operator = *self.rng.pick(&[Binary::Add, Binary::Subtract, Binary::Multiply]);
        Some(Statement::Compound { place, operator, value: self.expr(scalar, 1) })
    }

    /// A loop of two to four turns; with a coefficient as its end sometimes none.
    pub fn repetition(&mut self, depth: usize) -> Option<Statement> {
        let length = shape::length(self.program, self.rng);
        let (from, to, most) = match self.rng.weighted(&[50, 12, 38]) {
            0 => (Value::Usize(0), end(length.named, length.count), length.count),
            1 => (Value::Usize(1), end(length.named, length.count), length.count),
            _ => match self.read(Scalar::Usize) {
                Some(Expr::Read(place, scalar)) if !self.is_index(&place) => {
                    (Value::Usize(0), Expr::Read(place, scalar), 2)
                }
                _ => (Value::Usize(0), end(length.named, length.count), length.count),
            },
        };
        if self.cost + 2 * most * self.repeats > self.limit {
            return None;
        }
        let variable = self.fresh();
        let visible = self.scope.len();
        self.enter(&variable, Type::Scalar(Scalar::Usize), Access::Index(most));
        self.repeats *= most;
        let count = self.rng.between(1, 2);
        let body = self.block(count, None, depth);
        self.repeats /= most;
        self.scope.truncate(visible);
        Some(Statement::For { variable, from: Expr::Literal(from), to, body })
    }

    /// Whether a place may be looked at.
    pub fn has_value(&self, place: &Place) -> bool {
        self.scope.iter().any(|binding| binding.name == place.root && binding.readable)
    }

    /// Whether a place is a loop variable.
    fn is_index(&self, place: &Place) -> bool {
        let mut found = self.scope.iter().filter(|binding| binding.name == place.root);
        found.any(|binding| matches!(binding.access, Access::Index(_)))
    }
}

/// The end of a loop, by name where it has one.
fn end(named: Option<usize>, count: usize) -> Expr {
    Expr::Literal(named.map_or(Value::Usize(count), Value::Length))
}
