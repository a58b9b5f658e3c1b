//! Walking through the syntax: every statement and every expression, outer before inner, in the order of the text.

use super::syntax::{Argument, Block, Call, Callee, Choice, Expr, Place, Selection, Statement, Step};

/// What is met on the way.
#[derive(Clone, Copy, Debug)]
pub enum Node<'a> {
    /// a statement
    Statement(&'a Statement),
    /// an expression
    Expr(&'a Expr),
}

/// Called for each node.
pub type Visit<'v, 'a> = &'v mut dyn FnMut(Node<'a>);

impl Block {
    /// Calls the function for every statement and every expression, at any depth.
    pub fn visit<'a>(&'a self, visit: Visit<'_, 'a>) {
        for statement in &self.statements {
            statement.visit(visit);
        }
        if let Some(value) = &self.value {
            value.visit(visit);
        }
    }

    /// The calls in there.
    #[must_use]
    pub fn calls(&self) -> Vec<&Call> {
        let mut calls = Vec::new();
        self.visit(&mut |node| match node {
            Node::Statement(Statement::Call(call)) | Node::Expr(Expr::Call(call)) => calls.push(call),
            _ => {}
        });
        calls
    }

    /// The functions of the program that are called in there.
    #[must_use]
    pub fn callees(&self) -> Vec<usize> {
        let functions = self.calls().into_iter().filter_map(|call| match call.callee {
            Callee::Function(which) => Some(which),
            Callee::Intrinsic(_) => None,
        });
        functions.collect()
    }
}

impl Statement {
    /// As [`Block::visit`], this statement included.
    pub fn visit<'a>(&'a self, visit: Visit<'_, 'a>) {
        visit(Node::Statement(self));
        match self {
            Self::Let { value, .. } => value.visit(visit),
            Self::Assign { place, value } | Self::Compound { place, value, .. } => {
                place.visit(visit);
                value.visit(visit);
            }
            Self::For { from, to, body, .. } => {
                from.visit(visit);
                to.visit(visit);
                body.visit(visit);
            }
            Self::If(choice) => choice.visit(visit),
            Self::Match(selection) => selection.visit(visit),
            Self::Call(call) => call.visit(visit),
        }
    }
}

impl Expr {
    /// As [`Block::visit`], this expression included.
    pub fn visit<'a>(&'a self, visit: Visit<'_, 'a>) {
        visit(Node::Expr(self));
        match self {
            Self::Literal(_) => {}
            Self::Read(place, _) => place.visit(visit),
            Self::Unary(_, operand) | Self::Repeat(operand, _) => operand.visit(visit),
            Self::Binary(_, left, right) => {
                left.visit(visit);
                right.visit(visit);
            }
            Self::Call(call) => call.visit(visit),
            Self::If(choice) => choice.visit(visit),
            Self::Match(selection) => selection.visit(visit),
            Self::Array(elements) => elements.iter().for_each(|element| element.visit(visit)),
        }
    }
}

impl Choice {
    fn visit<'a>(&'a self, visit: Visit<'_, 'a>) {
        self.condition.visit(visit);
        self.then.visit(visit);
        if let Some(otherwise) = &self.otherwise {
            otherwise.visit(visit);
        }
    }
}

impl Selection {
    fn visit<'a>(&'a self, visit: Visit<'_, 'a>) {
        self.scrutinee.visit(visit);
        self.arms.iter().for_each(|arm| arm.body.visit(visit));
    }
}

impl Call {
    fn visit<'a>(&'a self, visit: Visit<'_, 'a>) {
        for argument in &self.arguments {
            match argument {
                Argument::Value(value) => value.visit(visit),
                Argument::Shared(place) | Argument::Mutable(place) => place.visit(visit),
            }
        }
    }
}

impl Place {
    fn visit<'a>(&'a self, visit: Visit<'_, 'a>) {
        for step in &self.steps {
            if let Step::Index(index) = step {
                index.visit(visit);
            }
        }
    }
}
