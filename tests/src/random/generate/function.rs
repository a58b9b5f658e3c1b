//! Random functions: named constants, functions that call each other, `init` and `step`.

use super::expression::operation;
use super::scope::{Access, Writer};
use super::{block, constant, shape};
use crate::random::rng::Rng;
use crate::random::syntax::{
    Block, COEFFS, Call, Callee, Expr, Function, INPUTS, Mode, OUTPUTS, Param, Program, STATE, Scalar, Type,
};
use portable::Binary;

/// What a function may cost: statements once it is specialised.
const FUNCTION_LIMIT: usize = 30;
/// What `step` may cost.
const STEP_LIMIT: usize = 110;

/// Adds the functions to a program that has its types.
pub fn add_all(program: &mut Program, rng: &mut Rng) {
    let mut costs = Vec::new();
    for _ in 0..rng.weighted(&[45, 40, 15]) {
        let function = named_constant(program, rng);
        program.functions.push(function);
        costs.push(0);
    }
    for _ in 0..rng.weighted(&[8, 45, 35, 12]) {
        let signature = signature(program, rng);
        add(signature, FUNCTION_LIMIT, program, &mut costs, rng, |writer, function| {
            let count = writer.rng.between(1, 3);
            function.body = writer.block(count, function.returns, 2);
            // At the end, a call that changes something is as good as any other value.
            if let (Some(scalar), true) = (function.returns, writer.rng.chance(60))
                && let Some(call) = writer.mutating_call_for(scalar)
            {
                function.body.value = Some(Box::new(Expr::Call(call)));
            }
        });
    }
    let init = block_function("init", &[("state", Mode::Mutable, STATE)]);
    add(init, FUNCTION_LIMIT, program, &mut costs, rng, block::init);
    let step = [
        ("state", Mode::Mutable, STATE),
        ("coeffs", Mode::Shared, COEFFS),
        ("inputs", Mode::Shared, INPUTS),
        ("outputs", Mode::Mutable, OUTPUTS),
    ];
    add(block_function("step", &step), STEP_LIMIT, program, &mut costs, rng, block::step);
}

/// Lets a function be written and adds it.
fn add(
    mut function: Function,
    limit: usize,
    program: &mut Program,
    costs: &mut Vec<usize>,
    rng: &mut Rng,
    write: impl FnOnce(&mut Writer<'_>, &mut Function),
) {
    let mut writer =
        Writer { rng, program, costs, scope: Vec::new(), lent: Vec::new(), known: false, repeats: 1, cost: 0, limit };
    for param in &function.params {
        let access = if param.mode == Mode::Mutable { Access::Mutable } else { Access::Read };
        writer.enter(&param.name, param.ty.clone(), access);
    }
    write(&mut writer, &mut function);
    let cost = writer.cost + 1;
    program.functions.push(function);
    costs.push(cost);
}

fn block_function(name: &str, params: &[(&str, Mode, usize)]) -> Function {
    let param = |(name, mode, which): &(&str, Mode, usize)| Param {
        name: (*name).to_owned(),
        mode: *mode,
        ty: Type::Struct(*which),
    };
    Function {
        name: name.to_owned(),
        inner: false,
        removed: false,
        params: params.iter().map(param).collect(),
        returns: None,
        body: Block::default(),
    }
}

/// A function without parameters. In the inner module it may have the name of one outside.
fn named_constant(program: &Program, rng: &mut Rng) -> Function {
    let scalar = shape::scalar(rng.chance(40), program, rng);
    let first = Expr::Literal(constant::value(scalar, &program.enums, rng));
    let earlier: Vec<usize> =
        (0..program.functions.len()).filter(|which| program.functions[*which].returns == Some(scalar)).collect();
    let value = match scalar {
        Scalar::Real | Scalar::I32 | Scalar::U32 if rng.chance(30) => {
            let second = if earlier.is_empty() {
                Expr::Literal(constant::value(scalar, &program.enums, rng))
            } else {
                let callee = Callee::Function(*rng.pick(&earlier));
                Expr::Call(Call { callee, arguments: Vec::new(), returns: Some(scalar) })
            };
            operation(*rng.pick(&[Binary::Add, Binary::Subtract, Binary::Multiply]), first, second)
        }
        _ => first,
    };
    let inner = rng.chance(25);
    let body = Block { statements: Vec::new(), value: Some(Box::new(value)) };
    Function { name: name("k", inner, program), inner, removed: false, params: Vec::new(), returns: Some(scalar), body }
}

/// A name that no function of the same module has.
fn name(stem: &str, inner: bool, program: &Program) -> String {
    let same = program.functions.iter().filter(|function| function.inner == inner && function.name.starts_with(stem));
    format!("{stem}{}", same.count())
}

fn signature(program: &Program, rng: &mut Rng) -> Function {
    let inner = rng.chance(25);
    let mut params = Vec::new();
    for position in 0..rng.weighted(&[0, 30, 45, 25]) {
        let (mode, ty) = match rng.weighted(&[45, 20, 35]) {
            0 => (Mode::Value, Type::Scalar(shape::scalar(rng.chance(40), program, rng))),
            1 => (Mode::Shared, aggregate(program, &[STATE, COEFFS, INPUTS], rng)),
            _ => (Mode::Mutable, changed(program, rng)),
        };
        let name = ["x", "double", "part"][position].to_owned();
        params.push(Param { name, mode, ty });
    }
    let mutates = params.iter().any(|param| param.mode == Mode::Mutable);
    let returns = match result_of_similar(&params, program) {
        Some(scalar) if rng.chance(50) => Some(scalar),
        _ if mutates && rng.chance(40) => None,
        _ if rng.chance(50) => Some(Scalar::Real),
        _ => Some(shape::scalar(false, program, rng)),
    };
    Function { name: name("f", inner, program), inner, removed: false, params, returns, body: Block::default() }
}

/// What a function changes: often what one before it changes, so that it can call that one.
fn changed(program: &Program, rng: &mut Rng) -> Type {
    let params = program.functions.iter().flat_map(|function| &function.params);
    let before: Vec<&Type> = params.filter(|param| param.mode == Mode::Mutable).map(|param| &param.ty).collect();
    if !before.is_empty() && rng.chance(60) {
        return (*rng.pick(&before)).clone();
    }
    aggregate(program, &[STATE, OUTPUTS], rng)
}

/// What a function gives that changes the same: a call of it may be what another gives.
fn result_of_similar(params: &[Param], program: &Program) -> Option<Scalar> {
    let changes = |function: &&Function| {
        let mut changed = function.params.iter().filter(|param| param.mode == Mode::Mutable);
        changed.any(|own| params.iter().any(|param| param.mode == Mode::Mutable && param.ty == own.ty))
    };
    program.functions.iter().filter(changes).find_map(|function| function.returns)
}

/// A struct or an array that one of the structs is or has.
fn aggregate(program: &Program, roots: &[usize], rng: &mut Rng) -> Type {
    let mut found = Vec::new();
    for root in roots {
        collect(&Type::Struct(*root), program, &mut found);
    }
    rng.pick(&found).clone()
}

fn collect(ty: &Type, program: &Program, found: &mut Vec<Type>) {
    match ty {
        Type::Scalar(_) => return,
        Type::Array(element, _) => collect(element, program, found),
        Type::Struct(which) => program.structs[*which].fields.iter().for_each(|(_, ty)| collect(ty, program, found)),
    }
    found.push(ty.clone());
}
