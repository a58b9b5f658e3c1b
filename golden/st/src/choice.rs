//! Conditional statements -> jumps over operations.

use super::constant::SMALLEST_DINT;
use super::kind::Kind;
use super::lowering::{Lowering, Operand};
use super::number;
use super::op::{Code, Op};
use super::syntax::{children, said, shown};
use super::variables;
use std::collections::BTreeSet;
use tree_sitter::Node;

impl Lowering<'_, '_> {
    /// Lowers an `IF`.
    pub(crate) fn choice(&mut self, node: Node<'_>) {
        let arms: Vec<Node<'_>> = std::iter::once(node).chain(clauses(node)).collect();
        self.arms(&arms, |lowering, arm| {
            let condition = arm.child_by_field_name("condition")?;
            let slot = lowering.condition(condition);
            Some(lowering.jump(Code::JumpUnless, slot))
        });
    }

    /// Lowers a `CASE`: its value is computed once, and compared with one label after another.
    pub(crate) fn case(&mut self, node: Node<'_>) {
        let subject = node.child_by_field_name("subject").and_then(|subject| self.subject(subject));
        let mut before = BTreeSet::new();
        self.arms(&clauses(node), |lowering, clause| {
            if clause.kind() == "else_clause" {
                return None;
            }
            let slot = lowering.labels(clause, subject, &mut before);
            Some(lowering.jump(Code::JumpUnless, slot))
        });
    }

    /// Lowers alternatives, of which at most one is executed. `test` appends the jump over an arm; an arm without a test is
    /// the last.
    fn arms(&mut self, arms: &[Node<'_>], mut test: impl FnMut(&mut Self, Node<'_>) -> Option<usize>) {
        let mut ends = Vec::new();
        // A variable has a value after the statement if it is assigned in each of its arms and, without an ELSE, before it.
        let mut after: Option<BTreeSet<(usize, u32)>> = None;
        for (at, &arm) in arms.iter().enumerate() {
            let what = match arm.kind() {
                "elsif_clause" => "`ELSIF`",
                "else_clause" => "`ELSE`",
                "case_clause" => "a branch of `CASE`",
                _ => "`IF`",
            };
            let skip = test(self, arm);
            let before = self.assigned.clone();
            self.statements(&body(arm), arm, what);
            let own = std::mem::replace(&mut self.assigned, before);
            after = Some(after.map_or_else(|| own.clone(), |others| others.intersection(&own).copied().collect()));
            if at + 1 < arms.len() {
                ends.push(self.jump(Code::Jump, 0));
            }
            if let Some(skip) = skip {
                self.land(skip);
            }
        }
        if arms.last().is_some_and(|arm| arm.kind() == "else_clause") {
            self.assigned = after.unwrap_or_default();
        }
        for end in ends {
            self.land(end);
        }
    }

    /// The slot of a condition.
    fn condition(&mut self, node: Node<'_>) -> u32 {
        let operand = self.expression(node);
        let operand = operand.and_then(|operand| self.typed(operand, Kind::Bool, node));
        match operand {
            Some((Kind::Bool, slot, _)) => slot,
            Some((kind, ..)) => {
                let found = format!("a condition of type {}", self.name(kind));
                self.say(node, found, "a BOOL");
                0
            }
            None => 0,
        }
    }

    /// The type and the slot of the value of a `CASE`; `None` after a reported error.
    fn subject(&mut self, node: Node<'_>) -> Option<(Kind, u32)> {
        match self.expression(node)? {
            Operand::Slot { kind: kind @ (Kind::Dint | Kind::Udint), slot, .. } => Some((kind, slot)),
            other => {
                let found = format!("`CASE` of {}", self.kind_name(other));
                self.say(node, found, "a DINT or UDINT");
                None
            }
        }
    }

    /// The slot of the condition that the value is one of a branch's labels; `before` has the previous labels.
    fn labels(&mut self, clause: Node<'_>, subject: Option<(Kind, u32)>, before: &mut BTreeSet<i64>) -> u32 {
        let (kind, subject) = subject.unzip();
        let kind = kind.unwrap_or(Kind::Dint);
        let mut any = None;
        for (node, _) in children(clause).into_iter().filter(|(part, _)| part.kind() == "case_value") {
            let label = self.label(node, before).and_then(|label| self.typed(Operand::Integer(label), kind, node));
            let (Some((_, label, _)), Some(subject)) = (label, subject) else { continue };
            let operands = [(kind, subject, false), (kind, label, false)];
            let mut test = self.emit(Code::EqualWord, Kind::Bool, &operands);
            if let (Some(any), Some(own)) = (any, self.typed(test, Kind::Bool, node)) {
                test = self.emit(Code::Or, Kind::Bool, &[any, own]);
            }
            any = self.typed(test, Kind::Bool, node);
        }
        any.map_or(0, |(_, slot, _)| slot)
    }

    /// The number of a label; `None` after a reported error.
    fn label(&mut self, node: Node<'_>, before: &mut BTreeSet<i64>) -> Option<i64> {
        let (part, _) = children(node).into_iter().next()?;
        let label = shown(node, self.text);
        let value = number::integer(said(part, self.text)).filter(|_| part.kind() == "integer_literal");
        let Some(value) = value else {
            if part.kind() == "subrange" {
                self.say(node, format!("the range {label}"), "each number of it, with commas between them");
            } else if !node.has_error() {
                self.say(node, format!("the label {label}"), "an integer literal");
            }
            return None;
        };
        if value == SMALLEST_DINT {
            // As in an expression: for some compilers 2147483648 is a LINT, and so is its negative.
            self.say(node, format!("the label {label}"), "another label");
            return None;
        }
        if !before.insert(value) {
            self.say(node, format!("the label {label} a second time"), "each label once");
            return None;
        }
        Some(value)
    }

    fn jump(&mut self, code: Code, a: u32) -> usize {
        self.ops.push(Op::new(code, 0, [a, 0]));
        self.ops.len() - 1
    }

    /// Sets the target of the jump to the next operation.
    fn land(&mut self, jump: usize) {
        self.ops[jump].to = variables::number(self.ops.len());
    }
}

/// The arms after the first words of a statement.
fn clauses(node: Node<'_>) -> Vec<Node<'_>> {
    children(node).into_iter().map(|(part, _)| part).filter(|part| part.kind().ends_with("_clause")).collect()
}

/// The statements of an arm.
fn body<'n>(arm: Node<'n>) -> Vec<Node<'n>> {
    let statement = |(part, field): &(Node<'n>, Option<&'n str>)| {
        part.is_named()
            && *field != Some("condition")
            && part.kind() != "case_value"
            && !part.kind().ends_with("_clause")
    };
    children(arm).into_iter().filter(statement).map(|(part, _)| part).collect()
}
