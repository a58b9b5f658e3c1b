//! The constructs of statements and expressions, each looked at on its own.

use super::{Constructs, name, note};
use crate::random::syntax::{
    Argument, Block, COEFFS, Call, Callee, Choice, Expr, Function, Place, Program, Scalar, Selection, Statement, Step,
    Type, Value,
};
use crate::random::visit::Node;

/// Notes the constructs of a function's body.
pub fn collect(function: &Function, program: &Program, found: &mut Constructs) {
    let known: Vec<&str> = function
        .params
        .iter()
        .filter(|param| param.ty == Type::Struct(COEFFS))
        .map(|param| param.name.as_str())
        .collect();
    function.body.visit(&mut |node| match node {
        Node::Statement(statement) => of_statement(statement, program, &known, found),
        Node::Expr(expr) => of_expr(expr, program, &known, found),
    });
    if let Some(value) = &function.body.value {
        of_whole(value, "at a function's end", program, found);
    }
}

fn of_statement(statement: &Statement, program: &Program, known: &[&str], found: &mut Constructs) {
    match statement {
        Statement::Let { value, mutable, .. } => {
            note(*mutable, "statement: let mut", found);
            of_whole(value, "right of let", program, found);
        }
        Statement::Assign { place, value } => {
            note(!place.steps.is_empty(), "statement: assignment to a part", found);
            note(place.steps.is_empty(), "statement: assignment to a local", found);
            of_whole(value, "right of =", program, found);
        }
        Statement::Compound { operator, value, .. } => {
            note(true, &format!("statement: {operator:?} and assign, {}", name(value.scalar())), found);
        }
        Statement::For { variable, to, body, .. } => {
            note(true, "loop", found);
            note(contains(body, |inner| matches!(inner, Statement::For { .. })), "loop: in a loop", found);
            note(
                contains(body, |inner| matches!(inner, Statement::If(_) | Statement::Match(_))),
                "loop: with a branch",
                found,
            );
            note(contains(body, |inner| matches!(inner, Statement::Call(_))), "loop: with a mutating call", found);
            note(matches!(to, Expr::Literal(Value::Length(_))), "loop: to a named length", found);
            note(matches!(to, Expr::Read(..)), "loop: to a coefficient", found);
            note(is_index_in(variable, body), "loop: its variable is an index", found);
        }
        Statement::If(choice) => of_choice(choice, "statement", known, found),
        Statement::Match(selection) => of_selection(selection, "statement", known, found),
        Statement::Call(call) => of_call(call, "as a statement", program, found),
    }
}

/// Notes what stands alone as a value.
fn of_whole(value: &Expr, place: &str, program: &Program, found: &mut Constructs) {
    if let Expr::Call(call) = value {
        of_call(call, place, program, found);
    }
}

fn of_call(call: &Call, place: &str, program: &Program, found: &mut Constructs) {
    if let Callee::Function(which) = call.callee
        && program.functions[which].mutates()
    {
        note(true, &format!("mutating call: {place}"), found);
    }
    for argument in &call.arguments {
        match argument {
            Argument::Mutable(place) => {
                let last = place.steps.last();
                note(matches!(last, Some(Step::Field(_))), "mutating call: of a field", found);
                note(matches!(last, Some(Step::Index(_))), "mutating call: of an element", found);
            }
            Argument::Value(Expr::Call(_)) => note(true, "pure call: as an argument", found),
            Argument::Value(_) | Argument::Shared(_) => {}
        }
    }
}

fn of_expr(expr: &Expr, program: &Program, known: &[&str], found: &mut Constructs) {
    match expr {
        Expr::Literal(value) => note(true, &format!("constant: {}", constant(*value)), found),
        Expr::Read(place, _) => note(place.steps.len() > 2, "place: three steps deep", found),
        Expr::Unary(operator, operand) => {
            note(true, &format!("operator: {operator:?}, {}", name(operand.scalar())), found);
            note(matches!(**operand, Expr::Call(_)), "pure call: as an operand", found);
        }
        Expr::Binary(operator, left, right) => {
            note(true, &format!("operator: {operator:?}, {}", name(left.scalar())), found);
            let calls = [left, right].into_iter().any(|side| is_call(side, program));
            note(calls, "pure call: as an operand", found);
        }
        Expr::Call(call) => {
            if let Callee::Intrinsic(intrinsic) = call.callee {
                note(true, &format!("intrinsic: {intrinsic:?}"), found);
            }
        }
        Expr::If(choice) => of_choice(choice, "value", known, found),
        Expr::Match(selection) => of_selection(selection, "value", known, found),
        Expr::Array(_) => note(true, "local array: by its elements", found),
        Expr::Repeat(..) => note(true, "local array: one value repeated", found),
    }
}

fn of_choice(choice: &Choice, kind: &str, known: &[&str], found: &mut Constructs) {
    note(true, &format!("if: {kind}"), found);
    note(choice.otherwise.is_none(), "if: without else", found);
    let chained = choice.otherwise.as_ref().is_some_and(|otherwise| {
        matches!(otherwise.statements[..], [Statement::If(_)])
            || matches!(otherwise.value.as_deref(), Some(Expr::If(_)))
    });
    note(chained, "if: else if", found);
    note(is_known(&choice.condition, known), "if: decided by a coefficient", found);
    let calls = matches!(&choice.condition, Expr::Call(call) if matches!(call.callee, Callee::Function(_)));
    note(calls, "pure call: as a condition", found);
}

fn of_selection(selection: &Selection, kind: &str, known: &[&str], found: &mut Constructs) {
    note(true, &format!("match: {} {kind}", name(selection.scrutinee.scalar())), found);
    let wildcards: Vec<bool> = selection.arms.iter().map(|arm| arm.patterns.is_empty()).collect();
    note(wildcards.last() == Some(&true), "match: wildcard", found);
    note(wildcards.last() == Some(&false), "match: all values named", found);
    note(wildcards.iter().rev().skip(1).any(|wildcard| *wildcard), "match: arm after the wildcard", found);
    note(selection.arms.iter().any(|arm| arm.patterns.len() > 1), "match: or-pattern", found);
    note(is_known(&selection.scrutinee, known), "match: decided by a coefficient", found);
}

/// Whether an expression reads coefficients and nothing else.
fn is_known(expr: &Expr, known: &[&str]) -> bool {
    let (mut reads, mut others) = (false, false);
    expr.visit(&mut |node| {
        if let Node::Expr(Expr::Read(place, scalar)) = node {
            reads = true;
            others |= *scalar != Scalar::Usize && !known.contains(&place.root.as_str());
        }
    });
    reads && !others
}

fn is_call(expr: &Expr, program: &Program) -> bool {
    match expr {
        Expr::Call(call) => match call.callee {
            Callee::Function(which) => !program.functions[which].params.is_empty(),
            Callee::Intrinsic(_) => false,
        },
        _ => false,
    }
}

fn contains(block: &Block, wanted: impl Fn(&Statement) -> bool) -> bool {
    let mut found = false;
    block.visit(&mut |node| {
        if let Node::Statement(statement) = node {
            found |= wanted(statement);
        }
    });
    found
}

fn is_index_in(variable: &str, body: &Block) -> bool {
    let mut found = false;
    let variable = Place::root(variable);
    body.visit(&mut |node| found |= matches!(node, Node::Expr(Expr::Read(place, Scalar::Usize)) if *place == variable));
    found
}

fn constant(value: Value) -> &'static str {
    match value {
        Value::Zero => "R::ZERO",
        Value::One => "R::ONE",
        Value::Lit(_) => "R::lit",
        Value::PerKind(..) => "R::per_kind",
        Value::Length(_) => "a named length",
        other => name(other.scalar()),
    }
}
