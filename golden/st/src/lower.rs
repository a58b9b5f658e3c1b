//! Statements -> operations, except conditional statements.

use super::constant;
use super::kind::{Kind, Value};
use super::lowering::{Lowering, Operand, Typed};
use super::op::{Code, Op};
use super::syntax::{said, shown};
use super::variables::Role;
use super::{DEPTH, Dialect};
use tree_sitter::Node;

impl Lowering<'_, '_> {
    /// Lowers a list of statements, which must not be empty.
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
            let end = match node.kind() {
                "if_statement" if !node.has_error() => Some("END_IF"),
                "case_statement" if !node.has_error() => Some("END_CASE"),
                _ => None,
            };
            // A rejected statement may have its semicolon.
            taken = !matches!(node.kind(), "assignment_statement" | "invocation_statement" | "pragma");
            if let Some(end) = end
                && list.get(at + 1).is_none_or(|next| next.kind() != "empty_statement")
            {
                self.mistakes.push(node.end_byte(), format!("no `;` after `{end}`"), format!("`{end};`"));
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
                let first = self.ops.len();
                self.assignment(node);
                self.assignments.push(first..self.ops.len());
            }
            "invocation_statement" => {
                self.invocation(node);
            }
            "if_statement" => self.choice(node),
            "case_statement" => self.case(node),
            // A pragma in a wrong place has already been reported.
            "pragma" => {}
            // An error of the grammar has already been reported.
            "ERROR" => {}
            other => {
                let (found, instead) = match other {
                    "for_statement" => ("`FOR`", "its passes one after another"),
                    "while_statement" => ("`WHILE`", "`IF`, and the rest in the next cycle"),
                    "repeat_statement" => ("`REPEAT`", "`IF`, and the rest in the next cycle"),
                    "exit_statement" => ("`EXIT`", "`IF`"),
                    "continue_statement" => ("`CONTINUE`", "`IF`"),
                    "return_statement" => ("`RETURN`", "`IF` around the rest"),
                    "reference_assignment_statement" => ("`REF=`", "`:=`"),
                    _ => (other, "`:=`, `IF` or `CASE`"),
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
        if self.is_whole(left) {
            return self.whole_assignment(left, right);
        }
        if let Some(target) = self.variables.arrays.get(said(left, self.text)) {
            return self.array_assignment(target, right);
        }
        let target = self.target(left);
        self.assign(target, right)
    }

    /// Lowers a value that is assigned to a variable; `None` after a reported error, which may concern the variable.
    pub(crate) fn assign(&mut self, target: Option<(Kind, u32)>, right: Node<'_>) -> Option<()> {
        let done = self.value_into(target, right);
        // A rejected value must not cause a second error where the variable is read.
        if let Some((kind, slot)) = target.filter(|_| self.dialect == Dialect::Scl) {
            self.assigned.insert((kind as usize, slot));
        }
        done
    }

    fn value_into(&mut self, target: Option<(Kind, u32)>, right: Node<'_>) -> Option<()> {
        if self.has_named_reals()
            && let Some(product) = constant::product(self.dialect, right, self.text, DEPTH - self.depth)
        {
            let value = constant::value(product, right, self.text, self.variables.real, self.mistakes)?;
            let Operand::Slot { kind: Kind::Real, slot, .. } = self.literal(Kind::Real, Value::Real(value)) else {
                return None;
            };
            return self.store(target?, (Kind::Real, slot, false), right);
        }
        let value = self.value(right)?;
        let target = target?;
        let value = self.typed(value, target.0, right)?;
        self.store(target, value, right)
    }

    /// The variable that an assignment writes.
    fn target(&mut self, node: Node<'_>) -> Option<(Kind, u32)> {
        let name = said(node, self.text);
        let is_part = matches!(node.kind(), "member_access_expression" | "index_expression");
        if node.kind() != "identifier" && !(is_part && self.variables.single.get(name).is_some()) {
            self.say(node, format!("{} left of `:=`", shown(node, self.text)), "a variable");
            return None;
        }
        let Some(variable) = self.variables.single.get(name) else {
            self.no_variable(node);
            return None;
        };
        match variable.role {
            Role::Output | Role::Local | Role::Shared | Role::Temporary => {
                return variable.known.then_some((variable.kind, variable.slot));
            }
            Role::Input => self.say(node, format!("the input `{name}` left of `:=`"), "a variable of its own"),
            Role::Constant => self.say(node, format!("the constant `{name}` left of `:=`"), "a variable of its own"),
        }
        None
    }

    fn store(&mut self, (kind, to): (Kind, u32), value: Typed, node: Node<'_>) -> Option<()> {
        let (found, slot, part) = value;
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
            Some(last) if part => (last.to, last.part) = (to, false),
            _ => {
                self.ops.push(Op::new(Code::moving(kind), to, [slot, 0]));
            }
        }
        Some(())
    }
}
