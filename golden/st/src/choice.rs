//! Statements that choose among others -> jumps over operations.

use super::kind::Kind;
use super::lowering::Lowering;
use super::op::{Code, Op};
use super::syntax::children;
use std::collections::BTreeSet;
use tree_sitter::Node;

impl Lowering<'_, '_> {
    /// Lowers an `IF`.
    pub(crate) fn choice(&mut self, node: Node<'_>) {
        let mut ends = Vec::new();
        // What has a value behind the question has one behind each of its arms, and without an ELSE before it too.
        let mut behind: Option<BTreeSet<(usize, u32)>> = None;
        let mut arms = vec![node];
        arms.extend(children(node).into_iter().map(|(part, _)| part).filter(|part| part.kind().ends_with("_clause")));
        for (at, &arm) in arms.iter().enumerate() {
            let what = match arm.kind() {
                "elsif_clause" => "`ELSIF`",
                "else_clause" => "`ELSE`",
                _ => "`IF`",
            };
            let skip = arm.child_by_field_name("condition").map(|condition| self.condition(condition));
            let before = self.assigned.clone();
            self.statements(&body(arm), arm, what);
            let own = std::mem::replace(&mut self.assigned, before);
            behind = Some(behind.map_or_else(|| own.clone(), |others| others.intersection(&own).copied().collect()));
            if at + 1 < arms.len() {
                ends.push(self.jump(Code::Jump, 0));
            }
            if let Some(skip) = skip {
                self.land(skip);
            }
        }
        if arms.last().is_some_and(|arm| arm.kind() == "else_clause") {
            self.assigned = behind.unwrap_or_default();
        }
        for end in ends {
            self.land(end);
        }
    }

    /// Appends the test of a condition; its jump has no aim yet.
    fn condition(&mut self, node: Node<'_>) -> usize {
        let operand = self.expression(node);
        let operand = operand.and_then(|operand| self.typed(operand, Kind::Bool, node));
        let slot = match operand {
            Some((Kind::Bool, slot, _)) => slot,
            Some((kind, ..)) => {
                let found = format!("a condition of type {}", self.name(kind));
                self.say(node, found, "a BOOL");
                0
            }
            None => 0,
        };
        self.jump(Code::JumpUnless, slot)
    }

    fn jump(&mut self, code: Code, a: u32) -> usize {
        self.ops.push(Op { code, to: 0, a, b: 0 });
        self.ops.len() - 1
    }

    /// The jump goes to the next operation.
    fn land(&mut self, jump: usize) {
        let here = u32::try_from(self.ops.len()).expect("engine: a text is shorter than 2^32 bytes");
        self.ops[jump].to = here;
    }
}

/// The statements of an arm of an `IF`.
fn body<'n>(arm: Node<'n>) -> Vec<Node<'n>> {
    let statement = |(part, field): &(Node<'n>, Option<&'n str>)| {
        part.is_named() && *field != Some("condition") && !part.kind().ends_with("_clause")
    };
    children(arm).into_iter().filter(statement).map(|(part, _)| part).collect()
}
