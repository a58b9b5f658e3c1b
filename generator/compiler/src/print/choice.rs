//! A choice by the number of an enumeration or by an integer: one `switch` or `CASE`, every list with its labels.

use super::language::Cases;
use super::{Doc, INDENTATION, Layout, NOTE_WIDTH};
use crate::program::{Arm, Expr, Statement, Var};
use pretty::DocAllocator;

impl<'d> Layout<'d> {
    pub(super) fn choice(&self, by: &'d Expr, arms: &'d [Arm], declared: &mut [bool]) -> Doc<'d> {
        let cases = &self.printer.language.cases;
        let [before, after] = cases.asks;
        let mut doc = self.arena.text(before).append(self.expr(by).doc).append(after);
        let (last, named) = arms.split_last().expect("print: a choice has arms");
        for arm in named {
            doc = doc.append(self.hardline).append(self.labels(&arm.labels)).append(self.arm(&arm.body, declared));
        }
        if !last.body.is_empty() {
            let [open, _, close] = self.printer.language.comment;
            let names = self.names(&last.labels).join(", ");
            // Readers of a longer list take the labels from the other lists.
            let is_shown = (1..=NOTE_WIDTH).contains(&names.len());
            let note = if is_shown { format!(" {open}{names}{close}") } else { String::new() };
            doc = doc.append(self.hardline).append(cases.others).append(note).append(self.arm(&last.body, declared));
        } else if !cases.nothing.is_empty() {
            doc = doc.append(self.hardline).append(cases.nothing);
        }
        doc.append(self.hardline).append(cases.end)
    }

    fn arm(&self, body: &'d [Statement], declared: &mut [bool]) -> Doc<'d> {
        let [inside, after] = self.printer.language.cases.ends;
        let mut list = self.list(body, declared);
        if !inside.is_empty() {
            list = list.append(self.hardline).append(inside);
        }
        let list = list.nest(INDENTATION);
        if after.is_empty() { list } else { list.append(self.hardline).append(after) }
    }

    /// The labels of a list.
    fn labels(&self, labels: &[Expr]) -> Doc<'d> {
        let Cases { label: [before, between, after], by_name, .. } = self.printer.language.cases;
        let names = self.names(labels);
        self.arena.text(if by_name && !names.is_empty() {
            format!("{before}{}{after}", names.join(between))
        } else {
            let digits: Vec<String> = labels.iter().map(|label| self.digits(label)).collect();
            let [open, _, close] = self.printer.language.comment;
            let note = if names.is_empty() { String::new() } else { format!(" {open}{}{close}", names.join(", ")) };
            format!("{before}{}{after}{note}", digits.join(between))
        })
    }

    /// The names of labels that have one.
    fn names(&self, labels: &[Expr]) -> Vec<&'d str> {
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
