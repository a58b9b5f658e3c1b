//! The random bodies of the two functions that make a block: `init` and `step`.

use super::scope::{Access, Writer};
use crate::random::syntax::{
    Block, Expr, Function, OUTPUTS, Place, Program, STATE, Scalar, Statement, Step, Type, Value,
};

/// `init`: writes parts of the state and looks at none, as nothing has a value before it.
pub fn init(writer: &mut Writer<'_>, function: &mut Function) {
    writer.scope[0].readable = false;
    let count = writer.choices.between(0, 2);
    function.body = writer.block(count, None, 1);
}

/// `step`: first every output gets a value, then anything may happen, at last the outputs show what came of it.
pub fn step(writer: &mut Writer<'_>, function: &mut Function) {
    let outputs = writer.scope.len() - 1;
    writer.scope[outputs].readable = false;
    let mut statements = Vec::new();
    let leaves = leaves(&Place::root("outputs"), &Type::Struct(OUTPUTS), writer.program);
    for (place, scalar) in &leaves {
        writer.choices.enter_named(&format!("{place:?}"));
        let value = if writer.choices.chance(50) { writer.leaf(*scalar) } else { writer.whole(*scalar, 1) };
        statements.push(Statement::Assign { place: place.clone(), value });
        writer.spend(1);
        writer.choices.leave();
    }
    writer.scope[outputs].readable = true;
    for _ in 0..writer.choices.between(1, 3) {
        writer.statement(3, &mut statements);
    }
    for which in 0..writer.program.functions.len() {
        let called = statements.iter().any(|statement| calls(statement, which));
        let is_init = which + 1 == writer.program.functions.len();
        writer.choices.enter();
        if !called && writer.choices.chance(if is_init { 10 } else { 80 }) {
            call_once(writer, which, &mut statements);
        }
        writer.choices.leave();
    }
    let remembered = self::leaves(&Place::root("state"), &Type::Struct(STATE), writer.program);
    for (place, scalar) in remembered.into_iter().chain(leaves) {
        let weight = if place.root == "outputs" { 70 } else { 30 };
        writer.choices.enter_named(&format!("{place:?} at last"));
        if writer.choices.chance(weight) {
            let value = if writer.choices.chance(50) { writer.whole(scalar, 1) } else { writer.expr(scalar, 3) };
            statements.push(Statement::Assign { place, value });
        }
        writer.choices.leave();
    }
    function.body = Block { statements, value: None };
}

fn calls(statement: &Statement, which: usize) -> bool {
    let block = Block { statements: vec![statement.clone()], value: None };
    block.callees().contains(&which)
}

/// A call of a function; its value is kept, or assigned where there is a place for it.
fn call_once(writer: &mut Writer<'_>, which: usize, statements: &mut Vec<Statement>) {
    let Some(call) = writer.call_of(which) else { return };
    let Some(scalar) = call.returns else {
        statements.push(Statement::Call(call));
        return;
    };
    let target = if writer.choices.chance(50) { writer.writable(Some(scalar)) } else { None };
    statements.push(match target {
        Some((place, _)) => Statement::Assign { place, value: Expr::Call(call) },
        None => {
            let name = writer.fresh();
            writer.enter(&name, Type::Scalar(scalar), Access::Read);
            Statement::Let { name, mutable: false, value: Expr::Call(call) }
        }
    });
}

/// The scalars of a place.
fn leaves(place: &Place, ty: &Type, program: &Program) -> Vec<(Place, Scalar)> {
    let with = |step| Place { root: place.root.clone(), steps: [place.steps.clone(), vec![step]].concat() };
    match ty {
        Type::Scalar(scalar) => vec![(place.clone(), *scalar)],
        Type::Array(element, length) => {
            let index = |index| Step::Index(Expr::Literal(Value::Usize(index)));
            (0..length.count).flat_map(|at| leaves(&with(index(at)), element, program)).collect()
        }
        Type::Struct(which) => {
            let fields = program.structs[*which].fields.iter();
            fields.flat_map(|(name, ty)| leaves(&with(Step::Field(name.clone())), ty, program)).collect()
        }
    }
}
