//! The description of Rust for the printer.

use super::language::{Appearance, Cases, Form, Language, Level};
use super::number::decimal;
use crate::program::{Expr, Type};
use portable::{Binary, Intrinsic, Literal, RealKind, Unary};
use std::collections::HashSet;
use std::sync::LazyLock;

/// Rust, any edition, without its standard library. Integers wrap around in every build: otherwise an overflow in a debug
/// build would panic.
pub static LANGUAGE: Language = Language {
    is_reserved: |name| RESERVED.contains(name),
    significant: None,
    kept: &[],
    types: ["bool", "i32", "u32", "f64", "f32"],
    literal,
    operand: |value| {
        let text = literal(value);
        let level = if text.starts_with('-') { Level::Sign } else { Level::Primary };
        (text, level)
    },
    symbols: ["+", "-", "*", "/", "%", "<", "<=", ">", ">=", "==", "!=", "&&", "||"],
    // `&&` next to `||` is legal but easily misread.
    logic: [Level::And, Level::Comparison],
    form,
    has_enumerations: true,
    appearances: |program, signals| {
        let is_value = |index| signals.iter().any(|signal| signal.constants.contains(&index));
        let appearance = |index| if is_value(index) { Appearance::Enumerator } else { Appearance::Declared };
        (0..program.constants.len()).map(appearance).collect()
    },
    before: ["inputs.", "outputs.", "state.", "", ""],
    inside: ".",
    has_structs: true,
    // A `let` with the name of a constant would be a pattern, not a new name.
    has_capitals: true,
    locals: Some([|name, ty| format!("let {name}: {ty}"), |name, ty| format!("let {name}: {ty};")]),
    assign: " =",
    choice: ["if ", "} else if ", " {", "} else {", "}"],
    nothing_else: None,
    cases: Cases {
        asks: ["match ", " {"],
        label: ["", " | ", " => {"],
        by_name: true,
        others: "_ => {",
        nothing: "_ => {}",
        ends: ["", "}"],
        end: "}",
    },
    // Without a call that panics, even where nothing is optimised.
    index: [".get(", " as usize).copied().unwrap_or_default()"],
    call: "any_cycle(state, inputs, outputs);",
    comment: ["// ", "// ", ""],
};

/// Reserved words of all editions of Rust; then the words that a block uses.
static RESERVED: LazyLock<HashSet<&'static str>> = LazyLock::new(|| {
    "
        abstract as async await become box break const continue crate do dyn else enum extern false final fn for gen if
        impl in let loop macro match mod move mut override priv pub ref return self static struct super trait true try
        type typeof union unsafe unsized use virtual where while yield state inputs outputs nearest any_cycle
    "
    .split_ascii_whitespace()
    .collect()
});

fn literal(value: Literal) -> String {
    match value {
        Literal::Bool(value) => value.to_string(),
        Literal::I32(value) => value.to_string(),
        Literal::U32(value) => value.to_string(),
        Literal::F64(_) | Literal::F32(_) => decimal(value),
        Literal::Usize(_) | Literal::Variant(_) => panic!("rust: {value:?} has no counterpart"),
    }
}

/// Digits have no own type when a method is called on them: a function is used instead.
fn form(operation: &Expr, ty: Type, real: RealKind) -> Option<Form> {
    use Intrinsic::{FromI32, FromU32, InRange, Narrow, Nearest, Truncate, Unsigned, Within};
    use Level::{Any, Comparison, Primary, Sign, Sum};
    let is_digits = matches!(operation.operands().next(), Some(Expr::Literal(_)));
    let choose = |[method, function]: [&'static str; 2]| {
        if is_digits { (Primary, function, [Any; 2]) } else { (Primary, method, [Primary, Any]) }
    };
    let (level, text, least) = match (operation, ty, real) {
        (Expr::Unary(Unary::Negate, _), Type::I32, _) => choose(["{0}.wrapping_neg()", "i32::wrapping_neg({0})"]),
        // `Primary`: shows the reader the operand of the sign.
        (Expr::Unary(Unary::Negate, _), ..) => (Sign, "-{0}", [Primary; 2]),
        (Expr::Unary(Unary::Not, _), ..) => (Sign, "!{0}", [Primary; 2]),
        (Expr::Binary(operator, ..), ..) => choose(wrapping(*operator, ty)?),
        (Expr::Intrinsic(intrinsic, _), ..) => match (intrinsic, real) {
            // |x| <= 0 without a magnitude
            (InRange | Within, _) if operation.is_about_zero() => (Comparison, "{0} == {1}", [Sum; 2]),
            (InRange | Within, _) if !is_digits => (Comparison, "{0}.abs() <= {1}", [Primary, Sum]),
            (InRange | Within, RealKind::F64) => (Comparison, "f64::abs({0}) <= {1}", [Any, Sum]),
            (InRange | Within, RealKind::F32) => (Comparison, "f32::abs({0}) <= {1}", [Any, Sum]),
            // The token after a cast may be read as part of its type, so a cast always gets parentheses.
            (FromU32, RealKind::F64) if is_digits => (Primary, "f64::from({0}_u32)", [Any; 2]),
            (FromU32, RealKind::F32) if is_digits => (Any, "{0}_u32 as f32", [Primary; 2]),
            (FromU32 | FromI32, RealKind::F64) => (Primary, "f64::from({0})", [Any; 2]),
            (FromU32 | FromI32, RealKind::F32) => (Any, "{0} as f32", [Primary; 2]),
            (Narrow, _) => (Any, "{0} as f32", [Primary; 2]),
            (Unsigned, _) => (Primary, "{0}.cast_unsigned()", [Primary; 2]),
            (Truncate, _) => (Any, "{0} as i32", [Primary; 2]),
            // More would need `unsafe` code.
            (Nearest, _) => (Primary, "nearest({0})", [Any; 2]),
        },
        _ => return None,
    };
    Some(Form { level, text, least })
}

/// The method and the function for an operator of integers, both of which wrap around.
fn wrapping(operator: Binary, ty: Type) -> Option<[&'static str; 2]> {
    Some(match (operator, ty) {
        (Binary::Add, Type::I32) => ["{0}.wrapping_add({1})", "i32::wrapping_add({0}, {1})"],
        (Binary::Subtract, Type::I32) => ["{0}.wrapping_sub({1})", "i32::wrapping_sub({0}, {1})"],
        (Binary::Multiply, Type::I32) => ["{0}.wrapping_mul({1})", "i32::wrapping_mul({0}, {1})"],
        (Binary::Add, Type::U32) => ["{0}.wrapping_add({1})", "u32::wrapping_add({0}, {1})"],
        (Binary::Subtract, Type::U32) => ["{0}.wrapping_sub({1})", "u32::wrapping_sub({0}, {1})"],
        (Binary::Multiply, Type::U32) => ["{0}.wrapping_mul({1})", "u32::wrapping_mul({0}, {1})"],
        _ => return None,
    })
}
