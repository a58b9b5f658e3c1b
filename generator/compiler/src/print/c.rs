//! What C99 is to the printer.

use super::language::{Appearance, Form, Language, Level, Operation, PRIMARY, Piece, Question};
use super::names::Words;
use super::number::decimal;
use crate::program::Type;
use portable::{Binary, Intrinsic, Literal, RealKind, Unary};

/// C99. Signed integers wrap around as unsigned ones do: an overflow of theirs has no meaning in C.
pub static LANGUAGE: Language = Language {
    is_reserved: |name| RESERVED.have(name),
    kept: &[],
    ty: type_name,
    literal,
    operand: |value| (literal(value), if is_negative(value) { SIGN } else { PRIMARY }),
    form,
    appearances: |program| vec![Appearance::Declared; program.constants.len()],
    before: ["inputs->", "outputs->", "state->", "", ""],
    has_structs: true,
    declaration: Some([|ty, name| format!("const {ty} {name}"), |ty, name| format!("{ty} {name}")]),
    assign: " =",
    question: Question { first: "if (", next: "} else if (", then: ") {", otherwise: "} else {", end: "}" },
    comment: ["/* ", " * ", " */"],
};

/// Words that C, C++ and the two headers that a block includes keep for themselves; then those that a block uses.
static RESERVED: Words = Words::new(
    "
    alignas alignof and and_eq asm auto bitand bitor bool break case catch char class compl concept const const_cast
    consteval constexpr constinit continue co_await co_return co_yield decltype default delete do double
    dynamic_cast else enum explicit export extern false float for friend goto if inline int int32_t int64_t long
    mutable namespace new noexcept not not_eq nullptr operator or or_eq private protected public register
    reinterpret_cast requires restrict return short signed sizeof static static_assert static_cast struct switch
    template this thread_local throw true try typedef typeid typename typeof uint32_t uint64_t union unsigned using
    virtual void volatile wchar_t while xor xor_eq
    state inputs outputs bits_of real_of fold digest scale step noise random sample magnitude nearest
",
);

const OR: Level = 0;
const AND: Level = 1;
const EQUALITY: Level = 2;
const RELATION: Level = 3;
const SUM: Level = 4;
const PRODUCT: Level = 5;
const SIGN: Level = 6;

/// The C name of a type.
fn type_name(ty: Type, real: RealKind) -> &'static str {
    match (ty, real) {
        (Type::Bool, _) => "bool",
        (Type::I32, _) => "int32_t",
        (Type::U32, _) => "uint32_t",
        (Type::Real, RealKind::F64) => "double",
        (Type::Real, RealKind::F32) => "float",
    }
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

/// Whether the literal's text begins with a sign.
fn is_negative(value: Literal) -> bool {
    match value {
        Literal::F64(value) => value.is_sign_negative(),
        Literal::F32(value) => value.is_sign_negative(),
        Literal::I32(value) => value < 0 && value != i32::MIN,
        _ => false,
    }
}

fn form(operation: Operation, ty: Type, real: RealKind) -> Form {
    match operation {
        Operation::Unary(Unary::Negate) if ty == Type::I32 => Form::Pieces(
            SIGN,
            &[Piece::Text("(int32_t)(0u - (uint32_t)"), Piece::Operand(0, PRIMARY), Piece::Text(")")],
        ),
        // `PRIMARY`: no `--x`, and the reader sees what the sign belongs to.
        Operation::Unary(Unary::Negate) => Form::Pieces(SIGN, const { &cast("-") }),
        Operation::Unary(Unary::Not) => Form::Pieces(SIGN, const { &cast("!") }),
        Operation::Binary(operator) => match operator {
            Binary::Add if ty == Type::I32 => Form::Pieces(SIGN, const { &wrapping(" + (uint32_t)") }),
            Binary::Subtract if ty == Type::I32 => Form::Pieces(SIGN, const { &wrapping(" - (uint32_t)") }),
            Binary::Multiply if ty == Type::I32 => Form::Pieces(SIGN, const { &wrapping(" * (uint32_t)") }),
            Binary::Add => Form::Infix(SUM, "+", [SUM, PRODUCT]),
            Binary::Subtract => Form::Infix(SUM, "-", [SUM, PRODUCT]),
            Binary::Multiply => Form::Infix(PRODUCT, "*", [PRODUCT, PRIMARY]),
            Binary::Divide => Form::Infix(PRODUCT, "/", [PRODUCT, PRIMARY]),
            // A comparison of comparisons, and `&&` beside `||`, are legal and misread: they get parentheses.
            Binary::Less => Form::Infix(RELATION, "<", [SUM, SUM]),
            Binary::LessEqual => Form::Infix(RELATION, "<=", [SUM, SUM]),
            Binary::Greater => Form::Infix(RELATION, ">", [SUM, SUM]),
            Binary::GreaterEqual => Form::Infix(RELATION, ">=", [SUM, SUM]),
            Binary::Equal => Form::Infix(EQUALITY, "==", [SUM, SUM]),
            Binary::NotEqual => Form::Infix(EQUALITY, "!=", [SUM, SUM]),
            Binary::And => Form::Infix(AND, "&&", [AND, AND]),
            Binary::Or => Form::Infix(OR, "||", [EQUALITY, EQUALITY]),
        },
        Operation::Intrinsic(intrinsic) => match (intrinsic, real) {
            (Intrinsic::InRange | Intrinsic::Within, _) => Form::Pieces(
                RELATION,
                &[Piece::Text("magnitude("), Piece::Operand(0, OR), Piece::Text(") <= "), Piece::Operand(1, SUM)],
            ),
            (Intrinsic::FromU32 | Intrinsic::FromI32, RealKind::F64) => Form::Pieces(SIGN, const { &cast("(double)") }),
            (Intrinsic::FromU32 | Intrinsic::FromI32, RealKind::F32) => Form::Pieces(SIGN, const { &cast("(float)") }),
            (Intrinsic::Truncate, _) => Form::Pieces(SIGN, const { &cast("(int32_t)") }),
            (Intrinsic::Nearest, _) => {
                Form::Pieces(PRIMARY, &[Piece::Text("nearest("), Piece::Operand(0, OR), Piece::Text(")")])
            }
        },
    }
}

const fn cast(to: &'static str) -> [Piece; 2] {
    [Piece::Text(to), Piece::Operand(0, PRIMARY)]
}

const fn wrapping(symbol: &'static str) -> [Piece; 5] {
    let [left, right] = [Piece::Operand(0, PRIMARY), Piece::Operand(1, PRIMARY)];
    [Piece::Text("(int32_t)((uint32_t)"), left, Piece::Text(symbol), right, Piece::Text(")")]
}
