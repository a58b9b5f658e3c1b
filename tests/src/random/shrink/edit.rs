//! The edits that may make a program smaller. They name statements and expressions by their position on the way through
//! the functions, outer before inner.

use crate::random::print::reached;
use crate::random::syntax::{Argument, Expr, Program, Statement, Value};
use crate::random::visit::Node;

/// An edit.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Edit {
    /// of a statement or an expression
    Node(usize, Action),
    /// takes a function away, with its calls
    Function(usize),
    /// takes a parameter away, with its arguments
    Param(usize, usize),
    /// takes a field away
    Field(usize, usize),
}

/// What is done to a statement or an expression.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Action {
    /// a statement goes
    Delete,
    /// a statement gives way to the inside of its block of that number
    Unwrap(usize),
    /// an `if` loses its `else`
    DropElse,
    /// a `match` loses an arm
    DropArm(usize),
    /// a loop runs once
    Once,
    /// an expression becomes the plainest constant
    Plain,
    /// a real becomes 1
    One,
    /// an expression gives way to its part of that number
    Part(usize),
}

/// All edits of a program.
#[must_use]
pub fn all(program: &Program) -> Vec<Edit> {
    let mut edits = Vec::new();
    let reached = reached(program);
    let mut at = 0;
    for (which, function) in program.functions.iter().enumerate() {
        let seen = reached.contains(&which);
        if seen && which + 2 < program.functions.len() {
            edits.push(Edit::Function(which));
            edits.extend((0..function.params.len()).map(|param| Edit::Param(which, param)));
        }
        function.body.visit(&mut |node| {
            if seen {
                edits.extend(actions(node).into_iter().map(|action| Edit::Node(at, action)));
            }
            at += 1;
        });
    }
    for (which, item) in program.structs.iter().enumerate() {
        edits.extend((0..item.fields.len()).map(|field| Edit::Field(which, field)));
    }
    edits
}

fn actions(node: Node<'_>) -> Vec<Action> {
    match node {
        Node::Statement(statement) => {
            let mut actions = vec![Action::Delete];
            match statement {
                Statement::For { .. } => actions.extend([Action::Unwrap(0), Action::Once]),
                Statement::If(choice) => {
                    actions.extend([Action::Unwrap(0), Action::Unwrap(1)]);
                    actions.extend(choice.otherwise.as_ref().map(|_| Action::DropElse));
                }
                Statement::Match(selection) => {
                    actions
                        .extend((0..selection.arms.len()).flat_map(|arm| [Action::Unwrap(arm), Action::DropArm(arm)]));
                }
                _ => {}
            }
            actions
        }
        Node::Expr(Expr::Literal(Value::Zero | Value::One)) => Vec::new(),
        Node::Expr(expr) => {
            let mut actions = vec![Action::Plain];
            actions.extend(matches!(expr, Expr::Literal(Value::Lit(_) | Value::PerKind(..))).then_some(Action::One));
            actions.extend((0..parts(expr).len()).map(Action::Part));
            if let Expr::Match(selection) = expr {
                actions.extend((0..selection.arms.len()).map(Action::DropArm));
            }
            actions
        }
    }
}

/// The parts of an expression that have its type and could stand for it.
#[must_use]
pub fn parts(expr: &Expr) -> Vec<&Expr> {
    let parts: Vec<&Expr> = match expr {
        Expr::Unary(_, operand) => vec![operand],
        Expr::Binary(_, left, right) => vec![left, right],
        Expr::Call(call) => call.arguments.iter().filter_map(value).collect(),
        Expr::If(choice) => {
            let blocks = [Some(&choice.then), choice.otherwise.as_ref()];
            blocks.into_iter().flatten().filter_map(|block| block.value.as_deref()).collect()
        }
        Expr::Match(selection) => selection.arms.iter().filter_map(|arm| arm.body.value.as_deref()).collect(),
        Expr::Literal(_) | Expr::Read(..) | Expr::Array(_) | Expr::Repeat(..) => Vec::new(),
    };
    let is_array = matches!(expr, Expr::Array(_) | Expr::Repeat(..));
    parts.into_iter().filter(|part| !is_array && part.scalar() == expr.scalar()).collect()
}

fn value(argument: &Argument) -> Option<&Expr> {
    match argument {
        Argument::Value(value) => Some(value),
        Argument::Shared(_) | Argument::Mutable(_) => None,
    }
}
