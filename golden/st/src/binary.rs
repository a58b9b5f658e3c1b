//! Operators with two operands -> operations: the valid operators for each type.

use super::constant::{SMALLEST_DINT, operator};
use super::kind::Kind;
use super::lowering::{Lowering, Operand};
use super::number;
use super::op::Code;
use super::syntax::said;
use tree_sitter::Node;

/// Lowers an operator and its two operands; `None`: a mistake was reported.
pub(crate) fn lower(lowering: &mut Lowering<'_, '_>, node: Node<'_>) -> Option<Operand> {
    let (left, right) = (node.child_by_field_name("left")?, node.child_by_field_name("right")?);
    let operator = operator(node, lowering.text).to_ascii_uppercase();
    let instead = match operator.as_str() {
        "**" => Some("products"),
        "XOR" => Some("`<>`"),
        "&" => Some("`AND`"),
        _ => None,
    };
    if let Some(instead) = instead {
        let place = node.child_by_field_name("operator").unwrap_or(node);
        lowering.say(place, format!("`{operator}`"), instead);
    }
    let (a, b) = (lowering.expression(left), lowering.expression(right));
    let (a, b) = (a?, b?);
    if instead.is_some() {
        return None;
    }
    let kind = match (a, b) {
        (Operand::Slot { kind, .. }, _) | (_, Operand::Slot { kind, .. }) => kind,
        // For the smallest DINT this is the only form that every compiler reads in the same way: no smaller type holds its
        // left side.
        (Operand::Integer(left), Operand::Integer(1)) if operator == "-" && left == SMALLEST_DINT + 1 => {
            return Some(Operand::Integer(SMALLEST_DINT));
        }
        (Operand::Integer(_), Operand::Integer(_)) => {
            lowering.say(node, format!("`{operator}` of two integer literals"), "its result");
            return None;
        }
    };
    let (a, b) = (lowering.typed(a, kind, left), lowering.typed(b, kind, right));
    let (a, b) = (a?, b?);
    let place = node.child_by_field_name("operator").unwrap_or(node);
    let (code, result, swapped) = operation(lowering, place, &operator, [a.0, b.0])?;
    if a.0 == Kind::Real && result == Kind::Bool {
        let place = format!("an operand of `{operator}`");
        let good = [left, right].map(|node| lowering.may_be(node, true, &place));
        if good.contains(&false) {
            return None;
        }
    }
    // Controllers behave differently for a division by 0, and of the smallest DINT by -1.
    if matches!(code, Code::DivideDint | Code::RemainderDint | Code::DivideUdint | Code::RemainderUdint)
        && !is_positive_literal(right, lowering.text)
    {
        lowering.say(right, "a divisor that is not a positive literal", "an integer literal from 1 on");
        return None;
    }
    Some(lowering.emit(code, result, &if swapped { [b, a] } else { [a, b] }))
}

/// The operation on two types, from [`code`]; `None` if it does not exist, which was reported.
fn operation(
    lowering: &mut Lowering<'_, '_>,
    place: Node<'_>,
    operator: &str,
    [one, other]: [Kind; 2],
) -> Option<(Code, Kind, bool)> {
    let names = [one, other].map(|kind| lowering.name(kind));
    if one != other {
        let instead = match (one, other) {
            (Kind::Real, integer @ (Kind::Dint | Kind::Udint)) | (integer @ (Kind::Dint | Kind::Udint), Kind::Real) => {
                format!("`{}_TO_{}`", lowering.name(integer), lowering.name(Kind::Real))
            }
            _ => "one type on both sides".to_owned(),
        };
        lowering.say(place, format!("`{operator}` of {} and {}", names[0], names[1]), instead);
        return None;
    }
    let found = code(operator, one);
    if found.is_none() {
        let instead = match (operator, one) {
            (_, Kind::Int | Kind::Uint) => "a DINT that was converted from it",
            ("AND" | "OR", _) => "BOOLs, or arithmetic",
            ("/", Kind::Udint) => "a DINT, or reals",
            ("MOD", _) => "a DINT",
            (_, Kind::Bool) => "`AND`, `OR`, `NOT`, `=` or `<>`",
            _ => "an operator of the type",
        };
        lowering.say(place, format!("`{operator}` of {}", names[0]), instead);
    }
    found
}

fn is_positive_literal(node: Node<'_>, text: &str) -> bool {
    node.kind() == "integer_literal" && number::integer(said(node, text)).is_some_and(|value| value > 0)
}

/// The operation, the type of its result, and whether its operands are swapped.
fn code(operator: &str, kind: Kind) -> Option<(Code, Kind, bool)> {
    use Kind::{Bool, Dint, Real, Udint};
    let code = match (operator, kind) {
        ("+", Real) => (Code::AddReal, Real, false),
        ("-", Real) => (Code::SubtractReal, Real, false),
        ("*", Real) => (Code::MultiplyReal, Real, false),
        ("/", Real) => (Code::DivideReal, Real, false),
        ("<", Real) => (Code::LessReal, Bool, false),
        ("<=", Real) => (Code::AtMostReal, Bool, false),
        (">", Real) => (Code::LessReal, Bool, true),
        (">=", Real) => (Code::AtMostReal, Bool, true),
        ("=", Real) => (Code::EqualReal, Bool, false),
        ("<>", Real) => (Code::UnequalReal, Bool, false),
        ("AND", Bool) => (Code::And, Bool, false),
        ("OR", Bool) => (Code::Or, Bool, false),
        ("=", Bool) => (Code::EqualBool, Bool, false),
        ("<>", Bool) => (Code::UnequalBool, Bool, false),
        ("+", Dint | Udint) => (Code::AddWord, kind, false),
        ("-", Dint | Udint) => (Code::SubtractWord, kind, false),
        ("*", Dint | Udint) => (Code::MultiplyWord, kind, false),
        ("/", Dint) => (Code::DivideDint, Dint, false),
        ("MOD", Dint) => (Code::RemainderDint, Dint, false),
        ("/", Udint) => (Code::DivideUdint, Udint, false),
        ("MOD", Udint) => (Code::RemainderUdint, Udint, false),
        ("=", Dint | Udint) => (Code::EqualWord, Bool, false),
        ("<>", Dint | Udint) => (Code::UnequalWord, Bool, false),
        ("<", Dint) => (Code::LessDint, Bool, false),
        ("<=", Dint) => (Code::AtMostDint, Bool, false),
        (">", Dint) => (Code::LessDint, Bool, true),
        (">=", Dint) => (Code::AtMostDint, Bool, true),
        ("<", Udint) => (Code::LessUdint, Bool, false),
        ("<=", Udint) => (Code::AtMostUdint, Bool, false),
        (">", Udint) => (Code::LessUdint, Bool, true),
        (">=", Udint) => (Code::AtMostUdint, Bool, true),
        _ => return None,
    };
    Some(code)
}
