//! Statements -> operations.

use super::constant;
use super::declarations::Role;
use super::kind::{Kind, Value};
use super::lowering::{Lowering, Operand, Typed};
use super::machine::{Code, Op};
use super::syntax::{children, said, shown};
use super::{DEPTH, Dialect};
use std::collections::BTreeSet;
use tree_sitter::Node;

impl Lowering<'_, '_> {
    /// Lowers a list of statements, of which there has to be one.
    pub(crate) fn statements(&mut self, list: &[Node<'_>], place: Node<'_>, what: &str) {
        let (mut real, mut taken) = (0, false);
        for (at, &node) in list.iter().enumerate() {
            if node.kind() == "empty_statement" {
                if !taken {
                    self.say(node, "`;` without a statement", "nothing");
                }
                taken = false;
                continue;
            }
            let ended = node.kind() == "if_statement" && !node.has_error();
            // What is refused already may have its semicolon.
            taken = !matches!(node.kind(), "assignment_statement" | "pragma");
            if ended && list.get(at + 1).is_none_or(|next| next.kind() != "empty_statement") {
                self.mistakes.push(node.end_byte(), "no `;` after `END_IF`", "`END_IF;`");
            }
            real += usize::from(node.kind() != "pragma");
            let _ = self.deeper(node, |lowering| lowering.statement(node));
        }
        if real == 0 {
            self.say(place, format!("{what} without a statement"), "a statement");
        }
    }

    fn statement(&mut self, node: Node<'_>) {
        match node.kind() {
            "assignment_statement" => {
                self.assignment(node);
            }
            "if_statement" => self.choice(node),
            // A pragma was said of already, where it may not stand.
            "pragma" => {}
            // So was what the grammar does not take.
            "ERROR" => {}
            other => {
                let (found, instead) = match other {
                    "for_statement" => ("`FOR`", "its passes one after another"),
                    "while_statement" => ("`WHILE`", "`IF`, and the rest in the next cycle"),
                    "repeat_statement" => ("`REPEAT`", "`IF`, and the rest in the next cycle"),
                    "case_statement" => ("`CASE`", "`IF` and `ELSIF`"),
                    "exit_statement" => ("`EXIT`", "`IF`"),
                    "continue_statement" => ("`CONTINUE`", "`IF`"),
                    "return_statement" => ("`RETURN`", "`IF` around the rest"),
                    "invocation_statement" => ("a call as a statement", "what it does"),
                    "reference_assignment_statement" => ("`REF=`", "`:=`"),
                    _ => (other, "`:=` or `IF`"),
                };
                self.say(node, found, instead);
            }
        }
    }

    fn assignment(&mut self, node: Node<'_>) -> Option<()> {
        if node.has_error() {
            return None;
        }
        let (left, right) = (node.child_by_field_name("left")?, node.child_by_field_name("right")?);
        let target = self.target(left);
        let kind = target.map(|(kind, _)| kind);
        if self.has_named_reals()
            && let Some(product) = constant::product(self.dialect, right, self.text, DEPTH - self.depth)
        {
            let value = constant::value(product, right, self.text, self.variables.real, self.mistakes)?;
            let Operand::Slot { kind: Kind::Real, slot, .. } = self.literal(Kind::Real, Value::Real(value)) else {
                return None;
            };
            return self.store(target?, (Kind::Real, slot, false), right);
        }
        let value = self.expression(right)?;
        let value = self.typed(value, kind?, right)?;
        self.store(target?, value, right)
    }

    /// The variable that an assignment writes.
    fn target(&mut self, node: Node<'_>) -> Option<(Kind, u32)> {
        let name = said(node, self.text);
        if node.kind() != "identifier" {
            self.say(node, format!("{} left of `:=`", shown(node, self.text)), "a variable");
            return None;
        }
        let Some(variable) = self.variables.find(name) else {
            self.undeclared(node);
            return None;
        };
        match variable.role {
            Role::Output | Role::Local | Role::Temporary => {
                return variable.known.then_some((variable.kind, variable.slot));
            }
            Role::Input => self.say(node, format!("the input `{name}` left of `:=`"), "a variable of its own"),
            Role::Constant => self.say(node, format!("the constant `{name}` left of `:=`"), "a variable of its own"),
        }
        None
    }

    fn store(&mut self, (kind, to): (Kind, u32), value: Typed, node: Node<'_>) -> Option<()> {
        let (found, slot, passing) = value;
        if found != kind {
            let (wanted, found) = (self.name(kind), self.name(found));
            let instead = if kind == Kind::Real && found != "BOOL" {
                format!("`{found}_TO_{wanted}`, or a {wanted}")
            } else {
                format!("a {wanted}")
            };
            self.say(node, format!("a {found} for a {wanted}"), instead);
            return None;
        }
        match self.ops.last_mut() {
            Some(last) if passing => {
                last.to = to;
                self.free[kind as usize].push(slot);
            }
            _ => {
                let code = match kind {
                    Kind::Real => Code::MoveReal,
                    Kind::Bool => Code::MoveBool,
                    Kind::Dint | Kind::Udint => Code::MoveWord,
                };
                self.ops.push(Op { code, to, a: slot, b: 0 });
            }
        }
        if self.dialect == Dialect::Scl {
            self.assigned.insert((kind as usize, to));
        }
        Some(())
    }

    fn choice(&mut self, node: Node<'_>) {
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
            Some((Kind::Bool, slot, passing)) => {
                if passing {
                    self.free[Kind::Bool as usize].push(slot);
                }
                slot
            }
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
