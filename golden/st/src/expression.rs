//! Expressions -> operations: every part gets a slot of its type.

use super::constant::{SMALLEST_DINT, operator};
use super::kind::{Kind, Value};
use super::lowering::{Lowering, Operand};
use super::number::{self, MINUS_ZERO};
use super::op::Code;
use super::syntax::{children, said, shown};
use super::variables::Role;
use super::{Dialect, binary, call};
use portable::RealKind;
use tree_sitter::Node;

/// The prefix of variables of TwinCAT's runtime, which a block may read; each is a UDINT.
const RUNTIME: &str = "TwinCAT_SystemInfoVarList.";

impl Lowering<'_, '_> {
    /// Lowers an expression; `None` after a reported error.
    pub(crate) fn expression(&mut self, node: Node<'_>) -> Option<Operand> {
        if node.has_error() {
            return None;
        }
        self.deeper(node, |lowering| inner(lowering, node))?
    }
}

fn inner(lowering: &mut Lowering<'_, '_>, node: Node<'_>) -> Option<Operand> {
    let text = lowering.text;
    match node.kind() {
        "identifier" => variable(lowering, node),
        "index_expression" => element(lowering, node),
        "boolean_literal" => {
            let value = Value::Bool(said(node, text).eq_ignore_ascii_case("TRUE"));
            Some(lowering.literal(Kind::Bool, value))
        }
        "integer_literal" => {
            let value = number::integer(said(node, text));
            // An underscore has already been reported.
            if value.is_none() && !said(node, text).contains('_') {
                lowering.say(node, shown(node, text), "an integer that fits a DINT or UDINT");
            }
            integer(lowering, node, value?)
        }
        "real_literal" => real(lowering, node),
        "parenthesized_expression" => {
            let (inside, _) = children(node).into_iter().find(|(part, _)| part.is_named())?;
            lowering.expression(inside)
        }
        "unary_expression" => unary(lowering, node),
        // A number of the text, not an operation that could be changed.
        "binary_expression" if said(node, text) == MINUS_ZERO && !lowering.has_named_reals() => {
            Some(lowering.literal(Kind::Real, Value::Real(-0.0)))
        }
        "binary_expression" => binary::lower(lowering, node),
        "member_access_expression" => match lowering.variables.single.get(said(node, text)) {
            // A block that reads its task uses only its inputs here, because there is no task.
            None if lowering.dialect == Dialect::TwinCat && said(node, text).starts_with(RUNTIME) => {
                Some(lowering.literal(Kind::Udint, Value::Word(0)))
            }
            Some(part) => part.known.then_some(Operand::Slot { kind: part.kind, slot: part.slot, part: false }),
            None => lowering.output(node),
        },
        "call_expression" => call::lower(lowering, node),
        // A string and a number with a type have already been reported.
        "string_literal"
        | "typed_literal"
        | "time_literal"
        | "date_literal"
        | "time_of_day_literal"
        | "date_and_time_literal" => None,
        _ => {
            lowering.say(node, shown(node, text), "a variable, a number or an operation on them");
            None
        }
    }
}

fn variable(lowering: &mut Lowering<'_, '_>, node: Node<'_>) -> Option<Operand> {
    let name = said(node, lowering.text);
    let Some(variable) = lowering.variables.single.get(name) else {
        lowering.no_variable(node);
        return None;
    };
    if variable.role == Role::Temporary && !lowering.assigned.contains(&(variable.kind as usize, variable.slot)) {
        lowering.say(node, format!("`{name}`, which has no value here on some way"), "an assignment before it");
        return None;
    }
    variable.known.then_some(Operand::Slot { kind: variable.kind, slot: variable.slot, part: false })
}

/// An element of an array, at a number of the text or at a DINT.
fn element(lowering: &mut Lowering<'_, '_>, node: Node<'_>) -> Option<Operand> {
    if lowering.variables.single.get(said(node, lowering.text)).is_some() {
        return variable(lowering, node);
    }
    let (object, index) = (node.child_by_field_name("object")?, node.child_by_field_name("index")?);
    let Some(array) = lowering.variables.arrays.get(said(object, lowering.text)) else {
        lowering.say(node, shown(node, lowering.text), "a variable, a number or an operation on them");
        return None;
    };
    match lowering.expression(index)? {
        Operand::Slot { kind: Kind::Dint, slot, part } => {
            let of = array.first.kind;
            let operand =
                lowering.emit(Code::element(of), of, &[(of, array.first.slot, false), (Kind::Dint, slot, part)]);
            lowering.ops.last_mut()?.c = array.length;
            Some(operand)
        }
        Operand::Integer(_) => {
            lowering.say(node, format!("{}, which is outside", shown(node, lowering.text)), "an element of the array");
            None
        }
        other => {
            let found = format!("a {} as an index", lowering.kind_name(other));
            lowering.say(index, found, "a DINT");
            None
        }
    }
}

fn integer(lowering: &mut Lowering<'_, '_>, node: Node<'_>, value: i64) -> Option<Operand> {
    if value == SMALLEST_DINT {
        // For some compilers 2147483648 is a LINT, and so is its negative.
        lowering.say(node, "`-2147483648` in an expression", "`-2147483647 - 1`");
        return None;
    }
    Some(Operand::Integer(value))
}

fn real(lowering: &mut Lowering<'_, '_>, node: Node<'_>) -> Option<Operand> {
    let text = lowering.text;
    if lowering.has_named_reals() {
        let name = lowering.name(Kind::Real);
        let found = match lowering.variables.real {
            RealKind::F32 => format!("{}, which is LREAL, in an expression of REAL", shown(node, text)),
            RealKind::F64 => format!("{} in an expression", shown(node, text)),
        };
        lowering.say(node, found, format!("a {name} variable that was assigned it"));
        return None;
    }
    let value = said(node, text).parse().ok()?;
    Some(lowering.literal(Kind::Real, Value::Real(value)))
}

fn unary(lowering: &mut Lowering<'_, '_>, node: Node<'_>) -> Option<Operand> {
    let inside = node.child_by_field_name("operand")?;
    if lowering.dialect == Dialect::Scl && said(inside, lowering.text).starts_with('-') {
        lowering.say(node, "two signs before an operand", "one sign, or parentheses");
        return None;
    }
    let operand = lowering.expression(inside);
    let operator = operator(node, lowering.text);
    let is_not = operator.eq_ignore_ascii_case("NOT");
    if is_not && !matches!(inside.kind(), "identifier" | "member_access_expression" | "call_expression") {
        let found = "`NOT` of an expression, which one compiler translates wrongly";
        lowering.say(node, found, "a BOOL variable that was assigned the condition");
        return None;
    }
    let operand = operand?;
    let code = match (operator.to_ascii_uppercase().as_str(), operand) {
        ("-", Operand::Integer(value)) => return integer(lowering, node, value.checked_neg()?),
        ("-", Operand::Slot { kind: Kind::Real, .. }) => {
            if !lowering.may_be(inside, false, "an operand of `-`") {
                return None;
            }
            Code::NegateReal
        }
        ("-", Operand::Slot { kind: Kind::Dint, .. }) => Code::NegateWord,
        ("NOT", Operand::Slot { kind: Kind::Bool, .. }) => Code::Not,
        // The plus has already been reported.
        ("+", _) => return Some(operand),
        _ => {
            let found = format!("`{operator}` of {}", lowering.kind_name(operand));
            lowering.say(node, found, if operator == "-" { "a REAL, LREAL or DINT" } else { "a BOOL" });
            return None;
        }
    };
    let (kind, slot, part) = lowering.typed(operand, Kind::Dint, node)?;
    Some(lowering.emit(code, kind, &[(kind, slot, part)]))
}
