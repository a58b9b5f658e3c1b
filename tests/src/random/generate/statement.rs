//! Random statements and blocks.

use super::scope::{Access, Writer};
use super::shape;
use crate::random::syntax::{Block, Choice, Expr, Place, Scalar, Statement, Type, Value};
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
        self.choices.enter();
        if self.choices.is_there() && self.spend(1) {
            self.statement_here(depth, statements);
        }
        self.choices.leave();
    }

    fn statement_here(&mut self, depth: usize, statements: &mut Vec<Statement>) {
        // What stands around others may be left out, and leave them.
        let is_around = self.choices.is_there();
        let branch = usize::from(depth > 0);
        let written =
            match self.choices.weighted(&[24, 6, 26, 13, 14 * branch, 9 * branch, 10 * branch, 15, 8, 7 * branch, 6]) {
                0 => Some(self.local()),
                1 => Some(self.array()),
                2 => self.assignment(depth),
                3 => self.compound(),
                4 => {
                    let choice = self.choice(None, depth - 1);
                    self.or_inside(is_around, Statement::If(choice), statements)
                }
                5 => {
                    let selection = self.selection(None, depth - 1);
                    self.or_inside(is_around, Statement::Match(selection), statements)
                }
                6 => {
                    let repetition = self.repetition(depth - 1, is_around);
                    repetition.and_then(|repetition| self.or_inside(is_around, repetition, statements))
                }
                7 => self.mutating_call().map(Statement::Call),
                8 => {
                    self.copied_before_change(depth, statements);
                    None
                }
                9 => {
                    self.assigned_on_some_ways(depth, statements);
                    None
                }
                _ => {
                    self.picked(statements);
                    None
                }
            };
        statements.extend(written.filter(does_something));
    }

    /// A whole value: right of `let` or `=`, or at a block's end.
    pub fn whole(&mut self, scalar: Scalar, depth: usize) -> Expr {
        self.choices.enter();
        let value = self.whole_here(scalar, depth);
        self.choices.leave();
        value
    }

    fn whole_here(&mut self, scalar: Scalar, depth: usize) -> Expr {
        let branch = usize::from(depth > 0 && scalar != Scalar::Usize);
        match self.choices.weighted(&[60, 14 * branch, 9 * branch, 22]) {
            1 => {
                let is_around = self.choices.is_there();
                let choice = self.choice(Some(scalar), depth - 1);
                match choice.then.value {
                    Some(value) if !is_around && choice.then.statements.is_empty() => *value,
                    value => Expr::If(Box::new(Choice { then: Block { value, ..choice.then }, ..choice })),
                }
            }
            2 => Expr::Match(Box::new(self.selection(Some(scalar), depth - 1))),
            3 => match self.call_for(scalar) {
                Some(call) => self.or_argument(call),
                None => self.expr(scalar, 2),
            },
            _ => {
                let depth = self.choices.between(1, 3);
                self.expr(scalar, depth)
            }
        }
    }

    /// The statement; or, where it is not to be around others, those of its first block that has any.
    fn or_inside(
        &mut self,
        is_around: bool,
        statement: Statement,
        statements: &mut Vec<Statement>,
    ) -> Option<Statement> {
        if is_around {
            return Some(statement);
        }
        let blocks: Vec<Block> = match statement {
            Statement::For { body, .. } => vec![body],
            Statement::If(choice) => [choice.then].into_iter().chain(choice.otherwise).collect(),
            Statement::Match(selection) => selection.arms.into_iter().map(|arm| arm.body).collect(),
            other => return Some(other),
        };
        let inside = blocks.into_iter().find(|block| !block.statements.is_empty()).unwrap_or_default().statements;
        for statement in &inside {
            if let Statement::Let { name, .. } = statement {
                // No other name may be the same.
                self.enter(name, Type::Scalar(Scalar::Bool), Access::Read);
                self.scope.last_mut().into_iter().for_each(|binding| binding.readable = false);
            }
        }
        statements.extend(inside);
        None
    }

    fn local(&mut self) -> Statement {
        if self.choices.chance(5)
            && let Some(known) = self.read(Scalar::Usize)
            && !matches!(&known, Expr::Read(place, _) if self.is_index(place))
        {
            let name = self.fresh();
            self.enter(&name, Type::Scalar(Scalar::Usize), Access::Read);
            return Statement::Let { name, mutable: false, value: known };
        }
        if self.choices.chance(6) {
            let value = self.truncated();
            let name = self.fresh();
            self.enter(&name, Type::Scalar(Scalar::I32), Access::Read);
            return Statement::Let { name, mutable: false, value };
        }
        let scalar = shape::scalar(false, self.program, self.choices);
        let mutable = self.choices.chance(50);
        let value = if mutable && self.choices.chance(40) { self.leaf(scalar) } else { self.whole(scalar, 1) };
        let name = self.fresh();
        self.enter(&name, Type::Scalar(scalar), if mutable { Access::Local } else { Access::Read });
        Statement::Let { name, mutable, value }
    }

    fn array(&mut self) -> Statement {
        let scalar = shape::scalar(false, self.program, self.choices);
        let length = shape::length(self.program, self.choices);
        let value = if self.choices.chance(50) {
            Expr::Array((0..length.count).map(|_| self.expr(scalar, 1)).collect())
        } else {
            Expr::Repeat(Box::new(self.expr(scalar, 1)), length)
        };
        let (name, mutable) = (self.fresh(), self.choices.chance(70));
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
        let scalar = *self.choices.pick(&[Scalar::I32, Scalar::U32]);
        let (place, _) = self.writable(Some(scalar)).filter(|(place, _)| self.has_value(place))?;
        let operator = *self.choices.pick(&[Binary::Add, Binary::Subtract, Binary::Multiply]);
        Some(Statement::Compound { place, operator, value: self.expr(scalar, 1) })
    }

    /// A loop of two to four turns; with a coefficient as its end sometimes none.
    pub fn repetition(&mut self, depth: usize, is_around: bool) -> Option<Statement> {
        let length = shape::length(self.program, self.choices);
        let (from, to, most) = match self.choices.weighted(&[50, 12, 38]) {
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
        if is_around {
            self.enter(&variable, Type::Scalar(Scalar::Usize), Access::Index(most));
        }
        self.repeats *= most;
        let count = self.choices.between(1, 2);
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

/// Whether a statement around others has any of them left.
fn does_something(statement: &Statement) -> bool {
    let is_full = |block: &Block| !block.statements.is_empty();
    match statement {
        Statement::For { body, .. } => is_full(body),
        Statement::If(choice) => is_full(&choice.then) || choice.otherwise.as_ref().is_some_and(is_full),
        Statement::Match(selection) => selection.arms.iter().any(|arm| is_full(&arm.body)),
        _ => true,
    }
}

/// The end of a loop, by name where it has one.
fn end(named: Option<usize>, count: usize) -> Expr {
    Expr::Literal(named.map_or(Value::Usize(count), Value::Length))
}
