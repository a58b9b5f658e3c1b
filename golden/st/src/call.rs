//! Calls of functions: the conversions on which all compilers agree, and the function in the emitted files.

use super::Dialect;
use super::kind::Kind;
use super::lowering::{Lowering, Operand, Typed};
use super::names;
use super::op::Code;
use super::syntax::{children, said, shown};
use tree_sitter::Node;

/// Lowers a call; `None` after a reported error.
pub(crate) fn lower(lowering: &mut Lowering<'_, '_>, node: Node<'_>) -> Option<Operand> {
    let text = lowering.text;
    let function = node.child_by_field_name("function")?;
    let name = said(function, text).to_ascii_uppercase();
    let arguments = node.child_by_field_name("arguments")?;
    let arguments: Vec<Node<'_>> =
        children(arguments).into_iter().map(|(part, _)| part).filter(Node::is_named).collect();
    let real = lowering.name(Kind::Real);
    if name == format!("DINT_TO_{real}") {
        return conversion(lowering, node, &arguments, (Kind::Dint, Code::RealOfDint, Kind::Real));
    }
    if name == format!("UDINT_TO_{real}") {
        return conversion(lowering, node, &arguments, (Kind::Udint, Code::RealOfUdint, Kind::Real));
    }
    if name == "LREAL_TO_REAL" && real == "LREAL" {
        return conversion(lowering, node, &arguments, (Kind::Real, Code::Single, Kind::Real));
    }
    if name == "DINT_TO_UDINT" {
        return conversion(lowering, node, &arguments, (Kind::Dint, Code::MoveWord, Kind::Udint));
    }
    if name == "UDINT_TO_DINT" && node.parent().is_some_and(|parent| parent.kind() == "index_expression") {
        return conversion(lowering, node, &arguments, (Kind::Udint, Code::MoveWord, Kind::Dint));
    }
    if lowering.known.is_program {
        let narrow = match name.as_str() {
            "UINT_TO_DINT" => Some((Kind::Uint, Code::MoveWord, Kind::Dint)),
            "INT_TO_DINT" => Some((Kind::Int, Code::MoveWord, Kind::Dint)),
            "DINT_TO_INT" => Some((Kind::Dint, Code::Narrow, Kind::Int)),
            _ => None,
        };
        if let Some(narrow) = narrow {
            return conversion(lowering, node, &arguments, narrow);
        }
    }
    if name == "TRUNC" {
        return truncation(lowering, node, &arguments);
    }
    if matches!(lowering.dialect, Dialect::TwinCat | Dialect::Codesys) && name == format!("F_AXGEN_IN_RANGE_{real}") {
        return in_range(lowering, node, &arguments);
    }
    if lowering.variables.inner.get(&name).is_some() {
        let found = format!("a call of {} in an expression", shown(function, text));
        lowering.say(function, found, "the call as a statement before it");
        return None;
    }
    let instead = match name.as_str() {
        "DINT_TO_LREAL" | "DINT_TO_REAL" | "UDINT_TO_LREAL" | "UDINT_TO_REAL" => {
            format!("a conversion to {real}, the type of this block")
        }
        "MIN" | "MAX" | "LIMIT" | "ABS" | "SEL" | "MUX" => "`IF`".to_owned(),
        _ => "what it computes, in operators".to_owned(),
    };
    let what = if names::function(&name) { "the standard function" } else { "a call of" };
    lowering.say(function, format!("{what} {}", shown(function, text)), instead);
    None
}

fn conversion(
    lowering: &mut Lowering<'_, '_>,
    node: Node<'_>,
    arguments: &[Node<'_>],
    (from, code, to): (Kind, Code, Kind),
) -> Option<Operand> {
    let name = lowering.name(from);
    let [argument] = arguments else {
        lowering.say(node, format!("a conversion of {} values", arguments.len()), "one value in the parentheses");
        return None;
    };
    if argument.kind() == "named_argument" {
        lowering.say(*argument, "a named argument of a conversion", "its value alone");
        return None;
    }
    match lowering.expression(*argument)? {
        Operand::Slot { kind, slot, part } if kind == from => Some(lowering.emit(code, to, &[(kind, slot, part)])),
        Operand::Integer(value) => {
            lowering.say(*argument, format!("a conversion of `{value}`"), format!("`{value}.0`"));
            None
        }
        other => {
            let found = format!("a {} where a {name} belongs", lowering.kind_name(other));
            lowering.say(*argument, found, "the conversion from its type");
            None
        }
    }
}

/// `TRUNC` of a real, alone to the right of `:=`: some compilers take its type from the assigned variable.
fn truncation(lowering: &mut Lowering<'_, '_>, node: Node<'_>, arguments: &[Node<'_>]) -> Option<Operand> {
    let [argument] = arguments else {
        lowering.say(node, format!("TRUNC of {} values", arguments.len()), "one value in the parentheses");
        return None;
    };
    if node.parent().is_none_or(|parent| parent.kind() != "assignment_statement") {
        lowering.say(node, "TRUNC inside an expression", "a DINT of its own that it is assigned to");
        return None;
    }
    let x = real(lowering, *argument)?;
    let good = lowering.may_be(*argument, false, "an operand of TRUNC");
    good.then(|| lowering.emit(Code::Truncate, Kind::Dint, &[x]))
}

fn in_range(lowering: &mut Lowering<'_, '_>, node: Node<'_>, arguments: &[Node<'_>]) -> Option<Operand> {
    let (mut values, text) = ([None, None], lowering.text);
    for argument in arguments {
        let name = argument.child_by_field_name("name").map_or("", |name| said(name, text)).to_ascii_lowercase();
        let assigned = children(*argument).iter().any(|(part, _)| part.kind() == ":=");
        let position = ["value", "largest"].iter().position(|wanted| assigned && name == *wanted);
        let Some(position) = position.filter(|&at| values[at].is_none()) else {
            lowering.say(*argument, format!("the argument {}", shown(*argument, text)), "`value := x, largest := y`");
            return None;
        };
        values[position] = argument.child_by_field_name("value");
    }
    let [Some(value), Some(limit)] = values else {
        lowering.say(node, shown(node, text), "`value := x, largest := y` in the parentheses");
        return None;
    };
    let (a, b) = (parameter(lowering, value), parameter(lowering, limit));
    Some(lowering.emit(Code::InRange, Kind::Bool, &[a?, b?]))
}

/// A real that is passed to a parameter of a function.
fn parameter(lowering: &mut Lowering<'_, '_>, node: Node<'_>) -> Option<Typed> {
    let typed = real(lowering, node)?;
    if let Some(last) = lowering.ops.last_mut().filter(|_| typed.2) {
        last.part = false;
    }
    lowering.may_be(node, true, "an argument of a function").then_some(typed)
}

fn real(lowering: &mut Lowering<'_, '_>, node: Node<'_>) -> Option<Typed> {
    let operand = lowering.expression(node)?;
    let typed = lowering.typed(operand, Kind::Real, node)?;
    if typed.0 == Kind::Real {
        return Some(typed);
    }
    let name = lowering.name(Kind::Real);
    let found = format!("a {} where a {name} belongs", lowering.name(typed.0));
    lowering.say(node, found, format!("a {name}"));
    None
}
