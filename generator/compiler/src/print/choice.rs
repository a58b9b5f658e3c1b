//! A choice by the number of an enumeration or by an integer: one `switch` or `CASE`, every list with its labels.

use super::language::Cases;
use super::{Layout, NOTE_WIDTH};
use crate::program::{Arm, Expr, Statement, Var};

impl Layout<'_> {
    pub(super) fn choice(&mut self, by: &Expr, arms: &[Arm], declared: &mut [bool]) {
        let Cases { asks: [before, after], others, nothing, ends, end, .. } = self.printer.language.cases;
        self.lines.text(before);
        self.expr(by);
        self.line(after);
        let (last, named) = arms.split_last().expect("print: a choice has arms");
        for arm in named {
            let begin = self.lines.begin();
            self.line(&self.labels(&arm.labels));
            self.arm(&arm.body, declared);
            if ends == [""; 2] && arm.body.iter().all(|inner| matches!(inner, Statement::Assign { .. })) {
                self.lines.join(begin);
            }
        }
        if !last.body.is_empty() {
            let [open, _, close] = self.printer.language.comment;
            let names = self.names(&last.labels).join(", ");
            // Readers of a longer list take the labels from the other lists.
            let is_shown = (1..=NOTE_WIDTH).contains(&names.len());
            let note = if is_shown { format!(" {open}{names}{close}") } else { String::new() };
            self.line(&format!("{others}{note}"));
            self.arm(&last.body, declared);
        } else if !nothing.is_empty() {
            self.line(nothing);
        }
        self.line(end);
    }

    fn arm(&mut self, body: &[Statement], declared: &mut [bool]) {
        let [inside, after] = self.printer.language.cases.ends;
        self.inner(body, declared);
        if !inside.is_empty() {
            self.indented(1, |layout| layout.line(inside));
        }
        if !after.is_empty() {
            self.line(after);
        }
    }

    /// The labels of a list.
    fn labels(&self, labels: &[Expr]) -> String {
        let Cases { label: [before, between, after], by_name, .. } = self.printer.language.cases;
        let names = self.names(labels);
        if by_name && !names.is_empty() {
            return format!("{before}{}{after}", names.join(between));
        }
        let digits: Vec<String> = labels.iter().map(|label| self.digits(label)).collect();
        let [open, _, close] = self.printer.language.comment;
        let note = if names.is_empty() { String::new() } else { format!(" {open}{}{close}", names.join(", ")) };
        format!("{before}{}{after}{note}", digits.join(between))
    }

    /// The names of labels that have one.
    fn names(&self, labels: &[Expr]) -> Vec<&str> {
        let name = |label: &Expr| match label {
            Expr::Var(Var::Constant(index)) => Some(self.printer.names.constants[*index].as_str()),
            _ => None,
        };
        labels.iter().filter_map(name).collect()
    }

    fn digits(&self, label: &Expr) -> String {
        let value = label.known(&self.printer.program.constants).expect("print: a label is known");
        (self.printer.language.literal)(value)
    }
}
