//! Expressions -> operations: every part gets a slot of its type.

use super::Dialect;
use super::constant::{operator, word};
use super::declarations::Role;
use super::kind::{Kind, Value};
use super::lowering::{Lowering, Operand, Typed};
use super::machine::{Code, Op};
use super::number;
use super::syntax::{children, said, shown};
use portable::RealKind;
use tree_sitter::Node;

impl Lowering<'_, '_> {
    /// Lowers an expression; `None`: a mistake was said.
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
        "identifier" => {
            let name = said(node, text);
            let Some(variable) = lowering.variables.find(name) else {
                lowering.undeclared(node);
                return None;
            };
            if variable.role == Role::Temporary && !lowering.assigned.contains(&(variable.kind as usize, variable.slot))
            {
                lowering.say(node, format!("`{name}`, which has no value here on some way"), "an assignment before it");
                return None;
            }
            let operand = Operand::Slot { kind: variable.kind, slot: variable.slot, passing: false };
            variable.known.then_some(operand)
        }
        "boolean_literal" => {
            let value = Value::Bool(said(node, text).eq_ignore_ascii_case("TRUE"));
            Some(lowering.literal(Kind::Bool, value))
        }
        "integer_literal" => {
            let value = number::integer(said(node, text));
            // An underscore was said of already.
            if value.is_none() && !said(node, text).contains('_') {
                lowering.say(node, shown(node, text), "an integer that fits a DINT or UDINT");
            }
            if value == Some(SMALLEST_DINT) {
                // To some compilers 2147483648 is a LINT, and so is minus it.
                lowering.say(node, "`-2147483648` in an expression".to_owned(), "`-2147483647 - 1`");
                return None;
            }
            value.map(Operand::Integer)
        }
        "real_literal" => real(lowering, node),
        "parenthesized_expression" => {
            let (inside, _) = children(node).into_iter().find(|(part, _)| part.is_named())?;
            lowering.expression(inside)
        }
        "unary_expression" => unary(lowering, node),
        "binary_expression" => binary(lowering, node),
        "call_expression" => lowering.call(node),
        // A string and a number with a type were said of already.
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

/// -2^31.
const SMALLEST_DINT: i64 = -2_147_483_648;

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
    let operand = lowering.expression(inside)?;
    let operator = operator(node, lowering.text);
    let code = match (operator.to_ascii_uppercase().as_str(), operand) {
        ("-", Operand::Integer(value)) => return value.checked_neg().map(Operand::Integer),
        ("-", Operand::Slot { kind: Kind::Real, .. }) => Code::NegateReal,
        ("-", Operand::Slot { kind: Kind::Dint, .. }) => Code::NegateWord,
        ("NOT", Operand::Slot { kind: Kind::Bool, .. }) => Code::Not,
        // The plus was said of already.
        ("+", _) => return Some(operand),
        _ => {
            let found = format!("`{operator}` of {}", lowering.kind_name(operand));
            lowering.say(node, found, if operator == "-" { "a REAL, LREAL or DINT" } else { "a BOOL" });
            return None;
        }
    };
    let (kind, slot, passing) = lowering.typed(operand, Kind::Dint, node)?;
    Some(lowering.emit(code, kind, &[(kind, slot, passing)]))
}

fn binary(lowering: &mut Lowering<'_, '_>, node: Node<'_>) -> Option<Operand> {
    let (left, right) = (node.child_by_field_name("left")?, node.child_by_field_name("right")?);
    let operator = operator(node, lowering.text).to_ascii_uppercase();
    let instead = match operator.as_str() {
        "MOD" => Some("a counter that begins again at its bound"),
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
        // Of the smallest DINT this is the only form that every compiler reads alike: no smaller type holds its left side.
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
    if a.0 != b.0 {
        let (one, other) = (lowering.name(a.0), lowering.name(b.0));
        let instead = match (a.0, b.0) {
            (Kind::Real, integer @ (Kind::Dint | Kind::Udint)) | (integer @ (Kind::Dint | Kind::Udint), Kind::Real) => {
                format!("`{}_TO_{}`", lowering.name(integer), lowering.name(Kind::Real))
            }
            _ => "one type on both sides".to_owned(),
        };
        lowering.say(place, format!("`{operator}` of {one} and {other}"), instead);
        return None;
    }
    let Some((code, result, swapped)) = code(&operator, a.0) else {
        let name = lowering.name(a.0);
        let instead = match (operator.as_str(), a.0) {
            ("AND" | "OR", _) => "BOOLs, or arithmetic",
            ("/", _) => "reals, or a coefficient",
            (_, Kind::Bool) => "`AND`, `OR`, `NOT`, `=` or `<>`",
            _ => "an operator of the type",
        };
        lowering.say(place, format!("`{operator}` of {name}"), instead);
        return None;
    };
    Some(lowering.emit(code, result, &if swapped { [b, a] } else { [a, b] }))
}

/// The operation, the type of its result, and whether its operands change places.
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

impl Lowering<'_, '_> {
    /// The name of an operand's type.
    pub(crate) fn kind_name(&self, operand: Operand) -> &'static str {
        match operand {
            Operand::Slot { kind, .. } => self.name(kind),
            Operand::Integer(_) => "an integer literal",
        }
    }

    /// The name of a type.
    pub(crate) fn name(&self, kind: Kind) -> &'static str {
        kind.name(self.variables.real)
    }

    /// A slot for a number of the text.
    pub(crate) fn literal(&mut self, kind: Kind, value: Value) -> Operand {
        Operand::Slot { kind, slot: self.variables.slot(kind, Some(value)), passing: false }
    }

    /// An operand, of which a literal takes the wanted type if it fits.
    pub(crate) fn typed(&mut self, operand: Operand, wanted: Kind, node: Node<'_>) -> Option<Typed> {
        match (operand, wanted) {
            (Operand::Slot { kind, slot, passing }, _) => Some((kind, slot, passing)),
            (Operand::Integer(value), Kind::Dint | Kind::Udint) => {
                if let Some(word) = word(value, wanted) {
                    return Some((wanted, self.variables.slot(wanted, Some(Value::Word(word))), false));
                }
                let instead = format!("an integer that fits a {}", self.name(wanted));
                self.say(node, format!("`{value}`"), instead);
                None
            }
            (Operand::Integer(value), _) => {
                let name = self.name(wanted);
                let instead =
                    if wanted == Kind::Real { format!("`{value}.0`") } else { "`TRUE` or `FALSE`".to_owned() };
                self.say(node, format!("the integer `{value}` where a {name} belongs"), instead);
                None
            }
        }
    }

    /// Appends an operation whose result goes into a slot of its own.
    pub(crate) fn emit(&mut self, code: Code, result: Kind, operands: &[Typed]) -> Operand {
        for &(kind, slot, passing) in operands {
            if passing {
                self.free[kind as usize].push(slot);
            }
        }
        let slot = self.free[result as usize].pop().unwrap_or_else(|| self.variables.slot(result, None));
        let of = |at: usize| operands.get(at).map_or(0, |&(_, slot, _)| slot);
        self.ops.push(Op { code, to: slot, a: of(0), b: of(1) });
        Operand::Slot { kind: result, slot, passing: true }
    }
}
