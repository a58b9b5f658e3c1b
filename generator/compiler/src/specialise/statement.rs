//! Statements, branches and loops: the order of effects, and the knowledge after a branch.

use super::Specialiser;
use super::part::{Cell, Leaf, Named, Part};
use crate::program::{Expr, Statement, Var};
use portable::{Arm, Binary, CodeBlock, Literal, Place};
use std::borrow::Cow;

impl Specialiser<'_> {
    /// Runs a block; returns its value. The names that it declares end with it.
    pub(super) fn block(&mut self, block: &'static CodeBlock) -> Option<Expr> {
        self.named_block(block, "value")
    }

    /// Runs a block; returns its value. A local that holds the value gets the name.
    pub(super) fn named_block(&mut self, block: &'static CodeBlock, name: &str) -> Option<Expr> {
        let (names, cells) = (self.names.len(), self.cells.len());
        for statement in block.statements {
            self.statement(statement);
        }
        let value = block.value.map(|value| self.named_value(value, name));
        self.names.truncate(names);
        self.cells.truncate(cells);
        value
    }

    fn statement(&mut self, statement: &'static portable::Statement) {
        match statement {
            portable::Statement::Let { name, value } => {
                let part = self.initial(value, name);
                self.declare(name, part);
            }
            portable::Statement::Default { name, ty, leaves } => {
                // Its parts are not variables of the block: they are locals if they are unknown.
                let mut cells = Vec::new();
                leaves(&mut |literal| cells.push(Cell::Known(literal)));
                let part = self.enter(*ty, cells.into_iter());
                self.declare(name, part);
            }
            portable::Statement::Assign { place, value } => self.assignment(place, value),
            portable::Statement::Note { text } => self.statements.push(Statement::Note((*text).to_owned())),
            portable::Statement::For { variable, from, to, body } => {
                for index in self.known_index(from)..self.known_index(to) {
                    let part = self.scalar(Cell::Known(Literal::Usize(index)));
                    self.declare(variable, part);
                    self.rounds.push(index);
                    self.block(body);
                    self.rounds.pop();
                    self.names.pop();
                }
            }
            portable::Statement::Expr { value } => match value {
                portable::Expr::Call { function, arguments } => _ = self.call(function, arguments, "value"),
                branching => _ = self.branch(branching, None),
            },
        }
    }

    fn assignment(&mut self, place: &'static Place, value: &'static portable::Expr) {
        let name = place.projections.iter().rev().find_map(|projection| match projection {
            portable::Projection::Field { name } => Some(*name),
            portable::Projection::Index { .. } => None,
        });
        let (name, part) = (name.unwrap_or(place.root), self.place(place));
        if let (None, portable::Expr::Read { place: source }) = (part.cell(), value) {
            let source = self.place(source);
            return self.copy(part, source, place.root, name);
        }
        let name = self.distinct(place.root, name);
        let value = self.named_value(value, &name);
        self.assign(part, &name, value);
    }

    /// The value of an expression. A local that holds a choice gets the name.
    fn named_value(&mut self, value: &'static portable::Expr, name: &str) -> Expr {
        match value {
            portable::Expr::If { .. } | portable::Expr::Match { .. } => self.choice(value, name),
            portable::Expr::Call { function, arguments } => self.called(function, arguments, name),
            value => self.expr(value),
        }
    }

    /// The cells of a new variable.
    fn initial(&mut self, value: &'static portable::Expr, name: &'static str) -> Part {
        match value {
            portable::Expr::Array { elements } => {
                let cell = |element| {
                    let value = self.expr(element);
                    self.fixed(name, value)
                };
                let cells: Vec<Cell> = elements.iter().map(cell).collect();
                self.scalars(cells)
            }
            portable::Expr::Repeat { value, len } => {
                let value = self.expr(value);
                let cell = self.fixed(name, value);
                self.scalars(vec![cell; *len])
            }
            value => {
                let value = self.named_value(value, name);
                self.bind(name, value)
            }
        }
    }

    fn declare(&mut self, name: &'static str, part: Part) {
        self.names.push(Named { name, part, path: None });
    }

    /// Assigns a struct or an array, scalar by scalar. rustc has checked that both have the same type.
    fn copy(&mut self, target: Part, source: Part, root: &str, name: &str) {
        for position in 0..target.ty.leaves() {
            let field = Leaf::at(target.ty, position).field.map_or(name, |(field, _)| field);
            let name = self.distinct(root, field);
            let value = self.read(Part::scalar(source.first + position));
            self.assign(Part::scalar(target.first + position), &name, value);
        }
    }

    fn assign(&mut self, part: Part, name: &str, value: Expr) {
        let Some(cell) = part.cell() else {
            panic!("specialise: in {}: only a scalar can be assigned", self.frame().function)
        };
        match self.cells[cell] {
            Cell::Memory(target) => {
                let value = self.run_time(value);
                self.statements.push(Statement::Assign { target, value });
            }
            Cell::Known(_) | Cell::Fixed(_) => self.cells[cell] = self.fixed(name, value),
            Cell::Coefficient(_) => panic!("specialise: in {}: a coefficient is written", self.frame().function),
        }
    }

    /// The value in a form that cannot change any more: a value that can change, or is computed, is assigned to a new local.
    pub(super) fn fixed(&mut self, name: &str, value: Expr) -> Cell {
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

    pub(super) fn scalar(&mut self, cell: Cell) -> Part {
        self.cells.push(cell);
        Part::scalar(self.cells.len() - 1)
    }

    fn scalars(&mut self, cells: Vec<Cell>) -> Part {
        let part = Part::scalars(self.cells.len(), cells.len());
        self.cells.extend(cells);
        part
    }

    /// The value of an `if` or a `match`; `name` is the name of a local that holds it.
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
                // Nothing is executed between the questions of a chain: the scrutinee need not be copied.
                let scrutinee = match self.expr(scrutinee) {
                    var @ Expr::Var(_) => var,
                    computed => value_of(self.fixed("choice", computed)),
                };
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

    /// Takes the known branch, or both; a local that differs after them gets a new value in each.
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
        self.cells.extend(before);
        let value = match (name, a, b) {
            (Some(name), Some(a), Some(b)) => Some(self.merge(name, [a, b], &mut branches)),
            _ => None,
        };
        // The names that the branches declared have ended with them.
        for (cell, (yes, no)) in (self.entered..self.cells.len()).zip(yes.into_iter().zip(no)) {
            self.cells[cell] = if yes == no {
                yes
            } else {
                let name = self.name_of(cell);
                let merged = self.merge(&name, [yes, no].map(value_of), &mut branches);
                self.fixed(&name, merged)
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
        for (branch, value) in branches.iter_mut().zip([a, b]) {
            let value = self.run_time(value);
            branch.push(Statement::Assign { target, value });
        }
        Expr::Var(target)
    }

    /// The Rust name of a cell, from the innermost function; for a cell of a struct the name of the field.
    fn name_of(&self, cell: usize) -> Cow<'static, str> {
        let mut names = self.names.iter().rev();
        let (root, name) = names.find_map(|named| Some((named.name, named.name_of(cell)?))).unwrap_or(("", "value"));
        self.distinct(root, name)
    }

    /// The name of a local that is a field of a struct: with the name of the struct, if the field has the name of a signal or
    /// of a part of the state.
    fn distinct<'f>(&self, root: &str, field: &'f str) -> Cow<'f, str> {
        let context = &*self.frame().context;
        let is_signal = || self.program.inputs.iter().chain(&self.program.outputs).any(|signal| signal.path == field);
        let is_kept = || {
            let mut above =
                self.program.state.iter().filter_map(|kept| kept.path.strip_suffix(field)?.strip_suffix('.'));
            above.any(|above| above == context)
        };
        let is_taken = match root {
            root if root == field => false,
            _ if context.is_empty() => is_signal(),
            "state" => false,
            _ => is_kept(),
        };
        if is_taken { Cow::Owned([root, "_", field].concat()) } else { Cow::Borrowed(field) }
    }
}

/// The value of a cell after a branch.
fn value_of(cell: Cell) -> Expr {
    match cell {
        Cell::Known(literal) => Expr::Literal(literal),
        Cell::Fixed(var) => Expr::Var(var),
        Cell::Coefficient(_) | Cell::Memory(_) => panic!("specialise: only a local has a value that changes"),
    }
}
