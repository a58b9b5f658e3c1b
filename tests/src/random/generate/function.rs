//! Random functions: named constants, functions that call each other, `init` and `step`.

use super::expression::operation;
use super::scope::{Access, Writer};
use super::{block, constant, shape};
use crate::random::choices::Choices;
use crate::random::syntax::{
    Block, COEFFS, Call, Callee, Expr, Function, INPUTS, Mode, OUTPUTS, Param, Program, STATE, Scalar, Type,
};
use portable::Binary;

/// What a function may cost: statements once it is specialised.
const FUNCTION_LIMIT: usize = 30;
/// What `step` may cost.
const STEP_LIMIT: usize = 110;

/// Adds the functions to a program that has its types.
pub fn add_all(program: &mut Program, choices: &mut Choices) {
    let mut costs = Vec::new();
    for _ in 0..choices.weighted(&[45, 40, 15]) {
        choices.enter();
        let function = named_constant(program, choices);
        choices.leave();
        program.functions.push(function);
        costs.push(0);
    }
    for _ in 0..choices.weighted(&[8, 45, 35, 12]) {
        choices.enter();
        let signature = signature(program, choices);
        choices.leave();
        add(signature, FUNCTION_LIMIT, program, &mut costs, choices, |writer, function| {
            let count = writer.choices.between(1, 3);
            function.body = writer.block(count, function.returns, 2);
            // At the end, a call that changes something is as good as any other value.
            if let (Some(scalar), true) = (function.returns, writer.choices.chance(60))
                && let Some(call) = writer.mutating_call_for(scalar)
            {
                function.body.value = Some(Box::new(Expr::Call(call)));
            }
        });
    }
    let init = block_function("init", &[("state", Mode::Mutable, STATE)]);
    add(init, FUNCTION_LIMIT, program, &mut costs, choices, block::init);
    let step = [
        ("state", Mode::Mutable, STATE),
        ("coeffs", Mode::Shared, COEFFS),
        ("inputs", Mode::Shared, INPUTS),
        ("outputs", Mode::Mutable, OUTPUTS),
    ];
    add(block_function("step", &step), STEP_LIMIT, program, &mut costs, choices, block::step);
}

/// Lets a function be written and adds it.
fn add(
    mut function: Function,
    limit: usize,
    program: &mut Program,
    costs: &mut Vec<usize>,
    choices: &mut Choices,
    write: impl FnOnce(&mut Writer<'_>, &mut Function),
) {
    let mut writer = Writer {
        choices,
        program,
        costs,
        scope: Vec::new(),
        lent: Vec::new(),
        known: false,
        repeats: 1,
        cost: 0,
        limit,
    };
    for param in &function.params {
        let access = if param.mode == Mode::Mutable { Access::Mutable } else { Access::Read };
        writer.enter(&param.name, param.ty.clone(), access);
    }
    writer.choices.enter();
    write(&mut writer, &mut function);
    writer.choices.leave();
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
        params: params.iter().map(param).collect(),
        returns: None,
        body: Block::default(),
    }
}

/// A function without parameters. In the inner module it may have the name of one outside.
fn named_constant(program: &Program, choices: &mut Choices) -> Function {
    let scalar = shape::scalar(choices.chance(40), program, choices);
    let first = Expr::Literal(constant::value(scalar, &program.enums, choices));
    let earlier: Vec<usize> =
        (0..program.functions.len()).filter(|which| program.functions[*which].returns == Some(scalar)).collect();
    let value = match scalar {
        Scalar::Real | Scalar::I32 | Scalar::U32 if choices.chance(30) => {
            let second = if earlier.is_empty() {
                Expr::Literal(constant::value(scalar, &program.enums, choices))
            } else {
                let callee = Callee::Function(*choices.pick(&earlier));
                Expr::Call(Call { callee, arguments: Vec::new(), returns: Some(scalar) })
            };
            operation(*choices.pick(&[Binary::Add, Binary::Subtract, Binary::Multiply]), first, second)
        }
        _ => first,
    };
    let inner = choices.chance(25);
    let body = Block { statements: Vec::new(), value: Some(Box::new(value)) };
    Function { name: name("k", inner, program), inner, params: Vec::new(), returns: Some(scalar), body }
}

/// A name that no function of the same module has.
fn name(stem: &str, inner: bool, program: &Program) -> String {
    let same = program.functions.iter().filter(|function| function.inner == inner && function.name.starts_with(stem));
    format!("{stem}{}", same.count())
}

fn signature(program: &Program, choices: &mut Choices) -> Function {
    let inner = choices.chance(25);
    let mut params = Vec::new();
    for position in 0..choices.weighted(&[0, 30, 45, 25]) {
        let (mode, ty) = match choices.weighted(&[45, 20, 35]) {
            0 => (Mode::Value, Type::Scalar(shape::scalar(choices.chance(40), program, choices))),
            1 => (Mode::Shared, aggregate(program, &[STATE, COEFFS, INPUTS], choices)),
            _ => (Mode::Mutable, changed(program, choices)),
        };
        let name = ["x", "double", "part"][position].to_owned();
        if choices.is_there() {
            params.push(Param { name, mode, ty });
        }
    }
    let mutates = params.iter().any(|param| param.mode == Mode::Mutable);
    let returns = match result_of_similar(&params, program) {
        Some(scalar) if choices.chance(50) => Some(scalar),
        _ if mutates && choices.chance(40) => None,
        _ if choices.chance(50) => Some(Scalar::Real),
        _ => Some(shape::scalar(false, program, choices)),
    };
    Function { name: name("f", inner, program), inner, params, returns, body: Block::default() }
}

/// What a function changes: often what one before it changes, so that it can call that one.
fn changed(program: &Program, choices: &mut Choices) -> Type {
    let params = program.functions.iter().flat_map(|function| &function.params);
    let before: Vec<&Type> = params.filter(|param| param.mode == Mode::Mutable).map(|param| &param.ty).collect();
    if !before.is_empty() && choices.chance(60) {
        return (*choices.pick(&before)).clone();
    }
    aggregate(program, &[STATE, OUTPUTS], choices)
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
fn aggregate(program: &Program, roots: &[usize], choices: &mut Choices) -> Type {
    let mut found = Vec::new();
    for root in roots {
        collect(&Type::Struct(*root), program, &mut found);
    }
    choices.pick(&found).clone()
}

fn collect(ty: &Type, program: &Program, found: &mut Vec<Type>) {
    match ty {
        Type::Scalar(_) => return,
        Type::Array(element, _) => collect(element, program, found),
        Type::Struct(which) => program.structs[*which].fields.iter().for_each(|(_, ty)| collect(ty, program, found)),
    }
    found.push(ty.clone());
}
