//! Statements, branches and loops: the order of effects, and what is known after a branch.

use super::node::{self, Cell, Node};
use super::{Specialiser, run_time};
use crate::program::{Expr, Statement, Var};
use portable::{Arm, Binary, CodeBlock, Literal};
use std::rc::Rc;

impl Specialiser<'_> {
    /// Runs a block; gives its value. The names that it declares end with it.
    pub(super) fn block(&mut self, block: &'static CodeBlock) -> Option<Expr> {
        let outer = self.frame().names.len();
        for statement in block.statements {
            self.statement(statement);
        }
        let value = block.value.map(|value| self.expr(value));
        self.frame_mut().names.truncate(outer);
        value
    }

    fn statement(&mut self, statement: &'static portable::Statement) {
        match statement {
            portable::Statement::Let { name, value } => {
                let node = match value {
                    portable::Expr::Array { elements } => {
                        let leaf = |element| {
                            let value = self.expr(element);
                            self.bind(name, value)
                        };
                        let elements = elements.iter().map(leaf).collect();
                        Rc::new(Node::Array { path: (*name).into(), elements })
                    }
                    portable::Expr::Repeat { value, len } => {
                        let value = self.expr(value);
                        let cell = self.settled(name, value);
                        let elements = (0..*len).map(|_| self.leaf(cell)).collect();
                        Rc::new(Node::Array { path: (*name).into(), elements })
                    }
                    value => {
                        let value = self.named_value(value, name);
                        self.bind(name, value)
                    }
                };
                self.frame_mut().names.push((name, node));
            }
            portable::Statement::Default { name, ty, leaves } => {
                let mut values = Vec::new();
                leaves(&mut |literal| values.push(literal));
                let mut values = values.into_iter();
                // Nothing of it is a variable of the block: its parts are locals, where they are not known.
                let node = node::build(*ty, None, "", &mut |_, _, _| {
                    let value = values.next().expect("specialise: as many values as the type has scalars");
                    self.cell(Cell::Known(value))
                });
                self.frame_mut().names.push((name, node));
            }
            portable::Statement::Assign { place, value } => {
                let name = place.projections.iter().rev().find_map(|projection| match projection {
                    portable::Projection::Field { name } => Some(*name),
                    portable::Projection::Index { .. } => None,
                });
                let name = name.unwrap_or(place.root);
                let value = self.named_value(value, name);
                let node = self.place(place);
                self.assign(&node, name, value);
            }
            portable::Statement::For { variable, from, to, body } => {
                for index in self.known_index(from)..self.known_index(to) {
                    let node = self.leaf(Cell::Known(Literal::Usize(index)));
                    self.frame_mut().names.push((variable, node));
                    self.block(body);
                    self.frame_mut().names.pop();
                }
            }
            portable::Statement::Expr { value } => match value {
                portable::Expr::Call { function, arguments } => {
                    self.call(function, arguments);
                }
                branching => {
                    self.branch(branching, None);
                }
            },
        }
    }

    /// The value of an expression; a local that holds a choice gets the name.
    fn named_value(&mut self, value: &'static portable::Expr, name: &str) -> Expr {
        match value {
            portable::Expr::If { .. } | portable::Expr::Match { .. } => self.choice(value, name),
            value => self.expr(value),
        }
    }

    fn assign(&mut self, node: &Node, name: &str, value: Expr) {
        let Node::Leaf(cell) = *node else {
            panic!("specialise: in {}: only a scalar can be assigned", self.frame().function)
        };
        match self.cells[cell] {
            Cell::Memory(target) => {
                let value = run_time(value);
                self.statements.push(Statement::Assign { target, value });
            }
            Cell::Known(_) | Cell::Fixed(_) => self.cells[cell] = self.settled(name, value),
            Cell::Coefficient(_) => panic!("specialise: in {}: a coefficient is written", self.frame().function),
        }
    }

    /// The value in a form that nothing can change any more: what can change, or is computed, goes to a new local.
    pub(super) fn settled(&mut self, name: &str, value: Expr) -> Cell {
        match value {
            Expr::Literal(literal) => Cell::Known(literal),
            Expr::Var(var @ (Var::Constant(_) | Var::Input(_) | Var::Local(_))) => Cell::Fixed(var),
            computed => {
                let target = self.local(name);
                self.statements.push(Statement::Assign { target, value: computed });
                Cell::Fixed(target)
            }
        }
    }

    pub(super) fn leaf(&mut self, cell: Cell) -> Rc<Node> {
        Rc::new(Node::Leaf(self.cell(cell)))
    }

    pub(super) fn cell(&mut self, cell: Cell) -> usize {
        self.cells.push(cell);
        self.cells.len() - 1
    }

    /// The value of an `if` or a `match`; `name` is what a local that holds it is called.
    pub(super) fn choice(&mut self, expr: &'static portable::Expr, name: &str) -> Expr {
        self.branch(expr, Some(name)).expect("specialise: every branch of a value has one")
    }

    fn branch(&mut self, expr: &'static portable::Expr, name: Option<&str>) -> Option<Expr> {
        match expr {
            portable::Expr::If { condition, then, otherwise } => {
                let condition = self.expr(condition);
                self.decide(condition, name, |this| this.block(then), |this| this.block(otherwise))
            }
            portable::Expr::Match { scrutinee, arms } => {
                let scrutinee = self.expr(scrutinee);
                let scrutinee = value_of(self.settled("choice", scrutinee));
                self.arms(&scrutinee, arms, name)
            }
            other => panic!("specialise: in {}: no branch: {other:?}", self.frame().function),
        }
    }

    /// The arms of a match, as a chain of `if`s. The last arm needs no condition: the match is exhaustive.
    fn arms(&mut self, scrutinee: &Expr, arms: &'static [Arm], name: Option<&str>) -> Option<Expr> {
        let (arm, rest) = arms.split_first().expect("specialise: a match has an arm");
        if arm.patterns.is_empty() || rest.is_empty() {
            return self.block(&arm.body);
        }
        let condition = arm.patterns.iter().fold(Expr::bool(false), |any, pattern| {
            let equal = self.binary(Binary::Equal, scrutinee.clone(), Expr::Literal(pattern()));
            self.binary(Binary::Or, any, equal)
        });
        let (scrutinee, body) = (scrutinee.clone(), &arm.body);
        self.decide(condition, name, |this| this.block(body), move |this| this.arms(&scrutinee, rest, name))
    }

    /// Takes the branch that is known, or both; a local that differs after them gets a new value in each.
    fn decide(
        &mut self,
        condition: Expr,
        name: Option<&str>,
        then: impl FnOnce(&mut Self) -> Option<Expr>,
        otherwise: impl FnOnce(&mut Self) -> Option<Expr>,
    ) -> Option<Expr> {
        match self.known(&condition) {
            Some(Literal::Bool(true)) => return then(self),
            Some(Literal::Bool(false)) => return otherwise(self),
            _ => {}
        }
        let outer = std::mem::take(&mut self.statements);
        let before = self.cells[self.entered..].to_vec();
        let a = then(self);
        let mut branches = [std::mem::take(&mut self.statements), Vec::new()];
        let yes = self.cells.split_off(self.entered);
        self.cells.extend_from_slice(&before);
        let b = otherwise(self);
        branches[1] = std::mem::replace(&mut self.statements, outer);
        let no = self.cells.split_off(self.entered);
        self.cells.extend_from_slice(&before);
        let value = match (name, a, b) {
            (Some(name), Some(a), Some(b)) => Some(self.merge(name, [a, b], &mut branches)),
            _ => None,
        };
        // What the branches declared has ended with them.
        for (cell, (yes, no)) in (self.entered..self.cells.len()).zip(yes.into_iter().zip(no)) {
            self.cells[cell] = if yes == no {
                yes
            } else {
                let name = self.name_of(cell);
                let merged = self.merge(&name, [yes, no].map(value_of), &mut branches);
                self.settled(&name, merged)
            };
        }
        let [then, otherwise] = branches;
        self.statements.push(Statement::If { condition, then, otherwise });
        value
    }

    /// One value after two branches.
    fn merge(&mut self, name: &str, [a, b]: [Expr; 2], branches: &mut [Vec<Statement>; 2]) -> Expr {
        if a == b && matches!(a, Expr::Literal(_) | Expr::Var(Var::Constant(_) | Var::Input(_) | Var::Local(_))) {
            return a; // nothing in the branches can have changed it
        }
        let target = self.local(name);
        branches[0].push(Statement::Assign { target, value: run_time(a) });
        branches[1].push(Statement::Assign { target, value: run_time(b) });
        Expr::Var(target)
    }

    /// The Rust name that stands for a cell, innermost function first: of a struct, the field's.
    fn name_of(&self, cell: usize) -> String {
        let mut names = self.frames.iter().rev().flat_map(|frame| frame.names.iter().rev());
        names.find_map(|(name, node)| name_within(name, node, cell)).unwrap_or("value").to_owned()
    }
}

/// The name under which a local or a parameter holds the cell: its own, or the field's where it is a struct.
fn name_within(name: &'static str, node: &Node, cell: usize) -> Option<&'static str> {
    match node {
        Node::Leaf(leaf) => (*leaf == cell).then_some(name),
        Node::Struct { fields, .. } => fields.iter().find_map(|(field, node)| name_within(field, node, cell)),
        Node::Array { elements, .. } => elements.iter().find_map(|element| name_within(name, element, cell)),
    }
}

/// The value that a cell has after a branch.
fn value_of(cell: Cell) -> Expr {
    match cell {
        Cell::Known(literal) => Expr::Literal(literal),
        Cell::Fixed(var) => Expr::Var(var),
        Cell::Coefficient(_) | Cell::Memory(_) => panic!("specialise: only a local has a value that changes"),
    }
}
