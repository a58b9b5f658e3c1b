//! Constructs that several statements make together: what is kept over a change, and locals that several ways assign.

use super::{Constructs, note};
use crate::random::syntax::{Argument, Block, Call, Expr, Place, Program, Statement};
use crate::random::visit::Node;

/// Notes the constructs of a block and of those inside it.
#[expect(clippy::only_used_in_recursion, reason = "each look at a block is asked in the same way")]
pub fn collect(block: &Block, program: &Program, found: &mut Constructs) {
    let locals: Vec<&str> = block.statements.iter().filter_map(mutable_local).collect();
    for local in locals {
        let place = Place::root(local);
        for statement in &block.statements {
            let ways = branches_around(statement, &place, 0);
            note(ways >= Some(1), "local: assigned in a branch", found);
            note(ways >= Some(2), "local: assigned in nested branches", found);
            let in_loop = matches!(statement, Statement::For { body, .. } if writes_in(body, &place));
            note(in_loop, "local: assigned in a loop", found);
        }
    }
    kept(block, found);
    for statement in &block.statements {
        inner_blocks(statement, &mut |inner| collect(inner, program, found));
    }
}

fn mutable_local(statement: &Statement) -> Option<&str> {
    match statement {
        Statement::Let { name, mutable: true, .. } => Some(name),
        _ => None,
    }
}

/// A value is read from a place that changes later, and used after that.
fn kept(block: &Block, found: &mut Constructs) {
    for (at, statement) in block.statements.iter().enumerate() {
        let Statement::Let { name, value: Expr::Read(place, _), .. } = statement else { continue };
        let later = &block.statements[at + 1..];
        for (between, change) in later.iter().enumerate().filter(|(_, change)| writes(change, place)) {
            let used = later[between + 1..].iter().any(|after| reads(after, name));
            let branch = matches!(change, Statement::If(_) | Statement::Match(_));
            let call = matches!(change, Statement::Call(_) | Statement::Let { .. });
            note(used, "order: a value is kept over a change of its source", found);
            note(used && branch, "order: a value is kept over a change in a branch", found);
            note(used && call, "order: a value is kept over a call that changes its source", found);
        }
    }
}

/// Calls the function for every block directly inside a statement.
fn inner_blocks<'a>(statement: &'a Statement, each: &mut dyn FnMut(&'a Block)) {
    match statement {
        Statement::For { body, .. } => each(body),
        Statement::If(choice) => {
            each(&choice.then);
            choice.otherwise.iter().for_each(each);
        }
        Statement::Match(selection) => selection.arms.iter().for_each(|arm| each(&arm.body)),
        _ => {}
    }
}

/// How many branches are at most around a write of a place; nothing, if there is no write.
fn branches_around(statement: &Statement, place: &Place, around: usize) -> Option<usize> {
    let inner = match statement {
        Statement::If(_) | Statement::Match(_) => around + 1,
        Statement::For { .. } => around,
        _ => return writes(statement, place).then_some(around),
    };
    let mut most = None;
    inner_blocks(statement, &mut |block| {
        for statement in &block.statements {
            most = most.max(branches_around(statement, place, inner));
        }
    });
    most
}

fn writes_in(block: &Block, place: &Place) -> bool {
    block.statements.iter().any(|statement| writes(statement, place))
}

/// Whether a statement or one inside it changes a place or a part of it.
fn writes(statement: &Statement, place: &Place) -> bool {
    let mut found = false;
    statement.visit(&mut |node| {
        found |= match node {
            Node::Statement(Statement::Assign { place: target, .. } | Statement::Compound { place: target, .. }) => {
                target.overlaps(place)
            }
            Node::Statement(Statement::Call(call)) | Node::Expr(Expr::Call(call)) => lends(call, place),
            _ => false,
        };
    });
    found
}

fn lends(call: &Call, place: &Place) -> bool {
    let lent = |argument: &Argument| matches!(argument, Argument::Mutable(lent) if lent.overlaps(place));
    call.arguments.iter().any(lent)
}

fn reads(statement: &Statement, name: &str) -> bool {
    let mut found = false;
    statement.visit(&mut |node| found |= matches!(node, Node::Expr(Expr::Read(place, _)) if place.root == name));
    found
}
