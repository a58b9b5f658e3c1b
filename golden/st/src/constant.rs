//! Values that are known from the text: initial values, and literals that are assigned to a REAL variable.

use super::Dialect;
use super::kind::{Kind, Value};
use super::mistake::Mistakes;
use super::number::{self, Constant, MINUS_ZERO};
use super::syntax::{said, shown};
use portable::RealKind;
use tree_sitter::Node;

/// -2^31.
pub(crate) const SMALLEST_DINT: i64 = -2_147_483_648;

/// A real literal, or `-`, `*` and parentheses of such; in SCL a literal with its sign and -0.0. `None` for anything else.
pub(crate) fn product(dialect: Dialect, node: Node<'_>, text: &str, depth: usize) -> Option<Constant> {
    let depth = depth.checked_sub(1)?;
    match node.kind() {
        "real_literal" => Constant::literal(said(node, text)),
        "parenthesized_expression" => {
            product(dialect, node.named_children(&mut node.walk()).find(no_comment)?, text, depth)
        }
        "unary_expression" if operator(node, text) == "-" => {
            let operand = node.child_by_field_name("operand")?;
            if dialect == Dialect::Scl && said(operand, text).starts_with('-') {
                return None;
            }
            Some(product(dialect, operand, text, depth)?.negated())
        }
        "binary_expression"
            if operator(node, text) == "*" && (dialect != Dialect::Scl || said(node, text) == MINUS_ZERO) =>
        {
            let left = product(dialect, node.child_by_field_name("left")?, text, depth)?;
            Some(left.times(product(dialect, node.child_by_field_name("right")?, text, depth)?))
        }
        _ => None,
    }
}

fn no_comment(node: &Node<'_>) -> bool {
    node.kind() != "comment"
}

/// The operator of an expression.
pub(crate) fn operator<'t>(node: Node<'_>, text: &'t str) -> &'t str {
    node.child_by_field_name("operator").map_or("", |operator| said(operator, text))
}

/// The value of a product in a block's real type; reports it if compilers disagree about it.
pub(crate) fn value(
    constant: Constant,
    node: Node<'_>,
    text: &str,
    real: RealKind,
    mistakes: &mut Mistakes<'_>,
) -> Option<f64> {
    let value = constant.value(real);
    if value.is_none() {
        let found = format!("{}, which is not the same number read as LREAL and as REAL", shown(node, text));
        match real {
            RealKind::F64 => {
                mistakes.push(node.start_byte(), format!("{}, no finite number", shown(node, text)), "a finite one")
            }
            RealKind::F32 => mistakes.push(node.start_byte(), found, "digits that give the same REAL both ways"),
        }
    }
    value
}

/// An initial value.
pub(crate) fn initial(
    (dialect, real): (Dialect, RealKind),
    node: Node<'_>,
    text: &str,
    kind: Kind,
    mistakes: &mut Mistakes<'_>,
) -> Option<Value> {
    let found = match (kind, node.kind()) {
        (Kind::Real, _) => {
            if let Some(constant) = product(dialect, node, text, super::DEPTH) {
                return value(constant, node, text, real, mistakes).map(Value::Real);
            }
            None
        }
        (Kind::Bool, "boolean_literal") => Some(Value::Bool(said(node, text).eq_ignore_ascii_case("TRUE"))),
        (Kind::Dint | Kind::Udint | Kind::Int | Kind::Uint, _) => {
            integer(node, text).and_then(|value| word(value, kind)).map(Value::Word)
        }
        _ => None,
    };
    if found.is_none() {
        let is_smallest = kind == Kind::Dint && number::integer(said(node, text)) == Some(SMALLEST_DINT);
        let instead =
            if is_smallest { "`-2147483647 - 1`".to_owned() } else { format!("a literal of {}", kind.name(real)) };
        mistakes.push(node.start_byte(), format!("the initial value {}", shown(node, text)), instead);
    }
    found
}

/// An integer literal, or the only form of -2^31 that every compiler reads in the same way.
fn integer(node: Node<'_>, text: &str) -> Option<i64> {
    let literal = |node: Node<'_>| {
        let value = number::integer(said(node, text)).filter(|_| node.kind() == "integer_literal");
        value.filter(|value| *value != SMALLEST_DINT)
    };
    let part = |name| node.child_by_field_name(name).and_then(literal);
    if operator(node, text) == "-" && part("left") == Some(SMALLEST_DINT + 1) && part("right") == Some(1) {
        return Some(SMALLEST_DINT);
    }
    literal(node)
}

/// The bits of an integer, if it is in the range of the type.
pub(crate) fn word(value: i64, kind: Kind) -> Option<u32> {
    match kind {
        Kind::Dint => i32::try_from(value).ok().map(i32::cast_unsigned),
        Kind::Udint => u32::try_from(value).ok(),
        Kind::Int => i16::try_from(value).ok().map(|value| i32::from(value).cast_unsigned()),
        Kind::Uint => u16::try_from(value).ok().map(u32::from),
        Kind::Real | Kind::Bool => None,
    }
}
