//! The permitted contents of a statement if reals are REAL: one operation, so that no compiler has an intermediate result
//! that it could keep in another precision. No operation is lowered here.

use super::lowering::{Lowering, Operand};
use super::op::{Code, Op};
use super::syntax::{children, shown};
use portable::RealKind;
use tree_sitter::Node;

/// What to write instead.
const INSTEAD: &str = "one operation a statement";

impl Lowering<'_, '_> {
    /// Lowers the right side of `:=`; `None` after a reported error. A condition contains at most comparisons, whose
    /// operands are checked one by one.
    pub(crate) fn value(&mut self, node: Node<'_>) -> Option<Operand> {
        let first = self.ops.len();
        let operand = self.expression(node)?;
        let count = self.ops[first..].iter().filter(|op| is_operation(op)).count();
        if self.variables.real == RealKind::F32 && count > 1 {
            self.say(node, format!("{count} operations on reals in a statement"), INSTEAD);
            return None;
        }
        Some(operand)
    }

    /// Whether a real may be an operand of an operation that is not arithmetic: as REAL it must be a variable, or the
    /// negative of one if `signed`; reports it if not.
    pub(crate) fn may_be(&mut self, node: Node<'_>, signed: bool, place: &str) -> bool {
        let good = self.variables.real == RealKind::F64 || is_variable(node) || signed && is_minus_variable(node);
        if !good {
            self.say(node, format!("{} as {place}", shown(node, self.text)), INSTEAD);
        }
        good
    }
}

/// Whether it is arithmetic on reals or a conversion to one. A minus is not: its operand is checked elsewhere.
fn is_operation(op: &Op) -> bool {
    matches!(
        op.code,
        Code::AddReal
            | Code::SubtractReal
            | Code::MultiplyReal
            | Code::DivideReal
            | Code::RealOfDint
            | Code::RealOfUdint
    )
}

fn is_variable(node: Node<'_>) -> bool {
    matches!(inside(node).kind(), "identifier" | "member_access_expression" | "index_expression")
}

fn is_minus_variable(node: Node<'_>) -> bool {
    let node = inside(node);
    node.kind() == "unary_expression" && node.child_by_field_name("operand").is_some_and(is_variable)
}

/// The expression inside parentheses.
fn inside(mut node: Node<'_>) -> Node<'_> {
    while node.kind() == "parenthesized_expression" {
        let Some((inner, _)) = children(node).into_iter().find(|(part, _)| part.is_named()) else { break };
        node = inner;
    }
    node
}
