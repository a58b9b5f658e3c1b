//! Carries edits out, all in one walk. What comes of it may name things that are gone: `repair` sees to that.

use super::edit::{Action, Edit, parts};
use crate::random::syntax::{
    Argument, Arm, Block, Call, Callee, Choice, Expr, Place, Program, Selection, Statement, Step, Tree, Value,
};
use std::collections::BTreeMap;

/// The program after the edits.
#[must_use]
pub fn program(program: &Program, edits: &[Edit]) -> Program {
    let mut program = program.clone();
    let mut walk = Walk { at: 0, actions: BTreeMap::new(), dropped: Vec::new() };
    for edit in edits {
        match edit {
            Edit::Node(at, action) => drop(walk.actions.insert(*at, action.clone())),
            Edit::Function(which) => program.functions[*which].removed = true,
            Edit::Param(which, param) => walk.dropped.push((*which, *param)),
            Edit::Field(..) => {}
        }
    }
    for (which, function) in program.functions.iter_mut().enumerate() {
        function.body = walk.block(std::mem::take(&mut function.body));
        let mut position = 0..;
        function.params.retain(|_| !walk.dropped.contains(&(which, position.next().unwrap_or_default())));
    }
    // From the last to the first, so that positions stay true.
    let mut fields: Vec<(usize, usize)> = edits.iter().filter_map(field).collect();
    fields.sort_unstable();
    for (which, field) in fields.into_iter().rev() {
        program.structs[which].fields.remove(field);
    }
    program.coefficients = fitting(&program.coefficients, &program);
    program
}

fn field(edit: &Edit) -> Option<(usize, usize)> {
    match edit {
        Edit::Field(which, field) => Some((*which, *field)),
        _ => None,
    }
}

/// The coefficients without the fields that are gone.
fn fitting(tree: &Tree, program: &Program) -> Tree {
    match tree {
        Tree::Leaf(value) => Tree::Leaf(*value),
        Tree::Array(elements) => Tree::Array(elements.iter().map(|element| fitting(element, program)).collect()),
        Tree::Struct(which, fields) => {
            let known = &program.structs[*which].fields;
            let kept = fields.iter().filter(|(name, _)| known.iter().any(|(field, _)| field == name));
            Tree::Struct(*which, kept.map(|(name, tree)| (name.clone(), fitting(tree, program))).collect())
        }
    }
}

/// The walk, in the order of `visit`.
struct Walk {
    at: usize,
    actions: BTreeMap<usize, Action>,
    /// functions and parameters that go
    dropped: Vec<(usize, usize)>,
}

impl Walk {
    fn action(&mut self) -> Option<Action> {
        self.at += 1;
        self.actions.get(&(self.at - 1)).cloned()
    }

    fn block(&mut self, block: Block) -> Block {
        let statements = block.statements.into_iter().flat_map(|statement| self.statement(statement)).collect();
        Block { statements, value: block.value.map(|value| Box::new(self.expr(*value))) }
    }

    fn statement(&mut self, statement: Statement) -> Vec<Statement> {
        let action = self.action();
        let mut statement = match statement {
            Statement::Let { name, mutable, value } => Statement::Let { name, mutable, value: self.expr(value) },
            Statement::Assign { place, value } => {
                let place = self.place(place);
                Statement::Assign { place, value: self.expr(value) }
            }
            Statement::Compound { place, operator, value } => {
                let place = self.place(place);
                Statement::Compound { place, operator, value: self.expr(value) }
            }
            Statement::For { variable, from, to, body } => {
                let (from, to) = (self.expr(from), self.expr(to));
                Statement::For { variable, from, to, body: self.block(body) }
            }
            Statement::If(choice) => Statement::If(self.choice(choice)),
            Statement::Match(selection) => Statement::Match(self.selection(selection)),
            Statement::Call(call) => Statement::Call(self.call(call)),
        };
        match action {
            Some(Action::Delete) => return Vec::new(),
            Some(Action::Unwrap(inner)) => return unwrapped(statement, inner),
            Some(action) => simplify(&mut statement, &action),
            None => {}
        }
        vec![statement]
    }

    fn expr(&mut self, expr: Expr) -> Expr {
        let action = self.action();
        let mut expr = match expr {
            Expr::Literal(value) => Expr::Literal(value),
            Expr::Read(place, scalar) => Expr::Read(self.place(place), scalar),
            Expr::Unary(operator, operand) => Expr::Unary(operator, Box::new(self.expr(*operand))),
            Expr::Binary(operator, left, right) => {
                let left = self.expr(*left);
                Expr::Binary(operator, Box::new(left), Box::new(self.expr(*right)))
            }
            Expr::Call(call) => Expr::Call(self.call(call)),
            Expr::If(choice) => Expr::If(Box::new(self.choice(*choice))),
            Expr::Match(selection) => Expr::Match(Box::new(self.selection(*selection))),
            Expr::Array(elements) => Expr::Array(elements.into_iter().map(|element| self.expr(element)).collect()),
            Expr::Repeat(element, length) => Expr::Repeat(Box::new(self.expr(*element)), length),
        };
        match action {
            Some(Action::Plain) if !matches!(expr, Expr::Array(_) | Expr::Repeat(..)) => {
                Expr::Literal(Value::plain(expr.scalar()))
            }
            Some(Action::One) => Expr::Literal(Value::One),
            Some(Action::Part(which)) => parts(&expr).get(which).map_or_else(|| expr.clone(), |part| (*part).clone()),
            Some(Action::DropArm(arm)) => {
                if let Expr::Match(selection) = &mut expr {
                    drop_arm(selection, arm);
                }
                expr
            }
            _ => expr,
        }
    }

    fn place(&mut self, mut place: Place) -> Place {
        for step in &mut place.steps {
            if let Step::Index(index) = step {
                *index = self.expr(index.clone());
            }
        }
        place
    }

    fn choice(&mut self, choice: Choice) -> Choice {
        let condition = self.expr(choice.condition);
        let then = self.block(choice.then);
        Choice { condition, then, otherwise: choice.otherwise.map(|otherwise| self.block(otherwise)) }
    }

    fn selection(&mut self, selection: Selection) -> Selection {
        let scrutinee = self.expr(selection.scrutinee);
        let arm = |arm: Arm| Arm { patterns: arm.patterns, body: self.block(arm.body) };
        Selection { scrutinee, arms: selection.arms.into_iter().map(arm).collect() }
    }

    fn call(&mut self, call: Call) -> Call {
        let mut arguments = Vec::new();
        for (position, argument) in call.arguments.into_iter().enumerate() {
            let argument = match argument {
                Argument::Value(value) => Argument::Value(self.expr(value)),
                Argument::Shared(place) => Argument::Shared(self.place(place)),
                Argument::Mutable(place) => Argument::Mutable(self.place(place)),
            };
            if !matches!(call.callee, Callee::Function(which) if self.dropped.contains(&(which, position))) {
                arguments.push(argument);
            }
        }
        Call { arguments, ..call }
    }
}

/// The inside of a statement's block of that number.
fn unwrapped(statement: Statement, inner: usize) -> Vec<Statement> {
    match statement {
        Statement::For { body, .. } => body.statements,
        Statement::If(choice) if inner == 0 => choice.then.statements,
        Statement::If(choice) => choice.otherwise.map(|otherwise| otherwise.statements).unwrap_or_default(),
        Statement::Match(mut selection) => selection.arms.swap_remove(inner).body.statements,
        other => vec![other],
    }
}

fn simplify(statement: &mut Statement, action: &Action) {
    match (statement, action) {
        (Statement::If(choice), Action::DropElse) => choice.otherwise = None,
        (Statement::Match(selection), Action::DropArm(arm)) => drop_arm(selection, *arm),
        (Statement::For { from, to, .. }, Action::Once) => {
            *from = Expr::Literal(Value::Usize(0));
            *to = Expr::Literal(Value::Usize(1));
        }
        _ => {}
    }
}

/// Takes an arm away; the last one that is left takes every value.
fn drop_arm(selection: &mut Selection, arm: usize) {
    if selection.arms.len() > 1 && arm < selection.arms.len() {
        selection.arms.remove(arm);
        selection.arms.last_mut().into_iter().for_each(|last| last.patterns.clear());
    }
}
