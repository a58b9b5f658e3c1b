//! The description of C99 for the printer.

use super::language::{Appearance, Cases, Form, Language, Level};
use super::number::decimal;
use crate::program::values::Signal;
use crate::program::{Constant, Expr, Origin, Program, Statement, Type, Var};
use portable::{Binary, Intrinsic, Literal, RealKind, Unary};
use std::collections::HashSet;
use std::sync::LazyLock;

/// C99. Signed integers are computed as unsigned ones, which wrap around: a signed overflow is undefined in C.
pub static LANGUAGE: Language = Language {
    is_reserved: |name| RESERVED.contains(name),
    // MISRA C:2012 5.2, of C99
    significant: Some(63),
    kept: &[],
    types: ["bool", "int32_t", "uint32_t", "double", "float"],
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
    appearances,
    before: ["inputs->", "outputs->", "state->", "", ""],
    inside: "->",
    has_structs: true,
    has_capitals: false,
    locals: Some([|name, ty| format!("const {ty} {name}"), |name, ty| format!("{ty} {name};")]),
    assign: " =",
    choice: ["if (", "} else if (", ") {", "} else {", "}"],
    // MISRA C:2012 15.7
    nothing_else: Some("/* no action */"),
    cases: Cases {
        asks: ["switch (", ") {"],
        label: ["case ", ": case ", ": {"],
        by_name: true,
        others: "default: {",
        nothing: "default: { /* no action */ break; }",
        ends: ["break;", "}"],
        end: "}",
    },
    index: ["[", "]"],
    call: "{block}_any_cycle(state, inputs, outputs);",
    comment: ["/* ", " * ", " */"],
};

/// Reserved words of C, C++ and the two headers that a block includes; then the parameters of a block's functions.
static RESERVED: LazyLock<HashSet<&'static str>> = LazyLock::new(|| {
    "
        alignas alignof and and_eq asm auto bitand bitor bool break case catch char class compl concept const const_cast
        consteval constexpr constinit continue co_await co_return co_yield decltype default delete do double
        dynamic_cast else enum explicit export extern false float for friend goto if inline int int32_t int64_t long
        mutable namespace new noexcept not not_eq nullptr operator or or_eq private protected public register
        reinterpret_cast requires restrict return short signed sizeof static static_assert static_cast struct switch
        template this thread_local throw true try typedef typeid typename typeof uint32_t uint64_t union unsigned using
        virtual void volatile wchar_t while xor xor_eq state inputs outputs
    "
    .split_ascii_whitespace()
    .collect()
});

/// A number that a caller may write or read by name is an enumerator, as is the label of a `case`: a `const` is not a
/// constant expression in C. Any other number is a constant of the function that reads it; one that both functions of a
/// cycle read is declared above them.
fn appearances(program: &Program, signals: &[Signal]) -> Vec<Appearance> {
    let [all, apart] = [&program.step[..], program.apart()].map(|list| readings(list, program.constants.len()));
    let appearance = |(index, constant): (usize, &Constant)| match constant.origin {
        _ if signals.iter().any(|signal| signal.constants.contains(&index)) => Appearance::Enumerator,
        Origin::Variant(_) => Appearance::Enumerator,
        Origin::Coefficient(_) | Origin::Function | Origin::Runtime(_)
            if 0 < apart[index] && apart[index] < all[index] =>
        {
            Appearance::Shared
        }
        Origin::Coefficient(_) | Origin::Function | Origin::Runtime(_) => Appearance::Declared,
    };
    program.constants.iter().enumerate().map(appearance).collect()
}

/// The number of times that statements read each constant.
fn readings(list: &[Statement], constants: usize) -> Vec<usize> {
    let mut readings = vec![0; constants];
    for statement in list {
        statement.reads(&mut |var| {
            if let Var::Constant(index) = var {
                readings[index] += 1;
            }
        });
    }
    readings
}

fn literal(value: Literal) -> String {
    match value {
        Literal::Bool(value) => value.to_string(),
        Literal::I32(i32::MIN) => "(-2147483647 - 1)".to_owned(),
        Literal::I32(value) => value.to_string(),
        Literal::U32(value) => format!("{value}u"),
        Literal::F64(_) => decimal(value),
        Literal::F32(_) => decimal(value) + "f",
        Literal::Usize(_) | Literal::Variant(_) => panic!("c: {value:?} has no counterpart"),
    }
}

fn form(operation: &Expr, ty: Type, real: RealKind) -> Option<Form> {
    use Level::{Any, Comparison, Primary, Sign, Sum};
    let (level, text, least) = match (operation, ty) {
        (Expr::Unary(Unary::Negate, _), Type::I32) => (Sign, "(int32_t)(0u - (uint32_t){0})", [Primary; 2]),
        // `Primary`: avoids `--x`, and shows the reader the operand of the sign.
        (Expr::Unary(Unary::Negate, _), _) => (Sign, "-{0}", [Primary; 2]),
        (Expr::Unary(Unary::Not, _), _) => (Sign, "!{0}", [Primary; 2]),
        (Expr::Binary(operator, ..), Type::I32) => match operator {
            Binary::Add => (Sign, "(int32_t)((uint32_t){0} + (uint32_t){1})", [Primary; 2]),
            Binary::Subtract => (Sign, "(int32_t)((uint32_t){0} - (uint32_t){1})", [Primary; 2]),
            Binary::Multiply => (Sign, "(int32_t)((uint32_t){0} * (uint32_t){1})", [Primary; 2]),
            _ => return None,
        },
        // |x| <= 0 without a magnitude
        (Expr::Intrinsic(Intrinsic::InRange | Intrinsic::Within, _), _) if operation.is_about_zero() => {
            (Primary, "{block}_is_zero({0})", [Any; 2])
        }
        (Expr::Intrinsic(intrinsic, _), _) => match (intrinsic, real) {
            (Intrinsic::InRange | Intrinsic::Within, _) => (Comparison, "{block}_magnitude({0})\n<= {1}", [Any, Sum]),
            (Intrinsic::FromU32 | Intrinsic::FromI32, RealKind::F64) => (Sign, "(double){0}", [Primary; 2]),
            (Intrinsic::FromU32 | Intrinsic::FromI32, RealKind::F32) => (Sign, "(float){0}", [Primary; 2]),
            (Intrinsic::Narrow, _) => (Sign, "(float){0}", [Primary; 2]),
            (Intrinsic::Unsigned, _) => (Sign, "(uint32_t){0}", [Primary; 2]),
            (Intrinsic::Truncate, _) => (Sign, "(int32_t){0}", [Primary; 2]),
            (Intrinsic::Nearest, _) => (Primary, "{block}_nearest({0})", [Any; 2]),
        },
        _ => return None,
    };
    Some(Form { level, text, least })
}
