//! Which constructs of portable Rust a program has: types and functions here, what stands in bodies next to it.

mod body;
mod order;

use super::print::reached;
use super::syntax::{COEFFS, Function, Mode, Program, Scalar, Type};
use std::collections::BTreeSet;

/// The constructs of a program, each by its name.
pub type Constructs = BTreeSet<String>;

/// The constructs that a program has.
#[must_use]
pub fn collect(program: &Program) -> Constructs {
    let mut found = Constructs::new();
    for (which, item) in program.structs.iter().enumerate() {
        for (_, ty) in &item.fields {
            of_field(ty, which == COEFFS, &mut found);
        }
    }
    let reached: Vec<&Function> = reached(program).into_iter().map(|which| &program.functions[which]).collect();
    for function in &reached {
        of_function(function, &mut found);
        body::collect(function, program, &mut found);
        order::collect(&function.body, program, &mut found);
        let twin = reached.iter().any(|other| other.name == function.name && other.inner != function.inner);
        note(twin, "function: same name in two modules", &mut found);
    }
    found
}

/// Notes a construct where it occurs.
fn note(occurs: bool, construct: &str, found: &mut Constructs) {
    if occurs {
        found.insert(construct.to_owned());
    }
}

/// The name of a scalar type; all enums have the same.
fn name(scalar: Scalar) -> &'static str {
    match scalar {
        Scalar::Real => "real",
        Scalar::Bool => "bool",
        Scalar::I32 => "i32",
        Scalar::U32 => "u32",
        Scalar::Usize => "usize",
        Scalar::Enum(_) => "enum",
    }
}

fn of_field(ty: &Type, coefficient: bool, found: &mut Constructs) {
    match ty {
        Type::Scalar(Scalar::Usize) => note(coefficient, "field: usize, of the coefficients", found),
        Type::Scalar(scalar) => note(true, &format!("field: {}", name(*scalar)), found),
        Type::Struct(_) => note(true, "field: struct", found),
        Type::Array(element, length) => {
            let kind = match **element {
                Type::Scalar(_) => "scalars",
                Type::Struct(_) => "structs",
                Type::Array(..) => "arrays",
            };
            note(true, &format!("field: array of {kind}"), found);
            note(length.named.is_some(), "field: array with a named length", found);
        }
    }
}

fn of_function(function: &Function, found: &mut Constructs) {
    if matches!(function.name.as_str(), "init" | "step") {
        return;
    }
    note(function.inner, "function: in an inner module", found);
    note(!function.body.callees().is_empty(), "function: calls another", found);
    if let Some(scalar) = function.returns {
        let kind = if function.params.is_empty() { "named constant" } else { "function: gives" };
        note(true, &format!("{kind} {}", name(scalar)), found);
    }
    for param in &function.params {
        let construct = match (param.mode, &param.ty) {
            (Mode::Value, Type::Scalar(scalar)) => format!("parameter: {} by value", name(*scalar)),
            (Mode::Mutable, Type::Array(..)) => "parameter: &mut of an array".to_owned(),
            (Mode::Mutable, _) => "parameter: &mut of a struct".to_owned(),
            (_, Type::Array(..)) => "parameter: & of an array".to_owned(),
            _ => "parameter: & of a struct".to_owned(),
        };
        note(true, &construct, found);
    }
}
